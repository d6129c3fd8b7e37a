// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_ELLIPSOID_3_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_ELLIPSOID_3_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Parameter_angles.h>
#include <CGAL/assertions.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the ellipsoid
/// \f$ \sigma(u, v) = (a \cos v \cos u, b \cos v \sin u, c \sin v) \f$, where the
/// longitude u has the period \f$ 2 \pi \f$, and the latitude v goes from the pole at
/// \f$ -\pi/2 \f$ to the one at \f$ \pi/2 \f$ (figure 5.4 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \cgalModels{ParametricSurface_3}
template <class K>
class Parametric_ellipsoid_3
{
public:
  typedef K                      Kernel;   ///< the kernel
  typedef typename K::FT         FT;       ///< its number type
  typedef typename K::Point_2    Point_2;  ///< a point of the parameters
  typedef typename K::Point_3    Point_3;  ///< a point of space
  typedef typename K::Vector_3   Vector_3; ///< a vector of space

  /// the ellipsoid with the half axes `a`, `b` and `c` along the axes of coordinates.
  /// \pre the half axes are positive and finite.
  Parametric_ellipsoid_3(double a, double b, double c) : m_a(a), m_b(b), m_c(c)
  {
    CGAL_precondition(a > 0 && b > 0 && c > 0 && std::isfinite(a + b + c));
  }

  /// the rectangle of parameters.
  Anisotropic_mesh_2::Parameter_rectangle parameters() const
  {
    Anisotropic_mesh_2::Parameter_rectangle r;
    r.u_max = 2 * CGAL_PI;
    r.v_min = -CGAL_PI / 2;
    r.v_max = CGAL_PI / 2;
    r.u_is_periodic = r.v_min_is_pole = r.v_max_is_pole = true;
    return r;
  }

  /// the point with the parameters `uv`.
  Point_3 point(const Point_2& uv) const
  {
    const Angles t(uv);
    return Point_3(FT(m_a*t.cos_v*t.cos_u), FT(m_b*t.cos_v*t.sin_u), FT(m_c*t.sin_v));
  }

  /// the derivatives by u and by v.
  std::array<Vector_3, 2> first_derivatives(const Point_2& uv) const
  {
    const Angles t(uv);
    return {vector(-t.cos_v*t.sin_u, t.cos_v*t.cos_u, 0), vector(-t.sin_v*t.cos_u, -t.sin_v*t.sin_u, t.cos_v)};
  }

  /// the derivatives twice by u, by u and v, and twice by v.
  std::array<Vector_3, 3> second_derivatives(const Point_2& uv) const
  {
    const Angles t(uv);
    return {vector(-t.cos_v*t.cos_u, -t.cos_v*t.sin_u, 0), vector(t.sin_v*t.sin_u, -t.sin_v*t.cos_u, 0),
            vector(-t.cos_v*t.cos_u, -t.cos_v*t.sin_u, -t.sin_v)};
  }

private:
  typedef Anisotropic_mesh_2::internal::Parameter_angles Angles;

  // in multiples of the half axes
  Vector_3 vector(double x, double y, double z) const { return Vector_3(FT(m_a*x), FT(m_b*y), FT(m_c*z)); }

  double m_a, m_b, m_c;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_ELLIPSOID_3_H

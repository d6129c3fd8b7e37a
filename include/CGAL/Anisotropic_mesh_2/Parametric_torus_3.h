// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_TORUS_3_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_TORUS_3_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Parameter_angles.h>
#include <CGAL/assertions.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the torus around the z-axis,
/// \f$ \sigma(u, v) = ((R + r \cos v) \cos u, (R + r \cos v) \sin u, r \sin v) \f$,
/// where u and v have the period \f$ 2 \pi \f$ (figure 5.6 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \cgalModels{ParametricSurface_3}
template <class K>
class Parametric_torus_3
{
public:
  typedef K                      Kernel;   ///< the kernel
  typedef typename K::FT         FT;       ///< its number type
  typedef typename K::Point_2    Point_2;  ///< a point of the parameters
  typedef typename K::Point_3    Point_3;  ///< a point of space
  typedef typename K::Vector_3   Vector_3; ///< a vector of space

  /// the torus with the radius `large` of the circle in its middle, and the radius `small` of its tube.
  /// \pre `0 < small < large`
  Parametric_torus_3(double large, double small) : m_large(large), m_small(small)
  {
    CGAL_precondition(0 < small && small < large && std::isfinite(large));
  }

  /// the rectangle of parameters.
  Anisotropic_mesh_2::Parameter_rectangle parameters() const
  {
    Anisotropic_mesh_2::Parameter_rectangle r;
    r.u_max = r.v_max = 2 * CGAL_PI;
    r.u_is_periodic = r.v_is_periodic = true;
    return r;
  }

  /// the point with the parameters `uv`.
  Point_3 point(const Point_2& uv) const
  {
    const Angles a(uv);
    const double w = m_large + m_small*a.cos_v;
    return Point_3(FT(w*a.cos_u), FT(w*a.sin_u), FT(m_small*a.sin_v));
  }

  /// the derivatives by u and by v.
  std::array<Vector_3, 2> first_derivatives(const Point_2& uv) const
  {
    const Angles a(uv);
    const double w = m_large + m_small*a.cos_v, s = m_small*a.sin_v;
    return {vector(-w*a.sin_u, w*a.cos_u, 0), vector(-s*a.cos_u, -s*a.sin_u, m_small*a.cos_v)};
  }

  /// the derivatives twice by u, by u and v, and twice by v.
  std::array<Vector_3, 3> second_derivatives(const Point_2& uv) const
  {
    const Angles a(uv);
    const double w = m_large + m_small*a.cos_v, s = m_small*a.sin_v, c = m_small*a.cos_v;
    return {vector(-w*a.cos_u, -w*a.sin_u, 0), vector(s*a.sin_u, -s*a.cos_u, 0), vector(-c*a.cos_u, -c*a.sin_u, -s)};
  }

private:
  typedef Anisotropic_mesh_2::internal::Parameter_angles Angles;

  static Vector_3 vector(double x, double y, double z) { return Vector_3(FT(x), FT(y), FT(z)); }

  double m_large, m_small;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETRIC_TORUS_3_H

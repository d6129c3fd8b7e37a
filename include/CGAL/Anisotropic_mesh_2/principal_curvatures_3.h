// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PRINCIPAL_CURVATURES_3_H
#define CGAL_ANISOTROPIC_MESH_2_PRINCIPAL_CURVATURES_3_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the curvatures of a surface at a point, positive where the surface bends to
/// the side of its normal (formula (5.2) of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \sa `principal_curvatures_3()`
template <class K>
struct Principal_curvatures_3
{
  double k_min;                  ///< the least normal curvature, one over a length
  double k_max;                  ///< the largest one
  typename K::Vector_3 v_min;    ///< the direction of the least one, of unit length
  typename K::Vector_3 v_max;    ///< that of the largest one, orthogonal to it
  typename K::Vector_3 normal;   ///< of unit length, along \f$ \sigma_u \times \sigma_v \f$
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the principal curvatures of `surface` at the parameters `uv`. Where they
/// are equal, the directions are any.
///
/// \tparam Surface a model of `ParametricSurface_3`
/// \param surface the surface
/// \param uv parameters of a point
/// \return the curvatures, in units of one over those of the space, and their directions
/// \throw Degenerate_parametrization_exception if the surface has no tangent plane or no finite second derivatives
/// there.
/// \sa `Curvature_metric_3`
template <class Surface>
Principal_curvatures_3<typename Surface::Kernel>
principal_curvatures_3(const Surface& surface, const typename Surface::Kernel::Point_2& uv)
{
  typedef typename Surface::Kernel::FT        FT;
  typedef typename Surface::Kernel::Vector_3  Vector_3;
  const std::array<Vector_3, 2> d = surface.first_derivatives(uv);
  const std::array<Vector_3, 3> dd = surface.second_derivatives(uv);
  const auto unit = [](const Vector_3& v) { return v / FT(std::sqrt(CGAL::to_double(v * v))); };
  const auto product = [](const Vector_3& v, const Vector_3& w) { return CGAL::to_double(v * w); };

  // an orthonormal basis of the tangent plane, and the derivatives in it: (a, 0) and (b, c)
  const Vector_3 normal = unit(cross_product(d[0], d[1])), t1 = unit(d[0]), t2 = cross_product(normal, t1);
  const double a = product(d[0], t1), b = product(d[1], t1), c = product(d[1], t2);
  const double l = product(dd[0], normal), m = product(dd[1], normal), n = product(dd[2], normal);

  // the shape operator
  const double xx = l / (a*a), xy = (m - l*b/a) / (a*c), yy = (n - 2*m*b/a + l*b*b/(a*a)) / (c*c);
  const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy), angle = std::atan2(2*xy, xx - yy) / 2;
  if(!std::isfinite(mean + radius))
    throw Degenerate_parametrization_exception("the curvature of the surface is not finite",
                                               CGAL::to_double(uv.x()), CGAL::to_double(uv.y()));
  const FT cosine(std::cos(angle)), sine(std::sin(angle));
  return {mean - radius, mean + radius, cosine*t2 - sine*t1, cosine*t1 + sine*t2, normal};
}

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PRINCIPAL_CURVATURES_3_H

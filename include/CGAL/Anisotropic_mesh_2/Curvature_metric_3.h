// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_CURVATURE_METRIC_3_H
#define CGAL_ANISOTROPIC_MESH_2_CURVATURE_METRIC_3_H

#include <CGAL/Metric_tensor_3.h>
#include <CGAL/assertions.h>
#include <CGAL/Anisotropic_mesh_2/principal_curvatures_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric of geometric surface meshes, whose sizes are multiples of the radii
/// of curvature, along the principal directions: formula (5.2) of
/// \cgalCite{dw-acvt-05}.
///
/// The factor is \f$ g(\epsilon) = 2 \sqrt{\epsilon (2 - \epsilon)} \f$: the chord of this
/// length in a circle of radius 1 has the arc at most \f$ \epsilon \f$ away. So unit
/// edges are as far from the surface as \f$ \epsilon \f$ times the radius of curvature in their direction, and
/// triangles of unit edges up to 4/3 times as far where the surface is like a sphere.
///
/// Sizes are kept between two bounds, which flat places need, and the ratio of the two sizes in the tangent
/// plane too. Along the normal the size is the smaller one of these.
///
/// \tparam Surface_ a model of `ParametricSurface_3`
/// \sa `principal_curvatures_3()`
/// \sa `Surface_metric_field_2`
template <class Surface_>
class Curvature_metric_3
{
public:
  typedef Surface_                       Surface; ///< the surface
  typedef typename Surface::Kernel       Kernel;  ///< its kernel
  typedef typename Kernel::FT            FT;      ///< the number type
  typedef typename Kernel::Point_2       Point_2; ///< a point of the parameters

  /// the metric of the relative chord error `epsilon`.
  /// \param epsilon the chord error, relative to the radius of curvature
  /// \param least_size the lower bound of the sizes, in units of the space
  /// \param largest_size the upper bound
  /// \param largest_ratio the bound of the ratio of the two sizes in the tangent plane
  /// \pre `0 < epsilon < 1`, `0 < least_size <= largest_size`, which is finite, and `largest_ratio >= 1`
  Curvature_metric_3(double epsilon, double least_size, double largest_size,
                     double largest_ratio = std::numeric_limits<double>::infinity())
    : m_factor(2 * std::sqrt(epsilon * (2 - epsilon))), m_least_size(least_size), m_largest_size(largest_size),
      m_largest_ratio(largest_ratio)
  {
    CGAL_precondition(0 < epsilon && epsilon < 1);
    CGAL_precondition(0 < least_size && least_size <= largest_size && std::isfinite(largest_size));
    CGAL_precondition(largest_ratio >= 1);
  }

  /// returns the tensor of the space at a point of the surface.
  /// \throw Degenerate_parametrization_exception if the surface has no tangent plane or no finite curvature there.
  Metric_tensor_3<Kernel> operator()(const Surface& surface, const Point_2& uv) const
  {
    const Principal_curvatures_3<Kernel> k = principal_curvatures_3(surface, uv);
    const double h_min = size(k.k_min), h_max = size(k.k_max), smaller = (std::min)(h_min, h_max);
    return Metric_tensor_3<Kernel>::from_directions
      ({k.v_min, k.v_max, k.normal},
       {FT((std::min)(h_min, m_largest_ratio * smaller)), FT((std::min)(h_max, m_largest_ratio * smaller)),
        FT(smaller)});
  }

private:
  double size(double curvature) const
  {
    return std::clamp(m_factor / std::abs(curvature), m_least_size, m_largest_size);
  }

  double m_factor, m_least_size, m_largest_size, m_largest_ratio;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_CURVATURE_METRIC_3_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SUMMATION_METRIC_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SUMMATION_METRIC_H

#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Metric_sample.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// A metric for sums over faces: that of samples where these agree with each other and the field
// itself elsewhere, since an interpolation is smoother than what it does not resolve, and sums
// would be too low. There few parts of a face must do. Without derivatives.
template <class Mesh>
class Summation_metric
{
  typedef typename Mesh::Vertex_handle Vertex_handle;

public:
  typedef typename Sampled_metric<Mesh>::Place Place;

  // In faces at vertices of at most this variation the field may be evaluated.
  Summation_metric(const Mesh& mesh, const Sampled_metric<Mesh>& samples, double largest_variation)
    : m_samples(samples), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_largest_variation(largest_variation)
  {}

  Place place_near(Vertex_handle v) const { return m_samples.place_near(v); }

  Metric_sample operator()(const Vector_of_doubles& x, Place& place) const
  {
    const Symmetric_form m = m_samples.tensor(x, place);
    if(m_samples.is_accurate(place))
      return {m, {}, {}, std::sqrt(m.determinant())};
    const Symmetric_form of_field(m_tensor(point_at<typename Mesh::Point>(x.x, x.y)));
    return {of_field, {}, {}, std::sqrt(of_field.determinant())};
  }

  double variation(Vertex_handle v) const
  {
    const double variation = m_samples.variation(v);
    return m_samples.is_accurate(v) ? variation : (std::min)(variation, m_largest_variation);
  }

private:
  const Sampled_metric<Mesh>& m_samples;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const double                m_largest_variation;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SUMMATION_METRIC_H

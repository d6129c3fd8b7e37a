// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_METRIC_FIELD_2_H
#define CGAL_DISCRETE_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Triangle_locator_2.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Metric_tensor_2.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field that interpolates tensors given at the vertices of a
/// triangle mesh, the background.
///
/// In a triangle, the matrix logarithms of the three tensors are interpolated linearly
/// (log-Euclidean mean \cgalCite{afpa-lem-06}), so that the result is positive definite and lies
/// between the three. A point outside of the background gets the tensor of the nearest point of the
/// background.
///
/// Copies share their data and are cheap; an object can be used by several
/// threads at once. A query takes \f$ O(\log n) \f$ time for reasonable meshes of `n` triangles.
///
/// \tparam K a model of `Kernel`; predicates decide which triangle holds a point, so it
/// should have exact predicates
/// \cgalModels{MetricField_2}
template <class K>
class Discrete_metric_field_2
{
public:
  typedef typename K::Point_2                                  Point_2;       ///< a point
  typedef Metric_tensor_2<K>                                   Metric_tensor; ///< a tensor
  typedef Anisotropic_mesh_2::Planar_straight_line_graph_2<K>  Background; ///< points and triangles

  /// interpolates `tensors[i]`, given at `background.points[i]`, over `background.triangles`,
  /// which may be oriented either way and should not overlap.
  /// \throw Anisotropic_mesh_2::Invalid_triangle_mesh_exception if there is no triangle, if a triangle is
  /// degenerate or names a vertex that does not exist, or if there are not as
  /// many tensors as points.
  Discrete_metric_field_2(const Background& background, const std::vector<Metric_tensor>& tensors)
    : m_data(std::make_shared<const Data>(checked(background, tensors), tensors))
  {}

  /// returns the interpolated tensor at `p`.
  /// \pre the coordinates of `p` are finite.
  Metric_tensor operator()(const Point_2& p) const
  {
    const auto place = m_data->locator.locate(p);
    std::array<double, 3> logarithm = {0, 0, 0};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        logarithm[j] += place.weights[i] * m_data->logarithms[place.vertices[i]][j];
    return Metric_tensor::from_logarithm(logarithm);
  }

private:
  struct Data
  {
    Data(const Background& background, const std::vector<Metric_tensor>& tensors)
      : locator(background.points, background.triangles)
    {
      logarithms.reserve(tensors.size());
      for(const Metric_tensor& m : tensors)
        logarithms.push_back(m.logarithm());
    }

    Anisotropic_mesh_2::internal::Triangle_locator_2<K> locator;
    std::vector<std::array<double, 3>>                  logarithms;
  };

  static const Background& checked(const Background& background, const std::vector<Metric_tensor>& tensors)
  {
    if(tensors.size() != background.points.size())
      throw Anisotropic_mesh_2::Invalid_triangle_mesh_exception
        ("the background has " + std::to_string(background.points.size()) +
                                  " vertices, but " + std::to_string(tensors.size()) +
                                  " metric tensors are given");
    return background;
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace CGAL

#endif // CGAL_DISCRETE_METRIC_FIELD_2_H

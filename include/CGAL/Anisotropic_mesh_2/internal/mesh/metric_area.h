// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_METRIC_AREA_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_METRIC_AREA_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/faces_in_domain.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/Too_many_vertices_exception.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The integral of (det M)^exponent over the domain of a mesh: its area in the
// metric for 1/2.
template <class ConcurrencyTag, class Mesh>
double metric_area(const Mesh& mesh, const std::vector<typename Mesh::Face_handle>& faces, double exponent,
                   double relative_tolerance, std::size_t maximum_quarterings)
{
  const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
  const auto density = [&](double x, double y) {
    const double det = CGAL::to_double(tensor(point_at<typename Mesh::Point>(x, y)).determinant());
    return exponent == 0.5 ? std::sqrt(det) : std::pow(det, exponent);
  };
  std::vector<double> sums(number_of_chunks(faces.size()), 0.);
  for_each_chunk<ConcurrencyTag>(faces.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Adaptive_triangle_integral<decltype(density)> integral(density, relative_tolerance,
                                                           maximum_quarterings / sums.size());
    for(std::size_t k = begin; k < end; ++k) {
      std::array<Vector_of_doubles, 3> t;
      for(int i = 0; i < 3; ++i)
        t[i] = to_doubles(faces[k]->vertex(i)->point());
      sums[chunk] += integral(t);
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

inline double ideal_number_of_vertices(double metric_area) { return 2 / std::sqrt(3.) * metric_area; }

template <class Mesh>
void check_ideal_number_of_vertices(const Mesh& mesh, std::size_t limit)
{
  std::vector<typename Mesh::Face_handle> faces;
  faces_in_domain(mesh, faces);
  const double ideal = ideal_number_of_vertices(metric_area<Sequential_tag>(mesh, faces, 0.5, 0.05, 100000));
  if(ideal > 1.5 * double(limit)) // an estimate must not refuse what just fits
    throw Too_many_vertices_exception(ideal, limit);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_METRIC_AREA_H

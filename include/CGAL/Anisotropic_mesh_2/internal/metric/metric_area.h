// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AREA_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AREA_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The integral of (det M)^exponent over the triangles triangle_at(0), ..., triangle_at(n - 1):
// their area in the metric for 1/2.
template <class ConcurrencyTag, class Point, class Triangle_at, class Construct_tensor>
double metric_area(std::size_t n, const Triangle_at& triangle_at, const Construct_tensor& tensor, double exponent,
                   double relative_tolerance, std::size_t maximum_quarterings)
{
  const auto density = [&](double x, double y) {
    const double det = CGAL::to_double(tensor(point_at<Point>(x, y)).determinant());
    return exponent == 0.5 ? std::sqrt(det) : std::pow(det, exponent);
  };
  std::vector<double> sums(number_of_chunks(n), 0.);
  for_each_chunk<ConcurrencyTag>(n, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Adaptive_triangle_integral<decltype(density)> integral(density, relative_tolerance,
                                                           maximum_quarterings / sums.size());
    for(std::size_t k = begin; k < end; ++k)
      sums[chunk] += integral(triangle_at(k));
  });
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

// the area of faces in the metric, by one sample in each
template <class Point, class Faces, class Construct_tensor>
double estimated_metric_area(const Faces& faces, const Construct_tensor& tensor)
{
  double sum = 0;
  for(const auto f : faces) {
    const Triangle_of_doubles t = triangle_of_doubles(f);
    const Vector_of_doubles b = barycentre(t);
    sum += area(t) * tensor(point_at<Point>(b.x, b.y)).area_density();
  }
  return sum;
}

constexpr double area_of_unit_triangle = 0.4330127018922193; // sqrt(3) / 4

inline double ideal_number_of_vertices(double metric_area) { return 2 / std::sqrt(3.) * metric_area; }

// Refuses a metric that asks for too many vertices in these triangles.
template <class Point, class Construct_tensor>
void check_ideal_number_of_vertices(const std::vector<Triangle_of_doubles>& triangles, const Construct_tensor& tensor,
                                    std::size_t limit)
{
  const auto triangle_at = [&](std::size_t k) -> const Triangle_of_doubles& { return triangles[k]; };
  const double ideal = ideal_number_of_vertices
    (metric_area<Sequential_tag, Point>(triangles.size(), triangle_at, tensor, 0.5, 0.2, 2000));
  if(ideal > 1.5 * double(limit)) // an estimate must not refuse what just fits
    throw Too_many_vertices_exception(ideal, limit);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AREA_H

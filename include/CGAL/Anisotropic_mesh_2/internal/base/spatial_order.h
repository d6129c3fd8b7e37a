// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SPATIAL_ORDER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SPATIAL_ORDER_H

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The numbers of points in the order of `spatial_sort()`, which is that of their coordinates as doubles, whatever the
// kernel is.
inline std::vector<std::size_t> spatial_order(const std::vector<Simple_cartesian<double>::Point_2>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  typedef Simple_cartesian<double> Kernel;
  typedef Pointer_property_map<Kernel::Point_2>::const_type Point_map;
  CGAL::spatial_sort(order.begin(), order.end(),
                     Spatial_sort_traits_adapter_2<Kernel, Point_map>(make_property_map(points)));
  return order;
}

template <class Point>
std::vector<std::size_t> spatial_order(const std::vector<Point>& points)
{
  std::vector<Simple_cartesian<double>::Point_2> rounded;
  rounded.reserve(points.size());
  for(const Point& p : points)
    rounded.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  return spatial_order(rounded);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SPATIAL_ORDER_H

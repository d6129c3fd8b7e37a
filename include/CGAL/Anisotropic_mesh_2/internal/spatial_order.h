// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SPATIAL_ORDER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SPATIAL_ORDER_H

#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// the ranks of points in an order of insertion in which neighbors follow each other
template <class Kernel>
std::vector<std::size_t> spatial_order(const std::vector<typename Kernel::Point_2>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  typedef typename Pointer_property_map<typename Kernel::Point_2>::const_type Point_map;
  CGAL::spatial_sort(order.begin(), order.end(),
                     Spatial_sort_traits_adapter_2<Kernel, Point_map>(make_property_map(points)));
  return order;
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SPATIAL_ORDER_H

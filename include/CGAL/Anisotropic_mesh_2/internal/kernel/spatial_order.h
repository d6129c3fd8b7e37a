// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_SPATIAL_ORDER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_SPATIAL_ORDER_H

#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// What spatial_sort() needs of traits, by reference: it copies its traits for
// each comparison, and copies of ours count the references to a metric field.
template <class Gt>
class Spatial_order_traits_2
{
public:
  typedef typename Gt::FT           FT;
  typedef typename Gt::Point_2      Point_2;
  typedef typename Gt::Compute_x_2  Compute_x_2;
  typedef typename Gt::Compute_y_2  Compute_y_2;
  typedef typename Gt::Less_x_2     Less_x_2;
  typedef typename Gt::Less_y_2     Less_y_2;

  explicit Spatial_order_traits_2(const Gt& traits) : m_traits(&traits) {}

  Compute_x_2 compute_x_2_object() const { return m_traits->compute_x_2_object(); }
  Compute_y_2 compute_y_2_object() const { return m_traits->compute_y_2_object(); }
  Less_x_2 less_x_2_object() const { return m_traits->less_x_2_object(); }
  Less_y_2 less_y_2_object() const { return m_traits->less_y_2_object(); }

private:
  const Gt* m_traits;
};

// the ranks of points in an order of insertion in which neighbors follow each other
template <class Gt>
std::vector<std::size_t> spatial_order(const std::vector<typename Gt::Point_2>& points, const Gt& traits)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  typedef Spatial_order_traits_2<Gt> Base;
  typedef typename Pointer_property_map<typename Gt::Point_2>::const_type Point_map;
  CGAL::spatial_sort(order.begin(), order.end(),
                     Spatial_sort_traits_adapter_2<Base, Point_map>(make_property_map(points), Base(traits)));
  return order;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_SPATIAL_ORDER_H

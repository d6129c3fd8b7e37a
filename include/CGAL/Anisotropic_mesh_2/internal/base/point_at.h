// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_POINT_AT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_POINT_AT_H

#include <type_traits>
#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// the number type of the coordinates of a point
template <class Point_2>
using Coordinate = std::decay_t<decltype(std::declval<const Point_2&>().x())>;

// the point with the given coordinates, which the constructor need not take as doubles
template <class Point_2>
Point_2 point_at(double x, double y)
{
  return Point_2(Coordinate<Point_2>(x), Coordinate<Point_2>(y));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_POINT_AT_H

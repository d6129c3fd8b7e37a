// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OF_DOUBLES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OF_DOUBLES_H

#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

struct Vector_of_doubles
{
  double x = 0, y = 0;
};

typedef std::vector<Vector_of_doubles> Vectors;

inline Vector_of_doubles middle(const Vector_of_doubles& p, const Vector_of_doubles& q)
{
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

template <class Point>
Vector_of_doubles to_doubles(const Point& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OF_DOUBLES_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNIT_APEX_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNIT_APEX_H

#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>

namespace CGAL::Anisotropic_mesh_2::internal {

// The point to the left of the edge from u to v that completes it to a triangle
// with two sides of unit length in the metric m. Returns false where the edge is
// so long that there is none, or so short or m so thin that rounding hides it.
template <class Point_2>
bool unit_apex(const Point_2& u, const Point_2& v, const Symmetric_form& m, Point_2& apex)
{
  const double ux = CGAL::to_double(u.x()), uy = CGAL::to_double(u.y());
  const double dx = CGAL::to_double(v.x()) - ux, dy = CGAL::to_double(v.y()) - uy;
  const double edge_squared = m(dx, dy), height_squared = 1 - edge_squared / 4;
  const double nx = -(m.c*dy + m.b*dx), ny = m.a*dx + m.b*dy; // normal to the edge in m
  const double normal_squared = m.determinant() * edge_squared;
  if(!(height_squared > 0.1 && normal_squared >= (std::numeric_limits<double>::min)()))
    return false;
  const double scale = std::sqrt(height_squared / normal_squared);
  apex = point_at<Point_2>(ux + dx/2 + scale*nx, uy + dy/2 + scale*ny);
  return true;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNIT_APEX_H

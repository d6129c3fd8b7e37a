// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_PARAMETER_ANGLES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_PARAMETER_ANGLES_H

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// two parameters that are angles
struct Parameter_angles
{
  double cos_u, sin_u, cos_v, sin_v;

  template <class Point_2>
  explicit Parameter_angles(const Point_2& uv)
    : cos_u(std::cos(CGAL::to_double(uv.x()))), sin_u(std::sin(CGAL::to_double(uv.x()))),
      cos_v(std::cos(CGAL::to_double(uv.y()))), sin_v(std::sin(CGAL::to_double(uv.y())))
  {}
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_PARAMETER_ANGLES_H

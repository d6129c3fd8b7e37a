// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// What the optimizer needs of the Voronoi region V of a generator z, with w the
// density of the measure: the integrals of w M and of w M (x - z). The mass
// centre is z + pull, the gradient of the energy is -2 A pull.
struct Region_moments
{
  Symmetric_form a;         // the integral of w M
  double gx = 0, gy = 0;    // the integral of w M (x - z)

  // Adds a mass, at x = z + (dx, dy), of the weighted tensor s; returns its energy.
  double add(const Symmetric_form& s, double dx, double dy)
  {
    a += s;
    const double sx = s.a*dx + s.b*dy, sy = s.b*dx + s.c*dy;
    gx += sx;
    gy += sy;
    return sx*dx + sy*dy;
  }

  Region_moments& operator+=(const Region_moments& m)
  {
    a += m.a;
    gx += m.gx;
    gy += m.gy;
    return *this;
  }

  // The vector from the generator to its mass centre; none for an empty region.
  void pull(double& x, double& y) const { solve(gx, gy, x, y); }

  // (x, y) = a^-1 (u, v)
  void solve(double u, double v, double& x, double& y) const
  {
    const double det = a.determinant();
    if(!(det > 0)) {
      x = y = 0;
      return;
    }
    x = (a.c*u - a.b*v) / det;
    y = (a.a*v - a.b*u) / det;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H

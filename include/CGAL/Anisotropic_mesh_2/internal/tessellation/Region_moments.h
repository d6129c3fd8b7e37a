// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// What the optimizer needs of the Voronoi region V of a generator z, with w the
// density of the measure: the integrals of w M and of w M (x - z). The mass
// centre is z + lloyd_move(), the gradient of the energy is -2 A lloyd_move().
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

  // From the generator to its mass centre; none for an empty region.
  Vector_of_doubles lloyd_move() const { return solve(gx, gy); }

  // a^-1 (u, v)
  Vector_of_doubles solve(double u, double v) const
  {
    const double det = a.determinant();
    if(!(det > 0))
      return {0, 0};
    return {(a.c*u - a.b*v) / det, (a.a*v - a.b*u) / det};
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_MOMENTS_H

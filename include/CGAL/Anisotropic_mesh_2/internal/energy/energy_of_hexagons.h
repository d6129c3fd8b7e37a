// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ENERGY_OF_HEXAGONS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ENERGY_OF_HEXAGONS_H

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// The energy of this number of regular hexagons, in the limit of many: the least one. See the page
// "Derivations" of the manual.
inline double energy_of_hexagons(double density_integral, double number)
{
  const double second_moment = 5 / (18 * std::sqrt(3.)); // of a regular hexagon of unit area
  return second_moment * density_integral * density_integral / number;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ENERGY_OF_HEXAGONS_H

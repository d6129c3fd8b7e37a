// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_DOMAIN_RULE_H
#define CGAL_ANISOTROPIC_MESH_2_DOMAIN_RULE_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Enums
///
/// what decides which side of its edges is inside a domain.
enum class Domain_rule
{
  /// crossing a boundary edge toggles between outside and inside, starting
  /// from the unbounded face (polygons, circles, Medit edge files).
  EVEN_ODD,
  /// outside is what can be reached from infinity or from the seed of a hole
  /// without crossing any edge (Triangle `.poly` files).
  FLOOD_FROM_SEEDS
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_DOMAIN_RULE_H

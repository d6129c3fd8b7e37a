// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_POINT_PLACEMENT_H
#define CGAL_ANISOTROPIC_MESH_2_POINT_PLACEMENT_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Enums
///
/// where unit meshing takes its field points from (section 3.2 of \cgalCite{dw-acvt-05}).
enum class Point_placement
{
  /// at unit distances on the interior edges.
  EDGE_SUBDIVISION,
  /// at unit distance from both ends of the edges of a front that advances from
  /// the constrained edges; edges that are still too long in the end are subdivided.
  ADVANCING_FRONT
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_POINT_PLACEMENT_H

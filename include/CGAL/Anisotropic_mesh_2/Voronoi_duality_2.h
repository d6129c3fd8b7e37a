// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_DUALITY_2_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_DUALITY_2_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how far a triangulation is dual to a tessellation in the sense of definition
/// 2.3 of \cgalCite{dw-acvt-05}: which of its edges join generators whose main
/// pieces share a bisector. Generators are named by the indices of their regions.
struct Voronoi_duality_2
{
  typedef std::pair<std::size_t, std::size_t> Pair; ///< two regions, the smaller index first

  std::size_t       number_of_dual_edges = 0;   ///< edges with a bisector
  std::vector<Pair> edges_without_bisector;     ///< in increasing order
  std::vector<Pair> bisectors_without_edge;     ///< in increasing order

  /// the share of dual edges among all pairs joined by an edge or sharing a bisector; 1 if there are none.
  double share_of_dual_edges() const
  {
    const std::size_t all = number_of_dual_edges + edges_without_bisector.size() + bisectors_without_edge.size();
    return all == 0 ? 1 : double(number_of_dual_edges) / double(all);
  }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_DUALITY_2_H

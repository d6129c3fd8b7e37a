// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_DELAUNAY_CONSISTENCY_H
#define CGAL_ANISOTROPIC_MESH_2_DELAUNAY_CONSISTENCY_H

#include <cstddef>
#include <ostream>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how far a triangulation is Delaunay in its varying metric, by the criterion of section 3.1 of
/// \cgalCite{dw-acvt-05}.
///
/// \sa `CGAL::anisotropic_Delaunay_consistency_2()`
struct Delaunay_consistency
{
  std::size_t edges = 0;             ///< free edges between two faces
  std::size_t consistent_edges = 0;  ///< those that pass `CGAL::is_consistent_edge()`
  std::size_t stars = 0;             ///< vertices
  std::size_t consistent_stars = 0;  ///< those that pass `CGAL::is_consistent_star()`

  /// the share of consistent edges, 1 if there are no edges.
  double edge_share() const { return share(consistent_edges, edges); }

  /// the share of consistent stars, 1 if there are no stars.
  double star_share() const { return share(consistent_stars, stars); }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Delaunay_consistency& c)
  {
    return os << "edges: " << c.edges << "\nconsistent_edges: " << c.consistent_edges
              << "\nstars: " << c.stars << "\nconsistent_stars: " << c.consistent_stars << '\n';
  }

private:
  static double share(std::size_t part, std::size_t whole) { return whole == 0 ? 1. : double(part) / double(whole); }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_DELAUNAY_CONSISTENCY_H

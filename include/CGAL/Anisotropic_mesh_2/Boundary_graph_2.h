// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_BOUNDARY_GRAPH_2_H
#define CGAL_ANISOTROPIC_MESH_2_BOUNDARY_GRAPH_2_H

#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a straight graph that bounds a domain, as `Anisotropic_Delaunay_mesh_2::insert_boundary()` takes it: points are
/// pairwise different, segments meet at common points only.
///
/// \tparam K the kernel of the points.
template <class K>
struct Boundary_graph_2
{
  typedef typename K::Point_2                              Point_2; ///< a point
  typedef typename Planar_straight_line_graph_2<K>::Region Region;  ///< a point in a region, with its reference

  /// an edge of the graph.
  struct Segment
  {
    std::size_t source;    ///< the index of one end in `points`
    std::size_t target;    ///< the index of the other end
    int         reference; ///< of the constrained edge
    bool is_boundary;      ///< whether crossing it toggles between inside and outside
  };

  std::vector<Point_2> points;   ///< the vertices
  std::vector<Segment> segments; ///< the edges
  std::vector<Region>  regions;  ///< the references of subdomains
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_BOUNDARY_GRAPH_2_H

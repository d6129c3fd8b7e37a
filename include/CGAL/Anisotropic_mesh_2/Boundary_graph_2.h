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

namespace CGAL::Anisotropic_mesh_2::internal {

// The straight graph that the mesher gets: points are pairwise different,
// segments meet at common points only.
template <class K>
struct Boundary_graph_2
{
  typedef typename K::Point_2                                 Point_2;
  typedef typename Planar_straight_line_graph_2<K>::Region    Region;

  struct Segment
  {
    std::size_t source;
    std::size_t target;
    int         reference;
    bool        is_boundary; // crossing it toggles inside and outside
  };

  std::vector<Point_2> points;
  std::vector<Segment> segments;
  std::vector<Region>  regions;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_BOUNDARY_GRAPH_2_H

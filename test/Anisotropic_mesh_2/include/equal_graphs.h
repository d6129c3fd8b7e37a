// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What it means that a graph was read back as it was written.

#ifndef ANISOTROPIC_MESH_2_TEST_EQUAL_GRAPHS_H
#define ANISOTROPIC_MESH_2_TEST_EQUAL_GRAPHS_H

#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>

#include <algorithm>

template <class K>
bool are_equal(const CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& a,
               const CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& b)
{
  typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K> Graph;
  const auto same_edge = [](const typename Graph::Edge& e, const typename Graph::Edge& f) {
    return e.source == f.source && e.target == f.target && e.reference == f.reference;
  };
  const auto same_region = [](const typename Graph::Region& r, const typename Graph::Region& s) {
    return r.seed == s.seed && r.reference == s.reference;
  };
  return a.points == b.points && a.point_references == b.point_references && a.holes == b.holes
      && a.triangles == b.triangles && a.triangle_references == b.triangle_references
      && std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), same_edge)
      && std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same_region);
}

#endif // ANISOTROPIC_MESH_2_TEST_EQUAL_GRAPHS_H

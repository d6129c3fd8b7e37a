// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_GRAPH_OF_TRIANGULATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_GRAPH_OF_TRIANGULATION_H

#include <CGAL/Anisotropic_mesh_2/Boundary_graph_2.h>

#include <cstddef>
#include <map>

namespace CGAL::Anisotropic_mesh_2::internal {

// All vertices of a constrained triangulation of CGAL, and its constrained edges;
// those with one face of the domain bound it.
template <class K, class Ct>
Boundary_graph_2<K> graph_of_triangulation(const Ct& ct)
{
  Boundary_graph_2<K> graph;
  std::map<typename Ct::Vertex_handle, std::size_t> index;
  for(auto v = ct.finite_vertices_begin(); v != ct.finite_vertices_end(); ++v) {
    index[v] = graph.points.size();
    graph.points.push_back(v->point());
  }
  // edges in an order that does not depend on the addresses of faces
  for(auto f = ct.all_faces_begin(); f != ct.all_faces_end(); ++f)
    for(int i = 0; i < 3; ++i) {
      if(!f->is_constrained(i))
        continue;
      const std::size_t u = index[f->vertex(Ct::ccw(i))], v = index[f->vertex(Ct::cw(i))];
      if(u < v)
        graph.segments.push_back({u, v, 1, f->is_in_domain() != f->neighbor(i)->is_in_domain()});
    }
  return graph;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_GRAPH_OF_TRIANGULATION_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H

#include <algorithm>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The vertices of the domain that end no constrained edge, in the order of their indices.
template <class Mesh>
std::vector<typename Mesh::Vertex_handle> free_vertices(const Mesh& mesh)
{
  typedef typename Mesh::Vertex_handle Vertex_handle;
  std::vector<bool> is_free(mesh.vertex_index_bound(), true);
  for(auto f = mesh.all_faces_begin(); f != mesh.all_faces_end(); ++f)
    for(int i = 0; i < 3; ++i)
      if(!mesh.is_infinite(f->vertex(i)) && (f->is_constrained(Mesh::ccw(i)) || !f->is_in_domain()))
        is_free[f->vertex(i)->index()] = false;
  std::vector<Vertex_handle> result;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    if(is_free[v->index()])
      result.push_back(v);
  std::sort(result.begin(), result.end(),
            [](Vertex_handle v, Vertex_handle w) { return v->index() < w->index(); });
  return result;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H

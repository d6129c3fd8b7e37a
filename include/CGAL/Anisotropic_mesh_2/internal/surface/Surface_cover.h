// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_COVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_COVER_H

#include <CGAL/Anisotropic_mesh_2/internal/surface/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Directed_edges.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Gives each face and each vertex of a surface mesh to one part of an atlas, to
// that in which it is farthest, in edges, from where the chart is cut.
template <class Field>
class Surface_cover
{
  typedef Anisotropic_surface_mesh_3<Field>  Surface_mesh;
  typedef typename Surface_mesh::Face        Face;
  typedef std::vector<int>                   Depths; // by vertex; -1 if it is not in the part

public:
  Surface_cover(const Surface_mesh& mesh, const Surface_atlas<Field>& atlas)
    : m_part_of_vertex(mesh.number_of_vertices(), 0), m_part_of_face(mesh.number_of_faces(), 0)
  {
    const Directed_edges edges(mesh.faces());
    std::vector<int> vertex_depth(m_part_of_vertex.size(), -1), face_depth(m_part_of_face.size(), -1);
    for(std::size_t k = 0; k < atlas.parts.size(); ++k) {
      const Chart_mesh<Field> part(mesh, atlas.parts[k]);
      const Depths depths = depths_in(mesh, edges, part);
      for(std::size_t v = 0; v < depths.size(); ++v)
        prefer(depths[v], k, vertex_depth[v], m_part_of_vertex[v]);
      for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
        const Face& w = mesh.faces()[f];
        if(part.has_face(f))
          prefer((std::min)({depths[w[0]], depths[w[1]], depths[w[2]]}), k, face_depth[f], m_part_of_face[f]);
      }
    }
  }

  std::size_t part_of_vertex(std::size_t v) const { return m_part_of_vertex[v]; }
  std::size_t part_of_face(std::size_t f) const { return m_part_of_face[f]; }

private:
  static constexpr int far = 12; // depths beyond are all alike

  static void prefer(int depth, std::size_t part, int& best, std::size_t& best_part)
  {
    if(depth > best) {
      best = depth;
      best_part = part;
    }
  }

  static Depths depths_in(const Surface_mesh& mesh, const Directed_edges& edges, const Chart_mesh<Field>& part)
  {
    Depths depths(mesh.number_of_vertices(), -1);
    for(const Face& f : part.faces())
      for(std::size_t v : f)
        depths[v] = far;
    for(const auto& e : part.border())
      if(edges.contains(e[1], e[0])) // the mesh goes on beyond
        depths[e[0]] = depths[e[1]] = 0;
    for(int sweep = 0; sweep < far; ++sweep)
      for(const Face& f : part.faces()) {
        const int least = (std::min)({depths[f[0]], depths[f[1]], depths[f[2]]});
        for(std::size_t v : f)
          depths[v] = (std::min)(depths[v], least + 1);
      }
    return depths;
  }

  std::vector<std::size_t> m_part_of_vertex, m_part_of_face;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_COVER_H

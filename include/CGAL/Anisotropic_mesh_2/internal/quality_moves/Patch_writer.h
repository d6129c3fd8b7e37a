// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_WRITER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_WRITER_H

#include <CGAL/Anisotropic_mesh_2/internal/kernel/face_marks.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Puts a changed patch in the place of the faces that it was copied from.
//
// Faces and vertices that both have are kept, with all that the user stores in
// them; new faces take the subdomain of the old ones.
template <class Mesh>
class Patch_writer
{
  typedef Mesh_patch<Mesh>               Patch;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;

  // what lies beyond an edge of the rim
  struct Outside
  {
    int         source, target;
    Face_handle face;
    int         index;
    Edge_mark   mark;
    bool        is_in_patch;
  };

public:
  Patch_writer(Mesh& mesh, const std::vector<Face_handle>& faces) : m_mesh(mesh), m_old(faces) {}

  // `vertex_of_index` maps indices to vertices, and is kept up to date.
  void operator()(const Patch& patch, std::vector<Vertex_handle>& vertex_of_index)
  {
    find_outside(patch);
    write_vertices(patch, vertex_of_index);
    provide_faces(patch);
    for(int f = 0; f < patch.number_of_faces(); ++f)
      if(patch.faces()[f].is_used)
        write_face(patch, f);
    for(const Outside& o : m_outside)
      attach(patch, o);
  }

private:
  void find_outside(const Patch& patch)
  {
    std::size_t rank = 0;
    for(Face_handle f : m_old)
      for(int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        const bool is_in_patch = std::find(m_old.begin(), m_old.end(), g) != m_old.end();
        if(is_in_patch && !f->is_constrained(i))
          continue;
        const auto& e = patch.rim()[rank++]; // which has the same order
        m_outside.push_back({e.source, e.target, g, m_mesh.mirror_index(f, i), edge_mark(*f, i), is_in_patch});
      }
  }

  void write_vertices(const Patch& patch, std::vector<Vertex_handle>& vertex_of_index)
  {
    for(int i = 0; i < patch.number_of_vertices(); ++i) {
      const auto& v = patch.vertices()[i];
      Vertex_handle w = v.handle;
      if(patch.is_removed(i)) {
        if(w != Vertex_handle()) {
          vertex_of_index[w->index()] = Vertex_handle();
          m_mesh.tds().delete_vertex(w);
        }
        m_vertices.push_back(Vertex_handle());
        continue;
      }
      if(w == Vertex_handle()) {
        w = m_mesh.tds().create_vertex();
        w->set_index(m_mesh.vertex_index_bound());
        m_mesh.set_vertex_index_bound(w->index() + 1);
        vertex_of_index.push_back(w);
      }
      if(v.is_free) {
        w->set_point(v.point);
        w->set_metric_tensor(v.tensor);
      }
      m_vertices.push_back(w);
    }
  }

  // Finds a place for each face that is used, and gives up those that are left over.
  void provide_faces(const Patch& patch)
  {
    const Region_mark region = region_mark(*m_old.front());
    std::size_t reused = 0;
    for(const auto& f : patch.faces()) {
      Face_handle g;
      if(f.is_used && reused < m_old.size())
        g = m_old[reused++];
      else if(f.is_used) {
        g = m_mesh.tds().create_face();
        set_region_mark(*g, region);
      }
      m_faces.push_back(g);
    }
    for(; reused < m_old.size(); ++reused)
      m_mesh.tds().delete_face(m_old[reused]);
  }

  void write_face(const Patch& patch, int f)
  {
    const auto& from = patch.faces()[f];
    const Face_handle to = m_faces[f];
    for(int i = 0; i < 3; ++i) {
      to->set_vertex(i, m_vertices[from.vertex[i]]);
      to->vertex(i)->set_face(to);
      to->set_neighbor(i, from.neighbor[i] == Patch::none ? Face_handle() : m_faces[from.neighbor[i]]);
      set_edge_mark(*to, i, Edge_mark());
    }
  }

  void attach(const Patch& patch, const Outside& o)
  {
    const std::array<int, 2> inside = patch.rim_edge(o.source, o.target);
    const Face_handle f = m_faces[inside[0]];
    set_edge_mark(*f, inside[1], o.mark);
    if(o.is_in_patch) // on both sides of a constrained edge; the other one has its own turn
      f->set_neighbor(inside[1], m_faces[patch.rim_edge(o.target, o.source)[0]]);
    else
      m_mesh.tds().set_adjacency(f, inside[1], o.face, o.index);
  }

  Mesh& m_mesh;
  const std::vector<Face_handle>& m_old;
  std::vector<Outside>       m_outside;
  std::vector<Vertex_handle> m_vertices; // of the mesh, for those of the patch
  std::vector<Face_handle>   m_faces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_WRITER_H

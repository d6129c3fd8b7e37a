// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_MESH_SNAPSHOT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_MESH_SNAPSHOT_H

#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// All that the vertices and faces of a mesh hold, to be given back to them, so
// that handles stay valid. In between, no vertex and no face may be created or removed.
template <class Mesh>
class Mesh_snapshot
{
public:
  explicit Mesh_snapshot(const Mesh& mesh)
    : m_vertices(mesh.tds().vertices().begin(), mesh.tds().vertices().end()),
      m_faces(mesh.tds().faces().begin(), mesh.tds().faces().end())
  {}

  void restore(Mesh& mesh) const
  {
    auto vertex = m_vertices.begin();
    for(auto& v : mesh.tds().vertices())
      v = *vertex++;
    auto face = m_faces.begin();
    for(auto& f : mesh.tds().faces())
      f = *face++;
  }

private:
  std::vector<typename Mesh::Triangulation_data_structure::Vertex> m_vertices;
  std::vector<typename Mesh::Triangulation_data_structure::Face>   m_faces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_MESH_SNAPSHOT_H

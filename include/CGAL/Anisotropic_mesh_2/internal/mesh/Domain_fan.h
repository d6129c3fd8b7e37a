// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_DOMAIN_FAN_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_DOMAIN_FAN_H

#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The faces of the domain at a vertex, counterclockwise, in runs that the
// outside separates: a single one if the domain surrounds the vertex.
template <class Mesh>
struct Domain_fan
{
  typedef std::vector<typename Mesh::Face_handle> Run;

  std::vector<Run> runs;
  bool             is_surrounded;

  Domain_fan(const Mesh& mesh, typename Mesh::Vertex_handle v)
  {
    auto first = mesh.incident_faces(v), f = first;
    while(f->is_in_domain() && ++f != first)
      ;
    is_surrounded = f->is_in_domain();
    first = f; // the faces before this one are not in its run
    bool is_in_run = false;
    do {
      if(f->is_in_domain()) {
        if(!is_in_run)
          runs.emplace_back();
        runs.back().push_back(f);
      }
      is_in_run = f->is_in_domain();
    } while(++f != first);
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_DOMAIN_FAN_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FACES_IN_DOMAIN_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FACES_IN_DOMAIN_H

#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Collects the faces of the domain, in an order that is the same in every run.
template <class Mesh>
void faces_in_domain(const Mesh& mesh, std::vector<typename Mesh::Face_handle>& faces)
{
  faces.clear();
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      faces.push_back(f);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FACES_IN_DOMAIN_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_FLOOD_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_FLOOD_H

#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Floods a triangulation from some faces on, across every edge for which `enters(f, i)` holds.
// That must mark the neighbor, and not hold for a marked one.
template <class Face_handle, class Enters>
void flood(std::vector<Face_handle> reached, const Enters& enters)
{
  while(!reached.empty()) {
    const Face_handle f = reached.back();
    reached.pop_back();
    for(int i = 0; i < 3; ++i)
      if(enters(f, i))
        reached.push_back(f->neighbor(i));
  }
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_FLOOD_H

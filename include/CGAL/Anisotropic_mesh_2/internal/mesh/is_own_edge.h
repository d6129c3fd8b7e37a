// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_IS_OWN_EDGE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_IS_OWN_EDGE_H

#include <CGAL/Triangulation_utils_2.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// Whether an edge of the domain is to be looked at from this face of it, and not from the one beyond.
template <class Face_handle>
bool is_own_edge(Face_handle f, int i)
{
  return !f->neighbor(i)->is_in_domain() || f->vertex(Triangulation_cw_ccw_2::ccw(i))->index()
                                              < f->vertex(Triangulation_cw_ccw_2::cw(i))->index();
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_IS_OWN_EDGE_H

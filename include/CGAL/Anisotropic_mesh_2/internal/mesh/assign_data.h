// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_ASSIGN_DATA_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_ASSIGN_DATA_H

namespace CGAL::Anisotropic_mesh_2::internal {

// Gives a vertex all that another one stores, in a base of the user too, except
// for what makes up its place: its face, its point, and the tensor there.
template <class Vertex>
void assign_data(Vertex& vertex, const Vertex& source)
{
  const auto face = vertex.face();
  const auto point = vertex.point();
  const auto tensor = vertex.metric_tensor();
  vertex = source;
  vertex.set_face(face);
  vertex.set_point(point);
  vertex.set_metric_tensor(tensor);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_ASSIGN_DATA_H

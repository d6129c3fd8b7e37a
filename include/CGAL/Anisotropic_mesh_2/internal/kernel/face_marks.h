// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FACE_MARKS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FACE_MARKS_H

#include <type_traits>
#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// What faces know of their edges and of the domain. The triangulation carries it
// along whenever it replaces faces. Faces that are no model of
// `AnisotropicMeshFaceBase_2` know of constraints alone.

template <class Face, class = void>
struct Is_mesh_face : std::false_type {};

template <class Face>
struct Is_mesh_face<Face, std::void_t<decltype(std::declval<Face&>().set_edge_reference(0, 0))>> : std::true_type {};

struct Edge_mark
{
  bool is_constrained = false;
  int  reference = 0;
  bool is_boundary = false; // inside and outside change there

  friend bool operator==(const Edge_mark& m, const Edge_mark& n)
  {
    return m.is_constrained == n.is_constrained && m.reference == n.reference && m.is_boundary == n.is_boundary;
  }
};

struct Region_mark
{
  bool is_in_domain = false;
  int  subdomain_index = 0;
};

template <class Face>
Edge_mark edge_mark(const Face& f, int i)
{
  if constexpr(Is_mesh_face<Face>::value)
    return {f.is_constrained(i), f.edge_reference(i), f.is_boundary(i)};
  else
    return {f.is_constrained(i)};
}

template <class Face>
void set_edge_mark(Face& f, int i, const Edge_mark& m)
{
  f.set_constraint(i, m.is_constrained);
  if constexpr(Is_mesh_face<Face>::value) {
    f.set_edge_reference(i, m.reference);
    f.set_boundary(i, m.is_boundary);
  }
}

template <class Face>
Region_mark region_mark(const Face& f)
{
  if constexpr(Is_mesh_face<Face>::value)
    return {f.is_in_domain(), f.subdomain_index()};
  else
    return {};
}

template <class Face>
void set_region_mark(Face& f, const Region_mark& m)
{
  if constexpr(Is_mesh_face<Face>::value) {
    f.set_in_domain(m.is_in_domain);
    f.set_subdomain_index(m.subdomain_index);
  }
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FACE_MARKS_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_REQUIRED_FOR_NOW_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_REQUIRED_FOR_NOW_H

#include <CGAL/Named_function_parameters.h>

#include <set>
#include <type_traits>

namespace CGAL::Anisotropic_mesh_2::internal {

// While it lives, the vertices are required that the parameter `vertex_is_constrained_map` names.
template <class Mesh>
class Required_for_now
{
public:
  template <class NamedParameters>
  Required_for_now(Mesh& mesh, const NamedParameters& np) : m_mesh(mesh)
  {
    const auto map = CGAL::parameters::get_parameter(np, internal_np::vertex_is_constrained);
    if constexpr(!std::is_same<std::decay_t<decltype(map)>, internal_np::Param_not_found>::value) {
      for(typename Mesh::Vertex_handle v : mesh.finite_vertex_handles())
        if(!v->is_required() && get(map, v))
          m_indices.insert(v->index());
      set_required(true); // only now, since the map may throw
    }
  }

  Required_for_now(const Required_for_now&) = delete;
  Required_for_now& operator=(const Required_for_now&) = delete;

  // handles may be others by now, indices of fixed vertices stay
  ~Required_for_now()
  {
    if(!m_indices.empty())
      set_required(false);
  }

private:
  void set_required(bool is_required)
  {
    for(typename Mesh::Vertex_handle v : m_mesh.finite_vertex_handles())
      if(m_indices.count(v->index()) > 0)
        v->set_required(is_required);
  }

  Mesh&         m_mesh;
  std::set<int> m_indices;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_REQUIRED_FOR_NOW_H

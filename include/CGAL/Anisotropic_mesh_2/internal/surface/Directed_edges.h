// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_DIRECTED_EDGES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_DIRECTED_EDGES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The edges of triangles that are known by the numbers of their vertices, each
// in the direction in which its triangle has it.
class Directed_edges
{
public:
  explicit Directed_edges(const std::vector<std::array<std::size_t, 3> >& faces)
  {
    m_edges.reserve(3 * faces.size());
    for(const auto& f : faces)
      for(int i = 0; i < 3; ++i) {
        const std::size_t source = f[i], target = f[(i + 1) % 3];
        m_are_simple = m_edges.insert(key(source, target)).second && source != target && m_are_simple;
      }
  }

  // whether no two triangles have the same edge, and none joins a vertex to itself
  bool are_simple() const { return m_are_simple; }

  bool contains(std::size_t source, std::size_t target) const { return m_edges.count(key(source, target)) > 0; }

private:
  static std::uint64_t key(std::size_t source, std::size_t target)
  {
    return (std::uint64_t(source) << 32) | std::uint64_t(target);
  }

  std::unordered_set<std::uint64_t> m_edges;
  bool                              m_are_simple = true;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_DIRECTED_EDGES_H

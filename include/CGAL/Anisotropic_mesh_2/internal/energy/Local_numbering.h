// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_LOCAL_NUMBERING_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_LOCAL_NUMBERING_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Numbers the vertices that a block of faces meets, from 0 on, by their indices
// in the mesh: a hash table that is small enough to stay in the cache.
class Local_numbering
{
public:
  Local_numbering() : m_table(1024, unused) {}

  void clear()
  {
    m_indices.clear();
    std::fill(m_table.begin(), m_table.end(), unused);
  }

  const std::vector<int>& indices() const { return m_indices; }

  // the local number of a vertex, a new one if it was not met before
  std::size_t operator()(int index)
  {
    std::size_t slot = hash(index);
    for(; m_table[slot] != unused; slot = (slot + 1) % m_table.size())
      if(m_indices[m_table[slot]] == index)
        return m_table[slot];
    m_table[slot] = static_cast<std::uint32_t>(m_indices.size());
    m_indices.push_back(index);
    if(2 * m_indices.size() > m_table.size())
      grow();
    return m_indices.size() - 1;
  }

private:
  static constexpr std::uint32_t unused = ~std::uint32_t(0);

  // the size of the table is a power of two
  std::size_t hash(int index) const { return (std::uint32_t(index) * 2654435769u >> 7) & (m_table.size() - 1); }

  void grow()
  {
    m_table.assign(2 * m_table.size(), unused);
    for(std::size_t i = 0; i < m_indices.size(); ++i) {
      std::size_t slot = hash(m_indices[i]);
      while(m_table[slot] != unused)
        slot = (slot + 1) % m_table.size();
      m_table[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<std::uint32_t> m_table;
  std::vector<int>           m_indices; // by local number
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_LOCAL_NUMBERING_H

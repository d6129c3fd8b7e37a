// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACEWISE_ENERGY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACEWISE_ENERGY_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_block_assembler.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_hessian.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The energy of the anisotropic Voronoi tessellation of the vertices of a mesh
// and the moments of the regions, assembled face by face: each face is divided
// among the vertices nearby by their bisectors. Where the metric varies within
// a face, the face is quartered until it does not, so that mild metrics do not
// pay for rough ones.
//
// Faces are treated in blocks, whose sums are added in their order.
template <class Mesh, class ConcurrencyTag = Sequential_tag>
class Facewise_energy
{
  typedef std::vector<typename Mesh::Face_handle> Faces;

public:
  static constexpr bool has_couplings = true;

  Facewise_energy(const Mesh& mesh, Measure measure, const Acvt_accuracy& accuracy = Acvt_accuracy())
    : m_mesh(mesh), m_is_riemannian(measure == Measure::RIEMANNIAN),
      m_assemblers(blocks_at_once, Face_block_assembler<Mesh>(mesh, m_is_riemannian, accuracy))
  {}

  // Returns the energy and sets the moments, by the index of the vertex.
  double operator()(std::vector<Region_moments>& moments) { return assemble(moments, nullptr); }

  // Sets the couplings as well.
  double operator()(std::vector<Region_moments>& moments, Bisector_hessian& couplings)
  {
    return assemble(moments, &couplings);
  }

  // Returns the energy in the given faces alone, and adds their share to the moments.
  double add_faces(const Faces& faces, std::vector<Region_moments>& moments)
  {
    return assemble(faces, moments, nullptr);
  }

private:
  static constexpr std::size_t faces_of_block = 512;
  static constexpr std::size_t blocks_at_once = is_parallel<ConcurrencyTag> ? 128 : 1;

  double assemble(std::vector<Region_moments>& moments, Bisector_hessian* couplings)
  {
    m_faces = m_mesh.faces_in_domain();
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    return assemble(m_faces, moments, couplings);
  }

  double assemble(const Faces& faces, std::vector<Region_moments>& moments, Bisector_hessian* couplings)
  {
    const std::size_t number_of_blocks = number_of_chunks(faces.size(), faces_of_block);
    if(couplings)
      resize(*couplings, faces, number_of_blocks);
    double energy = 0;
    for(std::size_t first = 0; first < number_of_blocks; first += blocks_at_once) {
      const std::size_t n = (std::min)(blocks_at_once, number_of_blocks - first);
      for_each_task<ConcurrencyTag>(n, [&](std::size_t i) {
        assemble_block(m_assemblers[i], faces, first + i, couplings);
      });
      for(std::size_t i = 0; i < n; ++i)
        energy += add_block(m_assemblers[i], moments, couplings);
    }
    return energy;
  }

  static void assemble_block(Face_block_assembler<Mesh>& assembler, const Faces& faces, std::size_t b,
                             Bisector_hessian* couplings)
  {
    const std::size_t begin = b * faces_of_block, end = (std::min)(faces.size(), begin + faces_of_block);
    assembler(faces.data() + begin, faces.data() + end, couplings ? &couplings->block(b) : nullptr);
  }

  // with the units of a face
  void resize(Bisector_hessian& couplings, const Faces& faces, std::size_t number_of_blocks) const
  {
    double length = 1, stiffness = 1;
    if(!faces.empty()) {
      const auto u = faces.front()->vertex(0), v = faces.front()->vertex(1);
      const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
      const Weighted_tensor m(Symmetric_form(u->metric_tensor()), m_is_riemannian);
      length = (std::max)(std::abs(p.x - q.x), std::abs(p.y - q.y));
      stiffness = (m.weighted.a + m.weighted.c) * length * length;
    }
    couplings.resize(number_of_blocks, m_mesh.vertex_index_bound(), length, stiffness);
  }

  static double add_block(const Face_block_assembler<Mesh>& block, std::vector<Region_moments>& moments,
                          Bisector_hessian* couplings)
  {
    for(std::size_t i = 0; i < block.sums().size(); ++i) {
      const Region_contribution& sums = block.sums()[i];
      moments[block.vertices()[i]] += sums.moments;
      if(couplings)
        couplings->add_response(block.vertices()[i], sums.response);
    }
    return block.energy();
  }

  const Mesh& m_mesh;
  const bool  m_is_riemannian;
  std::vector<Face_block_assembler<Mesh> > m_assemblers;
  Faces                                    m_faces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACEWISE_ENERGY_H

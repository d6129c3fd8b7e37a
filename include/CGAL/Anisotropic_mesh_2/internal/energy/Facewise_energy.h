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
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// How far the logarithm of the metric may vary in a face that is not divided: much where the exact gradient of
// whatever is computed is followed, little for mass centres and for energies that are compared with others.
constexpr double quick_tolerance = 1, accurate_tolerance = 0.1;

// The energy of the anisotropic Voronoi tessellation of the vertices of a mesh,
// assembled face by face. A face is taken in the tensor of its barycentre or, where the metric
// varies, divided into parts with a tensor each; the division is chosen at the construction, so that it
// is the same energy as long as vertices move.
//
// Faces are treated in blocks, whose sums are added in their order.
template <class Mesh, class ConcurrencyTag = Sequential_tag, class Metric = Field_metric<Mesh> >
class Facewise_energy
{
  typedef std::vector<typename Mesh::Face_handle> Faces;
  typedef Face_block_assembler<Mesh, Metric>      Block;

public:
  static constexpr bool has_couplings = true;

  // The edges of a face are halved where the logarithm of the metric varies by more than `tolerance` around
  // all of its vertices, and quartered from twice that on.
  Facewise_energy(const Mesh& mesh, const Metric& metric, Measure measure, double tolerance)
    : m_mesh(mesh), m_is_riemannian(measure == Measure::RIEMANNIAN),
      m_parts(parts_at_vertices(mesh, metric, tolerance)),
      m_assemblers(blocks_at_once, Block(mesh, metric, m_parts, m_is_riemannian))
  {}

  Facewise_energy(const Facewise_energy&) = delete;

  // Returns the energy of the regions and sets their moments, by the index of the vertex.
  double operator()(std::vector<Region_moments>& moments)
  {
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    return add_faces(m_mesh.faces_in_domain(), moments);
  }

  // The same, but with the integrals of w M (x - z) replaced by minus half of the exact gradient, which differs by what
  // moves with the faces; and an approximate Hessian.
  double operator()(std::vector<Region_moments>& moments, Bisector_hessian& couplings)
  {
    const Faces faces = m_mesh.faces_in_domain();
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    resize(couplings, faces);
    return assemble(faces, [&](Block& block, const auto* begin, const auto* end, std::size_t b) {
      block.add_gradient(begin, end, couplings.block(b));
    }, [&](const Block& block) { add_block(block, moments, &couplings); });
  }

  // Returns the energy of the regions in the given faces alone, and adds their share to the moments.
  double add_faces(const Faces& faces, std::vector<Region_moments>& moments)
  {
    return assemble(faces, [&](Block& block, const auto* begin, const auto* end, std::size_t) {
      block.add_regions(begin, end);
    }, [&](const Block& block) { add_block(block, moments, nullptr); });
  }

private:
  static constexpr std::size_t faces_of_block = 512;
  static constexpr std::size_t blocks_at_once = is_parallel<ConcurrencyTag> ? 128 : 1;

  static std::vector<unsigned char> parts_at_vertices(const Mesh& mesh, const Metric& metric, double tolerance)
  {
    std::vector<unsigned char> parts(mesh.vertex_index_bound(), 1);
    for(const auto v : mesh.vertices_in_domain()) {
      const double variation = metric.variation(v);
      parts[v->index()] = variation > 2 * tolerance ? 4 : variation > tolerance ? 2 : 1;
    }
    return parts;
  }

  template <class Work, class Add>
  double assemble(const Faces& faces, const Work& work, const Add& add)
  {
    const std::size_t number_of_blocks = number_of_chunks(faces.size(), faces_of_block);
    double energy = 0;
    for(std::size_t first = 0; first < number_of_blocks; first += blocks_at_once) {
      const std::size_t n = (std::min)(blocks_at_once, number_of_blocks - first);
      for_each_task<ConcurrencyTag>(n, [&](std::size_t i) {
        const std::size_t begin = (first + i) * faces_of_block, end = (std::min)(faces.size(), begin + faces_of_block);
        work(m_assemblers[i], faces.data() + begin, faces.data() + end, first + i);
      });
      for(std::size_t i = 0; i < n; ++i) {
        energy += m_assemblers[i].energy();
        add(m_assemblers[i]);
      }
    }
    return energy;
  }

  // with the units of a face
  void resize(Bisector_hessian& couplings, const Faces& faces) const
  {
    double length = 1, stiffness = 1;
    if(!faces.empty()) {
      const auto u = faces.front()->vertex(0), v = faces.front()->vertex(1);
      const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
      const Symmetric_form m(u->metric_tensor());
      length = (std::max)(std::abs(p.x - q.x), std::abs(p.y - q.y));
      stiffness = (m_is_riemannian ? std::sqrt(m.determinant()) : 1) * (m.a + m.c) * length * length;
    }
    couplings.resize(number_of_chunks(faces.size(), faces_of_block), m_mesh.vertex_index_bound(), length, stiffness);
  }

  static void add_block(const Block& block, std::vector<Region_moments>& moments, Bisector_hessian* couplings)
  {
    for(std::size_t i = 0; i < block.sums().size(); ++i) {
      const Region_contribution& sums = block.sums()[i];
      moments[block.vertices()[i]] += sums.moments;
      if(couplings)
        couplings->add_response(block.vertices()[i], sums.response);
    }
  }

  const Mesh& m_mesh;
  const bool  m_is_riemannian;
  std::vector<unsigned char> m_parts; // by the index of the vertex
  std::vector<Block>         m_assemblers;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACEWISE_ENERGY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Acute_face.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_hessian.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_gradient.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Local_numbering.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Metric_triangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Part_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Integrates over a block of faces. The sums of the regions stay in contiguous
// arrays until the block is done.
template <class Mesh, class Metric>
class Face_block_assembler
{
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Face_handle   Face_handle;

public:
  // `parts` gives for each vertex, by its index, into how many parts edges of the faces at it may be divided.
  Face_block_assembler(const Mesh& mesh, const Metric& metric, const std::vector<unsigned char>& parts,
                       bool is_riemannian)
    : m_mesh(&mesh), m_metric(&metric), m_parts(&parts), m_is_riemannian(is_riemannian)
  {}

  // The sums are of minus half the exact gradient of the energy, and of its approximate Hessian.
  void add_gradient(const Face_handle* begin, const Face_handle* end, Bisector_hessian::Face_block& couplings)
  {
    start(begin, end);
    couplings.clear(m_numbering.indices());
    for(const Face_handle* f = begin; f != end; ++f)
      add_gradient(*f, m_corners[f - begin], couplings);
  }

  // The sums are of the moments of the regions.
  void add_regions(const Face_handle* begin, const Face_handle* end)
  {
    start(begin, end);
    for(const Face_handle* f = begin; f != end; ++f)
      add_regions(*f, m_corners[f - begin]);
  }

  double energy() const { return m_energy; }
  const std::vector<int>& vertices() const { return m_numbering.indices(); }
  const std::vector<Region_contribution>& sums() const { return m_sums; }

private:
  typedef std::array<std::uint16_t, 3> Corners;

  void start(const Face_handle* begin, const Face_handle* end)
  {
    m_numbering.clear();
    m_positions.clear();
    m_sums.clear();
    m_corners.clear();
    m_energy = 0;
    for(const Face_handle* f = begin; f != end; ++f)
      m_corners.push_back({number(*f, 0), number(*f, 1), number(*f, 2)});
  }

  std::uint16_t number(Face_handle f, int i) { return static_cast<std::uint16_t>(number(f->vertex(i))); }

  std::size_t number(Vertex_handle v)
  {
    const std::size_t i = m_numbering(v->index());
    if(i == m_sums.size()) {
      m_positions.push_back(to_doubles(v->point()));
      m_sums.emplace_back();
    }
    return i;
  }

  int parts(Face_handle f) const
  {
    const auto of = [&](int i) { return (*m_parts)[f->vertex(i)->index()]; };
    return (std::min)({of(0), of(1), of(2)});
  }

  double density(const Metric_sample& s) const { return m_is_riemannian ? s.root_of_determinant : 1; }

  void add_gradient(Face_handle f, const Corners& corners, Bisector_hessian::Face_block& couplings)
  {
    const Triangle_of_doubles z = {m_positions[corners[0]], m_positions[corners[1]], m_positions[corners[2]]};
    const int n = parts(f);
    typename Metric::Place place = m_metric->place_near(f->vertex(0));
    const Metric_sample middle = (*m_metric)(barycentre(z), place);
    const Metric_triangle t(z, middle.tensor);
    Face_gradient g;
    if(n == 1 && is_divided_by_bisectors(f, t, middle.tensor))
      Acute_face(t, middle, density(middle))
        .add_to(g, m_is_riemannian, {{&m_sums[corners[0]], &m_sums[corners[1]], &m_sums[corners[2]]}});
    else {
      add_parts(f, z, n, g);
      g.add(z, g.energy / (2 * area(z))); // in proportion to which the energy of the parts grows
    }
    m_energy += g.energy;
    const Face_response response(t, density(middle) * middle.tensor);
    for(int i = 0; i < 3; ++i) {
      Region_contribution& sum = m_sums[corners[i]];
      sum.moments.gx -= g.by_corner[i].x / 2;
      sum.moments.gy -= g.by_corner[i].y / 2;
      sum.response += response.of_corner(i);
    }
    couplings.add(corners, response.couplings());
  }

  void add_regions(Face_handle f, const Corners& corners)
  {
    const Triangle_of_doubles z = {m_positions[corners[0]], m_positions[corners[1]], m_positions[corners[2]]};
    const int n = parts(f);
    if(n == 1) {
      typename Metric::Place place = m_metric->place_near(f->vertex(0));
      const Metric_sample middle = (*m_metric)(barycentre(z), place);
      const Metric_triangle t(z, middle.tensor);
      if(is_divided_by_bisectors(f, t, middle.tensor)) {
        m_energy += Acute_face(t, middle, density(middle))
          .add_to({{&m_sums[corners[0]].moments, &m_sums[corners[1]].moments, &m_sums[corners[2]].moments}});
        return;
      }
    }
    Face_gradient ignored;
    add_parts(f, z, n, ignored);
    m_energy += ignored.energy;
  }

  // Adds the moments of the regions, which make up the gradient together with the derivatives by what moves with the
  // face.
  void add_parts(Face_handle f, const Triangle_of_doubles& z, int n, Face_gradient& g)
  {
    const Part_generators generators = generators_near(f);
    typename Metric::Place place = m_metric->place_near(f->vertex(0));
    for(const Face_part& part : parts_of_face(n)) {
      const Metric_sample s = (*m_metric)(point_of(z, part.barycentre), place);
      Part_integrator integrate(part.corners(z), s.tensor, density(s));
      integrate(generators);
      g.add(part, integrate.gradient());
      g.add(part.barycentre, s, integrate.energy(), integrate.by_tensor(), m_is_riemannian);
    }
  }

  // whether the bisectors of its corners alone divide a face, and meet in it
  bool is_divided_by_bisectors(Face_handle f, const Metric_triangle& t, const Symmetric_form& m) const
  {
    return t.is_acute() && !has_obtuse_neighbor(f, t.corner, m);
  }

  // In an obtuse neighbor the vertex opposite to the common edge is nearer to a
  // part of this face than its own vertices.
  bool has_obtuse_neighbor(Face_handle f, const Triangle_of_doubles& z, const Symmetric_form& m) const
  {
    for(int i = 0; i < 3; ++i) {
      if(!f->neighbor(i)->is_in_domain())
        continue;
      const Vector_of_doubles &p = z[(i + 1) % 3], &q = z[(i + 2) % 3];
      const Vector_of_doubles o = to_doubles(m_mesh->mirror_vertex(f, i)->point());
      if(m(p.x - o.x, p.y - o.y, q.x - o.x, q.y - o.y) < 0)
        return true;
    }
    return false;
  }

  // the vertices of the face and of its neighbors
  Part_generators generators_near(Face_handle f)
  {
    boost::container::static_vector<std::size_t, 6> numbers;
    for(int i = 0; i < 3; ++i)
      numbers.push_back(number(f->vertex(i)));
    for(int i = 0; i < 3; ++i)
      if(f->neighbor(i)->is_in_domain())
        numbers.push_back(number(m_mesh->mirror_vertex(f, i)));
    Part_generators generators; // when no more are numbered, since sums move in memory
    for(std::size_t i : numbers)
      generators.push_back({m_positions[i], &m_sums[i].moments});
    return generators;
  }

  const Mesh*   m_mesh;
  const Metric* m_metric;
  const std::vector<unsigned char>* m_parts;
  bool          m_is_riemannian;

  // the current block; by local number
  Local_numbering                  m_numbering;
  Vectors                          m_positions;
  std::vector<Region_contribution> m_sums;
  std::vector<Corners>             m_corners;
  double                           m_energy = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H

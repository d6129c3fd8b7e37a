// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Acute_element_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Clipped_element_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Local_numbering.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_hessian.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// How elements are chosen.
struct Acvt_accuracy
{
  double linear = 0.03;    // up to this variation of the metric within an element, it is linear there
  double guess = 0.1;      // up to this, edges are not sampled
  double tolerance = 0.5;  // up to this, an element is left as it is
  int maximum_depth = 2;   // of the quartering of faces where it varies more
};

// Integrates over a block of faces: divides each face among the vertices nearby.
// All that a face needs of its vertices is gathered in contiguous arrays, and
// the sums of the regions stay there until the block is done.
template <class Mesh>
class Face_block_assembler
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef typename Mesh::Edge            Edge;

public:
  Face_block_assembler(const Mesh& mesh, bool is_riemannian, const Acvt_accuracy& accuracy)
    : m_mesh(&mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_is_riemannian(is_riemannian), m_accuracy(accuracy)
  {}

  // `couplings` may be null
  void operator()(const Face_handle* begin, const Face_handle* end, Bisector_hessian::Face_block* couplings)
  {
    m_numbering.clear();
    m_generators.clear();
    m_sums.clear();
    m_corners.clear();
    m_energy = 0;
    for(const Face_handle* f = begin; f != end; ++f)
      m_corners.push_back({number(*f, 0), number(*f, 1), number(*f, 2)});
    if(couplings)
      couplings->clear(m_numbering.indices());
    for(const Face_handle* f = begin; f != end; ++f)
      add_face(*f, m_corners[f - begin], couplings);
  }

  double energy() const { return m_energy; }
  const std::vector<int>& vertices() const { return m_numbering.indices(); }
  const std::vector<Region_contribution>& sums() const { return m_sums; }

private:
  typedef Clipped_element_integrator::Generators Generators;
  typedef std::array<std::uint16_t, 3>           Corners;

  struct Local_generator
  {
    Vector_of_doubles position;
    Weighted_tensor   tensor;
  };

  std::uint16_t number(Face_handle f, int i) { return static_cast<std::uint16_t>(number(f->vertex(i))); }

  std::size_t number(Vertex_handle v)
  {
    const std::size_t i = m_numbering(v->index());
    if(i == m_generators.size()) {
      m_generators.push_back({to_doubles(v->point()),
                              Weighted_tensor(Symmetric_form(v->metric_tensor()), m_is_riemannian)});
      m_sums.emplace_back();
    }
    return i;
  }

  Weighted_tensor tensor_at(const Vector_of_doubles& x) const
  {
    return Weighted_tensor(Symmetric_form(m_tensor(point_at<Point>(x.x, x.y))), m_is_riemannian);
  }

  static double square(double x) { return x*x; }

  void prepare_interpolation(Acvt_element& e, double squared_variation) const
  {
    if(squared_variation <= square(m_accuracy.linear))
      e.forget_bends();
    else if(squared_variation <= square(m_accuracy.guess))
      e.guess_bends();
    else
      e.sample_bends([this](const Vector_of_doubles& x) { return tensor_at(x); });
  }

  void add_face(Face_handle f, const Corners& corners, Bisector_hessian::Face_block* block)
  {
    Acvt_element e;
    for(int i = 0; i < 3; ++i) {
      e.corner[i] = m_generators[corners[i]].position;
      e.tensor[i] = m_generators[corners[i]].tensor;
    }
    e.middle = tensor_at(e.barycentre());
    Face_couplings sum, *couplings = block ? &sum : nullptr;
    m_energy += add_face(f, corners, e, couplings);
    if(block)
      block->add(corners, sum);
  }

  double add_face(Face_handle f, const Corners& corners, Acvt_element& e, Face_couplings* couplings)
  {
    const double squared_variation = e.squared_variation();
    if(squared_variation > square(m_accuracy.tolerance))
      return add_refined(e, generators_near(f, 2), m_accuracy.maximum_depth, couplings);
    prepare_interpolation(e, squared_variation);
    Acute_element_integrator acute;
    if(acute.prepare(e) && !has_obtuse_neighbor(f, e))
      return acute(e, {&m_sums[corners[0]], &m_sums[corners[1]], &m_sums[corners[2]]}, couplings);
    return Clipped_element_integrator()(e, generators_near(f, 1), couplings);
  }

  // In an obtuse neighbor the vertex opposite to the common edge is nearer to a
  // part of this face than its own vertices.
  bool has_obtuse_neighbor(Face_handle f, const Acvt_element& e) const
  {
    for(int i = 0; i < 3; ++i) {
      const Face_handle g = f->neighbor(i);
      if(!g->is_in_domain())
        continue;
      const Vector_of_doubles &p = e.corner[(i + 1) % 3], &q = e.corner[(i + 2) % 3];
      const Vector_of_doubles o = to_doubles(g->vertex(Mesh::ccw(g->index(f->vertex(Mesh::ccw(i)))))->point());
      if(e.middle.m(p.x - o.x, p.y - o.y, q.x - o.x, q.y - o.y) < 0)
        return true;
    }
    return false;
  }

  double add_refined(Acvt_element& e, const Generators& generators, int depth, Face_couplings* couplings) const
  {
    const double squared_variation = e.squared_variation();
    if(depth == 0 || squared_variation <= square(m_accuracy.tolerance)) {
      prepare_interpolation(e, squared_variation);
      return Clipped_element_integrator()(e, generators, couplings);
    }
    std::array<Vector_of_doubles, 3> middle; // of the edge opposite to the corner
    std::array<Weighted_tensor, 3> tensor;
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = e.corner[(i + 1) % 3], &q = e.corner[(i + 2) % 3];
      middle[i] = {(p.x + q.x) / 2, (p.y + q.y) / 2};
      tensor[i] = tensor_at(middle[i]);
    }
    const auto add_part = [&](const std::array<Vector_of_doubles, 3>& corner,
                              const std::array<Weighted_tensor, 3>& tensors)
    {
      Acvt_element part;
      part.corner = corner;
      part.tensor = tensors;
      part.middle = tensor_at(part.barycentre());
      return add_refined(part, generators, depth - 1, couplings);
    };
    double energy = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      energy += add_part({e.corner[i], middle[k], middle[j]}, {e.tensor[i], tensor[k], tensor[j]});
    }
    return energy + add_part(middle, tensor);
  }

  // the vertices of the face and of the faces up to `rings` edges away
  Generators generators_near(Face_handle f, int rings)
  {
    std::array<std::size_t, 12> numbers;
    std::size_t n = 0;
    for(int i = 0; i < 3; ++i)
      numbers[n++] = number(f->vertex(i));
    for(int i = 0; i < 3; ++i)
      add_numbers_beyond(m_mesh->mirror_edge(Edge(f, i)), rings, numbers, n);
    Generators generators; // when no more are numbered, since sums move in memory
    for(std::size_t i = 0; i < n; ++i)
      generators.push_back({m_generators[numbers[i]].position, &m_sums[numbers[i]], i < 3 ? int(i) : -1, {}});
    return generators;
  }

  void add_numbers_beyond(const Edge& e, int rings, std::array<std::size_t, 12>& numbers, std::size_t& n)
  {
    if(rings == 0 || !e.first->is_in_domain())
      return;
    const std::size_t i = number(e.first->vertex(e.second));
    if(std::find(numbers.begin(), numbers.begin() + n, i) == numbers.begin() + n)
      numbers[n++] = i;
    add_numbers_beyond(m_mesh->mirror_edge(Edge(e.first, Mesh::ccw(e.second))), rings - 1, numbers, n);
    add_numbers_beyond(m_mesh->mirror_edge(Edge(e.first, Mesh::cw(e.second))), rings - 1, numbers, n);
  }

  const Mesh* m_mesh;
  typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  bool          m_is_riemannian;
  Acvt_accuracy m_accuracy;

  // the current block; by local number
  Local_numbering              m_numbering;
  std::vector<Local_generator> m_generators;
  std::vector<Region_contribution>     m_sums;
  std::vector<Corners>         m_corners;
  double                       m_energy = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_BLOCK_ASSEMBLER_H

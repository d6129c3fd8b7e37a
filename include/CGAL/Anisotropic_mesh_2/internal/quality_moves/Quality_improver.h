// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_memo.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_improver.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Quality_acceptance.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Improves the badly shaped faces of a mesh, the worst ones first, each within
// the patch of the two rings of faces around it.
//
// In an optimized mesh these are where vertices of degree 5 and 7 are close to
// each other or to the boundary, and where the metric changes much within a
// face: there the tessellation of least energy has no faces of good shape.
// Elsewhere nothing is touched. If the field fails, the mesh has been improved
// in some places, and in no other changed.
template <class Mesh>
class Quality_improver
{
  typedef Mesh_patch<Mesh>               Patch;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;

  typedef std::array<int, 3>               Indices;  // of the vertices of a face, the least one first
  typedef std::pair<double, Indices>       Bad_face; // with its quality

public:
  Quality_improver(Mesh& mesh, Sampled_metric<Mesh>& metric, const Time_budget& time)
    : m_mesh(mesh), m_metric(metric), m_time(time), m_vertex(mesh.vertex_index_bound()), m_changed(m_vertex.size(), 0),
      m_maximum_of_trials(mesh.number_of_faces() / 16 + 512),
      m_maximum_of_evaluations(evaluations_per_vertex * mesh.number_of_vertices()),
      m_least_number(least_number_of_vertices()), m_field(mesh)
  {
    for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
      m_vertex[v->index()] = v;
  }

  // Returns why it ended: no face is badly shaped, none of those that are can be improved, the time
  // is spent, or there have been as many rounds or trials as are permitted.
  Mesh_optimization_return_code operator()()
  {
    Mesh_optimization_return_code code = MAX_ITERATION_NUMBER_REACHED;
    for(int round = 1; code == MAX_ITERATION_NUMBER_REACHED && round <= maximum_of_rounds; ++round)
      code = improve_bad_faces(round);
    close_gaps();
    return code;
  }

  std::size_t number_of_trials() const { return m_trials; }
  std::size_t number_of_improvements() const { return m_improvements; }

private:
  static constexpr double target = 0.88;
  static constexpr int    maximum_of_rounds = 3;
  static constexpr int    rings = 2;
  static constexpr std::size_t evaluations_per_vertex = 29; // besides those for vertices that move

  // returns `MAX_ITERATION_NUMBER_REACHED` if another round may be of use
  Mesh_optimization_return_code improve_bad_faces(int round)
  {
    const std::vector<Bad_face> bad = bad_faces();
    if(bad.empty())
      return CONVERGENCE_REACHED;
    const std::size_t before = m_improvements;
    for(const Bad_face& b : bad) {
      const Face_handle f = has_changed(b.second, round) ? face(b.second) : Face_handle();
      if(f == Face_handle() || quality(f) >= target)
        continue;
      if(m_trials == m_maximum_of_trials)
        return MAX_ITERATION_NUMBER_REACHED;
      if(m_time.is_spent())
        return TIME_LIMIT_REACHED;
      ++m_trials;
      m_improvements += improve_around(f, round);
    }
    return m_improvements > before || m_has_skipped ? MAX_ITERATION_NUMBER_REACHED : CANT_IMPROVE_ANYMORE;
  }

  double quality(Face_handle f) const
  {
    return metric_quality(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                          m_metric.tensor(barycentre(triangle_of_doubles(f)), f->vertex(0)));
  }

  std::vector<Bad_face> bad_faces() const
  {
    std::vector<Bad_face> result;
    for(Face_handle f : m_mesh.faces_in_domain()) {
      const double q = quality(f);
      if(q >= target)
        continue;
      Indices v{{f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()}};
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      result.push_back({q, v});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // the face of these vertices, if it is still there
  Face_handle face(const Indices& v) const
  {
    Face_handle f;
    const bool are_there = std::all_of(v.begin(), v.end(), [&](int i) { return m_vertex[i] != Vertex_handle(); });
    return are_there && m_mesh.is_face(m_vertex[v[0]], m_vertex[v[1]], m_vertex[v[2]], f) ? f : Face_handle();
  }

  // A trial that failed is repeated only if a vertex has been changed since the round before.
  bool has_changed(const Indices& v, int round) const
  {
    return round == 1 || std::any_of(v.begin(), v.end(), [&](int i) { return m_changed[i] >= round - 1; });
  }

  bool improve_around(Face_handle f, int round)
  {
    const Patch start(m_mesh, m_metric, patch_around(f));
    if(!start.is_accurate() && are_evaluations_spent())
      return false;
    Quality_acceptance<Patch> accept(start, target);
    const bool may_collapse = m_mesh.number_of_vertices() > m_least_number;
    Patch_improver<Patch, Quality_acceptance<Patch> > improver(start, accept, may_collapse);
    const std::unique_ptr<Patch> best = improver(target + 0.01); // leaves other vertices at their mass centres
    if(best == nullptr || !holds_in_field(start, *best))
      return false;
    for(Vertex_handle v : start.mesh_vertices())
      m_vertex[v->index()] = Vertex_handle();
    best->write_to(m_mesh);
    m_vertex.resize(m_mesh.vertex_index_bound());
    m_changed.resize(m_vertex.size(), round);
    for(auto v = best->tds().vertices_begin(); v != best->tds().vertices_end(); ++v) {
      const Vertex_handle w = best->mesh_vertices()[v->index()];
      m_vertex[w->index()] = w;
      if(Patch::is_free(v))
        m_changed[w->index()] = round;
    }
    return true;
  }

  bool are_evaluations_spent()
  {
    const bool result = m_field.number_of_evaluations() > m_maximum_of_evaluations;
    m_has_skipped = m_has_skipped || result;
    return result;
  }

  // Gives the patch the tensors of the field. Where samples say little, it must be better in these too.
  bool holds_in_field(const Patch& start, Patch& best)
  {
    const bool is_accurate = start.is_accurate() && best.is_accurate();
    if(!is_accurate && are_evaluations_spent())
      return false;
    best.take_tensors_from_field();
    if(!is_accurate) {
      Patch before = start;
      before.use_field(m_field);
      best.use_field(m_field);
      if(!Quality_acceptance<Patch>(before, target)(best))
        return false;
    }
    const Edge_swapper<Patch> swap; // should rounding have decided before
    swap(best);
    return swap.keeps_border(best);
  }

  // A little less than a unit mesh has, or than the mesh has if that is less: removing vertices raises qualities, but
  // is not what the metric asks for.
  std::size_t least_number_of_vertices() const
  {
    const std::vector<Face_handle> faces = m_mesh.faces_in_domain();
    const double metric_area
      = estimated_metric_area<typename Mesh::Point>(faces, m_mesh.geom_traits().construct_metric_tensor_2_object());
    // the boundary has as many vertices more than faces account for
    const double unit_number = ideal_number_of_vertices(metric_area)
                             + double(m_mesh.number_of_vertices()) - double(faces.size()) / 2;
    return std::size_t(0.97 * (std::min)(unit_number, double(m_mesh.number_of_vertices())));
  }

  // Faces beyond a constrained edge do not belong to the patch, unless they can be reached around its end.
  std::vector<Face_handle> patch_around(Face_handle center)
  {
    std::vector<Face_handle> faces(1, center);
    for(int ring = 0; ring < rings; ++ring) {
      std::vector<Vertex_handle> inner;
      for(Face_handle f : faces)
        inner.insert(inner.end(), {f->vertex(0), f->vertex(1), f->vertex(2)});
      std::sort(inner.begin(), inner.end());
      const auto is_inner = [&](Vertex_handle v) { return std::binary_search(inner.begin(), inner.end(), v); };
      for(std::size_t k = 0; k < faces.size(); ++k)
        for(int i = 0; i < 3; ++i) {
          const Face_handle f = faces[k], g = f->neighbor(i);
          if(!f->is_constrained(i) && are_alike(f, g)
             && (is_inner(g->vertex(0)) || is_inner(g->vertex(1)) || is_inner(g->vertex(2)))
             && std::find(faces.begin(), faces.end(), g) == faces.end())
            faces.push_back(g);
        }
    }
    return faces;
  }

  bool are_alike(Face_handle f, Face_handle g) const
  {
    return !m_mesh.is_infinite(g) && f->is_in_domain() == g->is_in_domain()
        && f->subdomain_index() == g->subdomain_index();
  }

  // Gives the indices of removed vertices to the last ones, so that there are no more indices than needed.
  void close_gaps()
  {
    std::size_t gap = 0;
    while(!m_vertex.empty()) {
      const Vertex_handle last = m_vertex.back();
      if(last != Vertex_handle()) {
        while(gap < m_vertex.size() && m_vertex[gap] != Vertex_handle())
          ++gap;
        if(gap == m_vertex.size() || m_mesh.is_fixed(last)) // which keeps its index
          break;
        last->set_index(int(gap));
        m_vertex[gap] = last;
      }
      m_vertex.pop_back();
    }
    m_mesh.set_vertex_index_bound(int(m_vertex.size()));
  }

  Mesh&                      m_mesh;
  Sampled_metric<Mesh>&      m_metric;
  const Time_budget&         m_time;
  std::vector<Vertex_handle> m_vertex;  // by index
  std::vector<int>           m_changed; // by index: the round in which the vertex was last free to move
  const std::size_t          m_maximum_of_trials, m_maximum_of_evaluations, m_least_number;
  std::size_t                m_trials = 0, m_improvements = 0;
  Field_memo<Mesh>           m_field; // where samples say little
  bool                       m_has_skipped = false; // a patch that would have needed it
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H

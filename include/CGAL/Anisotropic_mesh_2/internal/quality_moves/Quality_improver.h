// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_optimizer.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_writer.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Betters the badly shaped faces of a mesh, the worst ones first, each within
// the patch of the two rings of faces around it.
//
// In an optimized mesh these are where vertices of degree 5 and 7 are close to
// each other or to the boundary, and where the metric changes much within a
// face: there the tessellation of least energy has no faces of good shape.
// Elsewhere nothing is touched. If the field fails, the mesh has been bettered
// in some places, and in no other changed.
template <class Mesh>
class Quality_improver
{
  typedef Mesh_patch<Mesh>               Patch;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;

  struct Bad_face
  {
    double             quality;
    std::array<int, 3> index; // of its vertices, the least one first

    bool operator<(const Bad_face& b) const
    {
      return quality != b.quality ? quality < b.quality : index < b.index;
    }
  };

public:
  Quality_improver(Mesh& mesh, const Time_budget& time)
    : m_mesh(mesh), m_time(time), m_vertex(mesh.vertex_index_bound()), m_seen(m_vertex.size(), 0), m_changed(m_vertex.size(), 0),
      m_maximum_of_trials(mesh.number_of_faces() / 16 + 512)
  {
    for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
      m_vertex[v->index()] = v;
  }

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

  // returns `MAX_ITERATION_NUMBER_REACHED` if another round may be of use
  Mesh_optimization_return_code improve_bad_faces(int round)
  {
    const std::vector<Bad_face> bad = bad_faces();
    if(bad.empty())
      return CONVERGENCE_REACHED;
    const std::size_t before = m_improvements;
    for(const Bad_face& b : bad) {
      if(m_trials == m_maximum_of_trials)
        return MAX_ITERATION_NUMBER_REACHED;
      if(m_time.is_spent())
        return TIME_LIMIT_REACHED;
      if(is_worth_a_trial(b, round)) {
        ++m_trials;
        m_improvements += improve_around(face(b), round);
      }
    }
    return m_improvements > before ? MAX_ITERATION_NUMBER_REACHED : CANT_IMPROVE_ANYMORE;
  }

  double quality(Face_handle f) const
  {
    return quality_at_barycentre(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                                 m_mesh.geom_traits().construct_metric_tensor_2_object());
  }

  std::vector<Bad_face> bad_faces() const
  {
    std::vector<Bad_face> result;
    for(Face_handle f : m_mesh.faces_in_domain()) {
      const double q = quality(f);
      if(q >= target)
        continue;
      Bad_face b{q, {{f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()}}};
      std::rotate(b.index.begin(), std::min_element(b.index.begin(), b.index.end()), b.index.end());
      result.push_back(b);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // the face, if it is still there
  Face_handle face(const Bad_face& b) const
  {
    Face_handle f;
    for(int i : b.index)
      if(m_vertex[i] == Vertex_handle())
        return f;
    const bool is_there = m_mesh.is_face(m_vertex[b.index[0]], m_vertex[b.index[1]], m_vertex[b.index[2]], f);
    return is_there ? f : Face_handle();
  }

  // A trial that failed is repeated only if something has changed.
  bool is_worth_a_trial(const Bad_face& b, int round) const
  {
    bool has_changed = round == 1;
    for(int i : b.index)
      has_changed = has_changed || m_changed[i] >= round - 1;
    const Face_handle f = has_changed ? face(b) : Face_handle();
    return f != Face_handle() && quality(f) < target;
  }

  bool improve_around(Face_handle f, int round)
  {
    const std::vector<Face_handle> faces = patch_around(f);
    const Patch start(m_mesh, faces);
    Patch_optimizer<Mesh> improve(m_mesh, start, target);
    if(!improve())
      return false;
    for(const auto& v : improve.best().vertices())
      if(v.is_free && v.handle != Vertex_handle())
        m_changed[v.handle->index()] = round;
    Patch_writer<Mesh>(m_mesh, faces)(improve.best(), m_vertex);
    m_changed.resize(m_vertex.size(), round);
    m_seen.resize(m_vertex.size(), 0);
    return true;
  }

  // Faces beyond a constrained edge do not belong to the patch, unless they can be reached around its end.
  std::vector<Face_handle> patch_around(Face_handle center)
  {
    std::vector<Face_handle> faces(1, center);
    for(int ring = 0; ring < rings; ++ring) {
      ++m_stamp;
      for(Face_handle f : faces)
        for(int i = 0; i < 3; ++i)
          m_seen[f->vertex(i)->index()] = m_stamp;
      for(std::size_t k = 0; k < faces.size(); ++k)
        for(int i = 0; i < 3; ++i) {
          const Face_handle f = faces[k], g = f->neighbor(i);
          if(!f->is_constrained(i) && are_alike(f, g) && touches_seen_vertex(g)
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

  bool touches_seen_vertex(Face_handle f) const
  {
    return m_seen[f->vertex(0)->index()] == m_stamp || m_seen[f->vertex(1)->index()] == m_stamp
        || m_seen[f->vertex(2)->index()] == m_stamp;
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
  const Time_budget&         m_time;
  std::vector<Vertex_handle> m_vertex;  // by index
  std::vector<std::size_t>   m_seen;    // by index: when the vertex was last seen
  std::vector<int>           m_changed; // by index: the round in which the vertex was last moved
  std::size_t                m_stamp = 0;
  const std::size_t          m_maximum_of_trials;
  std::size_t                m_trials = 0, m_improvements = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_IMPROVER_H

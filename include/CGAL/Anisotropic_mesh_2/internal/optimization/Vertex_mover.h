// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_MOVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_MOVER_H

#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Free_vertices.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Mesh_snapshot.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/restore_connectivity.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Moves the free vertices of a mesh in place. A vertex whose move would invert
// a face goes only a part of its way; afterwards the criterion of the
// triangulation is restored by flips.
template <class Mesh, class Metric = Field_metric<Mesh>, class ConcurrencyTag = Sequential_tag>
class Vertex_mover
{
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef std::vector<double>            Array; // of coordinates, as `Free_vertices` has them

public:
  Vertex_mover(Mesh& mesh, Metric& metric)
    : m_mesh(mesh), m_metric(metric), m_free(mesh, metric), m_faces(mesh.faces_in_domain()), m_given(mesh)
  {}

  const Free_vertices<Mesh>& free_vertices() const { return m_free; }

  // Moves the free vertices towards `target`; they end there or, where faces
  // would turn over, on the way. Should the field fail at one of them, all stay where they are.
  void move_to(const Array& target)
  {
    const Array start = m_free.positions();
    m_free.template set_positions<ConcurrencyTag>(target);
    untangle(start, target);
    try {
      set_tensors(m_metric);
    }
    catch(...) {
      m_free.template set_positions<ConcurrencyTag>(start);
      throw;
    }
    restore_connectivity<ConcurrencyTag>(m_mesh, m_faces, m_metric);
  }

  // Remembers the mesh as it is.
  void keep() { m_kept.emplace(m_mesh); }

  // Gives the mesh back as it was at the beginning, or when it was kept last, with the same handles.
  void restore_given() { m_given.restore(m_mesh); }
  void restore_kept() { m_kept->restore(m_mesh); }

  // Sets the tensors of the field itself.
  void finish()
  {
    const Field_metric<Mesh> field(m_mesh);
    set_tensors(field);
    restore_connectivity<ConcurrencyTag>(m_mesh, m_faces, m_metric);
  }

private:
  static constexpr int halvings = 6;

  // Halves, again and again, the moves of the free vertices of inverted faces,
  // until none is left; from some point on the moves are taken back at once.
  // In each round a vertex is shortened, so that there is an end to it.
  void untangle(const Array& start, const Array& target)
  {
    std::vector<Face_handle> inverted = inverted_faces();
    if(inverted.empty())
      return;
    std::vector<unsigned char> shortened(m_free.size(), 0);
    const std::vector<int> ranks = ranks_of_vertices();
    while(!inverted.empty()) {
      std::vector<int> to_shorten;
      for(Face_handle f : inverted)
        for(int i = 0; i < 3; ++i) {
          const int rank = ranks[f->vertex(i)->index()];
          if(rank >= 0 && shortened[rank] <= halvings)
            to_shorten.push_back(rank);
        }
      std::sort(to_shorten.begin(), to_shorten.end());
      to_shorten.erase(std::unique(to_shorten.begin(), to_shorten.end()), to_shorten.end());
      for(int i : to_shorten) {
        const double t = ++shortened[i] > halvings ? 0 : 1. / (1 << shortened[i]);
        m_free[i]->set_point(m_free.point_between(start, target, t, i));
      }
      inverted = inverted_faces_around(to_shorten);
    }
  }

  std::vector<Face_handle> inverted_faces() const
  {
    return selected_of_chunks<ConcurrencyTag, Face_handle>(m_faces.size(), [&](std::size_t i, auto& inverted) {
      if(is_inverted(m_faces[i]))
        inverted.push_back(m_faces[i]);
    });
  }

  std::vector<Face_handle> inverted_faces_around(const std::vector<int>& ranks) const
  {
    std::vector<Face_handle> inverted;
    for(int i : ranks) {
      auto f = m_mesh.incident_faces(m_free[i]), done(f);
      do {
        if(is_inverted(f))
          inverted.push_back(f);
      } while(++f != done);
    }
    return inverted;
  }

  // by index, -1 for the vertices that stay
  std::vector<int> ranks_of_vertices() const
  {
    std::vector<int> ranks(m_mesh.vertex_index_bound(), -1);
    for(std::size_t i = 0; i < m_free.size(); ++i)
      ranks[m_free[i]->index()] = static_cast<int>(i);
    return ranks;
  }

  bool is_inverted(Face_handle f) const
  {
    return m_mesh.orientation(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) != LEFT_TURN;
  }

  // Sets all tensors or, if the field fails at a vertex, none.
  template <class AnyMetric>
  void set_tensors(AnyMetric& metric)
  {
    m_tensors.resize(m_free.size());
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) { m_tensors[i] = metric(m_free[i]); });
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) { m_free[i]->set_metric_tensor(m_tensors[i]); });
  }

  Mesh&   m_mesh;
  Metric& m_metric;
  Free_vertices<Mesh>        m_free;
  std::vector<Face_handle>   m_faces; // of the domain; flips only change what they hold
  const Mesh_snapshot<Mesh>           m_given;
  std::optional<Mesh_snapshot<Mesh> > m_kept;
  std::vector<typename Mesh::Metric_tensor_2> m_tensors;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_MOVER_H

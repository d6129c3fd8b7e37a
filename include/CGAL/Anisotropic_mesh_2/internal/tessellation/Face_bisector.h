// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_BISECTOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_BISECTOR_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_divider.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Bisects the faces of a subdivision until each one lies in the regions of at
// most three generators in a way that the metric within it cannot upset, and divides them.
//
// Edges are bisected that are the longest of both their faces, so that no face
// has a vertex within an edge and faces do not become needles.
//
// Faces are examined in rounds, at the same time with `Parallel_tag`; those that
// are refused are bisected one after the other before the next round.
template <class Generators, class ConcurrencyTag>
class Face_bisector
{
  typedef Region_tds::Vertex_handle Vertex_handle;
  typedef Region_tds::Face_handle   Face_handle;
  typedef Region_tds::Edge          Edge;

public:
  Face_bisector(const Generators& generators, double tolerance, Region_tds& tds)
    : m_generators(generators), m_tolerance(tolerance),
      m_maximum_number_of_vertices(200000 + 200 * generators.set().size()), m_tds(tds)
  {}

  void operator()()
  {
    std::vector<Face_handle> pending = m_tds.faces_in_domain();
    while(!pending.empty())
      pending = bisect(examine(pending));
  }

private:
  // Bisectors pass through the midpoints of generators, where vertices would
  // have two nearest generators: edges are cut a little off their midpoints.
  static constexpr double place_of_cut = 0.46;

  static constexpr std::size_t faces_of_chunk = 64;

  // Divides faces among the generators; returns those that are to be bisected.
  std::vector<Face_handle> examine(const std::vector<Face_handle>& pending) const
  {
    const bool is_last = m_tds.number_of_vertices() > m_maximum_number_of_vertices;
    std::vector<std::vector<Face_handle> > refused(number_of_chunks(pending.size(), faces_of_chunk));
    for_each_chunk<ConcurrencyTag>(pending.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      Face_divider<Generators> divide(m_generators, m_tolerance);
      for(std::size_t i = begin; i < end; ++i) {
        const Face_handle f = pending[i];
        Face_division d;
        d.corner = {&f->vertex(0)->point, &f->vertex(1)->point, &f->vertex(2)->point};
        f->is_pending = false;
        if(!divide(is_last, d))
          refused[chunk].push_back(f);
        else if(d.number_of_labels() > 1)
          f->division = std::make_shared<Face_division>(std::move(d));
      }
    }, faces_of_chunk);
    return joined(std::move(refused));
  }

  // Bisects faces that have been refused, and others on the way; returns the faces to be examined next.
  std::vector<Face_handle> bisect(const std::vector<Face_handle>& refused)
  {
    std::vector<Face_handle> pending;
    for(Face_handle f : refused) {
      while(!f->is_pending && m_tds.number_of_vertices() <= m_maximum_number_of_vertices)
        cut(last_edge_of_path(f), pending);
      add_pending(f, pending); // if the bisection ends early
    }
    return pending;
  }

  static void add_pending(Face_handle f, std::vector<Face_handle>& pending)
  {
    f->division.reset();
    if(f->is_pending)
      return;
    f->is_pending = true;
    pending.push_back(f);
  }

  // From the longest edge of the face on to the longest one of the face beyond,
  // until an edge is the longest one of both its faces, or for a number of
  // steps that only needles in the metric need.
  Edge last_edge_of_path(Face_handle f) const
  {
    Edge e = longest_edge(f);
    for(int step = 0; step < 20; ++step) {
      const Edge mirror = m_tds.mirror_edge(e);
      if(!mirror.first->is_in_domain)
        break;
      const Edge next = longest_edge(mirror.first);
      if(next == mirror)
        break;
      e = next;
    }
    return e;
  }

  // The order is total, and the same from both sides of the edges: so paths end.
  Edge longest_edge(Face_handle f) const
  {
    typedef std::pair<double, std::pair<std::size_t, std::size_t> > Rank;
    Rank greatest;
    int longest = 0;
    for(int i = 0; i < 3; ++i) {
      const auto uv = ends(Edge(f, i));
      const Rank rank(length(uv.first->point, uv.second->point), {uv.first->id, uv.second->id});
      if(i == 0 || greatest < rank) {
        greatest = rank;
        longest = i;
      }
    }
    return Edge(f, longest);
  }

  // Simpson's rule: a part of an edge must not be longer than the whole, or
  // paths would go round among edges that nearly coincide.
  double length(const Metric_point& p, const Metric_point& q) const
  {
    const double x = q.at.x - p.at.x, y = q.at.y - p.at.y;
    const Metric_point middle = m_generators.metric_point_at({p.at.x + x / 2, p.at.y + y / 2});
    return length_by_simpson(p.m, middle.m, q.m, x, y);
  }

  static std::pair<Vertex_handle, Vertex_handle> ends(const Edge& e)
  {
    const Vertex_handle u = e.first->vertex(Region_tds::ccw(e.second)), v = e.first->vertex(Region_tds::cw(e.second));
    return u->id < v->id ? std::make_pair(u, v) : std::make_pair(v, u);
  }

  void cut(const Edge& e, std::vector<Face_handle>& pending)
  {
    const auto uv = ends(e);
    const Vector_of_doubles p = uv.first->point.at, q = uv.second->point.at;
    const Metric_point x = m_generators.metric_point_at({p.x + place_of_cut * (q.x - p.x),
                                                         p.y + place_of_cut * (q.y - p.y)});
    const std::size_t label = m_generators.set().nearest(x, uv.first->point.label);
    m_tds.for_each_face_in_domain(m_tds.split_edge(e, {x, label}), [&](Face_handle f) { add_pending(f, pending); });
  }

  const Generators& m_generators;
  const double      m_tolerance;
  const std::size_t m_maximum_number_of_vertices;
  Region_tds&       m_tds;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_BISECTOR_H

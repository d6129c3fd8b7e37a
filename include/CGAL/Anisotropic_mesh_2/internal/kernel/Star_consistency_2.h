// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Unit_frame.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>

namespace CGAL::Anisotropic_mesh_2::internal {

// whether the face counts: a finite one, and of a mesh one of the domain
template <class Triangulation>
auto is_face_of_interest(const Triangulation& t, typename Triangulation::Face_handle f, int)
  -> decltype(t.edges_in_domain(), bool())
{
  return !t.is_infinite(f) && f->is_in_domain();
}

template <class Triangulation>
bool is_face_of_interest(const Triangulation& t, typename Triangulation::Face_handle f, long)
{
  return !t.is_infinite(f);
}

// Is the star of a vertex that of the constrained Delaunay triangulation under
// the tensor of the vertex? From each triangle of the star, the faces are visited
// whose entry edge cuts the disc around it; none may have a vertex in the disc.
//
// Vertices are decided by the predicate of the traits. Which edges cut the disc
// is decided in doubles, and in doubt they do.
template <class Triangulation>
class Star_consistency_2
{
  typedef typename Triangulation::Edge                                Edge;
  typedef typename Triangulation::Face_handle                         Face_handle;
  typedef typename Triangulation::Vertex_handle                       Vertex_handle;
  typedef typename Triangulation::Geom_traits::Side_of_metric_circle_2  Side;

public:
  Star_consistency_2(const Triangulation& t, Vertex_handle v)
    : m_t(t), m_v(v), m_side(t.geom_traits().side_of_metric_circle_2_object()),
      m_frame(v->point(), Symmetric_form(v->metric_tensor()))
  {}

  bool operator()() const
  {
    auto f = m_t.incident_faces(m_v), done(f);
    do {
      if(is_face_of_interest(m_t, f, 0) && !has_empty_disc(f))
        return false;
    } while(++f != done);
    return true;
  }

private:
  struct Disc { Vector_of_doubles centre; double squared_radius; };

  bool has_empty_disc(Face_handle f) const
  {
    const Disc disc = disc_of(f);
    boost::container::small_vector<Face_handle, 32> visited(1, f);
    boost::container::small_vector<Edge, 32> to_cross;
    for(int i = 0; i < 3; ++i)
      to_cross.push_back(Edge(f, i));
    while(!to_cross.empty()) {
      const Edge e = to_cross.back(), m = m_t.mirror_edge(e);
      to_cross.pop_back();
      const Face_handle g = m.first;
      if(e.first->is_constrained(e.second) || m_t.is_infinite(g) || !is_cut(e, disc)
         || std::find(visited.begin(), visited.end(), g) != visited.end())
        continue;
      if(is_inside(f, g->vertex(m.second)))
        return false;
      visited.push_back(g);
      to_cross.push_back(Edge(g, m_t.ccw(m.second)));
      to_cross.push_back(Edge(g, m_t.cw(m.second)));
    }
    return true;
  }

  bool is_inside(Face_handle f, Vertex_handle v) const
  {
    const auto& m = m_v->metric_tensor();
    return m_side(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), v->point(), m, m, m, m)
           == ON_POSITIVE_SIDE;
  }

  // with a little more than the true radius
  Disc disc_of(Face_handle f) const
  {
    const Vector_of_doubles a = at(f->vertex(0));
    const Vector_of_doubles b = minus(at(f->vertex(1)), a), c = minus(at(f->vertex(2)), a);
    const double bb = dot(b, b), cc = dot(c, c), d = 2 * (b.x*c.y - b.y*c.x);
    const Vector_of_doubles u = {(bb*c.y - cc*b.y) / d, (b.x*cc - c.x*bb) / d};
    return Disc{{a.x + u.x, a.y + u.y}, dot(u, u) * (1 + 1e-9)};
  }

  bool is_cut(const Edge& e, const Disc& disc) const
  {
    const Vector_of_doubles p = minus(at(e.first->vertex(m_t.ccw(e.second))), disc.centre);
    const Vector_of_doubles q = minus(at(e.first->vertex(m_t.cw(e.second))), disc.centre);
    const Vector_of_doubles s = minus(q, p);
    const double t = (std::min)(1., (std::max)(0., -dot(p, s) / dot(s, s)));
    const Vector_of_doubles nearest = {p.x + t*s.x, p.y + t*s.y};
    return !(dot(nearest, nearest) > disc.squared_radius); // true for NaN
  }

  Vector_of_doubles at(Vertex_handle v) const { return m_frame.in_frame(v->point()); }

  static Vector_of_doubles minus(const Vector_of_doubles& p, const Vector_of_doubles& q)
  {
    return {p.x - q.x, p.y - q.y};
  }

  static double dot(const Vector_of_doubles& p, const Vector_of_doubles& q) { return p.x*q.x + p.y*q.y; }

  const Triangulation& m_t;
  const Vertex_handle m_v;
  const Side m_side;
  const Unit_frame m_frame;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H

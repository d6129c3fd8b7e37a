// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>

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

// The picture of the plane in which a metric is Euclidean, from a point as origin.
class Metric_frame
{
public:
  struct Position { double x, y; };

  Metric_frame(double x, double y, const Symmetric_form& m)
    : m_x(x), m_y(y), m_a(std::sqrt(m.a)), m_b(m.b / m_a), m_c(std::sqrt(m.determinant() / m.a))
  {}

  template <class Point_2>
  Position operator()(const Point_2& p) const
  {
    const double x = CGAL::to_double(p.x()) - m_x, y = CGAL::to_double(p.y()) - m_y;
    return {m_a*x + m_b*y, m_c*y};
  }

private:
  double m_x, m_y, m_a, m_b, m_c;
};

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
  typedef Metric_frame::Position                                    Position;

public:
  Star_consistency_2(const Triangulation& t, Vertex_handle v)
    : m_t(t), m_v(v), m_side(t.geom_traits().side_of_metric_circle_2_object()),
      m_picture(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()), Symmetric_form(v->metric_tensor()))
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
  struct Disc { Position centre; double squared_radius; };

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
    const Position a = m_picture(f->vertex(0)->point());
    const Position b = minus(m_picture(f->vertex(1)->point()), a), c = minus(m_picture(f->vertex(2)->point()), a);
    const double bb = dot(b, b), cc = dot(c, c), d = 2 * (b.x*c.y - b.y*c.x);
    const Position u = {(bb*c.y - cc*b.y) / d, (b.x*cc - c.x*bb) / d};
    return Disc{{a.x + u.x, a.y + u.y}, dot(u, u) * (1 + 1e-9)};
  }

  bool is_cut(const Edge& e, const Disc& disc) const
  {
    const Position p = minus(m_picture(e.first->vertex(m_t.ccw(e.second))->point()), disc.centre);
    const Position q = minus(m_picture(e.first->vertex(m_t.cw(e.second))->point()), disc.centre);
    const Position s = minus(q, p);
    const double t = (std::min)(1., (std::max)(0., -dot(p, s) / dot(s, s)));
    const Position nearest = {p.x + t*s.x, p.y + t*s.y};
    return !(dot(nearest, nearest) > disc.squared_radius); // true for NaN
  }

  static Position minus(const Position& p, const Position& q) { return {p.x - q.x, p.y - q.y}; }
  static double dot(const Position& p, const Position& q) { return p.x*q.x + p.y*q.y; }

  const Triangulation& m_t;
  const Vertex_handle m_v;
  const Side m_side;
  const Metric_frame m_picture;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_STAR_CONSISTENCY_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_VISIBILITY_REGION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_VISIBILITY_REGION_H

#include <CGAL/Anisotropic_mesh_2/Visibility_sampling.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Domain_fan.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <CGAL/assertions.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The way from a generator p over q, on the edge opposite to it, to an end
// beyond that edge, or to q alone.
class Poly_segment
{
public:
  Poly_segment(const Vector_of_doubles& p, const Vector_of_doubles& q) : m_p(p), m_q(q), m_end(q), m_knee(1) {}

  // Both parts have their share of the parameter by their lengths in m.
  Poly_segment(const Vector_of_doubles& p, const Vector_of_doubles& q, const Vector_of_doubles& end,
               const Symmetric_form& m)
    : m_p(p), m_q(q), m_end(end)
  {
    const double first = m.length(q.x - p.x, q.y - p.y);
    m_knee = first / (first + m.length(end.x - q.x, end.y - q.y));
  }

  // The ends are exact, so that nothing lies beyond the domain.
  Vector_of_doubles operator()(double t) const
  {
    if(t >= 1)
      return m_end;
    return t < m_knee ? between(m_p, m_q, t / m_knee) : between(m_q, m_end, (t - m_knee) / (1 - m_knee));
  }

  static Vector_of_doubles between(const Vector_of_doubles& p, const Vector_of_doubles& q, double t)
  {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

private:
  Vector_of_doubles m_p, m_q, m_end;
  double m_knee; // the parameter of q
};

// The part of the Voronoi region of a vertex that can be seen from it, as
// section 4.1 of the paper finds it: in the faces of the domain at the vertex
// and those across their opposite edges, among the vertices of these faces.
template <class Mesh>
class Visibility_region
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef typename Mesh::Edge            Edge;
  typedef Domain_fan<Mesh>              Star;

public:
  Visibility_region(const Mesh& mesh, Vertex_handle v, const Visibility_sampling& sampling)
    : m_mesh(mesh), m_vertex(v), m_sampling(sampling),
      m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_generator(to_doubles(v->point())), m_form(v->metric_tensor())
  {
    CGAL_precondition(mesh.dimension() == 2);
    CGAL_precondition(sampling.subdivisions_of_edges >= 1 && sampling.steps >= 1);
    const Star star(mesh, v);
    find_testing_vertices(star);
    for(const auto& run : star.runs)
      add_polygon(run, star.is_surrounded);
  }

  const Vector_of_doubles& generator() const { return m_generator; }

  // Counterclockwise: one around the vertex, or one for each run of faces of
  // the domain, which begins with the vertex.
  const std::vector<Vectors>& polygons() const { return m_polygons; }

private:
  static constexpr double tolerance = 1e-10; // of crossings, in parts of a poly-segment
  static constexpr std::uintmax_t maximum_iterations = 60;

  void find_testing_vertices(const Star& star)
  {
    std::vector<Vertex_handle> vertices;
    for(const auto& run : star.runs)
      for(Face_handle f : run) {
        const int i = f->index(m_vertex);
        vertices.push_back(f->vertex(Mesh::ccw(i)));
        vertices.push_back(f->vertex(Mesh::cw(i)));
        const Edge across = m_mesh.mirror_edge(Edge(f, i));
        if(across.first->is_in_domain())
          vertices.push_back(across.first->vertex(across.second));
      }
    std::sort(vertices.begin(), vertices.end(),
              [](Vertex_handle v, Vertex_handle w) { return v->index() < w->index(); });
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for(Vertex_handle v : vertices)
      m_testing_vertices.push_back(to_doubles(v->point()));
  }

  void add_polygon(const typename Star::Run& run, bool is_closed)
  {
    m_polygons.emplace_back();
    if(!is_closed)
      m_polygons.back().push_back(m_generator);
    for(Face_handle f : run)
      for(int j = 0; j < m_sampling.subdivisions_of_edges; ++j)
        m_polygons.back().push_back(crossing(poly_segment(f, j)));
    if(!is_closed)
      m_polygons.back().push_back(crossing(poly_segment(run.back(), m_sampling.subdivisions_of_edges)));
  }

  // over the j-th division point of the edge opposite to the generator
  Poly_segment poly_segment(Face_handle f, int j) const
  {
    const int i = f->index(m_vertex);
    const Vector_of_doubles a = to_doubles(f->vertex(Mesh::ccw(i))->point());
    const Vector_of_doubles b = to_doubles(f->vertex(Mesh::cw(i))->point());
    const int n = m_sampling.subdivisions_of_edges;
    const Vector_of_doubles q = j == n ? b : Poly_segment::between(a, b, double(j) / n);
    const Edge across = m_mesh.mirror_edge(Edge(f, i));
    if(!across.first->is_in_domain())
      return Poly_segment(m_generator, q);
    const Vector_of_doubles c = to_doubles(across.first->vertex(across.second)->point());
    if(!m_sampling.shrinks_testing_region)
      return Poly_segment(m_generator, q, c, m_form);
    const Vector_of_doubles middle = Poly_segment::between(m_generator, c, 0.5);
    const bool is_beyond = (b.x - a.x) * (middle.y - a.y) < (b.y - a.y) * (middle.x - a.x);
    return is_beyond ? Poly_segment(m_generator, q, middle, m_form) : Poly_segment(m_generator, q);
  }

  // the point of the poly-segment where another vertex becomes nearer, or its end
  Vector_of_doubles crossing(const Poly_segment& s) const
  {
    double last = 0, excess_at_last = excess(m_generator, m_form);
    for(int k = 1; k <= m_sampling.steps; ++k) {
      const double t = double(k) / m_sampling.steps, excess_at_t = excess(s(t));
      if(excess_at_t > 0)
        return m_sampling.refines_crossings ? root(s, last, t, excess_at_last, excess_at_t) : s(t);
      last = t;
      excess_at_last = excess_at_t;
    }
    return s(1);
  }

  Vector_of_doubles root(const Poly_segment& s, double lower, double upper,
                         double excess_at_lower, double excess_at_upper) const
  {
    std::uintmax_t iterations = maximum_iterations;
    const auto bracket = boost::math::tools::toms748_solve(
      [&](double t) { return excess(s(t)); }, lower, upper, excess_at_lower, excess_at_upper,
      [](double a, double b) { return b - a <= tolerance; }, iterations);
    return s((bracket.first + bracket.second) / 2);
  }

  // How much farther, in squares, the generator is from x than the nearest testing vertex.
  double excess(const Vector_of_doubles& x) const
  {
    return excess(x, Symmetric_form(m_tensor(point_at<Point>(x.x, x.y))));
  }

  double excess(const Vector_of_doubles& x, const Symmetric_form& m) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Vector_of_doubles& z : m_testing_vertices)
      least = (std::min)(least, m(x.x - z.x, x.y - z.y));
    return m(x.x - m_generator.x, x.y - m_generator.y) - least;
  }

  const Mesh& m_mesh;
  const Vertex_handle m_vertex;
  const Visibility_sampling m_sampling;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const Vector_of_doubles m_generator;
  const Symmetric_form m_form;
  Vectors m_testing_vertices;
  std::vector<Vectors> m_polygons;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_VISIBILITY_REGION_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_INSERTER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_INSERTER_H

#include <CGAL/Anisotropic_mesh_2/Point_placement.h>
#include <CGAL/Anisotropic_mesh_2/Refinement_result.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Edge_subdivision.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Field_point_filter.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Uncovered_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/unit_apex.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Unit meshing of the domain (section 3.2 of the paper): points at unit
// distances on the edges that are too long, each accepted if it is far enough,
// in the metric, from all vertices that it would be joined to.
//
// The cavity of a candidate is found once and serves twice, for the filter and
// for the insertion. Under the metric its boundary holds the nearest vertex,
// old ones and those accepted just before alike, so that no other search is
// needed. Walks start from the previous point of the same edge: they are short
// in the metric, whatever the anisotropy.
template <class Mesh>
class Field_point_inserter
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Edge            Edge;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef typename Mesh::Metric_tensor_2 Metric_tensor;
  typedef std::pair<Vertex_handle, Vertex_handle> Vertex_pair;

public:
  Field_point_inserter(Mesh& mesh, std::size_t maximum_number_of_vertices, double time_limit)
    : m_mesh(mesh), m_limit(maximum_number_of_vertices), m_time(time_limit),
      m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()), m_filter(mesh)
  {}

  // With ADVANCING_FRONT, points come from the fronts as long as these advance;
  // what stays too long afterwards is subdivided. Where faces still have too much
  // area in the metric, new fronts begin.
  Refinement_result operator()(Point_placement placement)
  {
    if(placement == Point_placement::ADVANCING_FRONT)
      advance_fronts(front_edges());
    subdivide_edges(interior_edges());
    Uncovered_area<Mesh> uncovered(m_mesh);
    for(int round = 0; round < maximum_number_of_rounds; ++round) {
      const std::size_t first = m_new_vertices.size();
      for(const Point& p : uncovered.places())
        if(may_go_on())
          begin_front(p);
      if(m_new_vertices.size() == first)
        break;
      advance_fronts(edges_of_new_vertices(first));
      subdivide_edges(edges_of_new_vertices(first));
      uncovered.add_faces_of({m_new_vertices.begin() + std::ptrdiff_t(first), m_new_vertices.end()});
    }
    m_result.number_of_insertions = m_new_vertices.size();
    return m_result;
  }

private:
  static constexpr int    maximum_number_of_rounds = 1000;
  static constexpr double largest_ratio = 4; // to the ideal number of vertices

  void advance_fronts(std::vector<Vertex_pair> edges)
  {
    repeat_rounds(std::move(edges), &Field_point_inserter::advance);
  }

  void subdivide_edges(std::vector<Vertex_pair> edges)
  {
    repeat_rounds(std::move(edges), &Field_point_inserter::subdivide);
  }

  // Each round looks at the edges that the last one created. Accepted points
  // keep a distance in the metric, which ends the rounds; the bound is for
  // metrics so rough that distances mean little.
  void repeat_rounds(std::vector<Vertex_pair> edges, void (Field_point_inserter::*treat)(Vertex_handle, Vertex_handle))
  {
    for(int round = 0; round < maximum_number_of_rounds && !edges.empty(); ++round) {
      const std::size_t first = m_new_vertices.size();
      for(const Vertex_pair& e : edges) {
        if(!may_go_on())
          return;
        (this->*treat)(e.first, e.second);
      }
      edges = edges_of_new_vertices(first);
    }
  }

  // The mesh is compared with what its faces ask for whenever it has doubled.
  bool may_go_on()
  {
    m_result.time_limit_reached = m_result.time_limit_reached || m_time.is_spent();
    if(m_new_vertices.size() >= m_next_check && !m_result.vertex_limit_reached) {
      m_next_check *= 2;
      m_result.vertex_limit_reached
        = double(m_new_vertices.size()) > largest_ratio * ideal_number_of_vertices
                                              (estimated_metric_area<Point>(m_mesh.faces_in_domain(), m_tensor));
    }
    return !m_result.time_limit_reached && !m_result.vertex_limit_reached;
  }

  // A front begins with an edge of unit length along the longer axis of the metric.
  void begin_front(const Point& p)
  {
    Face_handle hint;
    try_to_insert(p, hint);
    const auto sizes = m_tensor(p).sizes();
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    try_to_insert(point_at<Point>(x - std::sin(sizes.angle) * sizes.h2, y + std::cos(sizes.angle) * sizes.h2), hint);
  }

  // Points at unit distance from both ends of an edge, on both its sides.
  void advance(Vertex_handle u, Vertex_handle v)
  {
    advance_to_the_left(u, v);
    advance_to_the_left(v, u);
  }

  // The metric halfway to the point is estimated from those at the ends of the
  // edge and at a first guess of the point, but only if that lies in the
  // domain: beyond, the field need not be defined.
  void advance_to_the_left(Vertex_handle u, Vertex_handle v)
  {
    const Symmetric_form at_edge = geometric_mean(Symmetric_form(u->metric_tensor()),
                                                  Symmetric_form(v->metric_tensor()));
    Point apex;
    Face_handle hint = u->face();
    if(!unit_apex(u->point(), v->point(), at_edge, apex) || !is_field_point(apex, hint))
      return;
    if(unit_apex(u->point(), v->point(), geometric_mean(at_edge, Symmetric_form(m_tensor(apex))), apex))
      try_to_insert(apex, hint);
  }

  bool is_field_point(const Point& p, Face_handle& hint) const
  {
    typename Mesh::Locate_type lt;
    int li;
    hint = m_mesh.locate(p, lt, li, hint);
    return m_mesh.is_field_point(lt, hint, li);
  }

  void subdivide(Vertex_handle u, Vertex_handle v)
  {
    Face_handle hint = u->face();
    for(const Point& p : m_subdivision(u->point(), u->metric_tensor(), v->point(), v->metric_tensor(), m_tensor))
      try_to_insert(p, hint);
  }

  void try_to_insert(const Point& p, Face_handle& hint)
  {
    typename Mesh::Locate_type lt;
    int li;
    const Face_handle f = m_mesh.locate(p, lt, li, hint);
    hint = f;
    if(!m_mesh.is_field_point(lt, f, li))
      return;
    const Metric_tensor m = m_tensor(p);
    m_cavity.faces.clear();
    m_cavity.boundary.clear();
    m_mesh.find_cavity(p, m, lt, f, li, m_cavity);
    if(!m_filter(p, m, m_cavity))
      return;
    if(m_mesh.number_of_vertices() >= m_limit)
      throw Too_many_vertices_exception(double(m_limit) + 1, m_limit);
    const Vertex_handle v = m_mesh.insert_in_cavity(p, m, m_cavity);
    m_new_vertices.push_back(v);
    hint = v->face();
  }

  // the constrained edges
  std::vector<Vertex_pair> front_edges() const
  {
    std::vector<Vertex_pair> edges;
    for(auto f = m_mesh.all_faces_begin(); f != m_mesh.all_faces_end(); ++f)
      for(int i = 0; i < 3; ++i) {
        const Vertex_handle u = f->vertex(Mesh::ccw(i)), v = f->vertex(Mesh::cw(i));
        if(f->is_constrained(i) && u->index() < v->index())
          edges.emplace_back(u, v);
      }
    return edges;
  }

  std::vector<Vertex_pair> interior_edges() const
  {
    std::vector<Vertex_pair> edges;
    for(const Edge& e : m_mesh.edges_in_domain())
      if(!m_mesh.is_constrained(e))
        edges.emplace_back(e.first->vertex(Mesh::ccw(e.second)), e.first->vertex(Mesh::cw(e.second)));
    return edges;
  }

  std::vector<Vertex_pair> edges_of_new_vertices(std::size_t first) const
  {
    std::vector<Vertex_pair> edges;
    for(std::size_t i = first; i < m_new_vertices.size(); ++i) {
      const Vertex_handle v = m_new_vertices[i];
      auto w = m_mesh.incident_vertices(v), done(w);
      do {
        // an edge between two new vertices is taken once
        if(w->index() < v->index())
          edges.emplace_back(w, v);
      } while(++w != done);
    }
    return edges;
  }

  Mesh& m_mesh;
  const std::size_t m_limit;
  const Time_budget m_time;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const Field_point_filter<Mesh> m_filter;
  Edge_subdivision<Point> m_subdivision;
  typename Mesh::Cavity m_cavity;
  std::vector<Vertex_handle> m_new_vertices;
  std::size_t m_next_check = 4096;
  Refinement_result m_result;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_INSERTER_H

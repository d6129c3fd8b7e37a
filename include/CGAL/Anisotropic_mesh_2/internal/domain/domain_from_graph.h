// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_FROM_GRAPH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_FROM_GRAPH_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Graph_roles_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// refuses indices out of range, points that are not finite, and equal points
template <class K>
void check_graph(const Planar_straight_line_graph_2<K>& graph)
{
  const std::size_t n = graph.points.size();
  const auto check_index = [n](const char* what, std::size_t i, std::size_t vertex) {
    if(vertex >= n)
      throw Invalid_domain_exception("the " + std::string(what) + " " + std::to_string(i + 1) + " names the point "
                                     + std::to_string(vertex + 1) + ", but there are " + std::to_string(n));
  };
  for(std::size_t i = 0; i < graph.edges.size(); ++i) {
    check_index("edge", i, graph.edges[i].source);
    check_index("edge", i, graph.edges[i].target);
  }
  for(std::size_t i = 0; i < graph.triangles.size(); ++i)
    for(std::size_t v : graph.triangles[i])
      check_index("triangle", i, v);
  for(std::size_t i = 0; i < n; ++i)
    if(!(CGAL::is_finite(graph.points[i].x()) && CGAL::is_finite(graph.points[i].y())))
      throw Invalid_domain_exception("the point " + std::to_string(i + 1) + " is not finite: "
                                     + describe(graph.points[i]));
  std::vector<std::size_t> order(n);
  for(std::size_t i = 0; i < n; ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&graph](std::size_t a, std::size_t b) {
    return graph.points[a] == graph.points[b] ? a < b : graph.points[a] < graph.points[b]; });
  for(std::size_t i = 1; i < n; ++i)
    if(graph.points[order[i-1]] == graph.points[order[i]])
      throw Invalid_domain_exception("duplicate points: " + std::to_string(order[i-1] + 1) + " and "
                                     + std::to_string(order[i] + 1) + " are both "
                                     + describe(graph.points[order[i]]));
}

// The domain that a triangle mesh covers: the edges of one triangle bound it,
// other listed edges and those between different references divide it.
template <class K>
class Domain_from_triangles
{
public:
  typedef Planar_straight_line_graph_2<K>   Graph;
  typedef typename Graph::Region            Region;
  typedef typename K::Point_2               Point_2;
  typedef typename K::FT                    FT;

  explicit Domain_from_triangles(const Graph& graph)
    : m_graph(graph), m_component(graph.triangles.size(), none)
  {
    collect_edges();
    make_pieces();
    if(!graph.triangle_references.empty())
      make_regions();
  }

  const std::vector<Domain_piece_2<K> >& pieces() const { return m_pieces; }
  const std::vector<Region>& regions() const { return m_regions; }

private:
  typedef std::pair<std::size_t, std::size_t>   Key;
  static constexpr std::size_t none = std::size_t(-1);

  struct Edge
  {
    std::array<std::size_t, 2> triangles = {none, none};
    std::size_t number = 0;      // in the list of edges, from 1
    int reference = 0;
  };

  static Key key(std::size_t a, std::size_t b) { return a < b ? Key(a, b) : Key(b, a); }

  void collect_edges()
  {
    for(std::size_t t = 0; t < m_graph.triangles.size(); ++t)
      for(int i = 0; i < 3; ++i)
        add_triangle(m_edges[key(m_graph.triangles[t][i], m_graph.triangles[t][(i+1) % 3])], t, i);
    for(std::size_t i = 0; i < m_graph.edges.size(); ++i) {
      Edge& e = m_edges[key(m_graph.edges[i].source, m_graph.edges[i].target)];
      if(e.number == 0) {
        e.number = i + 1;
        e.reference = m_graph.edges[i].reference;
      }
    }
  }

  void add_triangle(Edge& e, std::size_t t, int i) const
  {
    if(e.triangles[1] != none || e.triangles[0] == t) {
      const auto& vertices = m_graph.triangles[t];
      throw Invalid_domain_exception("the edge from " + describe(m_graph.points[vertices[i]]) + " to "
                                     + describe(m_graph.points[vertices[(i+1) % 3]])
                                     + " belongs to more than two triangles or twice to the triangle "
                                     + std::to_string(t + 1));
    }
    e.triangles[e.triangles[0] == none ? 0 : 1] = t;
  }

  int reference_of(std::size_t t) const
  {
    return t < m_graph.triangle_references.size() ? m_graph.triangle_references[t] : 0;
  }

  bool is_boundary(const Edge& e) const { return e.triangles[0] != none && e.triangles[1] == none; }

  bool divides(const Edge& e) const
  {
    return e.number > 0 || e.triangles[1] == none || reference_of(e.triangles[0]) != reference_of(e.triangles[1]);
  }

  void make_pieces()
  {
    for(const auto& entry : m_edges)
      if(divides(entry.second))
        m_pieces.push_back(Domain_piece_2<K>{
          Curve_piece_2<K>::segment(m_graph.points[entry.first.first], m_graph.points[entry.first.second],
                                    entry.second.reference),
          is_boundary(entry.second) ? Piece_role::BOUNDARY : Piece_role::CONSTRAINT,
          entry.second.number});
  }

  // one for each set of triangles that is not divided
  void make_regions()
  {
    for(std::size_t root = 0; root < m_graph.triangles.size(); ++root) {
      if(m_component[root] != none)
        continue;
      std::vector<std::size_t> component(1, root);
      m_component[root] = root;
      for(std::size_t i = 0; i < component.size(); ++i)
        for(int k = 0; k < 3; ++k) {
          const auto& vertices = m_graph.triangles[component[i]];
          add_neighbor(m_edges.at(key(vertices[k], vertices[(k+1) % 3])), component[i], root, component);
        }
      const std::size_t largest = *std::max_element(component.begin(), component.end(),
        [this](std::size_t s, std::size_t t) { return doubled_area(s) < doubled_area(t); });
      m_regions.push_back(Region{centroid(largest), reference_of(largest)});
    }
  }

  void add_neighbor(const Edge& e, std::size_t t, std::size_t root, std::vector<std::size_t>& component)
  {
    if(divides(e))
      return;
    const std::size_t other = e.triangles[0] == t ? e.triangles[1] : e.triangles[0];
    if(m_component[other] == none)
      component.push_back(other);
    m_component[other] = root;
  }

  const Point_2& corner(std::size_t t, int i) const { return m_graph.points[m_graph.triangles[t][i]]; }

  double doubled_area(std::size_t t) const
  {
    const Point_2 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
    return std::abs(CGAL::to_double((b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x())));
  }

  Point_2 centroid(std::size_t t) const
  {
    const Point_2 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
    return Point_2(a.x() + ((b.x() - a.x()) + (c.x() - a.x())) / FT(3),
                   a.y() + ((b.y() - a.y()) + (c.y() - a.y())) / FT(3));
  }

  const Graph&                    m_graph;
  std::map<Key, Edge>             m_edges;
  std::vector<std::size_t>        m_component;
  std::vector<Domain_piece_2<K> > m_pieces;
  std::vector<Region>             m_regions;
};

template <class K>
std::vector<Domain_piece_2<K> > pieces_of_edges(const Planar_straight_line_graph_2<K>& graph)
{
  const Graph_roles_2<K> roles(graph);
  std::vector<Domain_piece_2<K> > pieces;
  for(std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto& e = graph.edges[i];
    pieces.push_back(Domain_piece_2<K>{
      Curve_piece_2<K>::segment(graph.points[e.source], graph.points[e.target], e.reference),
      roles.roles()[i], i + 1});
  }
  return pieces;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_FROM_GRAPH_H

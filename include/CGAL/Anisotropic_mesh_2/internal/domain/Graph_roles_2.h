// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_GRAPH_ROLES_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_GRAPH_ROLES_2_H

#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/exact_predicates.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Decides which edges of a graph without triangles bound the domain.
//
// Edges on no cycle form open chains. What is left falls into components; if
// an even number of edges meets at each vertex of a component, all its edges
// are boundary; else curves divide the area that the component covers, and
// only its outer cycle is boundary.
template <class K>
class Graph_roles_2
{
public:
  typedef Planar_straight_line_graph_2<K>                     Graph;
  typedef Exact_predicates_kernel_of<K>                       Exact;

  explicit Graph_roles_2(const Graph& graph)
    : m_graph(graph), m_roles(graph.edges.size(), Piece_role::BOUNDARY), m_incident(graph.points.size())
  {
    pair_off_repeated_edges();
    find_open_chains();
    keep_edges_on_cycles();
    split_components();
  }

  const std::vector<Piece_role>& roles() const { return m_roles; }

private:
  typedef std::pair<std::size_t, std::size_t>   Half_edge; // source, edge
  static constexpr std::size_t none = std::size_t(-1);

  std::size_t opposite(std::size_t edge, std::size_t vertex) const
  {
    const auto& e = m_graph.edges[edge];
    return e.source == vertex ? e.target : e.source;
  }

  // Edges between the same two vertices cancel in pairs; one that is left counts.
  void pair_off_repeated_edges()
  {
    std::vector<std::array<std::size_t, 3> > sorted;
    for(std::size_t i = 0; i < m_graph.edges.size(); ++i) {
      const auto ends = std::minmax(m_graph.edges[i].source, m_graph.edges[i].target);
      sorted.push_back({ends.first, ends.second, i});
    }
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
      while(j < sorted.size() && sorted[j][0] == sorted[i][0] && sorted[j][1] == sorted[i][1])
        ++j;
      for(std::size_t k = i + (j - i) % 2; k < j; ++k)
        m_roles[sorted[k][2]] = Piece_role::UNDECIDED;
      if((j - i) % 2 == 1 && sorted[i][0] != sorted[i][1])
        for(int k = 0; k < 2; ++k)
          m_incident[sorted[i][k]].push_back(sorted[i][2]);
    }
  }

  struct Visit { std::size_t vertex, edge, next; };

  // An edge of the depth-first tree is on a cycle iff an edge outside of the
  // tree goes from its subtree to a vertex above it.
  void find_open_chains()
  {
    const std::size_t n = m_incident.size();
    std::vector<std::size_t> order(n, none), lowest(n, none);
    std::size_t count = 0;
    for(std::size_t root = 0; root < n; ++root) {
      if(order[root] != none)
        continue;
      std::vector<Visit> stack(1, Visit{root, none, 0});
      order[root] = lowest[root] = count++;
      while(!stack.empty()) {
        Visit& v = stack.back();
        if(v.next == m_incident[v.vertex].size()) {
          const Visit done = v;
          stack.pop_back();
          if(stack.empty())
            break;
          const std::size_t parent = stack.back().vertex;
          lowest[parent] = (std::min)(lowest[parent], lowest[done.vertex]);
          if(lowest[done.vertex] > order[parent])
            m_roles[done.edge] = Piece_role::OPEN_CHAIN;
          continue;
        }
        const std::size_t edge = m_incident[v.vertex][v.next++], w = opposite(edge, v.vertex);
        if(edge == v.edge)
          continue;
        if(order[w] != none) {
          lowest[v.vertex] = (std::min)(lowest[v.vertex], order[w]);
          continue;
        }
        order[w] = lowest[w] = count++;
        stack.push_back(Visit{w, edge, 0});
      }
    }
  }

  void keep_edges_on_cycles()
  {
    for(auto& edges : m_incident)
      edges.erase(std::remove_if(edges.begin(), edges.end(),
                                 [this](std::size_t e) { return m_roles[e] != Piece_role::BOUNDARY; }),
                  edges.end());
  }

  void split_components()
  {
    std::vector<bool> seen(m_incident.size(), false);
    for(std::size_t root = 0; root < m_incident.size(); ++root) {
      if(seen[root] || m_incident[root].empty())
        continue;
      const std::vector<std::size_t> component = connected_to(root, seen);
      if(std::any_of(component.begin(), component.end(),
                     [this](std::size_t v) { return m_incident[v].size() % 2 == 1; }))
        keep_outer_cycle(component);
    }
  }

  std::vector<std::size_t> connected_to(std::size_t root, std::vector<bool>& seen) const
  {
    std::vector<std::size_t> component(1, root);
    seen[root] = true;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(std::size_t edge : m_incident[component[i]]) {
        const std::size_t w = opposite(edge, component[i]);
        if(!seen[w])
          component.push_back(w);
        seen[w] = true;
      }
    return component;
  }

  // Walks around the component with the unbounded face at the left hand, from
  // the uppermost edge of the leftmost vertex on.
  void keep_outer_cycle(const std::vector<std::size_t>& component)
  {
    for(std::size_t v : component)
      sort_clockwise(v);
    const std::size_t leftmost = *std::min_element(component.begin(), component.end(),
      [this](std::size_t a, std::size_t b) { return m_graph.points[a] < m_graph.points[b]; });
    std::set<std::size_t> outer;
    const Half_edge first(leftmost, m_incident[leftmost].front());
    Half_edge h = first;
    do {
      outer.insert(h.second);
      h = next_half_edge(h);
    } while(h != first);
    for(std::size_t v : component)
      for(std::size_t edge : m_incident[v])
        if(outer.count(edge) == 0)
          m_roles[edge] = Piece_role::UNDECIDED;
  }

  // the edges around the vertex, from the upward direction on
  void sort_clockwise(std::size_t v)
  {
    const auto& points = m_graph.points;
    std::sort(m_incident[v].begin(), m_incident[v].end(), [&](std::size_t e, std::size_t f) {
      const std::size_t a = opposite(e, v), b = opposite(f, v);
      const bool a_is_right = points[v] < points[a], b_is_right = points[v] < points[b];
      return a_is_right != b_is_right ? a_is_right : side(v, a, b) == RIGHT_TURN;
    });
  }

  // the first edge clockwise from the one that leads here
  Half_edge next_half_edge(const Half_edge& h) const
  {
    const std::size_t v = opposite(h.second, h.first);
    const auto& edges = m_incident[v];
    const auto next = std::find(edges.begin(), edges.end(), h.second) + 1;
    return Half_edge(v, next == edges.end() ? edges.front() : *next);
  }

  Orientation side(std::size_t v, std::size_t a, std::size_t b) const
  {
    return Exact().orientation_2_object()(exact_point<K>(m_graph.points[v]), exact_point<K>(m_graph.points[a]),
                                          exact_point<K>(m_graph.points[b]));
  }

  const Graph&                           m_graph;
  std::vector<Piece_role>                m_roles;
  std::vector<std::vector<std::size_t> > m_incident; // edges at each vertex
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_GRAPH_ROLES_2_H

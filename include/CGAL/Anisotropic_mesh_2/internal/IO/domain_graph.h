// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_DOMAIN_GRAPH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_DOMAIN_GRAPH_H

#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>

#include <CGAL/number_utils.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The domain of a triangulation in plain numbers, as all writers take it.
typedef Planar_straight_line_graph_2<Simple_cartesian<double>> Domain_graph;

// what has faces that are in the domain or not
template <class Tr>
using If_marked = std::void_t<decltype(std::declval<const typename Tr::Face&>().is_in_domain())>;

// The reference that the triangulation itself keeps for an edge; 1 if it keeps none.
struct Stored_edge_reference {};

template <class Tr>
auto stored_reference(const Tr& tr, const typename Tr::Edge& e, int) -> decltype(tr.edge_reference(e))
{ return tr.edge_reference(e); }

template <class Tr>
int stored_reference(const Tr&, const typename Tr::Edge&, long) { return 1; }

template <class Tr>
int reference_of(const Tr& tr, const typename Tr::Edge& e, Stored_edge_reference) { return stored_reference(tr, e, 0); }

template <class Tr, class EdgeReference>
int reference_of(const Tr&, const typename Tr::Edge& e, const EdgeReference& edge_reference)
{ return edge_reference(e); }

template <class Face>
auto subdomain_of(const Face& f, int) -> decltype(f.subdomain_index()) { return f.subdomain_index(); }

template <class Face>
int subdomain_of(const Face&, long) { return 0; }

// The vertices of the faces of the domain, in the order of the triangulation,
// and the position of each.
template <class Tr>
class Domain_vertices
{
public:
  typedef typename Tr::Vertex_handle Vertex_handle;

  explicit Domain_vertices(const Tr& tr) : m_position(unused, tr.number_of_vertices())
  {
    for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
      for(int i = 0; i < 3 && f->is_in_domain(); ++i)
        m_position[f->vertex(i)] = 0;
    for(auto it = tr.finite_vertices_begin(); it != tr.finite_vertices_end(); ++it) {
      const Vertex_handle v = it;
      if(m_position[v] != unused) {
        m_position[v] = m_vertices.size();
        m_vertices.push_back(v);
      }
    }
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  std::size_t operator[](Vertex_handle v) const { return m_position[v]; }

private:
  static constexpr std::size_t unused = static_cast<std::size_t>(-1);

  Unique_hash_map<Vertex_handle, std::size_t> m_position;
  std::vector<Vertex_handle>                  m_vertices;
};

// Adds the constrained edges and the outline, with the domain to their left, in an order
// that does not depend on the addresses of faces, as that of finite_edges_begin() does.
// A vertex takes the least reference of its edges.
template <class Tr, class EdgeReference>
void add_edges_of_domain(const Tr& tr, const EdgeReference& edge_reference,
                         const Domain_vertices<Tr>& vertices, Domain_graph& graph)
{
  for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
    for(int i = 0; i < 3 && f->is_in_domain(); ++i) {
      const std::size_t source = vertices[f->vertex(Tr::ccw(i))], target = vertices[f->vertex(Tr::cw(i))];
      const typename Tr::Edge e(f, i);
      if(f->neighbor(i)->is_in_domain() && !(tr.is_constrained(e) && source < target))
        continue;
      const int reference = reference_of(tr, e, edge_reference);
      graph.edges.push_back({source, target, reference});
      for(std::size_t v : {source, target})
        if(graph.point_references[v] == 0 || reference < graph.point_references[v])
          graph.point_references[v] = reference;
    }
}

template <class Tr, class EdgeReference = Stored_edge_reference>
Domain_graph domain_graph(const Tr& tr, const EdgeReference& edge_reference = EdgeReference())
{
  Domain_graph graph;
  if(tr.dimension() < 2)
    return graph;
  const Domain_vertices<Tr> vertices(tr);
  for(typename Tr::Vertex_handle v : vertices.vertices())
    graph.points.emplace_back(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()));
  graph.point_references.assign(graph.points.size(), 0);
  for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f) {
    if(!f->is_in_domain())
      continue;
    graph.triangles.push_back({vertices[f->vertex(0)], vertices[f->vertex(1)], vertices[f->vertex(2)]});
    graph.triangle_references.push_back(subdomain_of(*f, 0));
  }
  add_edges_of_domain(tr, edge_reference, vertices, graph);
  return graph;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_DOMAIN_GRAPH_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_VIEW_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_VIEW_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A graph in the role of the triangulation that CGAL::IO::write_VTU() expects,
// so that only the domain is written, and doubles whatever the kernel is.
class Vtu_view
{
public:
  struct Vertex
  {
    std::array<double, 2> xy;
    const std::array<double, 2>& point() const { return xy; }
  };

  // write_VTU takes the vertices in the order 0, 2, 1
  struct Face
  {
    std::array<const Vertex*, 3> corners;
    const Vertex* vertex(int i) const { return corners[static_cast<std::size_t>(i)]; }
    bool is_in_domain() const { return true; }
  };

  // the edge of a face without the vertex `second`
  struct Edge
  {
    const Face* first;
    int         second;
  };

  struct Geom_traits { typedef double FT; };
  typedef const Vertex* Vertex_handle;
  typedef const Face*   Face_handle;
  typedef const Vertex* Finite_vertices_iterator;
  typedef const Face*   Finite_faces_iterator;
  typedef const Edge*   Constrained_edges_iterator;

  explicit Vtu_view(const Domain_graph& graph)
  {
    m_vertices.reserve(graph.points.size());
    for(const auto& p : graph.points)
      m_vertices.push_back({{p.x(), p.y()}});
    m_faces.reserve(graph.triangles.size());
    for(const auto& t : graph.triangles)
      m_faces.push_back(face(t[0], t[2], t[1]));
    m_edge_faces.reserve(graph.edges.size()); // edges keep pointers to them
    for(const auto& e : graph.edges) {
      m_edge_faces.push_back(face(e.source, e.target, e.target));
      m_edges.push_back({&m_edge_faces.back(), 2});
    }
  }
  Vtu_view(const Vtu_view&) = delete;
  Vtu_view& operator=(const Vtu_view&) = delete;

  std::size_t number_of_vertices() const { return m_vertices.size(); }
  Finite_vertices_iterator finite_vertices_begin() const { return m_vertices.data(); }
  Finite_vertices_iterator finite_vertices_end() const { return m_vertices.data() + m_vertices.size(); }
  Finite_faces_iterator finite_faces_begin() const { return m_faces.data(); }
  Finite_faces_iterator finite_faces_end() const { return m_faces.data() + m_faces.size(); }
  Constrained_edges_iterator constrained_edges_begin() const { return m_edges.data(); }
  Constrained_edges_iterator constrained_edges_end() const { return m_edges.data() + m_edges.size(); }

private:
  Face face(std::size_t a, std::size_t b, std::size_t c) const
  {
    return Face{{&m_vertices[a], &m_vertices[b], &m_vertices[c]}};
  }

  std::vector<Vertex> m_vertices;
  std::vector<Face>   m_faces, m_edge_faces;
  std::vector<Edge>   m_edges;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_VIEW_H

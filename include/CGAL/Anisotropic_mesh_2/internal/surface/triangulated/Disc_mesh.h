// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_DISC_MESH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_DISC_MESH_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A triangle mesh in space of the topology of a disc, with vertices numbered from 0
// and coordinates in units of its extent, from its first vertex.
class Disc_mesh
{
public:
  typedef Simple_cartesian<double>                Kernel;
  typedef Surface_mesh<Kernel::Point_3>           Graph;
  typedef Graph::Vertex_index                     Vertex;
  typedef Graph::Halfedge_index                   Halfedge;
  typedef std::array<std::size_t, 3>              Triangle;

  // Throws Invalid_triangle_mesh_exception if the triangles do not form a disc, or one has no area.
  template <class Point_3>
  Disc_mesh(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles)
  {
    add_vertices(points);
    for(const Triangle& t : triangles)
      add_triangle(t);
    check_topology();
  }

  Graph& graph() { return m_graph; }
  const Graph& graph() const { return m_graph; }

  // the extent of the given points
  double unit() const { return m_unit; }

  // a halfedge of the border, outside of the triangles
  Halfedge border() const { return m_border; }

  // the vertices of the border, in the direction in which the triangles are on the left
  std::vector<std::size_t> border_loop() const
  {
    std::vector<std::size_t> loop;
    for(Halfedge h : halfedges_around_face(m_border, m_graph))
      loop.push_back(target(h, m_graph));
    std::reverse(loop.begin(), loop.end());
    return loop;
  }

private:
  [[noreturn]] static void refuse(const std::string& what)
  { throw Invalid_triangle_mesh_exception("the surface " + what); }

  static std::string describe(const Triangle& t)
  {
    return "the triangle with the vertices " + std::to_string(t[0]) + ", " + std::to_string(t[1]) + " and "
           + std::to_string(t[2]);
  }

  template <class Point_3>
  void add_vertices(const std::vector<Point_3>& points)
  {
    std::vector<std::array<double, 3> > x;
    for(const Point_3& p : points) {
      const auto along = [&](int i) { return CGAL::to_double(p[i]) - CGAL::to_double(points[0][i]); };
      x.push_back({along(0), along(1), along(2)});
      const double distance = std::hypot(x.back()[0], x.back()[1], x.back()[2]);
      if(!std::isfinite(distance))
        refuse("has a vertex that is not finite: number " + std::to_string(x.size() - 1));
      m_unit = (std::max)(m_unit, distance);
    }
    for(const auto& p : x)
      m_graph.add_vertex(Kernel::Point_3(p[0] / m_unit, p[1] / m_unit, p[2] / m_unit));
  }

  void add_triangle(const Triangle& t)
  {
    const std::array<Vertex, 3> v = {Vertex(Graph::size_type(t[0])), Vertex(Graph::size_type(t[1])),
                                     Vertex(Graph::size_type(t[2]))};
    const auto normal = cross_product(m_graph.point(v[1]) - m_graph.point(v[0]),
                                      m_graph.point(v[2]) - m_graph.point(v[0]));
    if(!(normal.squared_length() > 0))
      refuse("is degenerate: " + describe(t) + " has no area");
    if(m_graph.add_face(v[0], v[1], v[2]) == Graph::null_face())
      refuse("is not a manifold at " + describe(t));
  }

  void check_topology()
  {
    if(m_graph.number_of_faces() == 0)
      refuse("has no triangles");
    auto component = m_graph.add_property_map<Vertex, std::size_t>("v:component").first;
    if(boost::connected_components(m_graph, component) != 1)
      refuse("is not connected");
    const std::vector<Halfedge> borders = border_cycles();
    if(borders.empty())
      refuse("is closed; cut it open to make it a disc");
    if(borders.size() > 1)
      refuse("is not a disc: it has " + std::to_string(borders.size()) + " borders");
    if(m_graph.number_of_vertices() + m_graph.number_of_faces() != m_graph.number_of_edges() + 1)
      refuse("is not a disc: it has a handle");
    m_border = borders[0];
    check_border();
  }

  // The border passes a vertex twice where triangles meet in nothing but that vertex.
  void check_border() const
  {
    std::vector<std::size_t> loop = border_loop();
    std::sort(loop.begin(), loop.end());
    const auto twice = std::adjacent_find(loop.begin(), loop.end());
    if(twice != loop.end())
      refuse("is not a manifold at the vertex " + std::to_string(*twice) + ", where triangles meet that share no edge");
  }

  // a halfedge of each border
  std::vector<Halfedge> border_cycles() const
  {
    std::vector<Halfedge> cycles;
    std::vector<bool> is_known(m_graph.num_halfedges(), false);
    for(Halfedge h : m_graph.halfedges())
      if(m_graph.is_border(h) && !is_known[h]) {
        cycles.push_back(h);
        for(Halfedge k : halfedges_around_face(h, m_graph))
          is_known[k] = true;
      }
    return cycles;
  }

  Graph    m_graph;
  Halfedge m_border;
  double   m_unit = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_DISC_MESH_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CHART_MESH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CHART_MESH_H

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Directed_edges.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/append_chart_faces.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Box_tree.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/enum.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The part of a surface mesh that lies in one chart, as a planar mesh. It ends
// where the mesh does, where the chart is cut, and at the given bounds of v; the
// vertices there are fixed.
template <class Field>
class Chart_mesh
{
  typedef Anisotropic_surface_mesh_3<Field>        Surface_mesh;
  typedef typename Surface_mesh::Face              Face;
  typedef Surface_chart<Field>                     Chart;
  typedef typename Surface_atlas<Field>::Part      Part;
  typedef typename Chart::Kernel                   Kernel;
  typedef typename Chart::Point_2                  Point_2;

public:
  typedef Riemannian_metric_traits_2<Kernel>  Traits;
  typedef Anisotropic_Delaunay_mesh_2<Traits> Mesh;
  typedef typename Mesh::Vertex_handle        Vertex_handle;
  typedef std::array<std::size_t, 2>          Chart_edge;

  Chart_mesh(const Surface_mesh& surface_mesh, const Part& part)
    : m_surface_mesh(surface_mesh), m_part(part), m_mesh(Traits(part.chart))
  {
    for(std::size_t v = 0; v < surface_mesh.number_of_vertices(); ++v)
      m_coordinates.push_back(part.chart.coordinates(to_doubles(surface_mesh.parameters(v))));
    choose_faces();
  }

  // by the numbers of the vertices in the surface mesh
  const std::vector<Face>& faces() const { return m_faces; }

  // whether the face with this number in the surface mesh is in the part
  bool has_face(std::size_t f) const { return m_has_face[f]; }

  // the edges that have a face of this part on one side only
  std::vector<Chart_edge> border() const
  {
    const Directed_edges edges(m_faces);
    std::vector<Chart_edge> result;
    for(const Face& f : m_faces)
      for(int i = 0; i < 3; ++i)
        if(!edges.contains(f[(i + 1) % 3], f[i]))
          result.push_back({f[i], f[(i + 1) % 3]});
    return result;
  }

  // Triangulates the vertices; those on the border are fixed. Returns false if that
  // cannot be, because lines of the border cross each other in the chart.
  bool triangulate()
  {
    typename Mesh::Boundary_graph boundary = rim_segments();
    std::vector<Point_2> inner;
    std::vector<bool> is_known(m_coordinates.size(), false);
    for(const Face& f : m_faces)
      for(std::size_t v : f) {
        if(!is_known[v] && m_places.count(v) == 0)
          inner.push_back(point(v));
        is_known[v] = true;
      }
    if(!insert(boundary))
      return false;
    m_mesh.insert(inner.begin(), inner.end());
    return true;
  }

  // Takes the faces as they are, so that all vertices are fixed. Returns false if that cannot be.
  bool copy_faces()
  {
    typename Mesh::Boundary_graph boundary = rim_segments();
    for(const Face& f : m_faces)
      for(int i = 0; i < 3; ++i)
        if(f[i] < f[(i + 1) % 3])
          boundary.segments.push_back({place(f[i], boundary), place(f[(i + 1) % 3], boundary), 0, false});
    return insert(boundary);
  }

  Mesh& mesh() { return m_mesh; }

  // the number in the surface mesh of a fixed vertex
  std::size_t number(Vertex_handle v) const { return m_numbers.at(v->point()); }

  // Puts what has become of the planar mesh in the place of what was there; nothing
  // is put if new edges coincide with those of other parts, in a very coarse mesh.
  void write_to(Surface_mesh& surface_mesh)
  {
    std::vector<Face> faces = m_outer_faces;
    append_chart_faces(m_mesh, m_part.chart, m_numbers, surface_mesh, faces);
    surface_mesh.replace_faces(Directed_edges(faces).are_simple() ? std::move(faces) : surface_mesh.faces());
  }

private:
  typedef typename Kernel::Segment_2 Segment_2;

  static constexpr int    maximum_trims = 4;
  static constexpr double contact = 1e-9; // closer than this share of the smaller extent of parameters, lines touch

  // Faces that are wide beyond what the metric resolves may be upside down in a chart other than the one they were
  // made in, and the sides of a seam that is not glued coincide. The border must not meet itself there: such vertices
  // leave the part with all faces around them.
  void choose_faces()
  {
    std::vector<bool> is_inside(m_coordinates.size(), true);
    for(const Face& f : m_surface_mesh.faces())
      if(!is_cut(f) && !is_upright(f))
        for(std::size_t v : f)
          is_inside[v] = false;
    divide_faces(is_inside);
    for(int i = 0; i < maximum_trims; ++i) {
      const std::vector<std::size_t> meeting = vertices_where_rim_meets_itself();
      if(meeting.empty())
        return;
      for(std::size_t v : meeting)
        is_inside[v] = false;
      divide_faces(is_inside);
    }
  }

  void divide_faces(const std::vector<bool>& is_inside)
  {
    m_faces.clear();
    m_outer_faces.clear();
    m_has_face.clear();
    for(const Face& f : m_surface_mesh.faces()) {
      const bool inside = is_in_bounds(f) && !is_cut(f)
                       && std::all_of(f.begin(), f.end(), [&](std::size_t v) { return is_inside[v]; });
      (inside ? m_faces : m_outer_faces).push_back(f);
      m_has_face.push_back(inside);
    }
  }

  // the ends of the edges of the border that touch another one which has no vertex in common
  std::vector<std::size_t> vertices_where_rim_meets_itself() const
  {
    const std::vector<Chart_edge> edges = border();
    const Parameter_rectangle r = m_surface_mesh.field().surface().parameters();
    const double reach = contact * (std::min)(r.u_extent(), r.v_extent());
    const auto segment = [&](const Chart_edge& e) { return Segment_2(point(e[0]), point(e[1])); };
    std::vector<Bbox_2> boxes;
    for(const Chart_edge& e : edges)
      boxes.push_back(enlarged(segment(e).bbox(), reach));
    const Box_tree tree(boxes, 1);
    std::vector<std::size_t> found, result;
    for(std::size_t i = 0; i < edges.size(); ++i) {
      tree.find_overlapping(boxes[i], found);
      for(std::size_t k : found) {
        const Chart_edge &e = edges[i], &f = edges[k];
        if(k > i && e[0] != f[0] && e[0] != f[1] && e[1] != f[0] && e[1] != f[1]
           && squared_distance(segment(e), segment(f)) <= reach * reach)
          result.insert(result.end(), {e[0], e[1], f[0], f[1]});
      }
    }
    return result;
  }

  bool is_in_bounds(const Face& f) const
  {
    return std::all_of(f.begin(), f.end(), [&](std::size_t v) {
      const double value = CGAL::to_double(m_surface_mesh.parameters(v).y());
      return m_part.v_low <= value && value <= m_part.v_high;
    });
  }

  bool is_cut(const Face& f) const
  {
    for(int i = 0; i < 3; ++i)
      if(m_part.chart.is_cut_between(m_coordinates[f[i]], m_coordinates[f[(i + 1) % 3]]))
        return true;
    return false;
  }

  // whether the face has its orientation in the chart as well
  bool is_upright(const Face& f) const
  {
    return m_mesh.geom_traits().orientation_2_object()(point(f[0]), point(f[1]), point(f[2])) == LEFT_TURN;
  }

  Point_2 point(std::size_t v) const { return point_at<Point_2>(m_coordinates[v].x, m_coordinates[v].y); }

  bool insert(const typename Mesh::Boundary_graph& boundary)
  {
    try {
      m_mesh.insert_boundary(boundary);
    }
    catch(const Invalid_domain_exception&) {
      return false;
    }
    return true;
  }

  typename Mesh::Boundary_graph rim_segments()
  {
    typename Mesh::Boundary_graph boundary;
    for(const Chart_edge& e : border())
      boundary.segments.push_back({place(e[0], boundary), place(e[1], boundary), 1, true});
    return boundary;
  }

  // the number of a vertex among the points of the boundary
  std::size_t place(std::size_t v, typename Mesh::Boundary_graph& boundary)
  {
    const auto added = m_places.emplace(v, boundary.points.size());
    if(added.second) {
      boundary.points.push_back(point(v));
      m_numbers[point(v)] = v;
    }
    return added.first->second;
  }

  const Surface_mesh&                 m_surface_mesh;
  const Part                          m_part;
  Mesh                                m_mesh;
  Vectors                             m_coordinates;  // of all vertices
  std::vector<Face>                   m_faces, m_outer_faces;
  std::vector<bool>                   m_has_face;     // by the number in the surface mesh
  std::map<std::size_t, std::size_t>  m_places;       // of fixed vertices, among the points of the boundary
  std::map<Point_2, std::size_t>      m_numbers;      // of fixed vertices, in the surface mesh
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CHART_MESH_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_SURFACE_MESH_3_H
#define CGAL_ANISOTROPIC_SURFACE_MESH_3_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Anisotropic_mesh_2/internal/surface/Directed_edges.h>

#include <boost/graph/graph_traits.hpp>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/assertions.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

namespace Anisotropic_mesh_2 {
namespace internal {

// outside of classes that have members of the name, which would hide the function of the graph
template <class FaceGraph>
typename boost::graph_traits<FaceGraph>::vertex_descriptor new_vertex(FaceGraph& graph) { return add_vertex(graph); }

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a triangle mesh whose vertices lie on a parametric surface that carries a metric
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// Vertices are known by their parameters, faces by the numbers of their
/// vertices, in counterclockwise order as seen from the side to which
/// \f$ \sigma_u \times \sigma_v \f$ points. Where a parameter is periodic or has a pole,
/// the mesh is closed.
///
/// \tparam Field_ a model of `MetricField_2` that knows its surface, such as `Surface_metric_field_2`
/// \sa `make_anisotropic_surface_mesh_3()`
/// \sa `anisotropic_surface_mesh_statistics_3()`
template <class Field_>
class Anisotropic_surface_mesh_3
{
public:
  typedef Field_                         Field;   ///< the metric of the parameters
  typedef typename Field::Surface        Surface; ///< the surface
  typedef typename Surface::Kernel       Kernel;  ///< its kernel
  typedef typename Kernel::Point_2       Point_2; ///< parameters of a vertex
  typedef typename Kernel::Point_3       Point_3; ///< a point of space
  typedef std::array<std::size_t, 3>     Face; ///< the numbers of three vertices

  /// the mesh without vertices of the surface of `field`.
  explicit Anisotropic_surface_mesh_3(const Field& field) : m_field(field) {}

  /// \name Access
  /// @{

  /// the metric of the parameters, which knows the surface.
  const Field& field() const { return m_field; }

  /// the number of vertices, which are numbered from 0.
  std::size_t number_of_vertices() const { return m_parameters.size(); }

  /// the number of faces.
  std::size_t number_of_faces() const { return m_faces.size(); }

  /// the parameters of the vertex `v`; those of a pole are any that lead there.
  const Point_2& parameters(std::size_t v) const { return m_parameters[v]; }

  /// the place of the vertex `v` in space.
  Point_3 point(std::size_t v) const { return m_field.surface().point(m_parameters[v]); }

  /// all faces, in no particular order.
  const std::vector<Face>& faces() const { return m_faces; }

  /// whether each edge has a face on both sides; takes time proportional to the number of faces.
  bool is_closed() const
  {
    const Anisotropic_mesh_2::internal::Directed_edges edges(m_faces);
    for(const Face& f : m_faces)
      for(int i = 0; i < 3; ++i)
        if(!edges.contains(f[(i + 1) % 3], f[i]))
          return false;
    return true;
  }
  /// @}

  /// \name Modification
  /// @{

  /// adds a vertex and returns its number.
  std::size_t add_vertex(const Point_2& parameters)
  {
    m_parameters.push_back(parameters);
    return m_parameters.size() - 1;
  }

  /// adds a face, whose vertices are there.
  void add_face(const Face& f) { m_faces.push_back(f); }

  /// replaces all faces, and removes the vertices that have none; the others keep their order, but get new numbers.
  void replace_faces(std::vector<Face> faces)
  {
    m_faces = std::move(faces);
    std::vector<std::size_t> number(m_parameters.size(), 0);
    for(const Face& f : m_faces)
      for(std::size_t v : f)
        number[v] = 1;
    std::size_t n = 0;
    for(std::size_t v = 0; v < number.size(); ++v)
      if(number[v] == 1) {
        m_parameters[n] = m_parameters[v];
        number[v] = n++;
      }
    m_parameters.resize(n);
    for(Face& f : m_faces)
      for(std::size_t& v : f)
        v = number[v];
  }
  /// @}

  /// adds all vertices and faces to a mesh in space.
  /// \tparam FaceGraph a model of `MutableFaceGraph`, such as `Surface_mesh<Kernel::Point_3>`,
  /// with an internal property map of points.
  /// \return its vertices, by their numbers here.
  /// \pre no two faces have the same edge in the same direction, which holds for what
  /// `make_anisotropic_surface_mesh_3()` returns.
  template <class FaceGraph>
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> add_to(FaceGraph& graph) const
  {
    typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor Vertex;
    CGAL_precondition(Anisotropic_mesh_2::internal::Directed_edges(m_faces).are_simple());
    auto points = get(CGAL::vertex_point, graph);
    std::vector<Vertex> vertices;
    for(std::size_t v = 0; v < number_of_vertices(); ++v) {
      vertices.push_back(Anisotropic_mesh_2::internal::new_vertex(graph));
      put(points, vertices.back(), point(v));
    }
    for(const Face& f : m_faces)
      CGAL::Euler::add_face(std::array<Vertex, 3>{vertices[f[0]], vertices[f[1]], vertices[f[2]]}, graph);
    return vertices;
  }

private:
  Field                m_field;
  std::vector<Point_2> m_parameters;
  std::vector<Face>    m_faces;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_SURFACE_MESH_3_H

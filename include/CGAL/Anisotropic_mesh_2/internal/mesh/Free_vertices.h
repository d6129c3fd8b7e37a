// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H

#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The vertices of the domain that are not fixed, in the order of their indices.
template <class Mesh>
std::vector<typename Mesh::Vertex_handle> free_vertices(const Mesh& mesh)
{
  typedef typename Mesh::Vertex_handle Vertex_handle;
  std::vector<Vertex_handle> result;
  for(Vertex_handle v : mesh.finite_vertex_handles()) // what ends no constrained edge has all its faces on one side
    if(v->face()->is_in_domain() && !mesh.is_fixed(v))
      result.push_back(v);
  std::sort(result.begin(), result.end(),
            [](Vertex_handle v, Vertex_handle w) { return v->index() < w->index(); });
  return result;
}

// The vertices of a mesh that may move, and their way to and from plain arrays: there, the
// coordinate k of the i-th vertex is number dimension * i + k. Where points are finer than doubles, the numbers of
// those at which the vertices stood at first lead back to exactly these.
template <class Mesh>
class Free_vertices
{
  typedef typename Mesh::Point         Point;
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef std::vector<double>          Array;

public:
  static constexpr std::size_t dimension = 2;

  explicit Free_vertices(const Mesh& mesh) : m_handles(free_vertices(mesh))
  {
    if constexpr(has_finer_points) {
      m_first_positions = positions();
      for(Vertex_handle v : m_handles)
        m_first_points.push_back(v->point());
    }
  }

  // Takes the vertices of the same indices, in their order, from another mesh.
  void find_in(const Mesh& mesh) { m_handles = free_vertices(mesh); }

  // without those where the metric has jumps: the energy says nothing there
  template <class Metric>
  Free_vertices(const Mesh& mesh, const Metric& metric) : Free_vertices(mesh)
  {
    m_handles.erase(std::remove_if(m_handles.begin(), m_handles.end(),
                                   [&](Vertex_handle v) { return !metric.is_resolved(v); }), m_handles.end());
  }

  std::size_t size() const { return m_handles.size(); }
  Vertex_handle operator[](std::size_t i) const { return m_handles[i]; }

  std::vector<int> indices() const
  {
    std::vector<int> result;
    for(Vertex_handle v : m_handles)
      result.push_back(v->index());
    return result;
  }

  Array positions() const
  {
    Array result;
    result.reserve(dimension * size());
    for(std::size_t i = 0; i < size(); ++i) {
      const auto x = m_handles[i]->point().x(), y = m_handles[i]->point().y();
      const bool is_first = i < m_first_points.size() && x == m_first_points[i].x() && y == m_first_points[i].y();
      result.push_back(is_first ? m_first_positions[2*i] : CGAL::to_double(x));
      result.push_back(is_first ? m_first_positions[2*i + 1] : CGAL::to_double(y));
    }
    return result;
  }

  // Tensors and faces stay as they are.
  template <class ConcurrencyTag>
  void set_positions(const Array& x) const
  {
    for_each_index<ConcurrencyTag>(size(), [&](std::size_t i) { m_handles[i]->set_point(point(x, i)); });
  }

  Point point(const Array& x, std::size_t i) const { return point(x[2*i], x[2*i + 1], i); }

  // on the way from x to y, of which it has gone the share t
  Point point_between(const Array& x, const Array& y, double t, std::size_t i) const
  {
    return point(x[2*i] + t * (y[2*i] - x[2*i]), x[2*i + 1] + t * (y[2*i + 1] - x[2*i + 1]), i);
  }

  // of the i-th vector of an array, in the tensor of the vertex
  double metric_length(const Array& v, std::size_t i) const
  {
    return Symmetric_form(m_handles[i]->metric_tensor()).length(v[2*i], v[2*i + 1]);
  }

private:
  static constexpr bool has_finer_points = !std::is_same<Coordinate<Point>, double>::value;

  // the one of the i-th vertex
  Point point(double x, double y, std::size_t i) const
  {
    if constexpr(has_finer_points)
      if(x == m_first_positions[2*i] && y == m_first_positions[2*i + 1])
        return m_first_points[i];
    return point_at<Point>(x, y);
  }

  std::vector<Vertex_handle> m_handles;
  std::vector<Point>         m_first_points;    // where points are finer than doubles;
  Array                      m_first_positions; // to_double() may depend on what has been computed since
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FREE_VERTICES_H

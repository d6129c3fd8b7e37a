// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_SAMPLED_METRIC_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_SAMPLED_METRIC_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Control_space.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The control space over the faces of a domain as they are at the time of
// construction. Vertices may move afterwards: where each was last is where the
// search for points near it begins.
template <class Mesh>
class Sampled_metric
{
  typedef typename Mesh::Point         Point;
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Face_handle   Face_handle;
  typedef typename Mesh::Metric_tensor_2 Metric_tensor_2;
  typedef typename Metric_tensor_2::FT FT;

public:
  template <class ConcurrencyTag>
  Sampled_metric(ConcurrencyTag tag, const Mesh& mesh)
    : m_triangle_of(mesh.vertex_index_bound(), 0), m_variation(mesh.vertex_index_bound(), 0),
      m_is_resolved(mesh.vertex_index_bound(), true), m_size(typical_size(mesh)),
      m_space(make_space(tag, mesh, m_size, m_triangle_of))
  {
    int triangle = 0;
    for(Face_handle f : mesh.faces_in_domain()) {
      for(int k = 0; k < 3; ++k) {
        const int i = f->vertex(k)->index();
        m_variation[i] = (std::max)(m_variation[i], m_space.variation(triangle));
        m_is_resolved[i] = m_is_resolved[i] && m_space.is_resolved(triangle);
      }
      ++triangle;
    }
  }

  explicit Sampled_metric(const Mesh& mesh) : Sampled_metric(Sequential_tag(), mesh) {}

  // the tensor at x, which lies near v
  Metric_sample operator()(const Vector_of_doubles& x, Vertex_handle v) const
  {
    int triangle = m_triangle_of[v->index()];
    const Metric_sample s = m_space(x, triangle);
    const double unit = 1 / (m_size * m_size);
    return {unit * s.tensor, unit * s.by_x, unit * s.by_y, unit * s.root_of_determinant};
  }

  Symmetric_form tensor(const Vector_of_doubles& x, Vertex_handle v) const
  {
    int triangle = m_triangle_of[v->index()];
    return 1 / (m_size * m_size) * Tensor_exponential(m_space.logarithm(x, triangle)).value();
  }

  // the tensor where v is
  Metric_tensor_2 operator()(Vertex_handle v)
  {
    const Symmetric_form l = m_space.logarithm(to_doubles(v->point()), m_triangle_of[v->index()]);
    return Metric_tensor_2::from_logarithm({l.a, l.b, l.c}).scaled(FT(m_size));
  }

  // how far the logarithm in the faces at v was from that at a corner, at most
  double variation(Vertex_handle v) const { return m_variation[v->index()]; }

  // whether samples agreed with the interpolation in all faces at v
  bool is_resolved(Vertex_handle v) const { return m_is_resolved[v->index()]; }

private:
  // A power of two: in sizes relative to it, meshes that are scaled by one have the same logarithms.
  static double typical_size(const Mesh& mesh)
  {
    if(mesh.number_of_vertices() == 0)
      return 1;
    const Symmetric_form m(mesh.finite_vertices_begin()->metric_tensor());
    return std::ldexp(1., -int(std::floor(std::ilogb(m.a + m.c) / 2.)));
  }

  template <class ConcurrencyTag>
  static Control_space make_space(ConcurrencyTag tag, const Mesh& mesh, double size, std::vector<int>& triangle_of)
  {
    const std::vector<Face_handle> faces = mesh.faces_in_domain();
    std::unordered_map<Face_handle, int> rank(2 * faces.size());
    for(std::size_t i = 0; i < faces.size(); ++i)
      rank[faces[i]] = int(i);
    std::vector<Control_space::Triangle> triangles(faces.size());
    Vectors points(mesh.vertex_index_bound());
    std::vector<Symmetric_form> logarithms(points.size());
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        const Vertex_handle v = faces[i]->vertex(k);
        const auto n = rank.find(faces[i]->neighbor(k));
        triangles[i].corner[k] = v->index();
        triangles[i].neighbor[k] = n == rank.end() ? -1 : n->second;
        points[v->index()] = to_doubles(v->point());
        triangle_of[v->index()] = int(i);
      }
    for(Vertex_handle v : mesh.finite_vertex_handles())
      logarithms[v->index()] = logarithm_of(v->metric_tensor().scaled(FT(1 / size)));
    const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
    return Control_space(tag, std::move(points), std::move(triangles), logarithms,
                         [&](const Vector_of_doubles& x) {
                           return logarithm_of(tensor(point_at<Point>(x.x, x.y)).scaled(FT(1 / size)));
                         });
  }

  // by the index of the vertex
  std::vector<int>    m_triangle_of;
  std::vector<double> m_variation;
  std::vector<bool>   m_is_resolved;
  const double        m_size;
  Control_space       m_space;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_SAMPLED_METRIC_H

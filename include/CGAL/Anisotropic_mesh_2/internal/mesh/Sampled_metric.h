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
  typedef int Place; // a triangle of the control space

  template <class ConcurrencyTag>
  Sampled_metric(ConcurrencyTag tag, const Mesh& mesh,
                 const Sampling& sampling = sampling_for_iteration)
    : m_triangle_of(mesh.vertex_index_bound(), 0), m_variation(mesh.vertex_index_bound(), 0),
      m_is_resolved(mesh.vertex_index_bound(), true), m_is_accurate(mesh.vertex_index_bound(), true),
      m_size(typical_size(mesh)), m_space(make_space(tag, mesh, sampling, m_size, m_triangle_of))
  {
    int triangle = 0;
    for(Face_handle f : mesh.faces_in_domain()) {
      for(int k = 0; k < 3; ++k) {
        const int i = f->vertex(k)->index();
        m_variation[i] = (std::max)(m_variation[i], m_space.variation(triangle));
        m_is_resolved[i] = m_is_resolved[i] && m_space.is_resolved(triangle);
        m_is_accurate[i] = m_is_accurate[i] && m_space.is_accurate(triangle);
      }
      ++triangle;
    }
  }

  explicit Sampled_metric(const Mesh& mesh) : Sampled_metric(Sequential_tag(), mesh) {}

  // where to search for points near v
  Place place_near(Vertex_handle v) const { return m_triangle_of[v->index()]; }

  // to be called for vertices that come later
  void set_place(Vertex_handle v, Place place)
  {
    m_triangle_of.resize((std::max)(m_triangle_of.size(), std::size_t(v->index()) + 1), place);
    m_triangle_of[v->index()] = place;
  }

  // the tensor at x; the search begins at a place that becomes that of x
  Metric_sample operator()(const Vector_of_doubles& x, Place& place) const
  {
    const Metric_sample s = m_space(x, place);
    const double unit = 1 / (m_size * m_size);
    return {unit * s.tensor, unit * s.by_x, unit * s.by_y, unit * s.root_of_determinant};
  }

  Symmetric_form tensor(const Vector_of_doubles& x, Place& place) const
  {
    return tensor_of(m_space.logarithm(x, place));
  }

  Symmetric_form tensor(const Vector_of_doubles& x, Vertex_handle v) const
  {
    Place place = place_near(v);
    return tensor(x, place);
  }

  Metric_tensor_2 metric_tensor(const Vector_of_doubles& x, Place& place) const
  {
    const Symmetric_form l = m_space.logarithm(x, place), m = Tensor_exponential(l).value();
    if(!(m.determinant() > 1e-6 * m.a * m.c)) // rounding errors of the entries are too large
      return Metric_tensor_2::from_logarithm({l.a, l.b, l.c}).scaled(FT(m_size));
    return Metric_tensor_2::from_entries(FT(m.a), FT(m.b), FT(m.c)).scaled(FT(m_size));
  }

  // the tensor where v is
  Metric_tensor_2 operator()(Vertex_handle v)
  {
    return metric_tensor(to_doubles(v->point()), m_triangle_of[v->index()]);
  }

  // As long as the mesh is as it was: what was sampled in a face, whose place is its rank in `faces_in_domain()`.

  Symmetric_form at_barycentre(Place face) const { return tensor_of(m_space.at_barycentre(face)); }

  // the integral of (det M)^exponent
  double density_integral(Place face, double exponent) const
  {
    return std::pow(m_size, -4 * exponent) * m_space.density_integral(face, exponent);
  }

  // the length of the edge of f that is opposite to its vertex i, and its error
  Control_space::Mean length(Face_handle f, Place face, int i) const
  {
    const Vector_of_doubles p = to_doubles(f->vertex(Mesh::ccw(i))->point());
    const Vector_of_doubles q = to_doubles(f->vertex(Mesh::cw(i))->point());
    return m_space.mean_over_edge(face, i, [&](const Symmetric_form& logarithm) {
      return tensor_of(logarithm).length(q.x - p.x, q.y - p.y);
    });
  }

  // how far the logarithm in the faces at v was from that at a corner, at most
  double variation(Vertex_handle v) const { return m_variation[v->index()]; }

  // whether samples came near to the interpolation in all faces at v
  bool is_resolved(Vertex_handle v) const { return m_is_resolved[v->index()]; }

  // whether they agreed with it there, at a place, or everywhere
  bool is_accurate(Vertex_handle v) const { return m_is_accurate[v->index()]; }
  bool is_accurate(Place place) const { return m_space.is_accurate(place); }
  bool is_accurate() const { return m_space.is_accurate(); }

private:
  Symmetric_form tensor_of(const Symmetric_form& logarithm) const
  {
    return 1 / (m_size * m_size) * Tensor_exponential(logarithm).value();
  }

  // A power of two: in sizes relative to it, meshes that are scaled by one have the same logarithms.
  static double typical_size(const Mesh& mesh)
  {
    if(mesh.number_of_vertices() == 0)
      return 1;
    const Symmetric_form m(mesh.finite_vertices_begin()->metric_tensor());
    return std::ldexp(1., -int(std::floor(std::ilogb(m.a + m.c) / 2.)));
  }

  template <class ConcurrencyTag>
  static Control_space make_space(ConcurrencyTag tag, const Mesh& mesh, const Sampling& sampling, double size,
                                  std::vector<int>& triangle_of)
  {
    const std::vector<Face_handle> faces = mesh.faces_in_domain();
    std::vector<Control_space::Indices> corners(faces.size());
    Vectors points(mesh.vertex_index_bound());
    std::vector<Symmetric_form> logarithms(points.size());
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        const Vertex_handle v = faces[i]->vertex(k);
        corners[i][k] = v->index();
        points[v->index()] = to_doubles(v->point());
        triangle_of[v->index()] = int(i);
      }
    for(Vertex_handle v : mesh.finite_vertex_handles())
      logarithms[v->index()] = logarithm_of(v->metric_tensor().scaled(FT(1 / size)));
    const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
    return Control_space(tag, sampling, points, corners, logarithms,
                         [&](const Vector_of_doubles& x) {
                           return logarithm_of(tensor(point_at<Point>(x.x, x.y)).scaled(FT(1 / size)));
                         });
  }

  // by the index of the vertex
  std::vector<int>    m_triangle_of;
  std::vector<double> m_variation;
  std::vector<bool>   m_is_resolved, m_is_accurate;
  const double        m_size;
  Control_space       m_space;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_SAMPLED_METRIC_H

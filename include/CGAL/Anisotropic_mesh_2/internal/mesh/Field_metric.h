// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_METRIC_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_METRIC_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Metric_sample.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// The metric field of a mesh itself, evaluated whenever it is asked for; derivatives are central differences.
template <class Mesh>
class Field_metric
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Metric_tensor_2 Metric_tensor_2;

public:
  typedef Vertex_handle Place;

  explicit Field_metric(const Mesh& mesh)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object())
  {}

  Metric_tensor_2 operator()(Vertex_handle v) const { return m_tensor(v->point()); }

  static Place place_near(Vertex_handle v) { return v; }

  Symmetric_form tensor(const Vector_of_doubles& x, Vertex_handle) const
  {
    return Symmetric_form(m_tensor(point_at<Point>(x.x, x.y)));
  }

  Metric_sample operator()(const Vector_of_doubles& x, Vertex_handle v) const
  {
    const Vector_of_doubles z = to_doubles(v->point());
    const double step = 1e-5 * (std::abs(x.x - z.x) + std::abs(x.y - z.y));
    const Symmetric_form m = tensor(x, v);
    const auto derivative = [&](double dx, double dy) {
      return (1 / (2*step)) * (tensor({x.x + dx, x.y + dy}, v) + (-1.) * tensor({x.x - dx, x.y - dy}, v));
    };
    return {m, derivative(step, 0), derivative(0, step), std::sqrt(m.determinant())};
  }

  // how far the logarithm at v is from those at its neighbors
  double variation(Vertex_handle v) const
  {
    const Symmetric_form l = logarithm_of(v->metric_tensor());
    double largest = 0;
    auto w = m_mesh.incident_vertices(v), done = w;
    do
      if(!m_mesh.is_infinite(w))
        largest = (std::max)(largest, (logarithm_of(w->metric_tensor()) + (-1.) * l).norm());
    while(++w != done);
    return largest;
  }

  static bool is_resolved(Vertex_handle) { return true; }
  static bool is_accurate() { return true; }

private:
  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_METRIC_H

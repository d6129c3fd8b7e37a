// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// How near a mesh is to a unit mesh: the share of edges of unit length, the mean
// quality and a tenth of the least one, which is that of a single face.
template <class ConcurrencyTag, class Mesh, class Metric>
class Unit_mesh_merit
{
  typedef typename Mesh::Face_handle   Face_handle;
  typedef typename Mesh::Vertex_handle Vertex_handle;

public:
  Unit_mesh_merit(const Mesh& mesh, const Metric& metric) : m_mesh(mesh), m_metric(metric) {}

  double operator()() const
  {
    const std::vector<double> q = qualities();
    return q.empty() ? 0 : share_of_unit_edges() + std::accumulate(q.begin(), q.end(), 0.) / double(q.size())
                         + *std::min_element(q.begin(), q.end()) / 10;
  }

private:
  std::vector<double> qualities() const
  {
    const std::vector<Face_handle> faces = m_mesh.faces_in_domain();
    std::vector<double> result(faces.size());
    for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t k) {
      const Face_handle f = faces[k];
      result[k] = metric_quality(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                                 m_metric.tensor(barycentre(triangle_of_doubles(f)), f->vertex(0)));
    });
    return result;
  }

  double share_of_unit_edges() const
  {
    const std::vector<typename Mesh::Edge> edges = m_mesh.edges_in_domain();
    return sum_over<ConcurrencyTag>(edges.size(), [&](std::size_t k) {
      const auto& [f, i] = edges[k];
      const double l = length(f->vertex(Mesh::ccw(i)), f->vertex(Mesh::cw(i)));
      return l*l >= 0.5 && l*l <= 2 ? 1. : 0.;
    }) / double(edges.size());
  }

  double length(Vertex_handle u, Vertex_handle v) const
  {
    const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
    return length_by_simpson(Symmetric_form(u->metric_tensor()), m_metric.tensor(middle(p, q), u),
                             Symmetric_form(v->metric_tensor()), q.x - p.x, q.y - p.y);
  }

  const Mesh&   m_mesh;
  const Metric& m_metric;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

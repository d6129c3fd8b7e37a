// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/Flip_policy.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Weighted_tensor.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Measures faces in the metric at their barycentres. Edges are rough where the tensors around them differ much.
template <class Mesh, class Metric>
class Quality_at_barycentre
{
  typedef typename Mesh::Vertex_handle   Vertex_handle;

public:
  explicit Quality_at_barycentre(const Metric& metric) : m_metric(&metric) {}

  double operator()(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    const Triangle_of_doubles t = {to_doubles(u->point()), to_doubles(v->point()), to_doubles(w->point())};
    return metric_quality(u->point(), v->point(), w->point(), m_metric->tensor(barycentre(t), u));
  }

  template <class Quadrilateral>
  bool is_rough(const Quadrilateral& v) const
  {
    const Weighted_tensor m(Symmetric_form(v[0]->metric_tensor()), false);
    for(Vertex_handle w : {v[2], v[1], v[3]})
      if(m.squared_distance_to(Weighted_tensor(Symmetric_form(w->metric_tensor()), false)) > squared_roughness)
        return true;
    return false;
  }

private:
  static constexpr double squared_roughness = 0.64;

  const Metric* m_metric;
};

// Flips edges of the domain, whose faces are given, until no flip is wanted any
// more. Most edges need none: these are found first, by all threads.
template <class ConcurrencyTag, class Mesh, class Metric>
void restore_connectivity(Mesh& mesh, const std::vector<typename Mesh::Face_handle>& faces, const Metric& metric)
{
  typedef typename Mesh::Edge Edge;
  if(faces.empty())
    return;
  const auto vertices = mesh.finite_vertex_handles();
  const bool is_uniform = have_multiples_of(vertices, (*vertices.begin())->metric_tensor());
  typedef Quality_at_barycentre<Mesh, Metric> Quality;
  Flip_policy<Mesh, Quality>
    policy(mesh, Quality(metric), mesh.number_of_faces(), is_uniform);
  mesh.flip_edges(selected_of_chunks<ConcurrencyTag, Edge>(faces.size(), [&](std::size_t k, auto& wanted) {
    for(int i = 0; i < 3; ++i)
      if(faces[k]->vertex(Mesh::ccw(i))->index() < faces[k]->vertex(Mesh::cw(i))->index()
         && policy.is_wanted(Edge(faces[k], i)))
        wanted.push_back(Edge(faces[k], i));
  }), [&](const Edge& e) { return policy(e); });
}

template <class Mesh>
void restore_connectivity(Mesh& mesh)
{
  restore_connectivity<Sequential_tag>(mesh, mesh.faces_in_domain(), Field_metric<Mesh>(mesh));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H

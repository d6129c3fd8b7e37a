// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_MESH_GENERATORS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_MESH_GENERATORS_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The vertices of the domain of a mesh as generators of a tessellation, with
// the distances to them and the integrals over their regions.
template <class Mesh_, class Distance>
class Mesh_generators
{
public:
  typedef Mesh_                        Mesh;
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Point         Point_2;

  static constexpr bool is_measured_at_generators = Distance::is_measured_at_generators;

  Mesh_generators(const Mesh& mesh, const Distance& distance)
    : m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()), m_set(collect(mesh, distance))
  {}

  const Generator_set& set() const { return m_set; }

  // in the order of the mesh
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // by the index of the vertex
  const std::vector<std::size_t>& numbers() const { return m_numbers; }

  // If distances are measured at generators, points get the Euclidean tensor.
  Metric_point metric_point_at(const Vector_of_doubles& x) const
  {
    if constexpr(is_measured_at_generators)
      return {x, Symmetric_form(1, 0, 1)};
    else
      return {x, tensor_at(x)};
  }

  // a vertex of the mesh
  template <class Vertex>
  Metric_point metric_point_of(const Vertex& v) const
  {
    return {to_doubles(v.point()), is_measured_at_generators ? Symmetric_form(1, 0, 1)
                                                             : Symmetric_form(v.metric_tensor())};
  }

  // the integrals over the triangles that make up region i
  Region_integrals integrate(std::size_t i, const std::vector<Triangle_of_doubles>& triangles, Measure measure,
                             double tolerance, double& error) const
  {
    const bool is_riemannian = measure == Measure::RIEMANNIAN;
    const auto density = [&](const Vector_of_doubles& x, Symmetric_form& m, double& w) {
      if(is_riemannian || !is_measured_at_generators)
        m = tensor_at(x);
      w = is_riemannian ? std::sqrt(m.determinant()) : 1;
      m = m_set.tensor({x, m}, i);
    };
    const Region_integrator<decltype(density)> integrator(density, tolerance);
    return integrator(triangles, m_set.position(i), error);
  }

private:
  Symmetric_form tensor_at(const Vector_of_doubles& x) const
  {
    return Symmetric_form(m_tensor(point_at<Point_2>(x.x, x.y)));
  }

  Generator_set collect(const Mesh& mesh, const Distance& distance)
  {
    m_numbers.assign(mesh.vertex_index_bound(), static_cast<std::size_t>(-1));
    Vectors positions;
    std::vector<Symmetric_form> tensors;
    for(Vertex_handle v : mesh.vertices_in_domain()) {
      m_numbers[v->index()] = m_vertices.size();
      m_vertices.push_back(v);
      positions.push_back(to_doubles(v->point()));
      if constexpr(is_measured_at_generators)
        tensors.push_back(Symmetric_form(distance(Vertex_handle(v))));
    }
    return Generator_set(std::move(positions), std::move(tensors));
  }

  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  std::vector<Vertex_handle>                                  m_vertices;
  std::vector<std::size_t>                                    m_numbers;
  Generator_set                                               m_set;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_MESH_GENERATORS_H

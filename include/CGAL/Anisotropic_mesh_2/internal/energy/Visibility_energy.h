// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_VISIBILITY_ENERGY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_VISIBILITY_ENERGY_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Visibility_sampling.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Weighted_tensor.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Visibility_region.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The energy of the tessellation of the vertices of a mesh and the moments of
// the regions, from the visibility regions of the vertices by the quadrature of
// section 4.2 of the paper. Neither tile the regions the domain exactly, nor
// are they free of overlaps: both are matters of sampling and of orphans.
template <class Mesh>
class Visibility_energy
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;

public:
  static constexpr bool has_couplings = false;

  Visibility_energy(const Mesh& mesh, Measure measure, const Visibility_sampling& sampling = Visibility_sampling())
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_is_riemannian(measure == Measure::RIEMANNIAN), m_sampling(sampling)
  {
    CGAL_precondition(sampling.parts_of_radius >= 1);
  }

  // Returns the energy and sets the moments, by the index of the vertex.
  double operator()(std::vector<Region_moments>& moments) const
  {
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    double energy = 0;
    for(auto v = m_mesh.finite_vertices_begin(); v != m_mesh.finite_vertices_end(); ++v)
      energy += add_region(v, moments[v->index()]);
    return energy;
  }

  // Adds the moments of the region of v; returns its energy.
  double add_region(Vertex_handle v, Region_moments& moments) const
  {
    const Visibility_region<Mesh> region(m_mesh, v, m_sampling);
    double energy = 0;
    for(const Vectors& polygon : region.polygons())
      for(std::size_t i = 0; i < polygon.size(); ++i)
        energy += add_triangle(region.generator(), polygon[i], polygon[(i + 1) % polygon.size()], moments);
    return energy;
  }

private:
  // The triangle zpq is divided along its radius into a triangle and trapezoids,
  // over each of which the tensor is that at the centroid.
  double add_triangle(const Vector_of_doubles& z, const Vector_of_doubles& p, const Vector_of_doubles& q,
                      Region_moments& moments) const
  {
    const double ux = p.x - z.x, uy = p.y - z.y, vx = q.x - z.x, vy = q.y - z.y;
    const double area = (ux*vy - uy*vx) / 2;
    if(area == 0) // where z is a corner of the region
      return 0;
    double energy = 0;
    for(int k = 0; k < m_sampling.parts_of_radius; ++k) {
      const double s = double(k) / m_sampling.parts_of_radius, t = double(k + 1) / m_sampling.parts_of_radius;
      const double share = t*t - s*s, ratio = (t*t*t - s*s*s) / (3 * share);
      const double dx = ratio * (ux + vx), dy = ratio * (uy + vy);
      const Symmetric_form m = area * weighted_tensor(z.x + dx, z.y + dy);
      moments.add(share * m, dx, dy);
      energy += (t*t*t*t - s*s*s*s) / 12 * (m(ux, uy) + m(vx, vy) + m(ux + vx, uy + vy));
    }
    return energy;
  }

  Symmetric_form weighted_tensor(double x, double y) const
  {
    return Weighted_tensor(Symmetric_form(m_tensor(point_at<Point>(x, y))), m_is_riemannian).weighted;
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const bool m_is_riemannian;
  const Visibility_sampling m_sampling;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_VISIBILITY_ENERGY_H

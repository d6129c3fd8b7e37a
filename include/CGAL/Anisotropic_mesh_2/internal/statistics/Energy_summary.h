// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_ENERGY_SUMMARY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_ENERGY_SUMMARY_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Summation_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/energy_of_hexagons.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// of the tessellations of one or several planar meshes, more exact than the optimizer needs it
template <class Mesh, class ConcurrencyTag>
class Energy_summary
{
  typedef std::vector<typename Mesh::Face_handle>   Faces;
  typedef std::vector<typename Mesh::Vertex_handle> Vertices;

public:
  explicit Energy_summary(Measure measure) : m_measure(measure) {}

  // Adds the energy and the area of `faces`, which have these `places` in the metric, and the pulls of `vertices`,
  // whose regions may reach into the `other_faces`.
  void add(const Mesh& mesh, const Sampled_metric<Mesh>& metric, const Faces& faces, const std::vector<int>& places,
           const Faces& other_faces, const Vertices& vertices)
  {
    const Summation_metric<Mesh> for_sums(mesh, metric, 2 * tolerance);
    Facewise_energy<Mesh, ConcurrencyTag, Summation_metric<Mesh> > energy(mesh, for_sums, m_measure, tolerance);
    std::vector<Region_moments> moments(mesh.vertex_index_bound());
    m_energy += energy.add_faces(faces, moments);
    energy.add_faces(other_faces, moments);
    for(const auto& v : vertices) {
      const Vector_of_doubles d = moments[v->index()].lloyd_move();
      m_largest_move = (std::max)(m_largest_move, Symmetric_form(v->metric_tensor()).length(d.x, d.y));
    }
    const double area = integral(metric, places, 0.5);
    m_area += area;
    m_faces += faces.size();
    m_density_integral += m_measure == Measure::RIEMANNIAN ? area : integral(metric, places, 0.25);
  }

  // Faces that were not added, because their regions are unknown, do not count in the ratio.
  template <class Statistics>
  void write_to(Statistics& statistics) const
  {
    if(m_faces == 0)
      return;
    statistics.ideal_vertices = ideal_number_of_vertices(m_area);
    statistics.energy = m_energy;
    statistics.energy_ratio = m_energy / energy_of_hexagons(m_density_integral, double(m_faces) / 2);
    statistics.gradient_norm = m_largest_move;
  }

private:
  static constexpr double tolerance = 0.2; // energies are as good as sums of samples

  static double integral(const Sampled_metric<Mesh>& metric, const std::vector<int>& places, double exponent)
  {
    return sum_over<ConcurrencyTag>(places.size(), [&](std::size_t k) {
      return metric.density_integral(places[k], exponent);
    });
  }

  Measure     m_measure;
  double      m_area = 0, m_density_integral = 0, m_energy = 0, m_largest_move = 0;
  std::size_t m_faces = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_ENERGY_SUMMARY_H

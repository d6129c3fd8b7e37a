// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_FULL_REGION_ENERGY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_FULL_REGION_ENERGY_H

#include <CGAL/Anisotropic_mesh_2/internal/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/Directional_distance_2.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>

#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The energy of the tessellation and the moments of the regions from the
// Voronoi diagram of the vertices, orphans included, by adaptive quadrature.
template <class Mesh>
class Full_region_energy
{
public:
  static constexpr bool has_couplings = false;

  Full_region_energy(const Mesh& mesh, Measure measure, double tolerance = 1e-4)
    : m_mesh(mesh), m_measure(measure), m_tolerance(tolerance)
  {}

  // Returns the energy and sets the moments, by the index of the vertex.
  double operator()(std::vector<Region_moments>& moments) const
  {
    const Anisotropic_Voronoi_diagram_2<Mesh> diagram(m_mesh, Directional_distance_2(), m_tolerance);
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    double energy = 0;
    for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
      const auto integrals = diagram.integrals(i, m_measure, m_tolerance);
      Region_moments& m = moments[diagram.region(i).vertex->index()];
      m.a = Symmetric_form(integrals.matrix[0], integrals.matrix[1], integrals.matrix[2]);
      m.gx = -integrals.energy_gradient[0] / 2;
      m.gy = -integrals.energy_gradient[1] / 2;
      energy += integrals.energy;
    }
    return energy;
  }

private:
  const Mesh&   m_mesh;
  const Measure m_measure;
  const double  m_tolerance;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_FULL_REGION_ENERGY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FULL_REGION_ENERGY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FULL_REGION_ENERGY_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Mesh_generators.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_subdivision.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/Directional_distance_2.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The energy of the tessellation and the moments of the regions from the
// Voronoi diagram of the vertices, orphans included, by adaptive quadrature; the
// boundaries of the regions are not needed.
template <class Mesh, class ConcurrencyTag = Sequential_tag>
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
    const Generators generators(m_mesh, Directional_distance_2());
    const std::vector<Region_integrals> sums = integrate(generators);
    moments.assign(m_mesh.vertex_index_bound(), Region_moments());
    double energy = 0;
    for(std::size_t i = 0; i < sums.size(); ++i) {
      moments[generators.vertices()[i]->index()] = sums[i].moments;
      energy += sums[i].energy;
    }
    return energy;
  }

private:
  typedef Mesh_generators<Mesh, Directional_distance_2> Generators;

  static constexpr std::size_t regions_of_chunk = 128;

  std::vector<Region_integrals> integrate(const Generators& generators) const
  {
    const Region_subdivision<Generators, ConcurrencyTag> subdivision(m_mesh, generators, m_tolerance);
    std::vector<Region_integrals> sums(generators.set().size());
    for_each_chunk<ConcurrencyTag>(sums.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i) {
        std::vector<Triangle_of_doubles> triangles;
        for(Region_tds::Face_handle f : subdivision.faces(i))
          triangles.push_back(Region_tds::triangle(f));
        double error;
        sums[i] = generators.integrate(i, triangles, m_measure, m_tolerance, error);
      }
    }, regions_of_chunk);
    return sums;
  }

  const Mesh&   m_mesh;
  const Measure m_measure;
  const double  m_tolerance;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FULL_REGION_ENERGY_H

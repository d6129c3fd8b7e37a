// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H
#define CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H

#include <CGAL/Anisotropic_mesh_2/internal/write_figures.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// figures of how good a mesh of a surface is, in the metric of the space at the surface
/// and as an approximation of the surface.
struct Surface_mesh_statistics
{
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double ideal_vertices = 0;           ///< what a unit mesh has: \f$ 2/\sqrt 3 \f$ times the area in the metric
  double edge_length_mean = 0;         ///< of the straight edges in space
  double edge_length_min = 0;
  double edge_length_max = 0;
  double edge_length_unit_share = 0;   ///< the share of edges with lengths in \f$ [\sqrt{1/2}, \sqrt 2] \f$
  double quality_mean = 0;             ///< \f$ 4 \sqrt 3 |T|_M / \sum_i e_i^T M e_i \f$ of flat triangles, `M` at the barycentre
  double quality_min = 0;
  double quality_min3_mean = 0;        ///< the least of the three qualities with `M` at the vertices
  double quality_min3_min = 0;
  double distance_mean = 0;            ///< from barycentres and midpoints of edges to the surface, in units of space
  double distance_max = 0;
  double normal_deviation_mean = 0;    ///< from the normal of the surface, at barycentres, in radians
  double normal_deviation_max = 0;
  double energy = 0;                   ///< of the anisotropic Voronoi tessellation in the charts, Riemannian measure
  double energy_ratio = 0;             ///< the energy over that of as many regular hexagons; 1 is perfect

  /// calls `visit(name, value)` for each figure in the order above.
  /// \tparam Visit a functor of a `const char*` and either a `std::size_t` or a `double`
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    visit("vertices", vertices);
    visit("triangles", triangles);
    visit("ideal_vertices", ideal_vertices);
    visit("edge_length_mean", edge_length_mean);
    visit("edge_length_min", edge_length_min);
    visit("edge_length_max", edge_length_max);
    visit("edge_length_unit_share", edge_length_unit_share);
    visit("quality_mean", quality_mean);
    visit("quality_min", quality_min);
    visit("quality_min3_mean", quality_min3_mean);
    visit("quality_min3_min", quality_min3_min);
    visit("distance_mean", distance_mean);
    visit("distance_max", distance_max);
    visit("normal_deviation_mean", normal_deviation_mean);
    visit("normal_deviation_max", normal_deviation_max);
    visit("energy", energy);
    visit("energy_ratio", energy_ratio);
  }

  /// writes one line per figure.
  friend std::ostream& operator<<(std::ostream& os, const Surface_mesh_statistics& s)
  {
    return internal::write_figures(os, s);
  }

  /// writes the figures as a flat JSON object.
  void write_json(std::ostream& os) const { internal::write_figures_as_json(os, *this); }
};

} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H

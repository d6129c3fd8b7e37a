// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_MESH_STATISTICS_H
#define CGAL_ANISOTROPIC_MESH_2_MESH_STATISTICS_H

#include <CGAL/Anisotropic_mesh_2/internal/statistics/write_statistics.h>

#include <cstddef>
#include <ostream>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// measures of how good a mesh is in its metric (section 5.1 of \cgalCite{dw-acvt-05}).
///
/// The quality of a triangle \f$ T \f$ with the edges \f$ e_i \f$ in a tensor \f$ M \f$ is
/// \f$ 4 \sqrt 3 \sqrt{\det M} |T| / \sum_i e_i^T M e_i \f$: 1 if it is equilateral in \f$ M \f$, else less, and
/// more than 0. Without triangles all of them are 0.
/// \sa `CGAL::anisotropic_mesh_statistics_2()`
struct Mesh_statistics
{
  std::size_t vertices = 0;            ///< of the domain
  std::size_t triangles = 0;           ///< of the domain
  double ideal_vertices = 0;           ///< \f$ 2/\sqrt 3 \f$ times the area in the metric: those of a unit mesh without
                                       ///< boundary, which brings about half of its own vertices in addition
  double edge_length_mean = 0;         ///< Riemannian lengths of the edges of the domain: their mean; 1 is ideal
  double edge_length_min = 0;          ///< the least of them
  double edge_length_max = 0;          ///< the largest of them
  double edge_length_unit_share = 0;   ///< the share of edges with lengths in \f$ [\sqrt{1/2}, \sqrt 2] \f$, at most 1
  double quality_mean = 0;             ///< qualities with the tensor at the barycentre: their mean
  double quality_min = 0;              ///< the least of them
  double quality_min3_mean = 0;        ///< the least qualities of triangles with the tensors at the vertices: the mean
  double quality_min3_min = 0;         ///< the least of these
  double energy = 0;                   ///< of the anisotropic Voronoi tessellation, in the measure asked for
  double energy_ratio = 0;             ///< the energy over that of equally many regular hexagons; 1 is perfect
  double gradient_norm = 0;            ///< the largest metric length from a free vertex to its mass centre; after
                                       ///< `optimize_anisotropic_mesh_2()` some hundredths, for its topological moves take
                                       ///< vertices away from there

  /// calls `visit(name, value)` for each value, from `vertices` to `gradient_norm`.
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
    visit("energy", energy);
    visit("energy_ratio", energy_ratio);
    visit("gradient_norm", gradient_norm);
  }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Mesh_statistics& s)
  {
    return internal::write_statistics(os, s);
  }

  /// writes the statistics as a flat JSON object.
  void write_json(std::ostream& os) const { internal::write_statistics_as_json(os, *this); }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_MESH_STATISTICS_H

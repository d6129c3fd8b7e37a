// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H
#define CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H

#include <CGAL/Anisotropic_mesh_2/Mesh_statistics.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/write_statistics.h>

#include <ostream>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// measures of how good a mesh of a surface is, in the metric of the space at the surface
/// and as an approximation of the surface (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// Lengths are those of the straight edges in space, qualities those of the flat triangles
/// \f$ T \f$ there, \f$ 4 \sqrt 3 |T|_M / \sum_i e_i^T M e_i \f$. Tessellation and mass centres are those in
/// charts of the surface, in each of which the vertices that are far from where it is cut are measured.
/// Vertices at the border of the mesh are not free. Faces that overlap others in every chart have no share in the
/// tessellation, nor in its ideal number of vertices.
/// \sa `CGAL::anisotropic_surface_mesh_statistics_3()`
struct Surface_mesh_statistics
  : public Mesh_statistics
{
  double distance_mean = 0;            ///< from barycentres and midpoints of edges to the surface, in units of space
  double distance_max = 0;             ///< the largest of these distances
  double normal_deviation_mean = 0;    ///< from the normal of the surface, at barycentres, in radians
  double normal_deviation_max = 0;     ///< the largest of these angles

  /// calls `visit(name, value)` for each figure, those of `Mesh_statistics` first.
  /// \tparam Visit a functor of a `const char*` and either a `std::size_t` or a `double`
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    Mesh_statistics::for_each(visit);
    visit("distance_mean", distance_mean);
    visit("distance_max", distance_max);
    visit("normal_deviation_mean", normal_deviation_mean);
    visit("normal_deviation_max", normal_deviation_max);
  }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Surface_mesh_statistics& s)
  {
    return internal::write_statistics(os, s);
  }

  /// writes the statistics as a flat JSON object.
  void write_json(std::ostream& os) const { internal::write_statistics_as_json(os, *this); }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_SURFACE_MESH_STATISTICS_H

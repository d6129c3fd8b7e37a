// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_SURFACE_VORONOI_REGION_3_H
#define CGAL_ANISOTROPIC_MESH_2_SURFACE_VORONOI_REGION_3_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the region of a vertex of a mesh of a surface, on the surface (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// \sa `CGAL::anisotropic_surface_Voronoi_regions_3()`
///
/// \tparam K a model of `Kernel`
template <class K>
struct Surface_voronoi_region_3
{
  typedef typename K::Point_3        Point_3; ///< a point of the surface
  typedef std::array<Point_3, 3>     Tile;    ///< the corners of a triangle

  std::size_t                        vertex;     ///< its number in the mesh
  std::vector<std::vector<Point_3> > boundaries; ///< closed lines with the region on their left
  std::vector<Tile>                  tiles;      ///< triangles that make up the region, but for the surface's curvature
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_SURFACE_VORONOI_REGION_3_H

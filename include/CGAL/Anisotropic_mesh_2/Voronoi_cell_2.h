// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_CELL_2_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_CELL_2_H

#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the region of a generator as polygons.
///
/// \tparam K a class with the type `Point_2`, for example a kernel of \cgal
template <class K>
struct Voronoi_cell_2
{
  typedef typename K::Point_2 Point_2;

  Point_2                             generator;
  std::vector<std::vector<Point_2> >  polygons;       ///< counterclockwise
  bool                                is_on_boundary; ///< whether the generator ends a constrained edge
};

} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_CELL_2_H

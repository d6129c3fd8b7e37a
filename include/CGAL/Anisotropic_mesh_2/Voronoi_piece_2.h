// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_PIECE_2_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_PIECE_2_H

#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a connected part of the region of a generator: a main or an orphan subregion in section 2.3 of
/// \cgalCite{dw-acvt-05}.
///
/// \tparam K a class with the type `Point_2`, for example a kernel of \cgal
template <class K>
struct Voronoi_piece_2
{
  typedef std::vector<typename K::Point_2> Polygon; ///< the corners of a closed line

  bool                  is_main = false; ///< whether it contains the generator; else it is an orphan
  double                area = 0;        ///< the Euclidean area
  std::vector<Polygon>  boundaries;      ///< the outer ones counterclockwise, those of holes clockwise
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_PIECE_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_BISECTOR_2_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_BISECTOR_2_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a curve along which the regions of two generators meet, as a polygonal line
/// (definition 2.2 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a class with the type `Point_2`, for example a kernel of \cgal
template <class K>
struct Voronoi_bisector_2
{
  std::array<std::size_t, 2>            regions;  ///< the one on the left and the one on the right
  bool                                  is_between_main_pieces; ///< else a piece beside it is an orphan
  bool                                  is_closed; ///< whether the last point is joined to the first one
  std::vector<typename K::Point_2>      points;    ///< the corners of the line, in order
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_BISECTOR_2_H

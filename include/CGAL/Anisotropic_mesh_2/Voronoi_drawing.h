// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_DRAWING_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_DRAWING_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>

#include <CGAL/Bbox_2.h>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2IO
///
/// what a picture of a Voronoi diagram shows besides the regions.
struct Voronoi_drawing
{
  bool generators = true;     ///< as dots
  bool mass_centres = false;  ///< in red, with a line from the generator
  bool dual_edges = false;    ///< lines between the generators of neighbors
  Measure measure = Measure::RIEMANNIAN; ///< of the mass centres
  Bbox_2 window;              ///< the part of the plane that is shown; all if it is empty
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_DRAWING_H

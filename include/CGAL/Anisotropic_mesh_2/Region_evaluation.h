// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_REGION_EVALUATION_H
#define CGAL_ANISOTROPIC_MESH_2_REGION_EVALUATION_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Enums
///
/// from what the optimizers take energies and mass centres.
enum class Region_evaluation
{
  /// from the faces, each divided among the vertices nearby by their bisectors: the fastest.
  BY_FACES,
  /// from the visibility regions of section 4.1 of \cgalCite{dw-acvt-05}, see
  /// `CGAL::anisotropic_visibility_region_2()`.
  VISIBILITY_REGIONS,
  /// from the full anisotropic Voronoi regions, orphans included, see
  /// `CGAL::Anisotropic_Voronoi_diagram_2`.
  FULL_REGIONS
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_REGION_EVALUATION_H

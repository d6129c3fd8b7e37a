// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_REFINEMENT_RESULT_H
#define CGAL_ANISOTROPIC_MESH_2_REFINEMENT_RESULT_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <cstddef>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how `CGAL::refine_anisotropic_mesh_2()` and `CGAL::make_anisotropic_mesh_2()` ended; the mesh is valid in any case.
struct Refinement_result
{
  std::size_t number_of_insertions = 0; ///< of field points
  bool time_limit_reached = false;      ///< whether the time limit ended the insertion
  bool vertex_limit_reached = false;    ///< whether there were four times as many vertices as the area of the faces in
                                        ///< the metric asks for, which ended the insertion
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_REFINEMENT_RESULT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_MEASURE_H
#define CGAL_ANISOTROPIC_MESH_2_MEASURE_H

#include <CGAL/license/Anisotropic_mesh_2.h>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Enums
///
/// the measure by which energies and mass centres are integrated (sections 2.4
/// and 4.2 of \cgalCite{dw-acvt-05}). It decides the sizes of an optimal mesh.
enum class Measure
{
  /// \f$ \sqrt{\det M}\, dx \f$: the optimal mesh has edges of unit length.
  RIEMANNIAN,
  /// \f$ dx \f$: the optimal density of vertices is \f$ (\det M)^{1/4} \f$,
  /// as function approximation wants it.
  LEBESGUE
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_MEASURE_H

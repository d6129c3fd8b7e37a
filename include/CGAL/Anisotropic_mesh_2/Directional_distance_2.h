// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_DIRECTIONAL_DISTANCE_2_H
#define CGAL_ANISOTROPIC_MESH_2_DIRECTIONAL_DISTANCE_2_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the directional distance of definition 2.1 of \cgalCite{dw-acvt-05}: the
/// distance from a point to a generator is measured by the tensor of the field
/// at the point. Bisectors pass through the midpoints of generators.
///
/// \cgalModels{GeneratorMetric_2}
struct Directional_distance_2
{
  /// distances are measured at points.
  static constexpr bool is_measured_at_generators = false;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_DIRECTIONAL_DISTANCE_2_H

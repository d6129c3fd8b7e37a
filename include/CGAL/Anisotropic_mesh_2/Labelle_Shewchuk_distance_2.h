// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_LABELLE_SHEWCHUK_DISTANCE_2_H
#define CGAL_ANISOTROPIC_MESH_2_LABELLE_SHEWCHUK_DISTANCE_2_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the distance of Labelle and Shewchuk \cgalCite{ls-avd-03}, for comparison: measured by the
/// tensor at the generator (section 2.3 of \cgalCite{dw-acvt-05}). Bisectors are
/// conics that do not pass through the midpoints of generators.
///
/// \cgalModels{GeneratorMetric_2}
struct Labelle_Shewchuk_distance_2
{
  /// distances are measured at generators.
  static constexpr bool is_measured_at_generators = true;

  /// the tensor by which distances to `v` are measured.
  template <class Vertex_handle>
  auto operator()(Vertex_handle v) const { return v->metric_tensor(); }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_LABELLE_SHEWCHUK_DISTANCE_2_H

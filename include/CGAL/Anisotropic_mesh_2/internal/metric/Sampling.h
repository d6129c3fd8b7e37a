// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SAMPLING_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SAMPLING_H

namespace CGAL::Anisotropic_mesh_2::internal {

// How closely a field is sampled over triangles, and at what price.
struct Sampling
{
  double tolerance;   // of matrix logarithms: triangles at whose barycentre the interpolation is that good stay
  double mean_error;  // of the others the worst ones are quartered, until this is the mean error
  double quarterings; // of a triangle, on an average, at most
};

// five percent of the entries wherever vertices may move to
constexpr Sampling sampling_for_iteration = {0.05, 0, 1.75};

// less than a thousandth of sums over all triangles
constexpr Sampling sampling_for_statistics = {0.005, 0.0005, 0.5};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SAMPLING_H

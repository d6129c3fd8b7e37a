// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_SAMPLE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_SAMPLE_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// The metric tensor at a point, and its derivatives along the axes.
struct Metric_sample
{
  Symmetric_form tensor, by_x, by_y;
  double         root_of_determinant;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_SAMPLE_H

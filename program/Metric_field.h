// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_METRIC_FIELD_H
#define ANISOTROPIC_MESH_2_PROGRAM_METRIC_FIELD_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Metric_tensor_2.h>

#include <functional>

namespace program {

typedef CGAL::Exact_predicates_inexact_constructions_kernel  Kernel;
typedef Kernel::Point_2                                      Point_2;
typedef CGAL::Metric_tensor_2<Kernel>                        Metric_tensor_2;

// Formulas, files and built-in metrics in one type, so that the mesher is
// instantiated once.
typedef std::function<Metric_tensor_2(const Point_2&)>       Metric_field;

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_METRIC_FIELD_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_COMPATIBILITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_COMPATIBILITY_H

#include <CGAL/version.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// Where CGAL has a named parameter `convergence`, ours is the same.
#if CGAL_VERSION_NR >= 1050600000
typedef CGAL::internal_np::convergence_ratio_t convergence_t;
#else
struct convergence_t {};
#endif

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_COMPATIBILITY_H

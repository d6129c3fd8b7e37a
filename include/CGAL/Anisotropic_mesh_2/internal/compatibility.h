// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_COMPATIBILITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_COMPATIBILITY_H

#include <CGAL/version.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Where CGAL has a named parameter `convergence`, ours is the same.
#if CGAL_VERSION_NR >= 1050600000
typedef CGAL::internal_np::convergence_ratio_t convergence_t;
#else
struct convergence_t {};
#endif

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_COMPATIBILITY_H

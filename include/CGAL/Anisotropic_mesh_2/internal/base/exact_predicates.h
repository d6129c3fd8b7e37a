// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_EXACT_PREDICATES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_EXACT_PREDICATES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <type_traits>

namespace CGAL::Anisotropic_mesh_2::internal {

// A kernel that decides exactly on the points of K: K itself, unless its
// numbers are plain floating point numbers.
template <class K>
using Exact_predicates_kernel_of =
  std::conditional_t<std::is_floating_point<typename K::FT>::value,
                     Exact_predicates_inexact_constructions_kernel, K>;

template <class K>
typename Exact_predicates_kernel_of<K>::Point_2 exact_point(const typename K::Point_2& p)
{
  return typename Exact_predicates_kernel_of<K>::Point_2(p.x(), p.y());
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_EXACT_PREDICATES_H

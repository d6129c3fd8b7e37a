// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

template <class ConcurrencyTag>
double scalar_product(const Vectors& u, const Vectors& v)
{
  return sum_over<ConcurrencyTag>(u.size(), [&](std::size_t i) { return u[i].x*v[i].x + u[i].y*v[i].y; });
}

// u += t v
template <class ConcurrencyTag>
void add_multiple(Vectors& u, double t, const Vectors& v)
{
  for_each_index<ConcurrencyTag>(u.size(), [&](std::size_t i) {
    u[i].x += t*v[i].x;
    u[i].y += t*v[i].y;
  });
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H

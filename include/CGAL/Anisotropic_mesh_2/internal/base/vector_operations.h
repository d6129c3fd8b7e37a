// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H

#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Of arrays of vectors, in which the coordinate k of the i-th one is number dimension * i + k;
// their numbers may be of different types.

template <class ConcurrencyTag, std::size_t dimension = 2, class U, class V>
double scalar_product(const std::vector<U>& u, const std::vector<V>& v)
{
  return sum_over<ConcurrencyTag>(u.size() / dimension, [&](std::size_t i) {
    double sum = u[dimension * i] * v[dimension * i];
    for(std::size_t k = dimension * i + 1; k < dimension * (i + 1); ++k)
      sum += u[k] * v[k];
    return sum;
  });
}

// u += t v
template <class ConcurrencyTag, class U, class V>
void add_multiple(std::vector<U>& u, double t, const std::vector<V>& v)
{
  for_each_index<ConcurrencyTag>(u.size(), [&](std::size_t i) { u[i] += t * v[i]; });
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_VECTOR_OPERATIONS_H

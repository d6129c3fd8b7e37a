// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_WEIGHTED_TENSOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_WEIGHTED_TENSOR_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// A tensor with its determinant, and weighted by the density of the measure.
struct Weighted_tensor
{
  Symmetric_form m;
  Symmetric_form weighted;
  double determinant = 1;

  Weighted_tensor() {}
  Weighted_tensor(const Symmetric_form& m, bool riemannian)
    : m(m), determinant(m.determinant())
  {
    weighted = riemannian ? std::sqrt(determinant) * m : m;
  }

  // The sum of (e - 1)^2 over the two eigenvalues e of m^-1 n: how far n is from
  // this tensor, seen from it.
  double squared_distance_to(const Weighted_tensor& n) const { return squared_distance_to(n, 1 / determinant); }

  // the same, the inverse of the determinant being known
  double squared_distance_to(const Weighted_tensor& n, double inverse) const
  {
    const double trace = (m.c*n.m.a - 2*m.b*n.m.b + m.a*n.m.c) * inverse;
    const double product = n.determinant * inverse;
    return (std::max)(0., trace*trace - 2*product - 2*trace + 2);
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_WEIGHTED_TENSOR_H

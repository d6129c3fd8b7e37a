// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_THREE_POINT_GAUSS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_THREE_POINT_GAUSS_H

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// the integral of f from t0 to t1, exact for polynomials of degree five
template <class Function>
double three_point_gauss(const Function& f, double t0, double t1)
{
  const double offset = std::sqrt(0.15) * (t1 - t0), middle = (t0 + t1) / 2;
  return (t1 - t0) / 18 * (5 * f(middle - offset) + 8 * f(middle) + 5 * f(middle + offset));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_THREE_POINT_GAUSS_H

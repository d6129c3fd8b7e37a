// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DIFFERENCE_OF_PRODUCTS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DIFFERENCE_OF_PRODUCTS_H

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// a*b - c*d
template <class FT>
FT difference_of_products(const FT& a, const FT& b, const FT& c, const FT& d)
{
  return a*b - c*d;
}

// The same with two fused operations where the products nearly cancel, which
// leaves an error of at most two units in the last place (Kahan).
inline double difference_of_products(const double& a, const double& b, const double& c, const double& d)
{
  const double ab = a*b, cd = c*d;
  const double plain = ab - cd;
  if(std::abs(plain) > 0.5 * std::abs(cd))
    return plain;
  const double error = std::fma(c, d, -cd);
  return std::fma(a, b, -cd) - error;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DIFFERENCE_OF_PRODUCTS_H

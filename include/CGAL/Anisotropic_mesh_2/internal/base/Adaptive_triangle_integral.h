// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_ADAPTIVE_TRIANGLE_INTEGRAL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_ADAPTIVE_TRIANGLE_INTEGRAL_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// The integral of a density over triangles by a rule of degree 5 with seven
// points, quartered until four parts agree with the whole up to a share of the
// integral and a density that is negligible. The depth is bounded, and so is the
// number of quarterings in all.
template <class Density>
class Adaptive_triangle_integral
{
public:
  typedef Triangle_of_doubles Triangle;

  Adaptive_triangle_integral(const Density& density, double relative_tolerance, std::size_t maximum_quarterings,
                             int maximum_depth = 24, double negligible_density = 0)
    : m_density(density), m_tolerance(relative_tolerance), m_budget(maximum_quarterings),
      m_maximum_depth(maximum_depth), m_negligible(negligible_density)
  {}

  double operator()(const Triangle& t)
  {
    const double whole = rule(t);
    return refined(t, whole, m_maximum_depth, m_tolerance * std::abs(whole));
  }

  // without quartering; exact for polynomials of degree five
  double rule(const Triangle& t) const
  {
    double sum = 0;
    for_each_node_of_radon(t, [&](const Vector_of_doubles& x, double weight, double) {
      sum += weight * m_density(x.x, x.y);
    });
    return area(t) * sum;
  }

private:
  // A part may be wrong by its relative tolerance, or else by an allowance that
  // halves with each quartering: where the density has a kink along a curve, the
  // number of parts on it only doubles.
  double refined(const Triangle& t, double whole, int depth, double allowance)
  {
    if(depth == 0 || m_budget == 0)
      return whole;
    --m_budget;
    const std::array<Triangle, 4> parts = quarters(t);
    std::array<double, 4> values;
    double sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += values[i] = rule(parts[i]);
    if(std::abs(sum - whole) <= (std::max)(m_tolerance * sum, allowance) + m_negligible * area(t))
      return sum;
    sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += refined(parts[i], values[i], depth - 1, allowance / 2);
    return sum;
  }

  Density     m_density;
  double      m_tolerance;
  std::size_t m_budget;
  int         m_maximum_depth;
  double      m_negligible;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_ADAPTIVE_TRIANGLE_INTEGRAL_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ADAPTIVE_TRIANGLE_INTEGRAL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ADAPTIVE_TRIANGLE_INTEGRAL_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The integral of a density over triangles by a rule of degree 5 with seven
// points, quartered until four parts agree with the whole up to a share of the
// integral and a density that is negligible. The depth is bounded, and so is the
// number of quarterings in all.
template <class Density>
class Adaptive_triangle_integral
{
public:
  typedef std::array<Vector_of_doubles, 3> Triangle;

  Adaptive_triangle_integral(const Density& density, double relative_tolerance, std::size_t maximum_quarterings,
                             int maximum_depth = 24, double negligible_density = 0)
    : m_density(density), m_tolerance(relative_tolerance), m_budget(maximum_quarterings),
      m_maximum_depth(maximum_depth), m_negligible(negligible_density)
  {}

  double operator()(const Triangle& t) { return refined(t, rule(t), m_maximum_depth); }

  // without quartering; exact for polynomials of degree five
  double rule(const Triangle& t) const
  {
    static const double r = std::sqrt(15.);
    const double outer = (6 - r) / 21, inner = (6 + r) / 21;
    const double sum = 0.225 * at(t, 1./3, 1./3)
      + (155 - r) / 1200 * (at(t, outer, outer) + at(t, outer, 1 - 2*outer) + at(t, 1 - 2*outer, outer))
      + (155 + r) / 1200 * (at(t, inner, inner) + at(t, inner, 1 - 2*inner) + at(t, 1 - 2*inner, inner));
    return area(t) * sum;
  }

private:
  double refined(const Triangle& t, double whole, int depth)
  {
    if(depth == 0 || m_budget == 0)
      return whole;
    --m_budget;
    const std::array<Triangle, 4> parts = quarters(t);
    std::array<double, 4> values;
    double sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += values[i] = rule(parts[i]);
    if(std::abs(sum - whole) <= m_tolerance * sum + m_negligible * area(t))
      return sum;
    sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += refined(parts[i], values[i], depth - 1);
    return sum;
  }

  static std::array<Triangle, 4> quarters(const Triangle& t)
  {
    const auto middle = [](const Vector_of_doubles& p, const Vector_of_doubles& q)
                        { return Vector_of_doubles{(p.x + q.x) / 2, (p.y + q.y) / 2}; };
    const Vector_of_doubles a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    return {{{{t[0], c, b}}, {{t[1], a, c}}, {{t[2], b, a}}, {{a, b, c}}}};
  }

  static double area(const Triangle& t)
  {
    return ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
  }

  double at(const Triangle& t, double l1, double l2) const
  {
    return m_density(t[0].x + l1 * (t[1].x - t[0].x) + l2 * (t[2].x - t[0].x),
                     t[0].y + l1 * (t[1].y - t[0].y) + l2 * (t[2].y - t[0].y));
  }

  Density     m_density;
  double      m_tolerance;
  std::size_t m_budget;
  int         m_maximum_depth;
  double      m_negligible;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ADAPTIVE_TRIANGLE_INTEGRAL_H

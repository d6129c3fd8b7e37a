// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BISECTOR_TRACER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BISECTOR_TRACER_H

#include <CGAL/Anisotropic_mesh_2/internal/Generator_set.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Finds points on the bisectors of generators.
template <class Place_at>
class Bisector_tracer
{
public:
  // `tolerance` is how far chords may be from the bisectors, relative to the distance to the generators
  Bisector_tracer(const Generator_set& generators, const Place_at& place_at, double tolerance)
    : m_generators(generators), m_place_at(place_at), m_tolerance(tolerance)
  {}

  // The point of the bisector of i and j between p, which is nearer to i, and
  // q, which is nearer to j; the same from both sides.
  Place crossing(const Place& p, const Place& q, std::size_t i, std::size_t j) const
  {
    if(j < i)
      return crossing(q, p, j, i);
    const auto at = [&](double t)
    { return Vector_of_doubles{p.at.x + t * (q.at.x - p.at.x), p.at.y + t * (q.at.y - p.at.y)}; };
    const auto excess = [&](double t) { return m_generators.difference(m_place_at(at(t)), i, j); };
    const double at_p = m_generators.difference(p, i, j), at_q = m_generators.difference(q, i, j);
    if(!(at_p < 0))
      return p;
    if(!(at_q > 0))
      return q;
    const double middle = excess(0.5);
    if(middle == 0) // as between two generators
      return m_place_at(at(0.5));
    std::uintmax_t steps = 60;
    const auto bracket = middle < 0
      ? boost::math::tools::toms748_solve(excess, 0.5, 1., middle, at_q, boost::math::tools::eps_tolerance<double>(50), steps)
      : boost::math::tools::toms748_solve(excess, 0., 0.5, at_p, middle, boost::math::tools::eps_tolerance<double>(50), steps);
    return m_place_at(at((bracket.first + bracket.second) / 2));
  }

  // Whether Newton's method finds, from `start` on, a point with the same
  // distance to the three generators without leaving where `contains` holds.
  template <class Contains>
  bool meeting_point(const Place& start, const std::array<std::size_t, 3>& label, const Contains& contains,
                     Place& result) const
  {
    result = start;
    for(int step = 0; step < 50; ++step) {
      const double u = m_generators.difference(result, label[0], label[1]);
      const double v = m_generators.difference(result, label[0], label[2]);
      const Vector_of_doubles gu = m_generators.gradient_of_difference(result, label[0], label[1]);
      const Vector_of_doubles gv = m_generators.gradient_of_difference(result, label[0], label[2]);
      const double det = gu.x*gv.y - gu.y*gv.x;
      const Vector_of_doubles d = {(u*gv.y - v*gu.y) / det, (gu.x*v - gv.x*u) / det};
      const double length = m_generators.tensor(result, label[0])(d.x, d.y);
      const double distance = m_generators.squared_distance(result, label[0]);
      const Vector_of_doubles next = {result.at.x - d.x, result.at.y - d.y};
      if(!contains(next))
        return false;
      result = m_place_at(next);
      if(length <= 1e-26 * distance)
        return true;
    }
    return false;
  }

  // Appends to `curve` the inner points of a polygonal line along the bisector
  // of i and j; fails where it leaves the place where `contains` holds.
  template <class Contains>
  bool trace(const Place& from, const Place& to, std::size_t i, std::size_t j, const Contains& contains,
             Vectors& curve) const
  {
    return trace(from.at, to.at, i, j, contains, maximum_depth, curve);
  }

private:
  static constexpr int maximum_depth = 12;

  template <class Contains>
  bool trace(const Vector_of_doubles& from, const Vector_of_doubles& to, std::size_t i, std::size_t j,
             const Contains& contains, int depth, Vectors& curve) const
  {
    const Place middle = m_place_at({(from.x + to.x) / 2, (from.y + to.y) / 2});
    Place p = middle;
    const bool is_on_bisector = project(p, i, j, contains);
    const double moved = std::sqrt(m_generators.tensor(middle, i)(p.at.x - middle.at.x, p.at.y - middle.at.y)
                                   / m_generators.squared_distance(middle, i));
    // a half of a curve is four times as near to its chord as the whole
    if(moved <= m_tolerance / 4)
      return true;
    if(!is_on_bisector)
      return false;
    if(moved <= m_tolerance || depth == 0) {
      curve.push_back(p.at);
      return true;
    }
    if(!trace(from, p.at, i, j, contains, depth - 1, curve))
      return false;
    curve.push_back(p.at);
    return trace(p.at, to, i, j, contains, depth - 1, curve);
  }

  // Moves p across the bisector onto it; fails if p would leave where
  // `contains` holds, and is then the first point beyond.
  template <class Contains>
  bool project(Place& p, std::size_t i, std::size_t j, const Contains& contains) const
  {
    const double rounding = 1e-24 * m_generators.squared_distance(p, i);
    for(int step = 0; step < 20; ++step) {
      const double excess = m_generators.difference(p, i, j);
      const Vector_of_doubles g = m_generators.gradient_of_difference(p, i, j), across = direction_across(i, j, g);
      const double t = -excess / (g.x*across.x + g.y*across.y);
      const Vector_of_doubles next = {p.at.x + t*across.x, p.at.y + t*across.y};
      const double last = m_generators.tensor(p, i)(t*across.x, t*across.y);
      if(last <= rounding)
        return true;
      if(!contains(next)) {
        p.at = next;
        return false;
      }
      p = m_place_at(next);
    }
    return false;
  }

  // perpendicular to the bisector, in the tensor of the place if that measures both distances
  Vector_of_doubles direction_across(std::size_t i, std::size_t j, const Vector_of_doubles& g) const
  {
    if(m_generators.is_measured_at_generators())
      return g;
    const Vector_of_doubles &zi = m_generators.position(i), &zj = m_generators.position(j);
    return {zj.x - zi.x, zj.y - zi.y};
  }

  const Generator_set& m_generators;
  const Place_at&      m_place_at;
  const double         m_tolerance;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BISECTOR_TRACER_H

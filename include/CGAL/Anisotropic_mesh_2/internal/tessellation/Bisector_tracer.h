// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_TRACER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_TRACER_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Anisotropic_mesh_2::internal {

// Finds points on the bisectors of generators.
template <class Generators>
class Bisector_tracer
{
public:
  // `tolerance` is how far chords may be from the bisectors, relative to the distance to the generators
  Bisector_tracer(const Generators& generators, double tolerance)
    : m_generators(generators), m_set(generators.set()), m_tolerance(tolerance)
  {}

  // The point of the bisector of i and j between p, which is nearer to i, and
  // q, which is nearer to j; the same from both sides.
  Metric_point crossing(const Metric_point& p, const Metric_point& q, std::size_t i, std::size_t j) const
  {
    if(j < i)
      return crossing(q, p, j, i);
    const auto at = [&](double t)
    { return Vector_of_doubles{p.at.x + t * (q.at.x - p.at.x), p.at.y + t * (q.at.y - p.at.y)}; };
    const auto excess = [&](double t) { return m_set.difference(m_generators.metric_point_at(at(t)), i, j); };
    const double at_p = m_set.difference(p, i, j), at_q = m_set.difference(q, i, j);
    if(!(at_p < 0))
      return p;
    if(!(at_q > 0))
      return q;
    const double middle = excess(0.5);
    if(middle == 0) // as between two generators
      return m_generators.metric_point_at(at(0.5));
    std::uintmax_t steps = 60;
    const boost::math::tools::eps_tolerance<double> is_narrow(50);
    const auto bracket = middle < 0
      ? boost::math::tools::toms748_solve(excess, 0.5, 1., middle, at_q, is_narrow, steps)
      : boost::math::tools::toms748_solve(excess, 0., 0.5, at_p, middle, is_narrow, steps);
    return m_generators.metric_point_at(at((bracket.first + bracket.second) / 2));
  }

  // Whether Newton's method finds, from the middle of the face on, a point
  // with the same distance to three generators without leaving the face. The
  // derivatives are differences towards two of its corners.
  template <class Contains>
  bool meeting_point(const std::array<const Metric_point*, 3>& corner, const Metric_point& middle,
                     const std::array<std::size_t, 3>& label, const Contains& contains, Metric_point& result) const
  {
    const double step = 1e-5;
    result = middle;
    for(int i = 0; i < 30; ++i) {
      const double u = m_set.difference(result, label[0], label[1]);
      const double v = m_set.difference(result, label[0], label[2]);
      std::array<Vector_of_doubles, 2> way;
      std::array<double, 2> du, dv;
      for(int k = 0; k < 2; ++k) {
        way[k] = {step * (corner[k]->at.x - result.at.x), step * (corner[k]->at.y - result.at.y)};
        const Metric_point p = m_generators.metric_point_at({result.at.x + way[k].x, result.at.y + way[k].y});
        du[k] = m_set.difference(p, label[0], label[1]) - u;
        dv[k] = m_set.difference(p, label[0], label[2]) - v;
      }
      const double det = du[0]*dv[1] - du[1]*dv[0];
      const double s = (du[1]*v - dv[1]*u) / det, t = (dv[0]*u - du[0]*v) / det;
      const Vector_of_doubles d = {s * way[0].x + t * way[1].x, s * way[0].y + t * way[1].y};
      const Vector_of_doubles next = {result.at.x + d.x, result.at.y + d.y};
      if(!contains(next))
        return false;
      const double length = m_set.tensor(result, label[0])(d.x, d.y);
      result = m_generators.metric_point_at(next);
      if(length <= 1e-24 * m_set.squared_distance(result, label[0]))
        return true;
    }
    return false;
  }

  // Appends to `curve` the inner points of a polygonal line along the bisector
  // of i and j; fails where it leaves the place where `contains` holds, or is far from the line.
  template <class Contains>
  bool trace(const Metric_point& from, const Metric_point& to, std::size_t i, std::size_t j, const Contains& contains,
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
    const Metric_point middle = m_generators.metric_point_at({(from.x + to.x) / 2, (from.y + to.y) / 2});
    Metric_point p = middle;
    const Vector_of_doubles chord = {to.x - from.x, to.y - from.y};
    const bool is_on_bisector = project(p, i, j, chord, contains);
    const Symmetric_form& m = m_set.tensor(middle, i);
    const double length = m.length(p.at.x - middle.at.x, p.at.y - middle.at.y);
    const double moved = length / std::sqrt(m_set.squared_distance(middle, i));
    // a half of a curve is four times as near to its chord as the whole
    if(moved <= m_tolerance / 4)
      return true;
    if(!is_on_bisector || length > m.length(chord.x, chord.y))
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

  // Moves p across the chord onto the bisector, by the secant method; fails if
  // p would leave where `contains` holds, and is then the first point beyond.
  template <class Contains>
  bool project(Metric_point& p, std::size_t i, std::size_t j, const Vector_of_doubles& chord,
               const Contains& contains) const
  {
    const double distance = m_set.squared_distance(p, i);
    const Metric_point start = p;
    const Symmetric_form& m = m_set.tensor(start, i);
    // perpendicular to the chord in the tensor of its middle
    const Vector_of_doubles across = {-(m.b*chord.x + m.c*chord.y), m.a*chord.x + m.b*chord.y};
    const double unit = std::sqrt(distance / m(across.x, across.y));
    double t = 0, excess = m_set.difference(p, i, j), old_t = 0, old_excess = excess;
    for(int step = 0; step < 30; ++step) {
      if(std::abs(excess) <= 1e-14 * distance)
        return true;
      const double next_t = step == 0 ? 1e-4 * m_tolerance : t - excess * (t - old_t) / (excess - old_excess);
      p.at = {start.at.x + next_t * unit * across.x, start.at.y + next_t * unit * across.y};
      if(!contains(p.at))
        return false;
      p = m_generators.metric_point_at(p.at);
      old_t = t;
      old_excess = excess;
      t = next_t;
      excess = m_set.difference(p, i, j);
      if(step > 0 && std::abs(t - old_t) <= 1e-12)
        return true;
    }
    return false;
  }

  const Generators&    m_generators;
  const Generator_set& m_set;
  const double         m_tolerance;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_TRACER_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Bisector_tracer.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_certificate.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// Divides faces among generators, given the labels of their corners; refuses
// where the labels alone do not tell how.
template <class Generators>
class Face_divider
{
public:
  // `tolerance` relative to the distance to the generator
  Face_divider(const Generators& generators, double tolerance)
    : m_generators(generators), m_set(generators.set()), m_tracer(generators, tolerance), m_certificate(generators),
      m_tolerance(tolerance)
  {}

  // Whether the face with the corners d.corner could be divided; always, if it is
  // the last chance or if the face is as small as the tolerance.
  bool operator()(bool is_last_chance, Face_division& d)
  {
    m_face.corner = {d.corner[0], d.corner[1], d.corner[2]};
    m_face.middle = mean(m_face.corner);
    const bool is_forced = is_last_chance || is_small(d);
    return (cross_edges(d) || is_forced)
        && (find_centre(d) || is_forced)
        && (m_certificate(m_face, d) || is_forced)
        && (trace(d) || is_forced);
  }

private:
  Metric_point mean(const std::array<const Metric_point*, 3>& p) const
  {
    return m_generators.metric_point_at({(p[0]->at.x + p[1]->at.x + p[2]->at.x) / 3,
                                  (p[0]->at.y + p[1]->at.y + p[2]->at.y) / 3});
  }

  // whether the face is as small as the tolerance
  bool is_small(const Face_division& d) const
  {
    const Metric_point& middle = m_face.middle;
    const double distance = m_set.squared_distance(middle, m_set.nearest(middle, d.label(0)));
    double longest = 0, length = 0, size = 0;
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = m_face.corner[k]->at, &q = m_face.corner[(k + 1) % 3]->at;
      longest = (std::max)(longest, m_set.tensor(middle, d.label(k))(q.x - p.x, q.y - p.y));
      length = (std::max)(length, (std::max)(std::abs(q.x - p.x), std::abs(q.y - p.y)));
      size = (std::max)(size, (std::max)(std::abs(p.x), std::abs(p.y)));
    }
    return longest <= m_tolerance * m_tolerance * distance || length <= 1e-13 * size;
  }

  // whether only the generators of their ends are nearest on the edges' crossings
  bool cross_edges(Face_division& d) const
  {
    bool is_clear = true;
    for(int k = 0; k < 3; ++k)
      if(d.is_crossed(k)) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        d.crossing[k] = m_tracer.crossing(*m_face.corner[i], *m_face.corner[j], d.label(i), d.label(j));
        is_clear = is_nearest(d.crossing[k], d.label(i)) && is_clear;
      }
    return is_clear;
  }

  // up to rounding
  bool is_nearest(const Metric_point& p, std::size_t label) const
  {
    const std::size_t nearest = m_set.nearest(p, label);
    return m_set.squared_distance(p, nearest) >= m_set.squared_distance(p, label) * (1 - 1e-10);
  }

  bool find_centre(Face_division& d) const
  {
    if(d.number_of_labels() != 3)
      return true;
    const bool is_found = m_tracer.meeting_point(m_face.corner, m_face.middle, {d.label(0), d.label(1), d.label(2)},
                                                 inside(), d.centre);
    if(is_found && is_nearest(d.centre, d.label(0)))
      return true;
    if(!is_found)
      d.centre = mean({&d.crossing[0], &d.crossing[1], &d.crossing[2]});
    return false;
  }

  auto inside() const { return [this](const Vector_of_doubles& x) { return contains(x); }; }

  // up to rounding, since faces may be needles
  bool contains(const Vector_of_doubles& x) const
  {
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = m_face.corner[k]->at, &q = m_face.corner[(k + 1) % 3]->at;
      const double u = (q.x - p.x) * (x.y - p.y), v = (q.y - p.y) * (x.x - p.x);
      if(!(u - v >= -1e-9 * (std::abs(u) + std::abs(v))))
        return false;
    }
    return true;
  }

  // whether the bisectors stay within the face
  bool trace(Face_division& d) const
  {
    const int n = d.number_of_labels();
    bool is_within = true;
    for(int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if(n == 3)
        is_within = trace(d.crossing[k], d.centre, d.label(i), d.label(j), d) && is_within;
      else if(n == 2 && !d.is_crossed(k)) // corner k is alone
        is_within = trace(d.crossing[j], d.crossing[i], d.label(k), d.label(i), d);
    }
    return is_within;
  }

  // A curve that does not stay within the face becomes straight.
  bool trace(const Metric_point& from, const Metric_point& to, std::size_t left, std::size_t right,
             Face_division& d) const
  {
    Face_division::Curve curve = {left, right, Vectors()};
    if(!m_tracer.trace(from, to, left, right, inside(), curve.points))
      return false;
    if(!curve.points.empty())
      d.curves.push_back(std::move(curve));
    return true;
  }

  const Generators&            m_generators;
  const Generator_set&         m_set;
  Bisector_tracer<Generators>  m_tracer;
  Face_certificate<Generators> m_certificate;
  const double                 m_tolerance;
  Face_samples                 m_face; // at hand
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H

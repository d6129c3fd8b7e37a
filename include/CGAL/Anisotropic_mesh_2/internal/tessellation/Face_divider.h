// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Bisector_tracer.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A place with its nearest generator.
struct Corner
{
  Place       place;
  std::size_t label = 0;
};

// How a face is divided among the nearest generators of its corners. Numbers
// of edges are those of the opposite corners.
struct Divided_face
{
  std::array<std::size_t, 3> label;
  std::array<Place, 3>       crossing; // of the bisector with an edge whose ends have different labels
  Place                      centre;   // where three bisectors meet, if there are three labels
  // The inner points of the bisectors: with three labels, curve[k] leads from
  // crossing[k] to the centre. With two, curve[k] of the corner k that is alone
  // leads from crossing[k + 2] to crossing[k + 1].
  std::array<Vectors, 3>     curve;

  bool is_crossed(int k) const { return label[(k + 1) % 3] != label[(k + 2) % 3]; }
  int number_of_labels() const
  {
    const int crossed = is_crossed(0) + is_crossed(1) + is_crossed(2);
    return crossed == 0 ? 1 : crossed;
  }
  // with two labels
  int odd_corner() const { return !is_crossed(0) ? 0 : !is_crossed(1) ? 1 : 2; }
};

// Divides faces among generators, given the labels of their corners; refuses
// where the labels alone do not decide. A face is settled if at all
// corners of the parts of each generator all others are farther by more than
// what the metric may do between the corners.
template <class Place_at>
class Face_divider
{
public:
  // `tolerance` relative to the distance to the generator
  Face_divider(const Generator_set& generators, const Place_at& place_at, double tolerance)
    : m_generators(generators), m_place_at(place_at), m_tracer(generators, place_at, tolerance),
      m_tolerance(tolerance)
  {}

  // Whether the face could be divided; always, if it is the last chance or if
  // the face is as small as the tolerance.
  bool operator()(const Corner& a, const Corner& b, const Corner& c, bool is_last_chance, Divided_face& d)
  {
    m_corner = {&a.place, &b.place, &c.place};
    d.label = {a.label, b.label, c.label};
    sample();
    const bool is_forced = is_last_chance || is_small(d);
    return (cross_edges(d) || is_forced)
        && (find_centre(d) || is_forced)
        && (is_settled(d) || is_forced)
        && (trace(d) || is_forced);
  }

private:
  // the tensors at the corners and in the middle, and how far the former are from the latter
  void sample()
  {
    const auto mean = [&](double Vector_of_doubles::* x)
    { return (m_corner[0]->at.*x + m_corner[1]->at.*x + m_corner[2]->at.*x) / 3; };
    m_middle = m_place_at({mean(&Vector_of_doubles::x), mean(&Vector_of_doubles::y)});
    m_variation = 0;
    m_stretch = 1;
    const double det = m_middle.m.determinant();
    for(const Place* p : m_corner) {
      // the eigenvalues of the tensor at p relative to that in the middle
      const double half_trace = (m_middle.m.c*p->m.a - 2*m_middle.m.b*p->m.b + m_middle.m.a*p->m.c) / det / 2;
      const double root = std::sqrt(std::max(0., half_trace*half_trace - p->m.determinant() / det));
      const double greatest = half_trace + root, least = p->m.determinant() / det / greatest;
      m_variation = (std::max)(m_variation, (std::max)(greatest - 1, 1 - least));
      m_stretch = (std::max)(m_stretch, std::sqrt(greatest / least));
    }
  }

  // whether the face is as small as the tolerance
  bool is_small(const Divided_face& d) const
  {
    const double distance = m_generators.squared_distance(m_middle, m_generators.nearest(m_middle, d.label[0]));
    double longest = 0, length = 0, size = 0;
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = m_corner[k]->at, &q = m_corner[(k + 1) % 3]->at;
      longest = (std::max)(longest, m_generators.tensor(m_middle, d.label[k])(q.x - p.x, q.y - p.y));
      length = (std::max)(length, (std::max)(std::abs(q.x - p.x), std::abs(q.y - p.y)));
      size = (std::max)(size, (std::max)(std::abs(p.x), std::abs(p.y)));
    }
    return longest <= m_tolerance * m_tolerance * distance || length <= 1e-13 * size;
  }

  // whether only the generators of their ends are nearest on the edges' crossings
  bool cross_edges(Divided_face& d) const
  {
    bool is_clear = true;
    for(int k = 0; k < 3; ++k)
      if(d.is_crossed(k)) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        d.crossing[k] = m_tracer.crossing(*m_corner[i], *m_corner[j], d.label[i], d.label[j]);
        is_clear = is_nearest(d.crossing[k], d.label[i]) && is_clear;
      }
    return is_clear;
  }

  // up to rounding
  bool is_nearest(const Place& p, std::size_t label) const
  {
    const std::size_t nearest = m_generators.nearest(p, label);
    return m_generators.squared_distance(p, nearest) >= m_generators.squared_distance(p, label) * (1 - 1e-10);
  }

  bool find_centre(Divided_face& d) const
  {
    if(d.number_of_labels() != 3)
      return true;
    const bool is_found = m_tracer.meeting_point(m_corner, m_middle, d.label, inside(), d.centre);
    if(is_found && is_nearest(d.centre, d.label[0]))
      return true;
    if(!is_found)
      d.centre = mean_of_crossings(d);
    return false;
  }

  Place mean_of_crossings(const Divided_face& d) const
  {
    const auto mean = [&](double Vector_of_doubles::* x)
    { return (d.crossing[0].at.*x + d.crossing[1].at.*x + d.crossing[2].at.*x) / 3; };
    return m_place_at({mean(&Vector_of_doubles::x), mean(&Vector_of_doubles::y)});
  }

  auto inside() const { return [this](const Vector_of_doubles& x) { return contains(x); }; }

  // up to rounding, since faces may be needles
  bool contains(const Vector_of_doubles& x) const
  {
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = m_corner[k]->at, &q = m_corner[(k + 1) % 3]->at;
      const double u = (q.x - p.x) * (x.y - p.y), v = (q.y - p.y) * (x.x - p.x);
      if(!(u - v >= -1e-9 * (std::abs(u) + std::abs(v))))
        return false;
    }
    return true;
  }

  bool is_settled(const Divided_face& d)
  {
    find_rivals(d);
    const bool has_centre = d.number_of_labels() == 3;
    for(int k = 0; k < 3; ++k) {
      const std::size_t own = d.label[k];
      if(!is_clear_of_rivals(*m_corner[k], own, {own, own, own}))
        return false;
      for(int l : {(k + 1) % 3, (k + 2) % 3})
        if(d.is_crossed(l) && !is_clear_of_rivals(d.crossing[l], own, {own, d.label[3 - k - l], own}))
          return false;
      if(has_centre && !is_clear_of_rivals(d.centre, own, d.label))
        return false;
    }
    return true;
  }

  // all generators that could be nearest somewhere in the face
  void find_rivals(const Divided_face& d)
  {
    double radius = std::numeric_limits<double>::infinity(), reach = 0;
    const bool at_generators = m_generators.is_measured_at_generators();
    for(std::size_t label : d.label) {
      double farthest = 0;
      for(const Place* p : m_corner)
        farthest = (std::max)(farthest, m_generators.squared_distance(Place{p->at, m_middle.m}, label));
      radius = (std::min)(radius, std::sqrt(farthest));
    }
    const Symmetric_form m = at_generators ? Symmetric_form(1, 0, 1) : m_middle.m;
    for(const Place* p : m_corner)
      reach = (std::max)(reach, m.length(p->at.x - m_middle.at.x, p->at.y - m_middle.at.y));
    const double safety = 1.1;
    m_generators.within(m_middle, reach, radius * (at_generators ? safety : safety * m_stretch), m_rivals);
  }

  // whether at x, a corner of the part of `own`, all rivals but those excepted are farther, with a margin
  bool is_clear_of_rivals(const Place& x, std::size_t own, const std::array<std::size_t, 3>& excepted) const
  {
    for(std::size_t rival : m_rivals)
      if(rival != own && rival != excepted[0] && rival != excepted[1] && rival != excepted[2]
         && !(margin(x, own, rival) > 0))
        return false;
    return true;
  }

  // A lower bound, for the part of which x is a corner, of how much the
  // squared distance to the rival is greater than to the own generator.
  double margin(const Place& x, std::size_t own, std::size_t rival) const
  {
    return m_generators.is_measured_at_generators() ? margin_of_conic(x, own, rival)
                                                    : margin_over_samples(x, own, rival);
  }

  // With a constant tensor the difference is linear. What it may be below its
  // linear interpolation is taken from the middle of the face, and from the
  // square of the variation, so that it vanishes faster than the face: an estimate, see "The
  // Margins of the Divider" on the page "Derivations" of the manual.
  double margin_over_samples(const Place& x, std::size_t own, std::size_t rival) const
  {
    const double difference = m_generators.difference(x, rival, own);
    if(m_variation == 0 || !(difference > 0))
      return difference;
    double deviation = m_generators.difference(m_middle, rival, own);
    for(const Place* p : m_corner)
      deviation -= m_generators.difference(*p, rival, own) / 3;
    const Vector_of_doubles &p = m_generators.position(own), &q = m_generators.position(rival);
    const double reach = std::sqrt(x.m(q.x - p.x, q.y - p.y) * x.m(x.at.x - (p.x + q.x) / 2, x.at.y - (p.y + q.y) / 2));
    const double variation = (std::min)(1., m_variation);
    return difference - 2 * std::abs(deviation) - 0.1 * variation * variation * reach;
  }

  // The difference is quadratic: what it is below its linear interpolation is
  // known from its second derivatives and the longest edge: a bound, derived there too.
  double margin_of_conic(const Place& x, std::size_t own, std::size_t rival) const
  {
    const Symmetric_form h = m_generators.tensor(x, rival) + (-1.) * m_generators.tensor(x, own);
    const double curvature = std::abs(h.a + h.c) / 2 + std::hypot((h.a - h.c) / 2, h.b);
    double longest = 0;
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = m_corner[k]->at, &q = m_corner[(k + 1) % 3]->at;
      longest = (std::max)(longest, (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
    }
    return m_generators.difference(x, rival, own) - curvature * longest / 2;
  }

  // whether the bisectors stay within the face
  bool trace(Divided_face& d) const
  {
    const int n = d.number_of_labels();
    if(n == 1)
      return true;
    if(n == 2) {
      const int k = d.odd_corner();
      return trace(d.crossing[(k + 2) % 3], d.crossing[(k + 1) % 3], d.label[k], d.label[(k + 1) % 3], d.curve[k]);
    }
    bool is_within = true;
    for(int k = 0; k < 3; ++k)
      is_within = trace(d.crossing[k], d.centre, d.label[(k + 1) % 3], d.label[(k + 2) % 3], d.curve[k]) && is_within;
    return is_within;
  }

  // A curve that does not stay within the face becomes straight.
  bool trace(const Place& from, const Place& to, std::size_t i, std::size_t j, Vectors& curve) const
  {
    const bool is_traced = m_tracer.trace(from, to, i, j, inside(), curve);
    if(!is_traced)
      curve.clear();
    return is_traced;
  }

  const Generator_set&        m_generators;
  const Place_at&             m_place_at;
  Bisector_tracer<Place_at>   m_tracer;
  const double                m_tolerance;

  // the current face
  std::array<const Place*, 3> m_corner;
  Place                       m_middle;
  double                      m_variation = 0; // the greatest relative distance of a sample from the middle
  double                      m_stretch = 1;   // how much the metric of a sample distorts that of the middle
  std::vector<std::size_t>    m_rivals;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVIDER_H

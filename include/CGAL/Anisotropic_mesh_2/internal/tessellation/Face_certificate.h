// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_CERTIFICATE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_CERTIFICATE_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The points by which a face is judged.
struct Face_samples
{
  std::array<const Metric_point*, 3> corner;
  Metric_point                       middle;
};

// How much farther than the own generator a rival is, at least, in the part of
// a face of which x is a corner; for distances measured at points.
//
// With a constant tensor the difference of the squared distances is linear. What
// it may be below its linear interpolation is taken from the middle of the face,
// and from the square of the variation, so that it vanishes faster than the face.
// "The Margins of a Face" on the page "Derivations" of the manual tells why.
class Margin_at_points
{
public:
  Margin_at_points(const Generator_set& generators, const Face_samples& face)
    : m_generators(generators), m_face(face)
  {
    const double det = face.middle.m.determinant();
    for(const Metric_point* p : face.corner) {
      // the eigenvalues of the tensor at p relative to that in the middle
      const Symmetric_form &m = face.middle.m, &n = p->m;
      const double half_trace = (m.c*n.a - 2*m.b*n.b + m.a*n.c) / det / 2;
      const double root = std::sqrt((std::max)(0., half_trace*half_trace - n.determinant() / det));
      const double greatest = half_trace + root, least = n.determinant() / det / greatest;
      m_variation = (std::max)(m_variation, (std::max)(greatest - 1, 1 - least));
      m_stretch = (std::max)(m_stretch, std::sqrt(greatest / least));
    }
  }

  // how much the metric of a corner distorts that in the middle
  double stretch() const { return m_stretch; }

  double operator()(const Metric_point& x, std::size_t own, std::size_t rival) const
  {
    const double difference = m_generators.difference(x, rival, own);
    if(m_variation == 0 || !(difference > 0))
      return difference;
    double deviation = m_generators.difference(m_face.middle, rival, own);
    for(const Metric_point* p : m_face.corner)
      deviation -= m_generators.difference(*p, rival, own) / 3;
    const Vector_of_doubles &p = m_generators.position(own), &q = m_generators.position(rival);
    const double reach = std::sqrt(x.m(q.x - p.x, q.y - p.y) * x.m(x.at.x - (p.x + q.x) / 2, x.at.y - (p.y + q.y) / 2));
    const double variation = (std::min)(1., m_variation);
    return difference - 2 * std::abs(deviation) - 0.1 * variation * variation * reach;
  }

private:
  const Generator_set& m_generators;
  const Face_samples&  m_face;
  double               m_variation = 0; // the greatest relative distance of the tensor of a corner from the middle
  double               m_stretch = 1;
};

// The same for distances measured at generators. The difference of the squared
// distances is quadratic: what it is below its linear interpolation is known
// from its second derivatives and the longest edge.
class Margin_at_generators
{
public:
  Margin_at_generators(const Generator_set& generators, const Face_samples& face) : m_generators(generators)
  {
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = face.corner[k]->at, &q = face.corner[(k + 1) % 3]->at;
      m_longest = (std::max)(m_longest, (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
    }
  }

  double stretch() const { return 1; }

  double operator()(const Metric_point& x, std::size_t own, std::size_t rival) const
  {
    const Symmetric_form h = m_generators.tensor(x, rival) + (-1.) * m_generators.tensor(x, own);
    const double curvature = std::abs(h.a + h.c) / 2 + std::hypot((h.a - h.c) / 2, h.b);
    return m_generators.difference(x, rival, own) - curvature * m_longest / 2;
  }

private:
  const Generator_set& m_generators;
  double               m_longest = 0; // the square of the longest edge
};

// Tells whether a face is divided as its division says: if at all corners of
// the parts of each generator all others are farther, with a margin for what the
// metric may do between the corners.
template <class Generators>
class Face_certificate
{
  typedef std::conditional_t<Generators::is_measured_at_generators, Margin_at_generators, Margin_at_points> Margin;

public:
  explicit Face_certificate(const Generators& generators) : m_generators(generators.set()) {}

  bool operator()(const Face_samples& face, const Face_division& d)
  {
    const Margin margin(m_generators, face);
    find_rivals(face, d, margin.stretch());
    const bool has_centre = d.number_of_labels() == 3;
    for(int k = 0; k < 3; ++k) {
      const std::size_t own = d.label(k);
      if(!is_clear_of_rivals(margin, *face.corner[k], own, {own, own, own}))
        return false;
      for(int l : {(k + 1) % 3, (k + 2) % 3})
        if(d.is_crossed(l) && !is_clear_of_rivals(margin, d.crossing[l], own, {own, d.label(3 - k - l), own}))
          return false;
      if(has_centre && !is_clear_of_rivals(margin, d.centre, own, {d.label(0), d.label(1), d.label(2)}))
        return false;
    }
    return true;
  }

private:
  // all generators that could be nearest somewhere in the face
  void find_rivals(const Face_samples& face, const Face_division& d, double stretch)
  {
    const Symmetric_form& m = face.middle.m;
    double radius = std::numeric_limits<double>::infinity(), reach = 0;
    for(int k = 0; k < 3; ++k) {
      double farthest = 0;
      for(const Metric_point* p : face.corner)
        farthest = (std::max)(farthest, m_generators.squared_distance(Metric_point{p->at, m}, d.label(k)));
      radius = (std::min)(radius, std::sqrt(farthest));
      const Vector_of_doubles& p = face.corner[k]->at;
      reach = (std::max)(reach, m.length(p.x - face.middle.at.x, p.y - face.middle.at.y));
    }
    const double safety = 1.1;
    m_generators.within(face.middle, reach, radius * safety * stretch, m_rivals);
  }

  // whether at x, a corner of the part of `own`, all rivals but those excepted are farther, with the margin
  bool is_clear_of_rivals(const Margin& margin, const Metric_point& x, std::size_t own,
                          const std::array<std::size_t, 3>& excepted) const
  {
    for(std::size_t rival : m_rivals)
      if(rival != own && rival != excepted[0] && rival != excepted[1] && rival != excepted[2]
         && !(margin(x, own, rival) > 0))
        return false;
    return true;
  }

  const Generator_set&     m_generators;
  std::vector<std::size_t> m_rivals;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_CERTIFICATE_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// Watches over the lengths of edges, which are to be within [1/sqrt(2), sqrt(2)].
// Vertices are what has a point and the metric tensor there.
template <class Gt>
class Unit_band
{
public:
  explicit Unit_band(const Gt& gt) : m_gt(gt) {}

  // Whether an edge is in the band by Simpson's rule, a little within to allow for its error.
  template <class Vertex>
  bool permits(const Vertex& u, const Vertex& v) const
  {
    const double l = estimate(u, v);
    return l > 0.715 && l < 1.4;
  }

  template <class Vertex>
  bool contains(const Vertex& u, const Vertex& v) const
  {
    const double guess = estimate(u, v);
    if(guess > 0.8 && guess < 1.25)
      return true;
    const double l = m_gt.compute_riemannian_length_2_object()(u.point(), v.point());
    return l >= std::sqrt(0.5) && l <= std::sqrt(2.);
  }

private:
  template <class Vertex>
  double estimate(const Vertex& u, const Vertex& v) const
  {
    const auto &p = u.point(), &q = v.point();
    const double dx = CGAL::to_double(q.x() - p.x()), dy = CGAL::to_double(q.y() - p.y());
    const typename Gt::Point_2 middle((p.x() + q.x()) / 2, (p.y() + q.y()) / 2);
    const Symmetric_form m(m_gt.construct_metric_tensor_2_object()(middle));
    return length_by_simpson(Symmetric_form(u.metric_tensor()), m, Symmetric_form(v.metric_tensor()), dx, dy);
  }

  const Gt& m_gt;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

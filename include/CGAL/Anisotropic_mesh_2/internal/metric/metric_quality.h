// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_QUALITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_QUALITY_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>

namespace CGAL::Anisotropic_mesh_2::internal {

// The quality 4 sqrt(3) |T| / (sum of the squared lengths of the edges) of a triangle T: `gram` is the
// Gram matrix of two edges, and `parallelogram` the area that they span, of which T is half. A triangle whose
// corners coincide has the quality 0.
inline double quality_from_gram(const Symmetric_form& gram, double parallelogram)
{
  const double squares = gram.a - gram.b + gram.c;
  return squares > 0 ? std::sqrt(3.) * parallelogram / squares : 0;
}

// with lengths and areas in M: 1 for a triangle that is equilateral in M, negative for an inverted one
template <class Point_2>
double metric_quality(const Point_2& a, const Point_2& b, const Point_2& c, const Symmetric_form& m)
{
  const double ux = CGAL::to_double(b.x() - a.x()), uy = CGAL::to_double(b.y() - a.y());
  const double vx = CGAL::to_double(c.x() - a.x()), vy = CGAL::to_double(c.y() - a.y());
  return quality_from_gram(Symmetric_form(m(ux, uy), m(ux, uy, vx, vy), m(vx, vy)),
                           std::sqrt(m.determinant()) * (ux*vy - uy*vx));
}

// What a face of quality q costs: of good faces it is a multiple of what q lacks of 1, of bad ones much more,
// so neither the mean nor the least quality is improved at too high a price in the other.
inline double quality_penalty(double q)
{
  return q > 0 ? 1 / ((q*q*q) * (q*q*q)) - 1 : std::numeric_limits<double>::infinity();
}

template <class Point_2, class Construct_tensor>
Symmetric_form metric_at_barycentre(const Point_2& a, const Point_2& b, const Point_2& c,
                                    const Construct_tensor& tensor)
{
  return Symmetric_form(tensor(Point_2((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3)));
}

template <class Point_2, class Construct_tensor>
double quality_at_barycentre(const Point_2& a, const Point_2& b, const Point_2& c, const Construct_tensor& tensor)
{
  return metric_quality(a, b, c, metric_at_barycentre(a, b, c, tensor));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_QUALITY_H

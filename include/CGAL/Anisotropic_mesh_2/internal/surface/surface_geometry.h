// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_GEOMETRY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_GEOMETRY_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// the quality of a triangle in space, with lengths and areas in the tensor `m`
template <class Point_3, class Tensor_3>
double surface_quality(const std::array<Point_3, 3>& t, const Tensor_3& m)
{
  const auto u = t[1] - t[0], v = t[2] - t[0];
  const Symmetric_form gram(CGAL::to_double(m.squared_length(u)), CGAL::to_double(m.scalar_product(u, v)),
                            CGAL::to_double(m.squared_length(v)));
  return quality_from_gram(gram, std::sqrt((std::max)(0., gram.determinant())));
}

// The length in space of the straight line between two points, by Simpson's rule.
template <class Vector_3, class Tensor_3>
double chord_length(const Vector_3& chord, const Tensor_3& at_source, const Tensor_3& in_middle,
                    const Tensor_3& at_target)
{
  const auto length = [&](const Tensor_3& m) { return std::sqrt(CGAL::to_double(m.squared_length(chord))); };
  return (length(at_source) + 4 * length(in_middle) + length(at_target)) / 6;
}

// the angle between the normal of a triangle and that of the surface at the parameters `p`
template <class Surface, class Point_2, class Point_3>
double normal_deviation(const Surface& surface, const Point_2& p, const std::array<Point_3, 3>& t)
{
  const auto d = surface.first_derivatives(p);
  const auto n = cross_product(d[0], d[1]), m = cross_product(t[1] - t[0], t[2] - t[0]);
  const auto c = cross_product(n, m);
  return std::atan2(std::sqrt(CGAL::to_double(c * c)), CGAL::to_double(n * m));
}

// the closest point of the rectangle of parameters, which does not end in periodic directions
inline Vector_of_doubles clamped(const Parameter_rectangle& r, const Vector_of_doubles& p)
{
  return {r.u_is_periodic ? p.x : std::clamp(p.x, r.u_min, r.u_max),
          r.v_is_periodic ? p.y : std::clamp(p.y, r.v_min, r.v_max)};
}

// The step of the method of Gauss and Newton from the parameters `p` towards the point of the surface closest to `x`.
template <class Surface, class Point_2, class Point_3>
Vector_of_doubles step_towards_closest_point(const Surface& surface, const Point_2& p, const Point_3& x)
{
  const auto d = surface.first_derivatives(p);
  const auto r = x - surface.point(p);
  const Symmetric_form gram(CGAL::to_double(d[0] * d[0]), CGAL::to_double(d[0] * d[1]), CGAL::to_double(d[1] * d[1]));
  const double fu = CGAL::to_double(r * d[0]), fv = CGAL::to_double(r * d[1]), det = gram.determinant();
  return {(gram.c * fu - gram.b * fv) / det, (gram.a * fv - gram.b * fu) / det};
}

// The distance of `x` from the surface close to the parameters `p`, by steps that are halved until they are of use.
template <class Surface, class Point_2, class Point_3>
double distance_to_surface(const Surface& surface, Point_2 p, const Point_3& x)
{
  const auto distance_to = [&](const Point_2& at) {
    return std::sqrt(CGAL::to_double((x - surface.point(at)).squared_length()));
  };
  const int steps = 20, halvings = 10;
  double least = distance_to(p);
  for(int i = 0; i < steps; ++i) {
    const Vector_of_doubles q = to_doubles(p), step = step_towards_closest_point(surface, p, x);
    double t = 1, distance = least;
    for(int k = 0; k < halvings && !(distance < least); ++k, t *= 0.5) {
      const Vector_of_doubles next = clamped(surface.parameters(), {q.x + t * step.x, q.y + t * step.y});
      p = point_at<Point_2>(next.x, next.y);
      distance = distance_to(p);
    }
    if(!(distance < (1 - 1e-6) * least))
      return (std::min)(distance, least);
    least = distance;
  }
  return least;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_GEOMETRY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_OF_DOUBLES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_OF_DOUBLES_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

typedef std::array<Vector_of_doubles, 3> Triangle_of_doubles;
typedef std::array<double, 3>            Barycentric; // coordinates

// of a face of a triangulation
template <class Face_handle>
Triangle_of_doubles triangle_of_doubles(Face_handle f)
{
  return {to_doubles(f->vertex(0)->point()), to_doubles(f->vertex(1)->point()), to_doubles(f->vertex(2)->point())};
}

inline double area(const Triangle_of_doubles& t)
{
  return ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
}

inline Vector_of_doubles barycentre(const Triangle_of_doubles& t)
{
  return {(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
}

inline Vector_of_doubles point_of(const Triangle_of_doubles& t, const Barycentric& l)
{
  return {l[0]*t[0].x + l[1]*t[1].x + l[2]*t[2].x, l[0]*t[0].y + l[1]*t[1].y + l[2]*t[2].y};
}

// of the edges, by the opposite corner
inline Triangle_of_doubles middles(const Triangle_of_doubles& t)
{
  return {middle(t[1], t[2]), middle(t[2], t[0]), middle(t[0], t[1])};
}

// The quarter i has the corner i of the triangle as its own corner i; the last one is the inner one.
inline std::array<Triangle_of_doubles, 4> quarters(const Triangle_of_doubles& t)
{
  const Triangle_of_doubles m = middles(t);
  return {{{{t[0], m[2], m[1]}}, {{m[2], t[1], m[0]}}, {{m[1], m[0], t[2]}}, m}};
}

// Calls `add(x, w, v)` for the seven nodes of Radon's rule with their weights w,
// which add up to 1 and are exact for polynomials of degree five, and v of a
// rule of degree two on some of the same nodes.
template <class Add>
void for_each_node_of_radon(const Triangle_of_doubles& t, const Add& add)
{
  static const double root = std::sqrt(15.), a1 = (6 - root) / 21, a2 = (6 + root) / 21;
  static const double w1 = (155 - root) / 1200, w2 = (155 + root) / 1200;
  static const double v2 = 1 / (18 * (2*a2*a2 + (1 - 2*a2) * (1 - 2*a2) - 1./3)), v0 = 1 - 3*v2;
  const auto at = [&](double l1, double l2) {
    return Vector_of_doubles{t[0].x + l1 * (t[1].x - t[0].x) + l2 * (t[2].x - t[0].x),
                             t[0].y + l1 * (t[1].y - t[0].y) + l2 * (t[2].y - t[0].y)};
  };
  add(at(1./3, 1./3), 9./40, v0);
  add(at(a1, a1), w1, 0.);
  add(at(a1, 1 - 2*a1), w1, 0.);
  add(at(1 - 2*a1, a1), w1, 0.);
  add(at(a2, a2), w2, v2);
  add(at(a2, 1 - 2*a2), w2, v2);
  add(at(1 - 2*a2, a2), w2, v2);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_OF_DOUBLES_H

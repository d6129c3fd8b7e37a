// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_METRIC_TRIANGLE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_METRIC_TRIANGLE_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// A triangle measured in a constant tensor.
struct Metric_triangle
{
  Triangle_of_doubles   corner;
  Triangle_of_doubles   edge;   // by the opposite corner, counterclockwise
  std::array<double, 3> square; // of their lengths
  std::array<double, 3> cosine; // the scalar product of the edges at a corner

  Metric_triangle(const Triangle_of_doubles& t, const Symmetric_form& m) : corner(t)
  {
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = t[(k + 1) % 3], &q = t[(k + 2) % 3];
      edge[k] = {q.x - p.x, q.y - p.y};
      square[k] = m(edge[k].x, edge[k].y);
    }
    for(int k = 0; k < 3; ++k)
      cosine[k] = (square[(k + 1) % 3] + square[(k + 2) % 3] - square[k]) / 2;
  }

  bool is_acute() const { return cosine[0] > 0 && cosine[1] > 0 && cosine[2] > 0; }

  // the barycentric coordinates of the centre of the circumcircle
  Barycentric circumcentre() const
  {
    const double sum = square[0]*cosine[0] + square[1]*cosine[1] + square[2]*cosine[2];
    return {{square[0]*cosine[0] / sum, square[1]*cosine[1] / sum, square[2]*cosine[2] / sum}};
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_METRIC_TRIANGLE_H

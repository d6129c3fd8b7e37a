// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// Watches over the lengths of edges of a patch, which are to be within [1/sqrt(2), sqrt(2)].
// Vertices are what has a point and the metric tensor there.
template <class Patch>
class Unit_band
{
  typedef typename Patch::Vertex Vertex;

public:
  // Whether an edge is in the band by Simpson's rule, with a tensor for its middle; a little within to allow for
  // errors.
  static bool permits(const Vertex& u, const Vertex& v, const Symmetric_form& in_middle)
  {
    const Vector_of_doubles p = to_doubles(u.point()), q = to_doubles(v.point());
    const double l = length_by_simpson(Symmetric_form(u.metric_tensor()), in_middle, Symmetric_form(v.metric_tensor()),
                                       q.x - p.x, q.y - p.y);
    return l > 0.72 && l < 1.39;
  }

  // with a margin within, as a factor
  static bool contains(const Patch& patch, const Vertex& u, const Vertex& v, double margin)
  {
    const double guess = length(patch, u, v, 1);
    if(guess > 0.8 && guess < 1.25)
      return true;
    const double l = length(patch, u, v, panels_in_doubt);
    return l >= std::sqrt(0.5) * margin && l * margin <= std::sqrt(2.);
  }

  // by Simpson's rule in some panels
  static double length(const Patch& patch, const Vertex& u, const Vertex& v, int panels)
  {
    const Vector_of_doubles p = to_doubles(u.point()), q = to_doubles(v.point());
    return length_by_simpson(Symmetric_form(u.metric_tensor()), Symmetric_form(v.metric_tensor()), p,
                             {q.x - p.x, q.y - p.y}, panels,
                             [&](const Vector_of_doubles& x) { return patch.tensor(x, v); });
  }

private:
  static constexpr int panels_in_doubt = 4;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TILTED_BOX_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TILTED_BOX_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Anisotropic_mesh_2::internal {

typedef Box_intersection_d::Box_with_info_d<double, 2, std::size_t> Tilted_box;

// A box with tilted axes around what axis-parallel boxes cover, with a margin.
//
// `box_intersection_d` takes quadratic time for boxes that are all cut by one
// line x = constant, and many domains have vertical edges of many parts; hardly
// any have them along the tilted axes.
template <class BboxRange>
Tilted_box tilted_box(const BboxRange& boxes, double margin, std::size_t info)
{
  static constexpr double tilt = 0.2718281828;
  const double infinity = std::numeric_limits<double>::infinity();
  double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity}, size = 0;
  for(const Bbox_2& b : boxes) {
    low[0] = (std::min)(low[0], b.xmin() + tilt*b.ymin());
    low[1] = (std::min)(low[1], b.ymin() - tilt*b.xmax());
    high[0] = (std::max)(high[0], b.xmax() + tilt*b.ymax());
    high[1] = (std::max)(high[1], b.ymax() - tilt*b.xmin());
    for(double c : {b.xmin(), b.xmax(), b.ymin(), b.ymax()})
      size = (std::max)(size, std::abs(c));
  }
  const double grown = 2*margin + 4*std::numeric_limits<double>::epsilon()*size; // more than all rounding
  for(int i = 0; i < 2; ++i) {
    low[i] -= grown;
    high[i] += grown;
  }
  return Tilted_box(low, high, info);
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TILTED_BOX_H

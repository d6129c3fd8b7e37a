// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_ATLAS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_ATLAS_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_chart.h>

#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Charts that cover a surface so that each place is far from the cuts of at least
// one of them: enough windows for the cuts in both directions not to
// hit the same place in all of them, and a cap around each pole.
template <class Field>
struct Surface_atlas
{
  // a chart, and the part of the range of v in which it is used
  struct Part
  {
    Surface_chart<Field> chart;
    double v_low, v_high;
  };

  std::vector<Part> parts;

  explicit Surface_atlas(const Field& field)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const Parameter_rectangle r = field.surface().parameters();
    const double du = r.u_extent(), dv = r.v_extent();
    const int windows = 1 + r.u_is_periodic + r.v_is_periodic;
    for(int i = 0; i < windows; ++i)
      parts.push_back({Surface_chart<Field>::window(field, r.u_min + i * du / windows, r.v_min + i * dv / windows),
                       r.v_min_is_pole ? r.v_min + window_margin * dv : -infinity,
                       r.v_max_is_pole ? r.v_max - window_margin * dv : infinity});
    if(r.v_min_is_pole)
      parts.push_back({Surface_chart<Field>::cap(field, true), -infinity, r.v_min + cap_reach * dv});
    if(r.v_max_is_pole)
      parts.push_back({Surface_chart<Field>::cap(field, false), r.v_max - cap_reach * dv, infinity});
  }

private:
  // shares of the range of v: what windows leave out at a pole, and how far caps reach
  static constexpr double window_margin = 0.15, cap_reach = 0.5;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_ATLAS_H

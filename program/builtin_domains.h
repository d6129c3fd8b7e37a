// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_DOMAINS_H
#define ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_DOMAINS_H

#include "Metric_field.h"
#include "Options.h"

#include <CGAL/Anisotropic_mesh_domain_2.h>

#include <cmath>
#include <string>
#include <vector>

namespace program {

typedef CGAL::Anisotropic_mesh_domain_2<Kernel> Domain;

struct Domain_with_metric
{
  Domain       domain;
  Metric_field metric;
};

// The planar test cases of the paper.
namespace builtin {

inline Domain polygon(const std::vector<Point_2>& points)
{
  Domain domain;
  domain.add_polygon(points);
  return domain;
}

inline Domain square(double side)
{
  return polygon({Point_2(0, 0), Point_2(side, 0), Point_2(side, side), Point_2(0, side)});
}

// a constant metric in a disc, figure 5.1
inline Domain_with_metric disc()
{
  Domain domain;
  domain.add_circle(Point_2(0, 0), 10);
  const Metric_tensor_2 m = Metric_tensor_2::from_sizes(1.5, 0.3, std::acos(-1.) / 4);
  return {domain, [m](const Point_2&) { return m; }};
}

// sizes growing along both axes, figure 5.2
inline Domain_with_metric square4()
{
  return {square(4), [](const Point_2& p) {
    return Metric_tensor_2::from_sizes(0.031 + p.x()/4, 0.031 + p.y()/4);
  }};
}

// the smaller of the two sizes around the line y = 5, and the larger
struct Sizes_at_line
{
  double small, large;

  explicit Sizes_at_line(double y)
  {
    const double d = std::abs(y - 5) / 5;
    small = d + 0.04;
    large = std::abs(5 - 4*d) * small;
  }
};

// refinement at the line y = 5 as the paper prints it, figure 5.3
inline Domain_with_metric square10()
{
  return {square(10), [](const Point_2& p) {
    const Sizes_at_line h(p.y());
    return Metric_tensor_2::from_sizes(h.small, h.large);
  }};
}

// the same with the two sizes exchanged: small across the line, large along it
inline Domain_with_metric layer10()
{
  return {square(10), [](const Point_2& p) {
    const Sizes_at_line h(p.y());
    return Metric_tensor_2::from_sizes(h.large, h.small);
  }};
}

// a constant metric in a parallelogram, figure 4.2
inline Domain_with_metric parallelogram()
{
  const Metric_tensor_2 m = Metric_tensor_2::from_sizes(2, 0.5);
  return {polygon({Point_2(0, 0), Point_2(30, 0), Point_2(40, 14), Point_2(10, 14)}),
          [m](const Point_2&) { return m; }};
}

} // namespace builtin

// throws Unusable_input for a name that is unknown
inline Domain_with_metric builtin_domain(const std::string& name)
{
  if(name == "disc")          return builtin::disc();
  if(name == "square4")       return builtin::square4();
  if(name == "square10")      return builtin::square10();
  if(name == "layer10")       return builtin::layer10();
  if(name == "parallelogram") return builtin::parallelogram();
  throw Unusable_input("builtin:" + name + ": unknown name; known are disc, square4, square10, layer10, "
                       "parallelogram and the surfaces ellipsoid, paraboloid, torus, saddle-sizes, saddle-curvature");
}

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_DOMAINS_H

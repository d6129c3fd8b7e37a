// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_SURFACES_H
#define ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_SURFACES_H

#include "Metric_field.h"

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_ellipsoid_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_torus_3.h>
#include <CGAL/Anisotropic_mesh_2/Quadratic_graph_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace program {

typedef Kernel::Point_3                                 Point_3;
typedef CGAL::Metric_tensor_3<Kernel>                   Metric_tensor_3;
typedef CGAL::Anisotropic_mesh_2::Parameter_rectangle   Parameter_rectangle;

// All surfaces in one type, so that the mesher is instantiated once.
struct Any_surface
{
  typedef program::Kernel Kernel;

  Parameter_rectangle                                                rectangle;
  std::function<Point_3(const Point_2&)>                             point;
  std::function<std::array<Kernel::Vector_3, 2>(const Point_2&)>     first_derivatives;
  std::function<std::array<Kernel::Vector_3, 3>(const Point_2&)>     second_derivatives;

  template <class Surface>
  explicit Any_surface(const Surface& s)
    : rectangle(s.parameters()), point([s](const Point_2& p) { return s.point(p); }),
      first_derivatives([s](const Point_2& p) { return s.first_derivatives(p); }),
      second_derivatives([s](const Point_2& p) { return s.second_derivatives(p); })
  {}

  const Parameter_rectangle& parameters() const { return rectangle; }
};

typedef std::function<Metric_tensor_3(const Any_surface&, const Point_2&)> Surface_metric;

struct Surface_with_metric
{
  Any_surface    surface;
  Surface_metric metric; // of the given scale
};

namespace builtin {

template <class Size>
Surface_metric isotropic(double scale, const Size& size)
{
  return [=](const Any_surface& s, const Point_2& p) { return Metric_tensor_3::from_size(scale * size(s.point(p))); };
}

inline Parameter_rectangle centred_square(double side)
{
  Parameter_rectangle r;
  r.u_min = r.v_min = -side / 2;
  r.u_max = r.v_max = side / 2;
  return r;
}

// refined at a pole
inline Surface_with_metric ellipsoid(double scale)
{
  const CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<Kernel> ellipsoid(2, 1.2, 0.8);
  return {Any_surface(ellipsoid), isotropic(scale, [](const Point_3& p) {
    return 0.03 + 0.1 * std::hypot(p.x(), p.y(), p.z() - 0.8);
  })};
}

// refined along a line
inline Surface_with_metric paraboloid(double scale)
{
  return {Any_surface(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<Kernel>(1, 1, centred_square(2))),
          isotropic(scale, [](const Point_3& p) { return 0.04 + 0.15 * std::abs(p.y()); })};
}

// refined along the outer circle
inline Surface_with_metric torus(double scale)
{
  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<Kernel> torus(2, 0.7);
  return {Any_surface(torus), isotropic(scale, [](const Point_3& p) {
    return 0.08 + 0.2 * std::hypot(std::hypot(p.x(), p.y()) - 2.7, p.z());
  })};
}

inline Surface_with_metric saddle_sizes(double scale)
{
  const Metric_tensor_3 m = Metric_tensor_3::from_sizes(0.04 * scale, 0.4 * scale, 0.04 * scale);
  return {Any_surface(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<Kernel>(2, -4, centred_square(1))),
          [m](const Any_surface&, const Point_2&) { return m; }};
}

// The chord error grows with the square of the sizes.
inline Surface_with_metric saddle_curvature(double scale)
{
  typedef CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<Kernel> Saddle;
  const double bound = (std::min)(0.99, 0.001 * scale*scale);
  const CGAL::Anisotropic_mesh_2::Curvature_metric_3<Any_surface> metric(bound, 0.005 * scale, scale);
  return {Any_surface(Saddle(2, -4, centred_square(2))), metric};
}

} // namespace builtin

inline const std::map<std::string, Surface_with_metric (*)(double scale)>& builtin_surfaces()
{
  static const std::map<std::string, Surface_with_metric (*)(double)> surfaces = {
    {"ellipsoid",        builtin::ellipsoid},
    {"paraboloid",       builtin::paraboloid},
    {"torus",            builtin::torus},
    {"saddle-sizes",     builtin::saddle_sizes},
    {"saddle-curvature", builtin::saddle_curvature}};
  return surfaces;
}

inline bool is_builtin_surface(const std::string& name) { return builtin_surfaces().count(name) > 0; }

inline Surface_with_metric builtin_surface(const std::string& name, double scale)
{
  return builtin_surfaces().at(name)(scale);
}

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_BUILTIN_SURFACES_H

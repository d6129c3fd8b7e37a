// A parametric surface of any type with any metric, so that what works on
// surfaces is compiled once for all of them.

#ifndef ANISOTROPIC_MESH_2_TEST_ANY_SURFACE_H
#define ANISOTROPIC_MESH_2_TEST_ANY_SURFACE_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/Surface_metric_field_2.h>

#include <array>
#include <functional>

struct Any_surface
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_2                                     Point_2;

  CGAL::Anisotropic_mesh_2::Parameter_rectangle                  rectangle;
  std::function<Kernel::Point_3(const Point_2&)>                 point;
  std::function<std::array<Kernel::Vector_3, 2>(const Point_2&)> first_derivatives;

  const CGAL::Anisotropic_mesh_2::Parameter_rectangle& parameters() const { return rectangle; }
};

typedef CGAL::Metric_tensor_3<Any_surface::Kernel>                                        Any_tensor_3;
typedef std::function<Any_tensor_3(const Any_surface&, const Any_surface::Point_2&)>      Any_metric_3;
typedef CGAL::Surface_metric_field_2<Any_surface, Any_metric_3>                           Any_surface_field;

template <class Surface, class Metric>
Any_surface_field surface_field(const Surface& surface, const Metric& metric)
{
  typedef Any_surface::Point_2 Point_2;
  const auto field = CGAL::make_surface_metric_field_2(surface, metric);
  const Any_surface any = {surface.parameters(), [=](const Point_2& p) { return surface.point(p); },
                           [=](const Point_2& p) { return surface.first_derivatives(p); }};
  return Any_surface_field(any, [=](const Any_surface&, const Point_2& p) { return field.metric_tensor_3(p); });
}

#endif // ANISOTROPIC_MESH_2_TEST_ANY_SURFACE_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_CHART_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_CHART_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// A planar coordinate system of a part of a surface, and the metric field in it.
//
// A window consists of the parameters themselves. Those that are periodic are cut
// at the given start, not necessarily where the rectangle of parameters begins. A
// cap has its origin at a pole, and the distance of v from there as radius; in it,
// the pole is a point like any other.
template <class Field>
class Surface_chart
{
public:
  typedef typename Field::Surface         Surface;
  typedef typename Surface::Kernel        Kernel;
  typedef typename Kernel::FT             FT;
  typedef typename Kernel::Point_2        Point_2;
  typedef Metric_tensor_2<Kernel>         Metric_tensor;

  static Surface_chart window(const Field& field, double u_start, double v_start)
  {
    Surface_chart chart(field);
    chart.m_start = {u_start, v_start};
    return chart;
  }

  static Surface_chart cap(const Field& field, bool at_v_min)
  {
    Surface_chart chart(field);
    chart.m_pole = at_v_min ? 1 : -1;
    return chart;
  }

  bool is_cap() const { return m_pole != 0; }

  // from the parameters to the coordinates of the chart
  Vector_of_doubles coordinates(const Vector_of_doubles& p) const
  {
    if(!is_cap())
      return {m_rectangle.u_is_periodic ? unrolled(p.x, m_start.x, m_rectangle.u_extent()) : p.x,
              m_rectangle.v_is_periodic ? unrolled(p.y, m_start.y, m_rectangle.v_extent()) : p.y};
    const double angle = (p.x - m_rectangle.u_min) / radians(), r = (std::max)(0., m_pole * (p.y - pole()));
    return m_pole > 0 ? Vector_of_doubles{r * std::sin(angle), r * std::cos(angle)}
                      : Vector_of_doubles{r * std::cos(angle), r * std::sin(angle)};
  }

  // from the coordinates of the chart to the parameters in their rectangle
  Vector_of_doubles parameters(const Vector_of_doubles& x) const
  {
    Vector_of_doubles p = x;
    if(is_cap())
      p = {m_rectangle.u_min + radians() * (m_pole > 0 ? std::atan2(x.x, x.y) : std::atan2(x.y, x.x)),
           pole() + m_pole * std::hypot(x.x, x.y)};
    return {m_rectangle.u_is_periodic ? unrolled(p.x, m_rectangle.u_min, m_rectangle.u_extent()) : p.x,
            m_rectangle.v_is_periodic ? unrolled(p.y, m_rectangle.v_min, m_rectangle.v_extent()) : p.y};
  }

  // the tensor of the field in the coordinates of the chart
  Metric_tensor operator()(const Point_2& x) const
  {
    const Vector_of_doubles c = {CGAL::to_double(x.x()), CGAL::to_double(x.y())};
    return is_cap() ? tensor_in_cap(c) : (*m_field)(point_at<Point_2>(c.x, c.y));
  }

  // Whether two points of a window are so far apart that the straight line between them is not the short way.
  bool is_cut_between(const Vector_of_doubles& p, const Vector_of_doubles& q) const
  {
    return !is_cap() && ((m_rectangle.u_is_periodic && 2 * std::abs(p.x - q.x) > m_rectangle.u_extent())
                      || (m_rectangle.v_is_periodic && 2 * std::abs(p.y - q.y) > m_rectangle.v_extent()));
  }

private:
  explicit Surface_chart(const Field& field) : m_field(&field), m_rectangle(field.surface().parameters()) {}

  double radians() const { return m_rectangle.u_extent() / (2 * CGAL_PI); } // a radian in units of u
  double pole() const { return m_pole > 0 ? m_rectangle.v_min : m_rectangle.v_max; }

  // the value of a periodic parameter in the period that begins at `start`
  static double unrolled(double value, double start, double period)
  {
    const double result = value - period * std::floor((value - start) / period);
    return result < start + period ? result : start; // after rounding
  }

  // At the pole itself the parameters have no tensor; it is taken nearby.
  Metric_tensor tensor_in_cap(Vector_of_doubles x) const
  {
    const double least = 1e-7 * m_rectangle.v_extent();
    double r = std::hypot(x.x, x.y);
    if(!(r >= least)) {
      x = r > 0 ? Vector_of_doubles{x.x * least / r, x.y * least / r} : Vector_of_doubles{least, 0};
      r = least;
    }
    const Vector_of_doubles p = parameters(x);
    const auto m = (*m_field)(point_at<Point_2>(p.x, p.y));
    // Along the radius v changes as the radius does, or inversely; then u, too, turns the other way round.
    const FT across(radians() / r), c(x.x / r), s(x.y / r);
    const FT rr = m.m22(), rt = -across * m.m12(), tt = across*across * m.m11();
    return Metric_tensor::from_entries(rr*c*c - 2*rt*c*s + tt*s*s,
                                       (rr - tt)*c*s + rt*(c*c - s*s),
                                       rr*s*s + 2*rt*c*s + tt*c*c);
  }

  const Field*        m_field;
  Parameter_rectangle m_rectangle;
  int                 m_pole = 0;  // 1 at the least v, -1 at the largest one, 0 if there is none
  Vector_of_doubles   m_start = {};
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_CHART_H

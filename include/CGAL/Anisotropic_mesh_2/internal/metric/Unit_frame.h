// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_UNIT_FRAME_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_UNIT_FRAME_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// Coordinates whose origin is a point and whose unit vectors, (e1, 0) and (e12, e2), are orthonormal in its metric.
class Unit_frame
{
public:
  template <class Point_2>
  Unit_frame(const Point_2& origin, const Symmetric_form& m)
    : m_origin(to_doubles(origin)), m_e1(1 / std::sqrt(m.a)), m_e2(std::sqrt(m.a / m.determinant())),
      m_e12(-m.b / m.a * m_e2)
  {}

  template <class Point_2>
  Point_2 point(const Vector_of_doubles& v) const
  {
    return point_at<Point_2>(m_origin.x + v.x*m_e1 + v.y*m_e12, m_origin.y + v.y*m_e2);
  }

  template <class Point_2>
  Vector_of_doubles in_frame(const Point_2& p) const
  {
    const Vector_of_doubles q = to_doubles(p);
    const double y = (q.y - m_origin.y) / m_e2;
    return {(q.x - m_origin.x - y*m_e12) / m_e1, y};
  }

  Symmetric_form in_frame(const Symmetric_form& m) const
  {
    return Symmetric_form(m(m_e1, 0), m(m_e1, 0, m_e12, m_e2), m(m_e12, m_e2));
  }

private:
  Vector_of_doubles m_origin;
  double            m_e1, m_e2, m_e12;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_UNIT_FRAME_H

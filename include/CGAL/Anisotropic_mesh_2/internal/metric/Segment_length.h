// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SEGMENT_LENGTH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SEGMENT_LENGTH_H

#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/three_point_gauss.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// The Riemannian length of straight segments: three-point Gauss quadrature,
// bisected until both halves together agree with the whole.
template <class Point_2, class Construct_tensor>
class Segment_length
{
public:
  Segment_length(const Point_2& p, const Point_2& q, const Construct_tensor& tensor)
    : m_p(p), m_q(q), m_dx(CGAL::to_double(q.x() - p.x())), m_dy(CGAL::to_double(q.y() - p.y())),
      m_tensor(tensor)
  {}

  double operator()() const { return refined(0, 1, gauss(0, 1), maximum_depth); }

private:
  static constexpr int    maximum_depth = 14;
  static constexpr double relative_tolerance = 1e-4; // of a difference whose halves are 64 times better

  double refined(double t0, double t1, double whole, int depth) const
  {
    const double middle = (t0 + t1) / 2, left = gauss(t0, middle), right = gauss(middle, t1);
    if(depth == 0 || std::abs(left + right - whole) <= relative_tolerance * (left + right))
      return left + right;
    return refined(t0, middle, left, depth - 1) + refined(middle, t1, right, depth - 1);
  }

  double gauss(double t0, double t1) const
  {
    return three_point_gauss([this](double t) { return speed(t); }, t0, t1);
  }

  double speed(double t) const
  {
    typedef Coordinate<Point_2> FT;
    const Point_2 x(m_p.x() + FT(t) * (m_q.x() - m_p.x()), m_p.y() + FT(t) * (m_q.y() - m_p.y()));
    const auto m = m_tensor(x);
    return std::sqrt((std::max)(0., CGAL::to_double(m.squared_length(FT(m_dx), FT(m_dy)))));
  }

  const Point_2& m_p;
  const Point_2& m_q;
  double m_dx, m_dy;
  const Construct_tensor& m_tensor;
};

template <class Point_2, class Construct_tensor>
double segment_length(const Point_2& p, const Point_2& q, const Construct_tensor& tensor)
{
  return Segment_length<Point_2, Construct_tensor>(p, q, tensor)();
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SEGMENT_LENGTH_H

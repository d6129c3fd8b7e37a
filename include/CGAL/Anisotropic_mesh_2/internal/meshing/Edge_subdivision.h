// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_EDGE_SUBDIVISION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_EDGE_SUBDIVISION_H

#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/three_point_gauss.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Divides straight edges into parts of equal length in the metric, that length
// being as close to 1 as a whole number of parts allows.
template <class Point_2>
class Edge_subdivision
{
  typedef Coordinate<Point_2> FT;

public:
  // the interior division points of the edge from p to q, whose tensors at the
  // ends are mp and mq; none if the edge is not too long. They stay valid until
  // the next call.
  template <class Metric_tensor, class Construct_tensor>
  const std::vector<Point_2>& operator()(const Point_2& p, const Metric_tensor& mp,
                                         const Point_2& q, const Metric_tensor& mq,
                                         const Construct_tensor& tensor)
  {
    m_points.clear();
    const double dx = CGAL::to_double(q.x() - p.x()), dy = CGAL::to_double(q.y() - p.y());
    const auto speed = [&](double t) { return length_of(tensor(at(p, q, t)), dx, dy); };
    const double sp = length_of(mp, dx, dy), sq = length_of(mq, dx, dy);
    if(sp < 1.2 && sq < 1.2 && std::abs(sp - sq) < 0.1) // what lies between is seen at the barycentres of the faces
      return m_points;
    const double middle = speed(0.5);
    const double length = (sp + 4*middle + sq) / 6;
    if(length < 1.3 && std::abs(length - middle) < 0.1)
      return m_points;

    m_parts.clear();
    collect_parts(speed, 0, 1, length, maximum_depth);
    divide(p, q);
    return m_points;
  }

private:
  struct Part
  {
    double begin, end; // of the parameter
    double length;     // of the metric
  };

  static constexpr int    maximum_depth = 20;
  static constexpr double longest_allowed = 1.41421356237309505;

  static Point_2 at(const Point_2& p, const Point_2& q, double t)
  {
    return Point_2(p.x() + FT(t) * (q.x() - p.x()), p.y() + FT(t) * (q.y() - p.y()));
  }

  template <class Metric_tensor>
  static double length_of(const Metric_tensor& m, double dx, double dy)
  {
    return std::sqrt((std::max)(0., CGAL::to_double(m.squared_length(FT(dx), FT(dy)))));
  }

  // Bisects until both halves agree with the whole to some hundredths of the unit length, and with each
  // other well enough for points to be placed in between.
  template <class Speed>
  void collect_parts(const Speed& speed, double t0, double t1, double whole, int depth)
  {
    const double middle = (t0 + t1) / 2;
    const double left = three_point_gauss(speed, t0, middle), right = three_point_gauss(speed, middle, t1);
    const double sum = left + right;
    if(depth == 0 || (std::abs(sum - whole) <= 0.03 && std::abs(left - right) <= 0.1)) {
      m_parts.push_back(Part{t0, middle, left});
      m_parts.push_back(Part{middle, t1, right});
      return;
    }
    collect_parts(speed, t0, middle, left, depth - 1);
    collect_parts(speed, middle, t1, right, depth - 1);
  }

  void divide(const Point_2& p, const Point_2& q)
  {
    double length = 0;
    for(const Part& part : m_parts)
      length += part.length;
    if(length <= longest_allowed)
      return;
    const double step = length / (std::max)(2., std::round(length));
    double done = 0, next = step;
    for(const Part& part : m_parts) {
      for(; next <= done + part.length && next < length - step / 2; next += step)
        m_points.push_back(at(p, q, part.begin + (part.end - part.begin) * (next - done) / part.length));
      done += part.length;
    }
  }

  std::vector<Part>    m_parts;
  std::vector<Point_2> m_points;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_EDGE_SUBDIVISION_H

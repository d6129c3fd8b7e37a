// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Box_tree.h>

#include <CGAL/assertions.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Finds the triangle that holds a point, or the nearest one, and the
// barycentric coordinates there, by a balanced tree of bounding boxes. Queries
// are const and keep no state.
//
// All coordinates but those that predicates see are scaled by a power of two
// that brings the largest one near to 1: their squares do not overflow.
template <class K>
class Triangle_locator_2
{
public:
  typedef typename K::Point_2         Point_2;
  typedef std::array<std::size_t, 3>  Triangle;

  // three vertices and their barycentric coordinates, none negative
  struct Place
  {
    Triangle              vertices;
    std::array<double, 3> weights;
  };

  Triangle_locator_2(const std::vector<Point_2>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles), m_scale(scale_of(points))
  {
    if(triangles.empty())
      throw Invalid_triangle_mesh_exception("the background mesh has no triangles");
    for(std::size_t i = 0; i < triangles.size(); ++i)
      orient(i);
    m_tree = Box_tree(boxes(), 4);
    sort_as_in_tree();
    for(const Triangle& t : m_triangles)
      m_corners.push_back({m_points[t[0]], m_points[t[1]], m_points[t[2]]});
  }

  Place locate(const Point_2& p) const
  {
    CGAL_precondition(CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()));
    const Xy q = query(p);
    const std::size_t i = triangle_at(p, q);
    return i < m_triangles.size() ? inner_place(m_triangles[i], q) : nearest_place(q);
  }

private:
  typedef std::array<double, 2>  Xy;
  typedef std::array<Point_2, 3> Corners;

  struct Candidate
  {
    double squared_distance;
    Place  place;
  };

  static double largest_coordinate(const Point_2& p)
  {
    return (std::max)(std::abs(CGAL::to_double(p.x())), std::abs(CGAL::to_double(p.y())));
  }

  static double scale_of(const std::vector<Point_2>& points)
  {
    double largest = 0;
    for(const Point_2& p : points)
      largest = (std::max)(largest, largest_coordinate(p));
    return largest > 0 ? std::ldexp(1., -(std::min)(1000, (std::max)(-1000, std::ilogb(largest)))) : 1;
  }

  Xy xy(const Point_2& p) const { return {m_scale * CGAL::to_double(p.x()), m_scale * CGAL::to_double(p.y())}; }
  Xy xy(const Triangle& t, int i) const { return xy(m_points[t[i]]); }

  // Far points are drawn nearer: from where they are, rounding hides what is nearest.
  Xy query(const Point_2& p) const
  {
    static constexpr double far = 1 << 25;
    const Xy q = xy(p);
    if((std::max)(std::abs(q[0]), std::abs(q[1])) < far)
      return q;
    const int exponent = std::ilogb(largest_coordinate(p));
    return {std::ldexp(CGAL::to_double(p.x()), 25 - exponent), std::ldexp(CGAL::to_double(p.y()), 25 - exponent)};
  }

  // makes the triangle counterclockwise
  void orient(std::size_t i)
  {
    Triangle& t = m_triangles[i];
    for(std::size_t v : t)
      if(v >= m_points.size())
        throw Invalid_triangle_mesh_exception("triangle " + std::to_string(i + 1) +
                                    " of the background mesh names a vertex that does not exist");
    const Orientation orientation = K().orientation_2_object()(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
    if(orientation == COLLINEAR)
      throw Invalid_triangle_mesh_exception("triangle " + std::to_string(i + 1) +
                                  " of the background mesh has no area");
    if(orientation == CLOCKWISE)
      std::swap(t[1], t[2]);
  }

  std::vector<Bbox_2> boxes() const
  {
    std::vector<Bbox_2> result(m_triangles.size());
    for(std::size_t i = 0; i < m_triangles.size(); ++i)
      for(int j = 0; j < 3; ++j) {
        const Xy p = xy(m_triangles[i], j);
        result[i] += Bbox_2(p[0], p[1], p[0], p[1]);
      }
    return result;
  }

  void sort_as_in_tree()
  {
    std::vector<Triangle> sorted;
    for(std::size_t i : m_tree.order())
      sorted.push_back(m_triangles[i]);
    m_triangles.swap(sorted);
  }

  static double squared_distance(const Bbox_2& box, const Xy& q)
  {
    const double dx = (std::max)({box.xmin() - q[0], q[0] - box.xmax(), 0.});
    const double dy = (std::max)({box.ymin() - q[1], q[1] - box.ymax(), 0.});
    return dx*dx + dy*dy;
  }

  static bool contains(const Bbox_2& box, const Xy& q)
  {
    return box.xmin() <= q[0] && q[0] <= box.xmax() && box.ymin() <= q[1] && q[1] <= box.ymax();
  }

  // the first triangle that holds the point, or else the number of triangles
  std::size_t triangle_at(const Point_2& p, const Xy& q) const
  {
    std::size_t found = m_triangles.size();
    m_tree.search([&](std::size_t node) { return contains(m_tree.nodes()[node].box, q) ? 0. : 1.; },
                   [&] { return found == m_triangles.size() ? 0. : -1.; },
                   [&](std::size_t k) {
                     if(found == m_triangles.size() && contains(m_corners[k], p))
                       found = k;
                   });
    return found;
  }

  Place nearest_place(const Xy& q) const
  {
    Candidate best = {std::numeric_limits<double>::infinity(), {m_triangles[0], {1, 0, 0}}};
    m_tree.search([&](std::size_t node) { return squared_distance(m_tree.nodes()[node].box, q); },
                   [&] { return best.squared_distance; },
                   [&](std::size_t k) { take_nearer_edge(m_triangles[k], q, best); });
    return best.place;
  }

  static bool contains(const Corners& corners, const Point_2& p)
  {
    const auto orientation = K().orientation_2_object();
    for(int i = 0; i < 3; ++i)
      if(orientation(corners[i], corners[(i + 1) % 3], p) == CLOCKWISE)
        return false;
    return true;
  }

  static double area(const Xy& a, const Xy& b, const Xy& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  Place inner_place(const Triangle& t, const Xy& q) const
  {
    const Xy a = xy(t, 0), b = xy(t, 1), c = xy(t, 2);
    std::array<double, 3> w = {area(q, b, c), area(a, q, c), area(a, b, q)};
    for(double& x : w)
      x = (std::max)(x, 0.); // rounding
    const double sum = w[0] + w[1] + w[2];
    if(!(sum > 0)) { // so flat that its area is rounded away
      Candidate nearest = {std::numeric_limits<double>::infinity(), {t, {1, 0, 0}}};
      take_nearer_edge(t, q, nearest);
      return nearest.place;
    }
    for(double& x : w)
      x /= sum;
    return Place{t, w};
  }

  void take_nearer_edge(const Triangle& t, const Xy& q, Candidate& best) const
  {
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Xy a = xy(t, i), b = xy(t, j);
      const double ux = b[0] - a[0], uy = b[1] - a[1], vx = q[0] - a[0], vy = q[1] - a[1];
      const double uu = ux*ux + uy*uy;
      const double s = uu > 0 ? (std::min)(1., (std::max)(0., (ux*vx + uy*vy) / uu)) : 0.;
      const double dx = vx - s*ux, dy = vy - s*uy, squared_distance = dx*dx + dy*dy;
      if(squared_distance < best.squared_distance) {
        best = Candidate{squared_distance, {t, {0, 0, 0}}};
        best.place.weights[i] = 1 - s;
        best.place.weights[j] = s;
      }
    }
  }

  std::vector<Point_2>  m_points;
  std::vector<Triangle> m_triangles;
  std::vector<Corners>  m_corners; // of the triangles, close together in memory
  double                m_scale;
  Box_tree              m_tree;    // of the triangles, which have its order
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H

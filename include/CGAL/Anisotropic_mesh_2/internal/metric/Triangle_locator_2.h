// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/assertions.h>
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
    build(0, m_triangles.size());
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

  struct Box
  {
    Xy low, high;

    bool contains(const Xy& q) const
    {
      return low[0] <= q[0] && q[0] <= high[0] && low[1] <= q[1] && q[1] <= high[1];
    }

    void add(const Xy& q)
    {
      for(int i = 0; i < 2; ++i) {
        low[i] = (std::min)(low[i], q[i]);
        high[i] = (std::max)(high[i], q[i]);
      }
    }

    double squared_distance(const Xy& q) const
    {
      const double dx = (std::max)({low[0] - q[0], q[0] - high[0], 0.});
      const double dy = (std::max)({low[1] - q[1], q[1] - high[1], 0.});
      return dx*dx + dy*dy;
    }
  };

  // The first child follows its parent; a leaf has no second.
  struct Node
  {
    Box         box;
    std::size_t begin, end, second_child;
  };

  struct Candidate
  {
    double squared_distance;
    Place  place;
  };

  static constexpr std::size_t leaf_size = 4, max_depth = 128;

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

  // Halves the triangles by their centres along the longer side of the box.
  void build(std::size_t begin, std::size_t end)
  {
    const std::size_t at = m_nodes.size();
    m_nodes.push_back(Node{box_of(begin, end), begin, end, 0});
    if(end - begin <= leaf_size)
      return;
    const Box& box = m_nodes[at].box;
    const int axis = box.high[0] - box.low[0] > box.high[1] - box.low[1] ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto triangle = [this](std::size_t i) { return m_triangles.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(triangle(begin), triangle(middle), triangle(end),
                     [this, axis](const Triangle& s, const Triangle& t) { return centre(s, axis) < centre(t, axis); });
    build(begin, middle);
    m_nodes[at].second_child = m_nodes.size();
    build(middle, end);
  }

  Box box_of(std::size_t begin, std::size_t end) const
  {
    Box box = {xy(m_triangles[begin], 0), xy(m_triangles[begin], 0)};
    for(std::size_t i = begin; i < end; ++i)
      for(int j = 0; j < 3; ++j)
        box.add(xy(m_triangles[i], j));
    return box;
  }

  double centre(const Triangle& t, int axis) const
  {
    return xy(t, 0)[axis] + xy(t, 1)[axis] + xy(t, 2)[axis];
  }

  // the first triangle that holds the point, or else the number of triangles
  std::size_t triangle_at(const Point_2& p, const Xy& q) const
  {
    std::array<std::size_t, max_depth> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while(size > 0) {
      const std::size_t at = stack[--size];
      const Node& node = m_nodes[at];
      if(!node.box.contains(q))
        continue;
      if(node.second_child > 0) {
        stack[size++] = node.second_child;
        stack[size++] = at + 1;
      } else
        for(std::size_t i = node.begin; i < node.end; ++i)
          if(contains(m_corners[i], p))
            return i;
    }
    return m_triangles.size();
  }

  // Visits the nearer boxes first and those only that can hold something
  // nearer than what was found.
  Place nearest_place(const Xy& q) const
  {
    std::array<std::size_t, max_depth> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    Candidate best = {std::numeric_limits<double>::infinity(), {m_triangles[0], {1, 0, 0}}};
    while(size > 0 && best.squared_distance > 0) {
      const std::size_t at = stack[--size];
      const Node& node = m_nodes[at];
      if(node.box.squared_distance(q) >= best.squared_distance)
        continue;
      if(node.second_child == 0)
        for(std::size_t i = node.begin; i < node.end; ++i)
          take_nearer_edge(m_triangles[i], q, best);
      else {
        std::size_t near = at + 1, far = node.second_child;
        if(m_nodes[far].box.squared_distance(q) < m_nodes[near].box.squared_distance(q))
          std::swap(near, far);
        stack[size++] = far;
        stack[size++] = near;
      }
    }
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
  std::vector<Node>     m_nodes;
  double                m_scale;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TRIANGLE_LOCATOR_2_H

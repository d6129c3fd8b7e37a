// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TRIANGLE_LOCATOR_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TRIANGLE_LOCATOR_2_H

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Finds the triangle that holds a point, or the nearest one, and the
// barycentric coordinates there. Queries are const and keep no state.
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
    : m_points(points), m_triangles(triangles)
  {
    if(triangles.empty())
      throw std::invalid_argument("the background mesh has no triangles");
    std::vector<Entry> entries;
    entries.reserve(triangles.size());
    for(std::size_t i = 0; i < triangles.size(); ++i) {
      orient(i);
      entries.emplace_back(box_of(m_triangles[i]), i);
    }
    m_tree = Tree(entries); // packed
  }

  Place locate(const Point_2& p) const
  {
    const Xy q = xy(p);
    const Tree_point at(q[0], q[1]);
    for(auto it = m_tree.qbegin(boost::geometry::index::intersects(at)); it != m_tree.qend(); ++it)
      if(contains(m_triangles[it->second], p))
        return inner_place(m_triangles[it->second], q);
    return nearest_place(q, at);
  }

private:
  typedef std::array<double, 2>                                                  Xy;
  typedef boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian> Tree_point;
  typedef boost::geometry::model::box<Tree_point>                                Box;
  typedef std::pair<Box, std::size_t>                                            Entry;
  typedef boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> Tree;

  static Xy xy(const Point_2& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

  // makes the triangle counterclockwise
  void orient(std::size_t i)
  {
    Triangle& t = m_triangles[i];
    for(std::size_t v : t)
      if(v >= m_points.size())
        throw std::invalid_argument("triangle " + std::to_string(i + 1) +
                                    " of the background mesh names a vertex that does not exist");
    const Orientation orientation = K().orientation_2_object()(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
    if(orientation == COLLINEAR)
      throw std::invalid_argument("triangle " + std::to_string(i + 1) +
                                  " of the background mesh has no area");
    if(orientation == CLOCKWISE)
      std::swap(t[1], t[2]);
  }

  Box box_of(const Triangle& t) const
  {
    const Xy a = xy(m_points[t[0]]), b = xy(m_points[t[1]]), c = xy(m_points[t[2]]);
    return Box(Tree_point((std::min)({a[0], b[0], c[0]}), (std::min)({a[1], b[1], c[1]})),
               Tree_point((std::max)({a[0], b[0], c[0]}), (std::max)({a[1], b[1], c[1]})));
  }

  bool contains(const Triangle& t, const Point_2& p) const
  {
    const auto orientation = K().orientation_2_object();
    for(int i = 0; i < 3; ++i)
      if(orientation(m_points[t[i]], m_points[t[(i + 1) % 3]], p) == CLOCKWISE)
        return false;
    return true;
  }

  static double area(const Xy& a, const Xy& b, const Xy& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  Place inner_place(const Triangle& t, const Xy& q) const
  {
    const Xy a = xy(m_points[t[0]]), b = xy(m_points[t[1]]), c = xy(m_points[t[2]]);
    std::array<double, 3> w = {area(q, b, c), area(a, q, c), area(a, b, q)};
    for(double& x : w)
      x = (std::max)(x, 0.); // rounding
    const double sum = w[0] + w[1] + w[2];
    if(!(sum > 0)) // so flat that its area is rounded away
      return nearest_place_in(t, q).second;
    for(double& x : w)
      x /= sum;
    return Place{t, w};
  }

  // Visits triangles by the distance of their boxes until no box can hold
  // anything nearer.
  Place nearest_place(const Xy& q, const Tree_point& at) const
  {
    std::pair<double, Place> best(std::numeric_limits<double>::infinity(), Place{m_triangles[0], {1, 0, 0}});
    const unsigned all = static_cast<unsigned>((std::min)(m_tree.size(),
      static_cast<std::size_t>((std::numeric_limits<unsigned>::max)())));
    for(auto it = m_tree.qbegin(boost::geometry::index::nearest(at, all)); it != m_tree.qend(); ++it) {
      if(boost::geometry::comparable_distance(at, it->first) > best.first)
        break;
      const std::pair<double, Place> place = nearest_place_in(m_triangles[it->second], q);
      if(place.first < best.first)
        best = place;
    }
    return best.second;
  }

  // the nearest point on the edges, with its squared distance
  std::pair<double, Place> nearest_place_in(const Triangle& t, const Xy& q) const
  {
    std::pair<double, Place> best(std::numeric_limits<double>::infinity(), Place{t, {1, 0, 0}});
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Xy a = xy(m_points[t[i]]), b = xy(m_points[t[j]]);
      const double ux = b[0] - a[0], uy = b[1] - a[1], vx = q[0] - a[0], vy = q[1] - a[1];
      const double uu = ux*ux + uy*uy;
      const double s = uu > 0 ? (std::min)(1., (std::max)(0., (ux*vx + uy*vy) / uu)) : 0.;
      const double dx = vx - s*ux, dy = vy - s*uy, distance = dx*dx + dy*dy;
      if(distance < best.first) {
        best = {distance, Place{t, {0, 0, 0}}};
        best.second.weights[i] = 1 - s;
        best.second.weights[j] = s;
      }
    }
    return best;
  }

  std::vector<Point_2>  m_points;
  std::vector<Triangle> m_triangles;
  Tree                  m_tree;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TRIANGLE_LOCATOR_2_H

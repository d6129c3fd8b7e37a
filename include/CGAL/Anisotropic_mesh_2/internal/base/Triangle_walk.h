// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_WALK_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_WALK_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Finds the triangle of a planar mesh that holds a point by a walk from one that is near. Triangles are
// counterclockwise and known by their number. A walk takes as many steps as there are triangles in between.
class Triangle_walk
{
public:
  typedef std::array<int, 3> Indices; // of the corners of a triangle, or of its neighbors opposite to these

  // the second and the third barycentric coordinate as functions
  struct Frame
  {
    Vector_of_doubles origin, second, third; // the first corner, and the gradients

    explicit Frame(const Triangle_of_doubles& z) : origin(z[0])
    {
      const double unit = 1 / (2 * area(z));
      second = {unit * (z[2].y - z[0].y), unit * (z[0].x - z[2].x)};
      third = {unit * (z[0].y - z[1].y), unit * (z[1].x - z[0].x)};
    }

    Barycentric operator()(const Vector_of_doubles& x) const
    {
      const double dx = x.x - origin.x, dy = x.y - origin.y;
      const double l1 = second.x*dx + second.y*dy, l2 = third.x*dx + third.y*dy;
      return {{1 - l1 - l2, l1, l2}};
    }
  };

  Triangle_walk(const Vectors& points, const std::vector<Indices>& corners)
    : m_neighbors(corners.size(), Indices{{-1, -1, -1}})
  {
    m_frames.reserve(corners.size());
    for(const Indices& c : corners)
      m_frames.emplace_back(Triangle_of_doubles{{points[c[0]], points[c[1]], points[c[2]]}});
    find_neighbors(points.size(), corners);
  }

  const Frame& frame(int triangle) const { return m_frames[triangle]; }

  // or -1
  int neighbor(int triangle, int i) const { return m_neighbors[triangle][i]; }

  // Returns the coordinates of x in the triangle that holds it, or of the nearest point of a triangle near the border
  // if none does; `triangle` is where the search begins, and becomes that one.
  Barycentric locate(const Vector_of_doubles& x, int& triangle) const
  {
    const int start = triangle;
    Barycentric l = walk(x, triangle);
    if(least(l) < -rounding) { // a hole or a notch is in the way
      triangle = search_around(x, start);
      l = m_frames[triangle](x);
    }
    return least(l) >= 0 ? l : drawn_inside(l);
  }

private:
  static constexpr int         maximum_steps = 1000;
  static constexpr std::size_t maximum_search = 100;
  static constexpr double      rounding = 1e-9;

  struct Half_edge
  {
    int upper_end, triangle, opposite;

    bool operator<(const Half_edge& e) const
    {
      return std::make_pair(upper_end, triangle) < std::make_pair(e.upper_end, e.triangle);
    }
  };

  // Triangles are neighbors at an edge between the same points. Edges are collected at their lower points.
  void find_neighbors(std::size_t number_of_points, const std::vector<Indices>& corners)
  {
    const auto ends = [&](std::size_t t, int k) {
      return std::minmax(corners[t][(k + 1) % 3], corners[t][(k + 2) % 3]);
    };
    std::vector<int> end(number_of_points + 1, 0); // of the edges of a point, which begin where those before end
    for(std::size_t t = 0; t < corners.size(); ++t)
      for(int k = 0; k < 3; ++k)
        ++end[ends(t, k).first + 1];
    for(std::size_t p = 0; p < number_of_points; ++p)
      end[p + 1] += end[p];
    std::vector<int> begin(end.begin(), end.end() - 1), next = begin;
    std::vector<Half_edge> edges(3 * corners.size());
    for(std::size_t t = 0; t < corners.size(); ++t)
      for(int k = 0; k < 3; ++k) {
        const auto [lower, upper] = ends(t, k);
        edges[next[lower]++] = {upper, int(t), k};
      }
    for(std::size_t p = 0; p < number_of_points; ++p)
      std::sort(edges.begin() + begin[p], edges.begin() + end[p + 1]);
    for(std::size_t p = 0; p < number_of_points; ++p)
      for(int e = begin[p]; e + 1 < end[p + 1]; ++e)
        if(const Half_edge &f = edges[e], &g = edges[e + 1]; f.upper_end == g.upper_end) {
          m_neighbors[f.triangle][f.opposite] = g.triangle;
          m_neighbors[g.triangle][g.opposite] = f.triangle;
        }
  }

  // Walks towards x, each time over an edge beyond which it lies. These are looked at in changing order,
  // since otherwise a walk among needles may go in circles.
  Barycentric walk(const Vector_of_doubles& x, int& triangle) const
  {
    Barycentric l = m_frames[triangle](x);
    for(int steps = 0; steps < maximum_steps; ++steps) {
      int next = -1;
      for(int i = 0; i < 3 && next < 0; ++i)
        if(const int k = (i + steps % 5) % 3; l[k] < -rounding)
          next = m_neighbors[triangle][k];
      if(next < 0)
        break;
      triangle = next;
      l = m_frames[triangle](x);
    }
    return l;
  }

  // the triangle that holds x or comes closest to it, among some near the start
  int search_around(const Vector_of_doubles& x, int start) const
  {
    std::vector<int> queue(1, start);
    int best = start;
    double largest = least(m_frames[start](x));
    for(std::size_t i = 0; i < queue.size() && queue.size() < maximum_search && largest < -rounding; ++i)
      for(int n : m_neighbors[queue[i]])
        if(n >= 0 && std::find(queue.begin(), queue.end(), n) == queue.end()) {
          queue.push_back(n);
          if(const double l = least(m_frames[n](x)); l > largest) {
            largest = l;
            best = n;
          }
        }
    return best;
  }

  static double least(const Barycentric& l) { return (std::min)({l[0], l[1], l[2]}); }

  static Barycentric drawn_inside(Barycentric l)
  {
    double sum = 0;
    for(double& t : l)
      sum += t = (std::max)(0., t);
    for(double& t : l)
      t /= sum;
    return l;
  }

  std::vector<Frame>   m_frames;
  std::vector<Indices> m_neighbors;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TRIANGLE_WALK_H

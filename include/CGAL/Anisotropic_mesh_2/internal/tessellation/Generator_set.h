// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A point with the tensor by which distances from there are measured.
struct Place
{
  Vector_of_doubles at;
  Symmetric_form    m;
};

// Generators and the distances to them, measured at places or at generators,
// with a tree of boxes that answers for any set of generators and any tensor.
class Generator_set
{
public:
  // distances measured at places
  explicit Generator_set(Vectors positions) : Generator_set(std::move(positions), std::vector<Symmetric_form>()) {}

  // Distances measured at generators, if `tensors` is not empty.
  Generator_set(Vectors positions, std::vector<Symmetric_form> tensors)
    : m_positions(std::move(positions)), m_tensors(std::move(tensors)), m_order(m_positions.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    if(!m_order.empty())
      build(0, m_order.size());
  }

  std::size_t size() const { return m_positions.size(); }
  const Vector_of_doubles& position(std::size_t i) const { return m_positions[i]; }
  bool is_measured_at_generators() const { return !m_tensors.empty(); }

  // the tensor by which the distance between the place and the generator is measured
  const Symmetric_form& tensor(const Place& p, std::size_t i) const
  {
    return is_measured_at_generators() ? m_tensors[i] : p.m;
  }

  double squared_distance(const Place& p, std::size_t i) const
  {
    return tensor(p, i)(p.at.x - m_positions[i].x, p.at.y - m_positions[i].y);
  }

  // The squared distance to i less that to j: where both are measured by the
  // same tensor, without the cancellation.
  double difference(const Place& p, std::size_t i, std::size_t j) const
  {
    if(is_measured_at_generators())
      return squared_distance(p, i) - squared_distance(p, j);
    const Vector_of_doubles &zi = m_positions[i], &zj = m_positions[j];
    return 2 * p.m(zj.x - zi.x, zj.y - zi.y, p.at.x - (zi.x + zj.x) / 2, p.at.y - (zi.y + zj.y) / 2);
  }

  // The nearest generator, the one of lowest index if several are. `hint` is
  // any generator; the nearer it is the faster the answer.
  std::size_t nearest(const Place& p, std::size_t hint = 0) const
  {
    std::pair<double, std::size_t> best(squared_distance(p, hint), hint);
    search_nearest(0, p, best);
    return best.second;
  }

  // All generators that are within `radius` of a point that is within `reach`
  // of p; lengths are metric if measured at places, else `reach` is Euclidean.
  void within(const Place& p, double reach, double radius, std::vector<std::size_t>& result) const
  {
    result.clear();
    if(!m_order.empty())
      search_within(0, p, reach, radius, result);
  }

private:
  static constexpr std::size_t bucket_size = 8;

  struct Node
  {
    double x_min, x_max, y_min, y_max;
    double least_eigenvalue; // of the tensors at the generators; 1 if there are none
    std::size_t begin, end;  // in the order
    std::size_t second;      // the second child; the first one follows its parent. 0 for a bucket
  };

  std::size_t build(std::size_t begin, std::size_t end)
  {
    const std::size_t index = m_nodes.size();
    m_nodes.push_back(bound(begin, end));
    if(end - begin <= bucket_size)
      return index;
    const Node& n = m_nodes.back();
    const bool along_x = n.x_max - n.x_min > n.y_max - n.y_min;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return m_order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t i, std::size_t j) {
      const double u = along_x ? m_positions[i].x : m_positions[i].y;
      const double v = along_x ? m_positions[j].x : m_positions[j].y;
      return std::make_pair(u, i) < std::make_pair(v, j);
    });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    m_nodes[index].second = second;
    return index;
  }

  Node bound(std::size_t begin, std::size_t end) const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    Node n = {infinity, -infinity, infinity, -infinity, is_measured_at_generators() ? infinity : 1, begin, end, 0};
    for(std::size_t k = begin; k < end; ++k) {
      const std::size_t i = m_order[k];
      n.x_min = (std::min)(n.x_min, m_positions[i].x);
      n.x_max = (std::max)(n.x_max, m_positions[i].x);
      n.y_min = (std::min)(n.y_min, m_positions[i].y);
      n.y_max = (std::max)(n.y_max, m_positions[i].y);
      if(is_measured_at_generators())
        n.least_eigenvalue = (std::min)(n.least_eigenvalue, least_eigenvalue(m_tensors[i]));
    }
    return n;
  }

  static double least_eigenvalue(const Symmetric_form& m)
  {
    const double greatest = (m.a + m.c) / 2 + std::hypot((m.a - m.c) / 2, m.b);
    return m.determinant() / greatest;
  }

  // the least squared length from p to a point of the box
  static double squared_distance_to_box(const Vector_of_doubles& p, const Symmetric_form& m, const Node& n)
  {
    const double x0 = n.x_min - p.x, x1 = n.x_max - p.x, y0 = n.y_min - p.y, y1 = n.y_max - p.y;
    if(x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0)
      return 0;
    double least = std::numeric_limits<double>::infinity();
    for(double x : {x0, x1})
      least = (std::min)(least, m(x, (std::min)(y1, (std::max)(y0, -m.b*x / m.c))));
    for(double y : {y0, y1})
      least = (std::min)(least, m(std::min(x1, (std::max)(x0, -m.b*y / m.a)), y));
    // rounding must not hide a generator, whose terms may cancel
    return least * (1 - 1e-9) - 1e-14 * (m.a * (std::max)(x0*x0, x1*x1) + m.c * (std::max)(y0*y0, y1*y1));
  }

  double squared_distance_to_box(const Place& p, const Node& n) const
  {
    return is_measured_at_generators()
      ? squared_distance_to_box(p.at, Symmetric_form(1, 0, 1), n) * n.least_eigenvalue
      : squared_distance_to_box(p.at, p.m, n);
  }

  void search_nearest(std::size_t index, const Place& p, std::pair<double, std::size_t>& best) const
  {
    const Node& n = m_nodes[index];
    if(n.second == 0) {
      for(std::size_t k = n.begin; k < n.end; ++k)
        best = (std::min)(best, std::make_pair(squared_distance(p, m_order[k]), m_order[k]));
      return;
    }
    std::pair<double, std::size_t> first(squared_distance_to_box(p, m_nodes[index + 1]), index + 1),
                                   second(squared_distance_to_box(p, m_nodes[n.second]), n.second);
    if(second < first)
      std::swap(first, second);
    if(first.first <= best.first)
      search_nearest(first.second, p, best);
    if(second.first <= best.first)
      search_nearest(second.second, p, best);
  }

  void search_within(std::size_t index, const Place& p, double reach, double radius,
                     std::vector<std::size_t>& result) const
  {
    const Node& n = m_nodes[index];
    const Symmetric_form m = is_measured_at_generators() ? Symmetric_form(1, 0, 1) : p.m;
    const double limit = reach + radius / std::sqrt(n.least_eigenvalue);
    if(squared_distance_to_box(p.at, m, n) > limit * limit)
      return;
    if(n.second != 0) {
      search_within(index + 1, p, reach, radius, result);
      search_within(n.second, p, reach, radius, result);
      return;
    }
    for(std::size_t k = n.begin; k < n.end; ++k) {
      const Vector_of_doubles& z = m_positions[m_order[k]];
      if(m(z.x - p.at.x, z.y - p.at.y) <= limit * limit)
        result.push_back(m_order[k]);
    }
  }

  Vectors                     m_positions;
  std::vector<Symmetric_form> m_tensors;
  std::vector<std::size_t>    m_order; // of the generators in the tree
  std::vector<Node>           m_nodes;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H

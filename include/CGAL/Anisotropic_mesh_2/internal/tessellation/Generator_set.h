// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Box_tree.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A point with the tensor by which distances from there are measured.
struct Metric_point
{
  Vector_of_doubles at;
  Symmetric_form    m;
};

// Generators and the distances to them, measured at points or at generators,
// with a tree of boxes that answers for any set of generators and any tensor.
class Generator_set
{
public:
  // distances measured at points
  explicit Generator_set(Vectors positions) : Generator_set(std::move(positions), std::vector<Symmetric_form>()) {}

  // Distances measured at generators, if `tensors` is not empty.
  Generator_set(Vectors positions, std::vector<Symmetric_form> tensors)
    : m_positions(std::move(positions)), m_tensors(std::move(tensors)), m_tree(boxes(m_positions), 8)
  {
    if(is_measured_at_generators())
      find_least_eigenvalues();
  }

  std::size_t size() const { return m_positions.size(); }
  const Vector_of_doubles& position(std::size_t i) const { return m_positions[i]; }
  bool is_measured_at_generators() const { return !m_tensors.empty(); }

  // the tensor by which the distance between the point and the generator is measured
  const Symmetric_form& tensor(const Metric_point& p, std::size_t i) const
  {
    return is_measured_at_generators() ? m_tensors[i] : p.m;
  }

  double squared_distance(const Metric_point& p, std::size_t i) const
  {
    return tensor(p, i)(p.at.x - m_positions[i].x, p.at.y - m_positions[i].y);
  }

  // The squared distance to i less that to j: where both are measured by the
  // same tensor, without the cancellation.
  double difference(const Metric_point& p, std::size_t i, std::size_t j) const
  {
    if(is_measured_at_generators())
      return squared_distance(p, i) - squared_distance(p, j);
    const Vector_of_doubles &zi = m_positions[i], &zj = m_positions[j];
    return 2 * p.m(zj.x - zi.x, zj.y - zi.y, p.at.x - (zi.x + zj.x) / 2, p.at.y - (zi.y + zj.y) / 2);
  }

  // The nearest generator, the one of lowest index if several are. `hint` is
  // any generator; the nearer it is the faster the answer.
  std::size_t nearest(const Metric_point& p, std::size_t hint = 0) const
  {
    std::pair<double, std::size_t> best(squared_distance(p, hint), hint);
    m_tree.search([&](std::size_t node) { return squared_distance_to_box(p, node); },
                  [&] { return best.first; },
                  [&](std::size_t k) {
                    const std::size_t i = m_tree.order()[k];
                    best = (std::min)(best, std::make_pair(squared_distance(p, i), i));
                  });
    return best.second;
  }

  // All generators that are within `radius` of a point that is within `reach`
  // of p; lengths are metric if measured at points, else `reach` is Euclidean.
  void within(const Metric_point& p, double reach, double radius, std::vector<std::size_t>& result) const
  {
    result.clear();
    const Symmetric_form m = is_measured_at_generators() ? Symmetric_form(1, 0, 1) : p.m;
    const auto excess = [&](double squared_distance, double eigenvalue) { // over what is within, or 0
      const double limit = reach + radius / std::sqrt(eigenvalue);
      return (std::max)(0., squared_distance - limit * limit);
    };
    m_tree.search([&](std::size_t node) {
                    return excess(squared_distance_to_box(p.at, m, m_tree.nodes()[node].box),
                                  least_eigenvalue_in(node));
                  },
                  [] { return 0.; },
                  [&](std::size_t k) {
                    const std::size_t i = m_tree.order()[k];
                    const double x = m_positions[i].x - p.at.x, y = m_positions[i].y - p.at.y;
                    if(excess(m(x, y), is_measured_at_generators() ? least_eigenvalue(m_tensors[i]) : 1) <= 0)
                      result.push_back(i);
                  });
  }

private:
  static std::vector<Bbox_2> boxes(const Vectors& positions)
  {
    std::vector<Bbox_2> result;
    for(const Vector_of_doubles& z : positions)
      result.emplace_back(z.x, z.y, z.x, z.y);
    return result;
  }

  void find_least_eigenvalues()
  {
    const auto& nodes = m_tree.nodes();
    m_least_eigenvalues.assign(nodes.size(), std::numeric_limits<double>::infinity());
    for(std::size_t n = nodes.size(); n-- > 0; )
      if(nodes[n].is_leaf())
        for(std::size_t k = nodes[n].begin; k < nodes[n].end; ++k)
          m_least_eigenvalues[n] = (std::min)(m_least_eigenvalues[n],
                                              least_eigenvalue(m_tensors[m_tree.order()[k]]));
      else
        m_least_eigenvalues[n] = (std::min)(m_least_eigenvalues[n + 1], m_least_eigenvalues[nodes[n].second_child]);
  }

  static double least_eigenvalue(const Symmetric_form& m)
  {
    const double greatest = (m.a + m.c) / 2 + std::hypot((m.a - m.c) / 2, m.b);
    return m.determinant() / greatest;
  }

  double least_eigenvalue_in(std::size_t node) const
  {
    return is_measured_at_generators() ? m_least_eigenvalues[node] : 1;
  }

  // the least squared length from p to a point of the box
  static double squared_distance_to_box(const Vector_of_doubles& p, const Symmetric_form& m, const Bbox_2& box)
  {
    const double x0 = box.xmin() - p.x, x1 = box.xmax() - p.x, y0 = box.ymin() - p.y, y1 = box.ymax() - p.y;
    if(x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0)
      return 0;
    double least = std::numeric_limits<double>::infinity();
    for(double x : {x0, x1})
      least = (std::min)(least, m(x, (std::min)(y1, (std::max)(y0, -m.b*x / m.c))));
    for(double y : {y0, y1})
      least = (std::min)(least, m((std::min)(x1, (std::max)(x0, -m.b*y / m.a)), y));
    // rounding must not hide a generator, whose terms may cancel
    return least * (1 - 1e-9) - 1e-14 * (m.a * (std::max)(x0*x0, x1*x1) + m.c * (std::max)(y0*y0, y1*y1));
  }

  double squared_distance_to_box(const Metric_point& p, std::size_t node) const
  {
    const Bbox_2& box = m_tree.nodes()[node].box;
    return is_measured_at_generators()
      ? squared_distance_to_box(p.at, Symmetric_form(1, 0, 1), box) * least_eigenvalue_in(node)
      : squared_distance_to_box(p.at, p.m, box);
  }

  Vectors                     m_positions;
  std::vector<Symmetric_form> m_tensors;
  Box_tree                    m_tree;
  std::vector<double>         m_least_eigenvalues; // of the tensors in each node of the tree
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_GENERATOR_SET_H

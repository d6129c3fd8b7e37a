// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_LBFGS_HISTORY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_LBFGS_HISTORY_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

inline double scalar_product(const Vectors& u, const Vectors& v)
{
  double sum = 0;
  for(std::size_t i = 0; i < u.size(); ++i)
    sum += u[i].x*v[i].x + u[i].y*v[i].y;
  return sum;
}

// u += t v
inline void add_multiple(Vectors& u, double t, const Vectors& v)
{
  for(std::size_t i = 0; i < u.size(); ++i) {
    u[i].x += t*v[i].x;
    u[i].y += t*v[i].y;
  }
}

// The last steps and differences of gradients, which stand for the inverse
// Hessian in the two-loop recursion of the L-BFGS method.
class Lbfgs_history
{
public:
  explicit Lbfgs_history(std::size_t maximum_size = 7) : m_maximum_size(maximum_size) {}

  void clear() { m_pairs.clear(); }
  bool empty() const { return m_pairs.empty(); }

  // Pairs without positive curvature would spoil the definiteness and are dropped.
  void add(Vectors step, Vectors gradient_difference)
  {
    const double curvature = scalar_product(step, gradient_difference);
    if(!(curvature > 1e-10 * std::sqrt(scalar_product(gradient_difference, gradient_difference)
                                     * scalar_product(step, step))))
      return;
    if(m_pairs.size() == m_maximum_size)
      m_pairs.pop_front();
    m_pairs.push_back({std::move(step), std::move(gradient_difference), 1 / curvature});
  }

  // Turns a gradient into minus the product with the inverse Hessian, that of
  // the beginning being applied by `precondition`.
  template <class Precondition>
  void direction(Vectors& v, const Precondition& precondition) const
  {
    std::vector<double> alpha(m_pairs.size());
    for(std::size_t k = m_pairs.size(); k-- > 0;) {
      alpha[k] = m_pairs[k].rho * scalar_product(m_pairs[k].step, v);
      add_multiple(v, -alpha[k], m_pairs[k].difference);
    }
    precondition(v);
    for(std::size_t k = 0; k < m_pairs.size(); ++k) {
      const double beta = m_pairs[k].rho * scalar_product(m_pairs[k].difference, v);
      add_multiple(v, alpha[k] - beta, m_pairs[k].step);
    }
    for(Vector_of_doubles& w : v)
      w = {-w.x, -w.y};
  }

private:
  struct Pair
  {
    Vectors step, difference;
    double  rho;
  };

  std::size_t      m_maximum_size;
  std::deque<Pair> m_pairs;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_LBFGS_HISTORY_H

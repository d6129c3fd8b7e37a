// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_LBFGS_HISTORY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_LBFGS_HISTORY_H

#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/vector_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The last steps and differences of gradients, which stand for the inverse
// Hessian in the two-loop recursion of the L-BFGS method. Kept as directions in
// single precision, with their lengths apart.
template <class ConcurrencyTag>
class Lbfgs_history
{
public:
  explicit Lbfgs_history(std::size_t maximum_size = 5) : m_maximum_size(maximum_size) {}

  void clear() { m_pairs.clear(); }
  bool empty() const { return m_pairs.empty(); }

  // Pairs without positive curvature would destroy the definiteness and are dropped.
  void add(const std::vector<double>& step, const std::vector<double>& gradient_difference)
  {
    const double s = length(step), y = length(gradient_difference);
    const double cosine = scalar_product<ConcurrencyTag>(step, gradient_difference) / (s * y);
    if(!(cosine > 1e-10))
      return;
    if(m_pairs.size() < m_maximum_size)
      m_pairs.emplace_back();
    else
      std::rotate(m_pairs.begin(), m_pairs.begin() + 1, m_pairs.end()); // the memory of the oldest serves again
    Pair& pair = m_pairs.back();
    set_to_quotient(pair.step, step, s);
    set_to_quotient(pair.difference, gradient_difference, y);
    pair.cosine = cosine;
    pair.ratio = s / y;
  }

  // Turns a gradient into minus the product with the inverse Hessian, that of
  // the beginning being applied by `precondition`.
  template <class Precondition>
  void direction(std::vector<double>& v, const Precondition& precondition) const
  {
    std::vector<double> alpha(m_pairs.size());
    for(std::size_t k = m_pairs.size(); k-- > 0;) {
      const Pair& p = m_pairs[k];
      alpha[k] = scalar_product<ConcurrencyTag>(p.step, v) / p.cosine;
      add_multiple<ConcurrencyTag>(v, -alpha[k], p.difference);
    }
    precondition(v);
    for(std::size_t k = 0; k < m_pairs.size(); ++k) {
      const Pair& p = m_pairs[k];
      const double beta = scalar_product<ConcurrencyTag>(p.difference, v) / p.cosine;
      add_multiple<ConcurrencyTag>(v, p.ratio * alpha[k] - beta, p.step);
    }
    for_each_index<ConcurrencyTag>(v.size(), [&](std::size_t i) { v[i] = -v[i]; });
  }

private:
  struct Pair
  {
    std::vector<float> step, difference; // of unit length
    double cosine, ratio;               // of the angle and of the lengths of the two
  };

  static double length(const std::vector<double>& v) { return std::sqrt(scalar_product<ConcurrencyTag>(v, v)); }

  static void set_to_quotient(std::vector<float>& u, const std::vector<double>& v, double divisor)
  {
    u.resize(v.size());
    for_each_index<ConcurrencyTag>(v.size(), [&](std::size_t i) { u[i] = float(v[i] / divisor); });
  }

  std::size_t       m_maximum_size;
  std::vector<Pair> m_pairs;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_LBFGS_HISTORY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TENSOR_EXPONENTIAL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TENSOR_EXPONENTIAL_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// The metric tensor with a given matrix logarithm l, and how it changes with l.
// With l = t I + B, where B has no trace, exp(l) = e^t (cosh s I + sinh s / s B), s being the norm of B.
class Tensor_exponential
{
public:
  explicit Tensor_exponential(const Symmetric_form& l) : m_p((l.a - l.c) / 2), m_q(l.b)
  {
    const double s = std::sqrt(m_p*m_p + m_q*m_q), e = std::exp(s), even = (e + 1/e) / 2;
    const double odd = s > 1e-3 ? (e - 1/e) / (2*s) : 1 + s*s/6;
    m_scale = std::exp((l.a + l.c) / 2);
    m_odd = m_scale * odd;
    m_bent = m_scale * (s > 0.03 ? (even - odd) / (s*s) : 1./3 + s*s/30);
    // cosh s = e^-s + sinh s, and of s + p and s - p the smaller one without cancellation
    const double larger = s + std::abs(m_p), smaller = s > 0 ? m_q*m_q / larger : 0;
    const double plus = m_p > 0 ? larger : smaller, minus = m_p > 0 ? smaller : larger;
    m_value = Symmetric_form(m_scale / e + m_odd * plus, m_odd * m_q, m_scale / e + m_odd * minus);
  }

  const Symmetric_form& value() const { return m_value; }
  double root_of_determinant() const { return m_scale; }

  // the derivative of the tensor while the logarithm changes by dl
  Symmetric_form derivative(const Symmetric_form& dl) const
  {
    const double dt = (dl.a + dl.c) / 2, dp = (dl.a - dl.c) / 2, dq = dl.b, r = m_p*dp + m_q*dq;
    const double p = m_bent * r * m_p + m_odd * dp, q = m_bent * r * m_q + m_odd * dq;
    return dt * m_value + Symmetric_form(m_odd * r + p, q, m_odd * r - p);
  }

private:
  double         m_p, m_q, m_scale, m_odd, m_bent;
  Symmetric_form m_value;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_TENSOR_EXPONENTIAL_H

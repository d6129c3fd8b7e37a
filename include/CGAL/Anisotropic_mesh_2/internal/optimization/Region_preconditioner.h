// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_REGION_PRECONDITIONER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_REGION_PRECONDITIONER_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_hessian.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// An approximation of the inverse of the Hessian 2 A - R of the energy: a few
// steps of Chebyshev's iteration for 2 (1 + damping) A - R, whose spectrum
// relative to 2 A lies below 1 + damping. It is a fixed linear map, and positive
// even where the Hessian is not, since below the interval of the iteration its
// polynomial is positive.
template <class ConcurrencyTag>
class Region_preconditioner
{
  typedef Bisector_hessian::Vector_of_floats  Vector_of_floats;
  typedef Bisector_hessian::Vectors_of_floats Vectors_of_floats;

public:
  // `free` holds the indices of the free vertices; the others do not move.
  Region_preconditioner(const std::vector<int>& free) : m_free(free) {}

  // Replaces g, an array of the coordinates of the free vertices.
  void operator()(const std::vector<Region_moments>& moments, Bisector_hessian& couplings, std::vector<double>& g)
  {
    const double centre = (1 + 2*damping) / 2, radius = 0.5, sigma = centre / radius;
    const double length = couplings.unit_of_length(), stiffness = couplings.unit_of_stiffness();
    double rho = 1 / sigma;
    m_step.assign(moments.size(), {});
    m_sum.resize(m_free.size());
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
      const Vector_of_doubles r = scaled(moments[m_free[i]], g[2*i] / length, g[2*i + 1] / length);
      g[2*i] = r.x; // from here on the residual, relative to 2 A
      g[2*i + 1] = r.y;
      m_sum[i] = m_step[m_free[i]] = {float(r.x / centre), float(r.y / centre)};
    });
    for(int step = 0; step < steps; ++step) {
      couplings.multiply<ConcurrencyTag>(m_step, m_product);
      const double next_rho = 1 / (2*sigma - rho);
      for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
        Vector_of_floats& d = m_step[m_free[i]];
        const Vector_of_floats& p = m_product[m_free[i]];
        const Vector_of_doubles q = scaled(moments[m_free[i]], stiffness * p.x, stiffness * p.y);
        g[2*i] += q.x - (1 + damping) * d.x;
        g[2*i + 1] += q.y - (1 + damping) * d.y;
        d.x = float(next_rho * (rho * d.x + 2/radius * g[2*i]));
        d.y = float(next_rho * (rho * d.y + 2/radius * g[2*i + 1]));
        m_sum[i].x += d.x;
        m_sum[i].y += d.y;
      });
      rho = next_rho;
    }
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
      g[2*i] = length * m_sum[i].x;
      g[2*i + 1] = length * m_sum[i].y;
    });
  }

private:
  static constexpr double damping = 0.1;
  static constexpr int    steps = 2;

  // (2 A)^-1 (x, y)
  static Vector_of_doubles scaled(const Region_moments& m, double x, double y)
  {
    return m.solve(x / 2, y / 2);
  }

  const std::vector<int>& m_free;
  Vectors_of_floats m_step, m_product; // by index
  Vectors_of_floats m_sum;             // by rank
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_REGION_PRECONDITIONER_H

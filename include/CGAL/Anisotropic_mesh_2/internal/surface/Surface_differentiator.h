// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DIFFERENTIATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DIFFERENTIATOR_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/weights_of_five_nodes.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// Derivatives of a function from parameters to points, by differences of five
// nodes in each direction, none of which leaves a range that is not periodic.
//
// Steps balance truncation, of the fourth order, and rounding, for functions that
// change over a sixth of the range as the sine does over one radian.
template <class K, class Function>
class Surface_differentiator
{
  typedef typename K::FT         FT;
  typedef typename K::Point_2    Point_2;
  typedef typename K::Vector_3   Vector_3;

public:
  Surface_differentiator(const Function& function, const Parameter_rectangle& r) : m_function(function), m_r(r) {}

  // the derivative of the given orders, which add up to 1 or 2
  Vector_3 operator()(const Point_2& uv, int order_u, int order_v) const
  {
    const double relative_step = order_u + order_v == 1 ? 1.2e-4 : 4e-4;
    const Stencil su(CGAL::to_double(uv.x()), m_r.u_min, m_r.u_max, m_r.u_is_periodic, relative_step, order_u);
    const Stencil sv(CGAL::to_double(uv.y()), m_r.v_min, m_r.v_max, m_r.v_is_periodic, relative_step, order_v);
    const auto origin = m_function(uv); // differences from here lose less
    Vector_3 sum(FT(0), FT(0), FT(0));
    for(int i = 0; i < 5; ++i)
      for(int j = 0; j < 5; ++j)
        if(su.weight[i] != 0 && sv.weight[j] != 0)
          sum = sum + FT(su.weight[i] * sv.weight[j]) * (m_function(Point_2(FT(su.node[i]), FT(sv.node[j]))) - origin);
    return sum;
  }

private:
  // the nodes and their weights in one direction
  struct Stencil
  {
    std::array<double, 5> node, weight;

    Stencil(double x, double low, double high, bool is_periodic, double relative_step, int order)
    {
      const double step = relative_step * (high - low);
      int here = 2; // the number of the node at x
      if(!is_periodic && x - low < 2*step)
        here = x - low < step ? 0 : 1;
      else if(!is_periodic && high - x < 2*step)
        here = high - x < step ? 4 : 3;
      const double scale = order == 0 ? 1 : 1 / (12 * (order == 1 ? step : step*step));
      for(int i = 0; i < 5; ++i) {
        node[i] = x + (i - here) * step;
        weight[i] = scale * weights_of_five_nodes[order][here][i];
      }
    }
  };

  const Function&           m_function;
  const Parameter_rectangle m_r;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DIFFERENTIATOR_H

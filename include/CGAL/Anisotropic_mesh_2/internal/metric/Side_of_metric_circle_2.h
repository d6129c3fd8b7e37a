// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_2_H

#include <CGAL/Metric_tensor_2.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/Uncertain.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// The cavity criterion (sections 3.1 of the paper) in the arithmetic of K.
//
// For the counterclockwise triangle abc and the tensor M, the in-circle
// determinant of the points lifted by x^T M x is linear in M:
//     I_M = m11 X + 2 m12 S + m22 Y,
// with X, S, Y common to the four tensors, and with o the doubled area and L_M
// the product of the squared lengths of the edges,
//     alpha_M^2 = 1 - 4 det(M) o I_M / L_M.
// So the product of the four alphas is below 1 iff
//     prod (L_M - 4 det(M) o I_M) < prod L_M,
// which needs ring operations only. Where the four I_M agree in sign they decide.
template <class K>
class Side_of_metric_circle_2
{
  typedef typename K::FT        FT;
  typedef typename K::Point_2   Point_2;
  typedef Metric_tensor_2<K>    Metric_tensor;

  typedef std::array<FT, 4>     Four;

public:
  typedef typename K::Oriented_side result_type;

  result_type operator()(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                         const Metric_tensor& ma, const Metric_tensor& mb,
                         const Metric_tensor& mc, const Metric_tensor& mp) const
  {
    const Four in_circle = in_circle_determinants(a, b, c, p, ma, mb, mc, mp);

    bool inside = true, outside = true, on = true;
    for(const FT& i : in_circle) {
      inside  = inside  && certainly(i >= 0);
      outside = outside && certainly(i <= 0);
      on      = on      && certainly(i == 0);
    }
    if(on)
      return make_certain_side(ON_ORIENTED_BOUNDARY);
    if(inside && some_certainly_nonzero(in_circle))
      return make_certain_side(ON_POSITIVE_SIDE);
    if(outside && some_certainly_nonzero(in_circle))
      return make_certain_side(ON_NEGATIVE_SIDE);

    const FT o = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    FT all_l = 1, all_alpha = 1;
    const std::array<const Metric_tensor*, 4> tensors = {&ma, &mb, &mc, &mp};
    for(int i = 0; i < 4; ++i) {
      const FT l = product_of_squared_edges(a, b, c, *tensors[i]);
      all_l = all_l * l;
      all_alpha = all_alpha * (l - 4 * tensors[i]->determinant() * o * in_circle[i]);
    }
    return CGAL::compare(all_l, all_alpha);
  }

private:
  static result_type make_certain_side(Oriented_side s) { return result_type(s); }

  static bool some_certainly_nonzero(const Four& values)
  {
    for(const FT& v : values)
      if(certainly(v != 0))
        return true;
    return false;
  }

  static Four in_circle_determinants(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                     const Metric_tensor& ma, const Metric_tensor& mb,
                                     const Metric_tensor& mc, const Metric_tensor& mp)
  {
    const FT ax = a.x() - p.x(), ay = a.y() - p.y();
    const FT bx = b.x() - p.x(), by = b.y() - p.y();
    const FT cx = c.x() - p.x(), cy = c.y() - p.y();
    const FT bc = bx*cy - by*cx, ca = cx*ay - cy*ax, ab = ax*by - ay*bx;
    const FT x = ax*ax*bc + bx*bx*ca + cx*cx*ab;
    const FT s = ax*ay*bc + bx*by*ca + cx*cy*ab;
    const FT y = ay*ay*bc + by*by*ca + cy*cy*ab;
    const auto lifted = [&](const Metric_tensor& m) -> FT
                        { return m.m11()*x + 2*m.m12()*s + m.m22()*y; };
    return Four{lifted(ma), lifted(mb), lifted(mc), lifted(mp)};
  }

  static FT product_of_squared_edges(const Point_2& a, const Point_2& b, const Point_2& c,
                                     const Metric_tensor& m)
  {
    return m.squared_length(b.x() - a.x(), b.y() - a.y())
         * m.squared_length(c.x() - b.x(), c.y() - b.y())
         * m.squared_length(a.x() - c.x(), a.y() - c.y());
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_2_H

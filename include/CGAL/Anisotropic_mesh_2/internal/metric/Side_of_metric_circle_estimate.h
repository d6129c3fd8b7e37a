// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_ESTIMATE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_ESTIMATE_H

#include <CGAL/enum.h>
#include <CGAL/Uncertain.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// half a unit in the last place of 1
constexpr double rounding_unit = 1. / (1ull << 53);

// The in-circle determinants of the points lifted by the tensors, as a linear
// form of the entries of the tensor. All coordinates are relative to p.
struct Lifted_determinant
{
  double ax, ay, bx, by, cx, cy;
  double x, s, y; // the coefficients of m11, 2 m12 and m22

  template <class Point_2>
  Lifted_determinant(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p)
    : ax(a.x() - p.x()), ay(a.y() - p.y()), bx(b.x() - p.x()), by(b.y() - p.y()),
      cx(c.x() - p.x()), cy(c.y() - p.y())
  {
    const double bc = bx*cy - by*cx, ca = cx*ay - cy*ax, ab = ax*by - ay*bx;
    const double ax_bc = ax*bc, ay_bc = ay*bc, bx_ca = bx*ca, by_ca = by*ca, cx_ab = cx*ab, cy_ab = cy*ab;
    x = ax*ax_bc + bx*bx_ca + cx*cx_ab;
    s = ax*ay_bc + bx*by_ca + cx*cy_ab;
    y = ay*ay_bc + by*by_ca + cy*cy_ab;
  }

  template <class Metric_tensor>
  double operator()(const Metric_tensor& m) const { return m.m11()*x + m.m12()*(2*s) + m.m22()*y; }

  double reach_x() const { return (std::max)(std::abs(ax), (std::max)(std::abs(bx), std::abs(cx))); }
  double reach_y() const { return (std::max)(std::abs(ay), (std::max)(std::abs(by), std::abs(cy))); }
};

// Bounds, term by term, of the rounding errors of a lifted determinant.
class Lifted_determinant_error
{
public:
  explicit Lifted_determinant_error(const Lifted_determinant& d)
  {
    add(std::abs(d.ax), std::abs(d.ay), std::abs(d.bx*d.cy) + std::abs(d.by*d.cx));
    add(std::abs(d.bx), std::abs(d.by), std::abs(d.cx*d.ay) + std::abs(d.cy*d.ax));
    add(std::abs(d.cx), std::abs(d.cy), std::abs(d.ax*d.by) + std::abs(d.ay*d.bx));
  }

  // At most thirteen roundings act on a term of the sum; twenty are granted (the manual's "Derivations").
  template <class Metric_tensor>
  double operator()(const Metric_tensor& m) const
  {
    return 20*rounding_unit * (m.m11()*m_x + 2*std::abs(m.m12())*m_s + m.m22()*m_y);
  }

  // whether neither underflow nor overflow can break the bound, for tensors in their range
  bool is_in_safe_range(const Lifted_determinant& d) const
  {
    return (std::max)(d.reach_x(), d.reach_y()) < 1e40 && m_x > 1e-164 && m_y > 1e-164;
  }

  template <class Metric_tensor>
  static bool is_in_safe_range(const Metric_tensor& m)
  {
    const double trace = m.m11() + m.m22();
    return trace > 1e-60 && trace < 1e60;
  }

private:
  void add(double x, double y, double minor)
  {
    m_x += x*x*minor;
    m_s += x*y*minor;
    m_y += y*y*minor;
  }

  double m_x = 0, m_s = 0, m_y = 0;
};

// The cavity criterion in plain doubles together with bounds of the rounding
// errors, for configurations in which not all determinants have the same sign.
template <class Point_2, class Metric_tensor>
class Side_of_metric_circle_estimate
{
  typedef std::array<double, 4>                 Four;
  typedef Uncertain<Oriented_side>              Result;
  typedef std::array<const Metric_tensor*, 4>   Tensors;

  static constexpr double unit = rounding_unit;

public:
  Side_of_metric_circle_estimate(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                 const Tensors& tensors)
    : m_determinant(a, b, c, p),
      m_tensors(tensors)
  {
    const double ex[3] = {b.x() - a.x(), c.x() - b.x(), a.x() - c.x()};
    const double ey[3] = {b.y() - a.y(), c.y() - b.y(), a.y() - c.y()};
    for(int i = 0; i < 3; ++i) {
      m_exx[i] = ex[i]*ex[i];
      m_exy[i] = 2*ex[i]*ey[i];
      m_eyy[i] = ey[i]*ey[i];
    }
    const double left = ex[2]*ey[0], right = ey[2]*ex[0];
    m_area = left - right;
    m_area_error = 5*unit * (std::abs(left) + std::abs(right));
  }

  Result operator()() const
  {
    const Lifted_determinant_error error(m_determinant);
    if(!error.is_in_safe_range(m_determinant))
      return Result::indeterminate();
    Four determinants, errors;
    for(int i = 0; i < 4; ++i) {
      if(!error.is_in_safe_range(*m_tensors[i]))
        return Result::indeterminate();
      determinants[i] = m_determinant(*m_tensors[i]);
      errors[i] = error(*m_tensors[i]);
    }
    const Result side = compare_signs(determinants, errors);
    return is_certain(side) ? side : compare_products(determinants, errors);
  }

private:
  static Result compare_signs(const Four& determinants, const Four& errors)
  {
    int positive = 0, negative = 0;
    for(int i = 0; i < 4; ++i) {
      positive += determinants[i] > errors[i];
      negative += determinants[i] < -errors[i];
    }
    return positive == 4 ? Result(ON_POSITIVE_SIDE)
         : negative == 4 ? Result(ON_NEGATIVE_SIDE) : Result::indeterminate();
  }

  // alpha^2 = 1 - t, each with its error, multiplied up and compared with 1
  Result compare_products(const Four& determinants, const Four& errors) const
  {
    const double o = m_area, o_error = m_area_error;
    if(!(o_error > 1e-250))
      return Result::indeterminate();
    double product = 1, error = 0;
    for(int i = 0; i < 4; ++i) {
      double scale, relative_error;
      if(!find_scale(*m_tensors[i], scale, relative_error))
        return Result::indeterminate();
      const double d = determinants[i], t = scale * o * d;
      const double t_error = scale * ((std::abs(o) + o_error) * errors[i] + std::abs(d) * o_error)
                           + 2 * std::abs(t) * relative_error;
      const double alpha = 1 - t, alpha_error = t_error + 2*unit * (1 + std::abs(t));
      error = error * (std::abs(alpha) + alpha_error) + std::abs(product) * alpha_error;
      product *= alpha;
      error += 2*unit * std::abs(product);
    }
    error *= 1.01;
    if(std::abs(product - 1) > error && std::isfinite(product) && std::isfinite(error))
      return product < 1 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
    return Result::indeterminate();
  }

  // 4 det(M) / L_M; false if it is not known well enough
  bool find_scale(const Metric_tensor& m, double& scale, double& relative_error) const
  {
    double length[3], bound[3];
    for(int i = 0; i < 3; ++i) {
      const double diagonal = m.m11()*m_exx[i] + m.m22()*m_eyy[i], mixed = m.m12()*m_exy[i];
      length[i] = diagonal + mixed;
      bound[i] = diagonal + std::abs(mixed);
    }
    const double shortest = (std::min)(length[0], (std::min)(length[1], length[2]));
    const double longest = (std::max)(bound[0], (std::max)(bound[1], bound[2]));
    const double det = m.determinant();
    if(!(shortest > 1e-80 && longest < 1e80 && det > 1e-280))
      return false;
    const double l12 = length[1]*length[2], inverse = 1 / (length[0]*l12);
    scale = 4 * det * inverse;
    relative_error = 8*unit * (1 + inverse * (bound[0]*l12 + length[0] * (bound[1]*length[2] + length[1]*bound[2])));
    return relative_error < 0.01;
  }

  const Lifted_determinant m_determinant;
  const Tensors m_tensors;
  double m_exx[3], m_exy[3], m_eyy[3]; // squares and products of the edge vectors
  double m_area, m_area_error;         // twice the area of the triangle
};

// The cavity criterion in doubles with all its bounds. Out of line: it is called
// rarely and would take registers away from the usual case.
template <class Point_2, class Metric_tensor>
BOOST_NOINLINE Uncertain<Oriented_side>
carefully_estimate_side_of_metric_circle(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                         const std::array<const Metric_tensor*, 4>& tensors)
{
  return Side_of_metric_circle_estimate<Point_2, Metric_tensor>(a, b, c, p, tensors)();
}

// The cavity criterion as far as doubles can decide it.
//
// Mostly the four determinants agree in sign by more than a bound of their
// rounding errors that is made of the largest coordinates alone: twenty
// roundings, six terms, and 2 |m12| rx ry <= m11 rx^2 + m22 ry^2. See "The Error
// Bounds of the Filter" on the page "Derivations" of the manual. Subtracted from the
// coefficients beforehand, this bound costs nothing for each tensor. Below the
// limits, underflow could make it wrong; overflow leaves no finite sum.
template <class Point_2, class Metric_tensor>
Uncertain<Oriented_side>
estimate_side_of_metric_circle(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                               const Metric_tensor& ma, const Metric_tensor& mb,
                               const Metric_tensor& mc, const Metric_tensor& mp)
{
  Lifted_determinant d(a, b, c, p);
  const double rx = d.reach_x(), ry = d.reach_y(), error = 256*rounding_unit * (rx*ry);
  if((std::min)(rx, ry) > 1e-70) {
    const double sign = std::copysign(1., d(mp));
    d.x = sign * d.x - error * (rx*rx);
    d.s = sign * d.s;
    d.y = sign * d.y - error * (ry*ry);
    const double da = d(ma), db = d(mb), dc = d(mc), dp = d(mp), least = 1e-280;
    if(da > least && db > least && dc > least && dp > least && da + db + dc + dp < 1e280)
      return sign > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
  }
  return carefully_estimate_side_of_metric_circle<Point_2, Metric_tensor>(a, b, c, p, {&ma, &mb, &mc, &mp});
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SIDE_OF_METRIC_CIRCLE_ESTIMATE_H

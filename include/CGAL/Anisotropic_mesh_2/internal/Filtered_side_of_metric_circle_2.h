// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H

#include <CGAL/Anisotropic_mesh_2/internal/Side_of_metric_circle_2.h>

#include <CGAL/Filtered_predicate.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Converts what the kernel's converter converts, and metric tensors.
template <class Kernel_converter, class Source, class Target>
struct Metric_tensor_converter
  : public Kernel_converter
{
  using Kernel_converter::operator();

  Metric_tensor_2<Target> operator()(const Metric_tensor_2<Source>& m) const
  {
    return Metric_tensor_2<Target>(m, static_cast<const Kernel_converter&>(*this));
  }
};

// The cavity criterion in plain doubles together with a bound of its rounding
// error, for coordinates whose differences lie in a range where no underflow
// or overflow can spoil that bound.
class Side_of_metric_circle_estimate
{
public:
  template <class Point_2, class Metric_tensor>
  Side_of_metric_circle_estimate(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                 const Metric_tensor& ma, const Metric_tensor& mb,
                                 const Metric_tensor& mc, const Metric_tensor& mp)
  {
    const double ax = a.x() - p.x(), ay = a.y() - p.y();
    const double bx = b.x() - p.x(), by = b.y() - p.y();
    const double cx = c.x() - p.x(), cy = c.y() - p.y();
    lift(ax, ay, bx*cy, by*cx);
    lift(bx, by, cx*ay, cy*ax);
    lift(cx, cy, ax*by, ay*bx);
    if(!(is_in_safe_range() && is_in_safe_range(ma) && is_in_safe_range(mb)
         && is_in_safe_range(mc) && is_in_safe_range(mp)))
      return;
    add_sign(ma); add_sign(mb); add_sign(mc); add_sign(mp);
    if(m_unknown == 0 && (m_positive == 0 || m_negative == 0)) {
      m_side = m_positive > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
      m_is_certain = true;
    }
    else
      compare_products(a, b, c, std::array<const Metric_tensor*, 4>{&ma, &mb, &mc, &mp});
  }

  bool is_certain() const { return m_is_certain; }
  Oriented_side side() const { return m_side; }

private:
  static constexpr double unit = 1. / (1ull << 53);

  // one row of the determinant: (x, y) times the minor p - q
  void lift(double x, double y, double p, double q)
  {
    const double minor = p - q, bound = std::abs(p) + std::abs(q);
    m_x += x*x*minor;        m_x_bound += x*x*bound;
    m_s += x*y*minor;        m_s_bound += std::abs(x*y)*bound;
    m_y += y*y*minor;        m_y_bound += y*y*bound;
    m_reach = std::max(m_reach, std::max(std::abs(x), std::abs(y)));
  }

  bool is_in_safe_range() const
  {
    return m_reach < 1e40 && m_x_bound > 1e-164 && m_y_bound > 1e-164;
  }

  template <class Metric_tensor>
  static bool is_in_safe_range(const Metric_tensor& m)
  {
    const double trace = m.m11() + m.m22();
    return trace > 1e-60 && trace < 1e60;
  }

  template <class Metric_tensor>
  double in_circle(const Metric_tensor& m) const { return m.m11()*m_x + 2*m.m12()*m_s + m.m22()*m_y; }

  // Thirteen roundings at the most reach a term of the sum; twenty are granted.
  template <class Metric_tensor>
  double in_circle_error(const Metric_tensor& m) const
  {
    return 20*unit * (m.m11()*m_x_bound + 2*std::abs(m.m12())*m_s_bound + m.m22()*m_y_bound);
  }

  template <class Metric_tensor>
  void add_sign(const Metric_tensor& m)
  {
    const double value = in_circle(m), error = in_circle_error(m);
    if(value > error)
      ++m_positive;
    else if(value < -error)
      ++m_negative;
    else
      ++m_unknown;
  }

  // alpha^2 = 1 - t, each with its error, multiplied up and compared with 1
  template <class Point_2, class Metric_tensor>
  void compare_products(const Point_2& a, const Point_2& b, const Point_2& c,
                        const std::array<const Metric_tensor*, 4>& tensors)
  {
    const std::array<double, 3> ex = {b.x() - a.x(), c.x() - b.x(), a.x() - c.x()};
    const std::array<double, 3> ey = {b.y() - a.y(), c.y() - b.y(), a.y() - c.y()};
    const double p = ex[2]*ey[0], q = ey[2]*ex[0];
    const double o = p - q, o_error = 5*unit * (std::abs(p) + std::abs(q));
    if(!(o_error > 1e-250))
      return;

    double product = 1, error = 0;
    for(const Metric_tensor* m : tensors) {
      double l = 1, l_relative_error = 8*unit;
      for(int i = 0; i < 3; ++i) {
        const double length = m->squared_length(ex[i], ey[i]);
        const double bound = m->m11()*ex[i]*ex[i] + 2*std::abs(m->m12()*ex[i]*ey[i]) + m->m22()*ey[i]*ey[i];
        if(!(length > 1e-80 && length < 1e80))
          return;
        l *= length;
        l_relative_error += 8*unit * bound / length;
      }
      const double det = m->determinant();
      if(!(l_relative_error < 0.01 && det > 1e-280))
        return;
      const double scale = 4 * det / l, i = in_circle(*m), t = scale * o * i;
      const double t_error = std::abs(scale) * ((std::abs(o) + o_error) * in_circle_error(*m) + std::abs(i) * o_error)
                           + 2 * std::abs(t) * l_relative_error;
      const double alpha = 1 - t, alpha_error = t_error + 2*unit * (1 + std::abs(t));
      error = error * (std::abs(alpha) + alpha_error) + std::abs(product) * alpha_error;
      product *= alpha;
      error += 2*unit * std::abs(product);
    }
    error *= 1.01;
    if(std::abs(product - 1) > error && std::isfinite(product) && std::isfinite(error)) {
      m_side = product < 1 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
      m_is_certain = true;
    }
  }

  double m_x = 0, m_s = 0, m_y = 0;
  double m_x_bound = 0, m_s_bound = 0, m_y_bound = 0, m_reach = 0;
  int m_positive = 0, m_negative = 0, m_unknown = 0;
  bool m_is_certain = false;
  Oriented_side m_side = ON_ORIENTED_BOUNDARY;
};

// The cavity criterion for kernels with double coordinates and exact
// predicates: an estimate in doubles first, then intervals, then exact numbers.
template <class K>
class Filtered_side_of_metric_circle_2
{
  typedef typename K::Approximate_kernel  AK;
  typedef typename K::Exact_kernel_rt     EK;
  typedef Filtered_predicate<Side_of_metric_circle_2<EK>, Side_of_metric_circle_2<AK>,
                             Metric_tensor_converter<typename K::C2E_rt, K, EK>,
                             Metric_tensor_converter<typename K::C2F, K, AK> >  Interval_then_exact;

public:
  typedef Oriented_side result_type;

  result_type operator()(const typename K::Point_2& a, const typename K::Point_2& b,
                         const typename K::Point_2& c, const typename K::Point_2& p,
                         const Metric_tensor_2<K>& ma, const Metric_tensor_2<K>& mb,
                         const Metric_tensor_2<K>& mc, const Metric_tensor_2<K>& mp) const
  {
    const Side_of_metric_circle_estimate estimate(a, b, c, p, ma, mb, mc, mp);
    return estimate.is_certain() ? estimate.side()
                                 : m_exact(a, b, c, p, ma, mb, mc, mp);
  }

private:
  Interval_then_exact m_exact;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H

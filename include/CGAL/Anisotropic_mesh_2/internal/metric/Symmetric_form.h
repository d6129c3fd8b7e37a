// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SYMMETRIC_FORM_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SYMMETRIC_FORM_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/difference_of_products.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// A symmetric 2x2 matrix of doubles, as sums and means of tensors need it.
struct Symmetric_form
{
  double a = 0, b = 0, c = 0; // rows (a, b) and (b, c)

  Symmetric_form() {}
  Symmetric_form(double m11, double m12, double m22) : a(m11), b(m12), c(m22) {}

  template <class K>
  explicit Symmetric_form(const Metric_tensor_2<K>& m)
    : a(CGAL::to_double(m.m11())), b(CGAL::to_double(m.m12())), c(CGAL::to_double(m.m22()))
  {}

  double operator()(double x, double y) const { return (a*x + 2*b*y)*x + c*y*y; }
  double operator()(double x, double y, double u, double v) const { return (a*x + b*y)*u + (b*x + c*y)*v; }

  Vector_of_doubles times(const Vector_of_doubles& v) const { return {a*v.x + b*v.y, b*v.x + c*v.y}; }

  // the length of (x, y), which rounding cannot make the root of a negative number
  double length(double x, double y) const { return std::sqrt((std::max)(0., (*this)(x, y))); }

  // of Frobenius
  double norm() const { return std::sqrt(a*a + 2*b*b + c*c); }

  // the determinant times the inverse
  Symmetric_form adjugate() const { return Symmetric_form(c, -b, a); }

  double determinant() const { return difference_of_products(a, c, b, b); }

  Symmetric_form& operator+=(const Symmetric_form& m) { a += m.a; b += m.b; c += m.c; return *this; }
  friend Symmetric_form operator+(Symmetric_form m, const Symmetric_form& n) { return m += n; }
  friend Symmetric_form operator*(double s, const Symmetric_form& m) { return Symmetric_form(s*m.a, s*m.b, s*m.c); }
};

// the matrix logarithm
template <class K>
Symmetric_form logarithm_of(const Metric_tensor_2<K>& m)
{
  const auto l = m.logarithm();
  return Symmetric_form(l[0], l[1], l[2]);
}

// The length of the vector (x, y) along which the tensor varies, by Simpson's rule.
inline double length_by_simpson(const Symmetric_form& at_begin, const Symmetric_form& in_middle,
                                const Symmetric_form& at_end, double x, double y)
{
  return (at_begin.length(x, y) + 4 * in_middle.length(x, y) + at_end.length(x, y)) / 6;
}

// The same in some panels: p is where the vector begins, and `tensor_at(x)` the tensor in between.
template <class Tensor_at>
double length_by_simpson(Symmetric_form at_begin, const Symmetric_form& at_end, const Vector_of_doubles& p,
                         const Vector_of_doubles& vector, int panels, const Tensor_at& tensor_at)
{
  const auto at = [&](double t) { return tensor_at({p.x + t / panels * vector.x, p.y + t / panels * vector.y}); };
  double sum = 0;
  for(int k = 0; k < panels; ++k) {
    const Symmetric_form end = k + 1 < panels ? at(k + 1) : at_end;
    sum += length_by_simpson(at_begin, at(k + 0.5), end, vector.x / panels, vector.y / panels);
    at_begin = end;
  }
  return sum;
}

// The geometric mean of two positive definite forms: sizes in it are the
// geometric means of sizes where both have the same axes.
inline Symmetric_form geometric_mean(const Symmetric_form& m, const Symmetric_form& n)
{
  const double root_m = std::sqrt(m.determinant()), root_n = std::sqrt(n.determinant());
  const Symmetric_form sum = (1 / root_m) * m + (1 / root_n) * n;
  return std::sqrt(root_m * root_n / sum.determinant()) * sum;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_SYMMETRIC_FORM_H

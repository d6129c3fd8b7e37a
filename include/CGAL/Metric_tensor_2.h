// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_METRIC_TENSOR_2_H
#define CGAL_METRIC_TENSOR_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/difference_of_products.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/refuse_metric_tensor.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <ostream>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// A symmetric positive definite matrix by which lengths are measured at
/// a point of the plane (section 2.2 of \cgalCite{dw-acvt-05}).
///
/// The vectors of length 1 form an ellipse. Its two half axes are the *sizes* `h1`, along
/// the direction \f$ (\cos \theta, \sin \theta) \f$, and `h2`, across it:
/// \f$ M = R^T \mathrm{diag}(h_1^{-2}, h_2^{-2}) R \f$ with the rotation \f$ R \f$ by \f$ -\theta \f$.
///
/// No invalid tensor can be built: every way to build one from numbers throws
/// `Anisotropic_mesh_2::Invalid_metric_tensor_exception` unless the result is finite and positive
/// definite. A default constructed tensor is the identity.
///
/// \tparam K a class with the types `FT`, that of the entries, a number type as
/// `RiemannianMetricTraits_2` has it, and `Vector_2`; for example a model of `Kernel`.
/// With `double` entries, ratios `h1 : h2` up to about 10<sup>7</sup> are resolved
/// in any direction, and sizes lie between 10<sup>-75</sup> and 10<sup>75</sup>;
/// beyond, the determinant leaves the range of numbers and the tensor is refused.
template <class K>
class Metric_tensor_2
{
public:
  typedef K                      Kernel;   ///< the parameter of the template
  typedef typename K::FT         FT;       ///< the type of the entries
  typedef typename K::Vector_2   Vector_2; ///< a vector of the plane

  /// the half axes of the unit ellipse, and the direction \f$ \theta \f$ of the first.
  struct Sizes
  {
    double h1;    ///< the size along \f$ \theta \f$, the smaller one
    double h2;    ///< the size across \f$ \theta \f$, the larger one
    double angle; ///< \f$ \theta \f$, in radians
  };

  /// \name Creation
  /// @{

  /// the identity: lengths are the Euclidean ones.
  Metric_tensor_2() : m_11(1), m_12(0), m_22(1) {}

  /// the tensor `m` of another kernel, its entries converted one by one.
  /// Nothing is checked again.
  /// \tparam K2 the other kernel
  /// \tparam Converter a function object from the entries of `m` to `FT`.
  template <class K2, class Converter>
  Metric_tensor_2(const Metric_tensor_2<K2>& m, const Converter& convert)
    : m_11(convert(m.m11())), m_12(convert(m.m12())), m_22(convert(m.m22()))
  {}

  /// the tensor with the rows `(m11, m12)` and `(m12, m22)`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if it is not finite or not positive definite.
  static Metric_tensor_2 from_entries(const FT& m11, const FT& m12, const FT& m22)
  {
    Metric_tensor_2 m(m11, m12, m22);
    if(!m.is_positive_definite())
      Anisotropic_mesh_2::internal::refuse_metric_tensor(
        {{"the metric tensor with m11 = ", m11}, {", m12 = ", m12}, {", m22 = ", m22}});
    return m;
  }

  /// the tensor of the size `h1` along \f$ \theta \f$ and the size `h2` across it.
  /// \param h1,h2 the sizes, in units of the coordinates
  /// \param angle \f$ \theta \f$, in radians
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if a size is not positive or not
  /// finite, if the angle is not finite, or if the entries overflow.
  static Metric_tensor_2 from_sizes(const FT& h1, const FT& h2, double angle = 0)
  {
    if(!(is_size(h1) && is_size(h2) && std::isfinite(angle)))
      Anisotropic_mesh_2::internal::refuse_metric_tensor(
        {{"the metric with h1 = ", h1}, {", h2 = ", h2}, {", theta = ", angle}});
    const FT l1 = FT(1) / (h1*h1), l2 = FT(1) / (h2*h2);
    if(angle == 0)
      return from_entries(l1, FT(0), l2);
    return rounded_to_positive_definite(rotated(l1, l2, FT(std::cos(angle)), FT(std::sin(angle))),
                                        h1, h2, angle);
  }

  /// the isotropic tensor of size `h`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if `h` is not positive or not finite, or if the
  /// entries overflow.
  static Metric_tensor_2 from_size(const FT& h)
  {
    if(!is_size(h))
      Anisotropic_mesh_2::internal::refuse_metric_tensor({{"the metric of size ", h}});
    return from_sizes(h, h);
  }

  /// the tensor whose matrix logarithm has the entries `l`, in the order of `logarithm()`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if an entry is not finite, or if the determinant
  /// leaves the range of numbers.
  static Metric_tensor_2 from_logarithm(const std::array<double, 3>& l)
  {
    const double mean = (l[0] + l[2]) / 2, radius = std::hypot((l[0] - l[2]) / 2, l[1]);
    const double angle = std::atan2(2*l[1], l[0] - l[2]) / 2;
    if(!(std::abs(mean) + radius < 1400))
      Anisotropic_mesh_2::internal::refuse_metric_tensor(
        {{"the metric whose logarithm has the entries ", l[0]}, {", ", l[1]}, {", ", l[2]}});
    return from_sizes(FT(std::exp(-(mean + radius) / 2)), FT(std::exp(-(mean - radius) / 2)), angle);
  }
  /// @}

  /// \name Access
  /// @{

  /// the entry in the first row and column.
  const FT& m11() const { return m_11; }

  /// the entry off the diagonal.
  const FT& m12() const { return m_12; }

  /// the entry in the second row and column.
  const FT& m22() const { return m_22; }

  /// the determinant, which keeps its relative accuracy with `double` entries
  /// however large the ratio of the sizes is.
  FT determinant() const
  {
    return Anisotropic_mesh_2::internal::difference_of_products(m_11, m_22, m_12, m_12);
  }

  /// \f$ \sqrt{\det M} \f$, the area that a piece of unit Euclidean area has in this metric.
  double area_density() const { return std::sqrt(CGAL::to_double(determinant())); }

  /// the sizes, the smaller first, and the direction of the smaller one.
  Sizes sizes() const
  {
    const double a = CGAL::to_double(m_11), b = CGAL::to_double(m_12), c = CGAL::to_double(m_22);
    const double large = (a + c) / 2 + std::hypot((a - c) / 2, b);
    const double small = CGAL::to_double(determinant()) / large;
    return Sizes{1 / std::sqrt(large), 1 / std::sqrt(small), std::atan2(2*b, a - c) / 2};
  }

  /// the entries `(l11, l12, l22)` of the matrix logarithm. Means of logarithms
  /// are the log-Euclidean means of tensors.
  std::array<double, 3> logarithm() const
  {
    const Sizes s = sizes();
    const double l1 = -2 * std::log(s.h1), l2 = -2 * std::log(s.h2);
    const double c = std::cos(s.angle), d = std::sin(s.angle);
    return {l1*c*c + l2*d*d, (l1 - l2)*c*d, l1*d*d + l2*c*c};
  }
  /// @}

  /// \name Measuring
  /// @{

  /// the squared length \f$ v^T M v \f$ of the vector `v = (x, y)`.
  FT squared_length(const FT& x, const FT& y) const { return (m_11*x + 2*m_12*y)*x + m_22*y*y; }

  /// the squared length of `v`.
  FT squared_length(const Vector_2& v) const { return squared_length(v.x(), v.y()); }

  /// the scalar product \f$ v^T M w \f$.
  FT scalar_product(const Vector_2& v, const Vector_2& w) const
  {
    return v.x() * (m_11*w.x() + m_12*w.y()) + v.y() * (m_12*w.x() + m_22*w.y());
  }
  /// @}

  /// the tensor whose sizes are `s` times those of this one.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if `s` is not positive or not finite.
  Metric_tensor_2 scaled(const FT& s) const
  {
    if(!is_size(s))
      Anisotropic_mesh_2::internal::refuse_metric_tensor(
        {{"the metric tensor scaled by ", s}, {" with m11 = ", m_11}, {", m22 = ", m_22}});
    return from_entries(m_11 / (s*s), m_12 / (s*s), m_22 / (s*s));
  }

  /// whether `m` is `n` times a number.
  friend bool is_multiple_of(const Metric_tensor_2& m, const Metric_tensor_2& n)
  {
    return m.m_11 * n.m_22 == m.m_22 * n.m_11 && m.m_11 * n.m_12 == m.m_12 * n.m_11;
  }

  /// whether all entries are equal.
  friend bool operator==(const Metric_tensor_2& m, const Metric_tensor_2& n)
  {
    return m.m_11 == n.m_11 && m.m_12 == n.m_12 && m.m_22 == n.m_22;
  }
  /// whether an entry differs.
  friend bool operator!=(const Metric_tensor_2& m, const Metric_tensor_2& n) { return !(m == n); }

  /// writes the three entries.
  friend std::ostream& operator<<(std::ostream& os, const Metric_tensor_2& m)
  {
    return os << m.m_11 << ' ' << m.m_12 << ' ' << m.m_22;
  }

private:
  Metric_tensor_2(const FT& m11, const FT& m12, const FT& m22) : m_11(m11), m_12(m12), m_22(m22) {}

  static bool is_size(const FT& h) { return CGAL::is_finite(h) && h > 0; }

  bool is_positive_definite() const
  {
    if(!(CGAL::is_finite(m_11) && CGAL::is_finite(m_12) && CGAL::is_finite(m_22)))
      return false;
    const FT det = determinant();
    return m_11 > 0 && m_22 > 0 && det > 0 && CGAL::is_finite(det);
  }

  static Metric_tensor_2 rotated(const FT& l1, const FT& l2, const FT& c, const FT& s)
  {
    return Metric_tensor_2(l1*c*c + l2*s*s, (l1 - l2)*c*s, l1*s*s + l2*c*c);
  }

  // At ratios of sizes beyond 10^7 the rounding of the entries can eat the
  // smaller eigenvalue; adding a few units in the last place gives it back.
  static Metric_tensor_2 rounded_to_positive_definite(Metric_tensor_2 m, const FT& h1, const FT& h2,
                                                      double angle)
  {
    const FT ulp(std::ldexp(1., -52));
    for(int i = 0; i < 4 && !m.is_positive_definite(); ++i)
      m = Metric_tensor_2(m.m_11 + ulp*m.m_11, m.m_12, m.m_22 + ulp*m.m_22);
    if(!m.is_positive_definite())
      Anisotropic_mesh_2::internal::refuse_metric_tensor(
        {{"the metric with h1 = ", h1}, {", h2 = ", h2}, {", theta = ", angle}});
    return m;
  }

  FT m_11, m_12, m_22;
};

} // namespace CGAL

#endif // CGAL_METRIC_TENSOR_2_H

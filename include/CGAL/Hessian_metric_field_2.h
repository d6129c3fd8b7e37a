// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HESSIAN_METRIC_FIELD_2_H
#define CGAL_HESSIAN_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Metric_tensor_2.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field for piecewise linear approximations of a function \f$ f \f$,
/// and for piecewise constant ones of its gradient (section 2.6 of \cgalCite{dw-acvt-05}).
///
/// The tensor is \f$ M = |H| / e \f$, where \f$ |H| \f$ has the eigenvectors of the
/// Hessian of \f$ f \f$ and the absolute values of its eigenvalues. To first
/// order the linear interpolation errs by at most \f$ e/8 \f$ on an edge of unit
/// length.
///
/// A unit mesh of this field spreads the largest error evenly. For the least
/// \f$ L^p \f$ error the tensor is multiplied by \f$ (\det |H|)^{-1/(2p+2)} \f$.
///
/// Sizes are kept between two bounds. Eigenvalues too small for the ratio of
/// these bounds are raised beforehand.
///
/// \tparam K a model of `Kernel`
/// \tparam Hessian a functor that takes a `K::Point_2` and returns the second
/// derivatives of \f$ f \f$, twice by `x`, by `x` and `y`, and twice by `y`,
/// as something that structured bindings can take apart, such as a
/// `std::array<double, 3>`. It must be copyable and callable from several threads.
/// \cgalModels{MetricField_2}
/// \sa `make_hessian_metric_field_2()`
/// \sa `piecewise_linear_approximation_error_2()`
template <class K, class Hessian>
class Hessian_metric_field_2
{
public:
  typedef typename K::FT        FT;            ///< the number type of the kernel
  typedef typename K::Point_2   Point_2;       ///< a point
  typedef Metric_tensor_2<K>    Metric_tensor; ///< a tensor

  /// the field of the function with the given Hessian.
  /// \param hessian the Hessian.
  /// \param error the number \f$ e \f$, in units of the function if `norm` is infinity.
  /// \param least_size the lower bound of the sizes, in units of the coordinates.
  /// \param largest_size the upper bound.
  /// \param norm the number \f$ p \f$; infinity leaves \f$ M \f$ as it is.
  /// \pre `error` and `least_size` are positive, `largest_size` is not less than
  /// `least_size`, and `norm` is at least 1.
  Hessian_metric_field_2(Hessian hessian, double error, double least_size, double largest_size,
                         double norm = std::numeric_limits<double>::infinity())
    : m_hessian(std::move(hessian)), m_error(error), m_least_size(least_size), m_largest_size(largest_size),
      m_exponent(-1 / (2*norm + 2))
  {
    CGAL_precondition(error > 0 && least_size > 0 && least_size <= largest_size && norm >= 1);
  }

  /// returns the tensor at `p`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception with the point, if the Hessian is not finite.
  Metric_tensor operator()(const Point_2& p) const
  {
    return Anisotropic_mesh_2::internal::metric_at([this](const Point_2& q) {
      const auto [xx, xy, yy] = m_hessian(q);
      return tensor(CGAL::to_double(xx), CGAL::to_double(xy), CGAL::to_double(yy));
    }, p);
  }

private:
  Metric_tensor tensor(double xx, double xy, double yy) const
  {
    const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    const double larger = std::abs(mean) + radius;
    if(!std::isfinite(larger))
      refuse(xx, xy, yy);
    if(larger == 0)
      return Metric_tensor::from_size(FT(m_largest_size));
    const double ratio = m_least_size / m_largest_size;
    const double first = (std::max)(std::abs(mean + radius), ratio*ratio * larger);
    const double second = (std::max)(std::abs(mean - radius), ratio*ratio * larger);
    const double scale = std::pow(first * second, m_exponent) / m_error;
    return Metric_tensor::from_sizes(size(scale * first), size(scale * second), std::atan2(2*xy, xx - yy) / 2);
  }

  FT size(double eigenvalue) const
  {
    return FT(std::clamp(1 / std::sqrt(eigenvalue), m_least_size, m_largest_size));
  }

  [[noreturn]] static void refuse(double xx, double xy, double yy)
  {
    using Anisotropic_mesh_2::internal::describe;
    throw Anisotropic_mesh_2::Invalid_metric_tensor_exception("the Hessian with the entries " + describe(xx) + ", "
                                                              + describe(xy) + ", " + describe(yy) + " is not finite");
  }

  Hessian m_hessian;
  double  m_error, m_least_size, m_largest_size, m_exponent;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the metric field of the function whose Hessian `hessian(p)` gives;
/// `K` is to be named, as in `make_hessian_metric_field_2<K>(hessian, error, least_size, largest_size)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Hessian as for `Hessian_metric_field_2`
/// \param hessian,error,least_size,largest_size,norm as for the constructor of `Hessian_metric_field_2`
/// \return the field
template <class K, class Hessian>
Hessian_metric_field_2<K, Hessian>
make_hessian_metric_field_2(Hessian hessian, double error, double least_size, double largest_size,
                            double norm = std::numeric_limits<double>::infinity())
{
  return Hessian_metric_field_2<K, Hessian>(std::move(hessian), error, least_size, largest_size, norm);
}

} // namespace CGAL

#endif // CGAL_HESSIAN_METRIC_FIELD_2_H

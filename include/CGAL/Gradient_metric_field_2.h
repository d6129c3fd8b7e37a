// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_METRIC_FIELD_2_H
#define CGAL_GRADIENT_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Metric_tensor_2.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field for piecewise constant approximations of a function \f$ f \f$
/// (section 2.6 of \cgalCite{dw-acvt-05}).
///
/// The tensor is \f$ M = (\alpha I + \nabla f \, \nabla^T f) / e^2 \f$. To first
/// order \f$ f \f$ changes by at most \f$ e \f$ along an edge of unit length, and the
/// energy with the measure `Anisotropic_mesh_2::Measure::LEBESGUE`, times
/// \f$ e^2 \f$, bounds the squared \f$ L^2 \f$ error of the function that has on
/// each region the value of \f$ f \f$ at the generator.
///
/// A unit mesh of this field spreads the largest error evenly. For the least
/// \f$ L^p \f$ error the tensor is multiplied by \f$ (e^4 \det M)^{-1/(p+2)} \f$. For
/// \f$ p = 2 \f$ the energy with the measure `RIEMANNIAN` is then that of
/// \f$ M \f$ with the measure `LEBESGUE`, up to a constant, so that the default measure
/// of the optimizers is the right one, and the boundary is subdivided accordingly.
///
/// \tparam K a model of `Kernel`
/// \tparam Gradient a functor that takes a `K::Point_2` and returns the two
/// derivatives of \f$ f \f$ by `x` and by `y`, as something that structured
/// bindings can take apart, such as a `std::array<double, 2>`. It must be copyable and callable from
/// several threads.
/// \cgalModels{MetricField_2}
/// \sa `make_gradient_metric_field_2()`
/// \sa `piecewise_constant_approximation_error_2()`
template <class K, class Gradient>
class Gradient_metric_field_2
{
public:
  typedef typename K::FT        FT;            ///< the number type of the kernel
  typedef typename K::Point_2   Point_2;       ///< a point
  typedef Metric_tensor_2<K>    Metric_tensor; ///< a tensor

  /// the field of the function with the given gradient.
  /// \param gradient the gradient.
  /// \param alpha a small squared slope below which the function counts as
  /// flat: the size across the gradient is \f$ e / \sqrt\alpha \f$ times that of the scaling.
  /// \param error the number \f$ e \f$, in units of the function.
  /// \param norm the number \f$ p \f$; infinity leaves \f$ M \f$ as it is.
  /// \pre `alpha` and `error` are positive, and `norm` is at least 1.
  Gradient_metric_field_2(Gradient gradient, double alpha, double error,
                          double norm = std::numeric_limits<double>::infinity())
    : m_gradient(std::move(gradient)), m_alpha(alpha), m_error(error), m_exponent(-1 / (norm + 2))
  {
    CGAL_precondition(alpha > 0 && error > 0 && norm >= 1);
  }

  /// returns the tensor at `p`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception with the point, if the gradient is not finite.
  Metric_tensor operator()(const Point_2& p) const
  {
    return Anisotropic_mesh_2::internal::metric_at([this](const Point_2& q) {
      const auto [dx, dy] = m_gradient(q);
      return tensor(CGAL::to_double(dx), CGAL::to_double(dy));
    }, p);
  }

private:
  // from sizes, since the entries may hide alpha from rounded numbers
  Metric_tensor tensor(double x, double y) const
  {
    const double along = m_alpha + x*x + y*y;
    const double size = m_error / std::sqrt(std::pow(along * m_alpha, m_exponent));
    return Metric_tensor::from_sizes(FT(size / std::sqrt(along)), FT(size / std::sqrt(m_alpha)), std::atan2(y, x));
  }

  Gradient m_gradient;
  double   m_alpha, m_error, m_exponent;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the metric field of the function whose gradient `gradient(p)` gives;
/// `K` is to be named, as in `make_gradient_metric_field_2<K>(gradient, alpha, error)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Gradient as for `Gradient_metric_field_2`
/// \param gradient,alpha,error,norm as for the constructor of `Gradient_metric_field_2`
/// \return the field
template <class K, class Gradient>
Gradient_metric_field_2<K, Gradient>
make_gradient_metric_field_2(Gradient gradient, double alpha, double error,
                             double norm = std::numeric_limits<double>::infinity())
{
  return Gradient_metric_field_2<K, Gradient>(std::move(gradient), alpha, error, norm);
}

} // namespace CGAL

#endif // CGAL_GRADIENT_METRIC_FIELD_2_H

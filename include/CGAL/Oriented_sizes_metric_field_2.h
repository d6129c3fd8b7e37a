// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ORIENTED_SIZES_METRIC_FIELD_2_H
#define CGAL_ORIENTED_SIZES_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Metric_tensor_2.h>

#include <CGAL/number_utils.h>

#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field of two sizes and a direction that depend on the place
/// (section 2.2 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \tparam Sizes a functor that takes a `K::Point_2` and returns three numbers
/// that structured bindings can take apart, such as a `std::array<double, 3>`,
/// a tuple, or a structure with three members: the size `h1` along
/// \f$ \theta \f$, the size `h2` across it, and \f$ \theta \f$ in radians. It must be copyable and callable
/// from several threads.
/// \cgalModels{MetricField_2}
/// \sa `make_oriented_sizes_metric_field_2()`
template <class K, class Sizes>
class Oriented_sizes_metric_field_2
{
public:
  typedef typename K::FT        FT;            ///< the number type of the kernel
  typedef typename K::Point_2   Point_2;       ///< a point
  typedef Metric_tensor_2<K>    Metric_tensor; ///< a tensor

  /// the field with what `sizes` gives.
  explicit Oriented_sizes_metric_field_2(Sizes sizes) : m_sizes(std::move(sizes)) {}

  /// returns the tensor whose unit ellipse has the half axes and the direction at `p`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception with the point, if a size is not
  /// positive or anything is not finite.
  Metric_tensor operator()(const Point_2& p) const
  {
    return Anisotropic_mesh_2::internal::metric_at([this](const Point_2& q) {
      const auto [h1, h2, angle] = m_sizes(q);
      return Metric_tensor::from_sizes(FT(h1), FT(h2), CGAL::to_double(angle));
    }, p);
  }

private:
  Sizes m_sizes;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the metric field of the sizes and directions that `sizes(p)` gives;
/// `K` is to be named, as in `make_oriented_sizes_metric_field_2<K>(sizes)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Sizes as for `Oriented_sizes_metric_field_2`
/// \param sizes the sizes and the angle at a point
/// \return the field
template <class K, class Sizes>
Oriented_sizes_metric_field_2<K, Sizes> make_oriented_sizes_metric_field_2(Sizes sizes)
{
  return Oriented_sizes_metric_field_2<K, Sizes>(std::move(sizes));
}

} // namespace CGAL

#endif // CGAL_ORIENTED_SIZES_METRIC_FIELD_2_H

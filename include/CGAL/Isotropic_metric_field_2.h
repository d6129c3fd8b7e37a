// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ISOTROPIC_METRIC_FIELD_2_H
#define CGAL_ISOTROPIC_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Metric_tensor_2.h>

#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field of an isotropic size that depends on the place (section 2.2 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \tparam Size a functor `FT(const K::Point_2&)`, copyable and callable from several threads
/// \cgalModels{MetricField_2}
/// \sa `make_isotropic_metric_field_2()`
template <class K, class Size>
class Isotropic_metric_field_2
{
public:
  typedef typename K::FT        FT;            ///< the number type of the kernel
  typedef typename K::Point_2   Point_2;       ///< a point
  typedef Metric_tensor_2<K>    Metric_tensor; ///< a tensor

  /// the field with the sizes that `size` gives.
  explicit Isotropic_metric_field_2(Size size) : m_size(std::move(size)) {}

  /// returns the isotropic tensor whose size is the one at `p`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception with the point, if the size is not
  /// positive or not finite.
  Metric_tensor operator()(const Point_2& p) const
  {
    return Anisotropic_mesh_2::internal::metric_at(
      [this](const Point_2& q) { return Metric_tensor::from_size(FT(m_size(q))); }, p);
  }

private:
  Size m_size;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the metric field of the sizes that `size(p)` gives; `K` is to be
/// named, as in `make_isotropic_metric_field_2<K>(size)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Size as for `Isotropic_metric_field_2`
/// \param size the size at a point, in units of the coordinates
/// \return the field
template <class K, class Size>
Isotropic_metric_field_2<K, Size> make_isotropic_metric_field_2(Size size)
{
  return Isotropic_metric_field_2<K, Size>(std::move(size));
}

} // namespace CGAL

#endif // CGAL_ISOTROPIC_METRIC_FIELD_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONSTANT_METRIC_FIELD_2_H
#define CGAL_CONSTANT_METRIC_FIELD_2_H

#include <CGAL/Metric_tensor_2.h>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric field that has the same tensor everywhere, uniform in section 2.2 of \cgalCite{dw-acvt-05}.
///
/// \tparam K a model of `Kernel`
/// \cgalModels{MetricField_2}
template <class K>
class Constant_metric_field_2
{
public:
  typedef typename K::Point_2   Point_2;       ///< a point
  typedef Metric_tensor_2<K>    Metric_tensor; ///< a tensor

  /// the field with the tensor `m`.
  explicit Constant_metric_field_2(const Metric_tensor& m = Metric_tensor()) : m_tensor(m) {}

  /// returns the tensor.
  const Metric_tensor& operator()(const Point_2&) const { return m_tensor; }

private:
  Metric_tensor m_tensor;
};

} // namespace CGAL

#endif // CGAL_CONSTANT_METRIC_FIELD_2_H

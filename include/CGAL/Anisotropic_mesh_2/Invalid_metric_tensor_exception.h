// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INVALID_METRIC_TENSOR_EXCEPTION_H
#define CGAL_ANISOTROPIC_MESH_2_INVALID_METRIC_TENSOR_EXCEPTION_H

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <stdexcept>
#include <string>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a metric tensor is not finite or not positive definite.
///
/// The message names the entries (or the sizes and the angle) and, as soon as
/// the tensor was asked for at a point, the point.
class Invalid_metric_tensor_exception
  : public std::runtime_error
{
public:
  /// the complaint `what`.
  explicit Invalid_metric_tensor_exception(const std::string& what)
    : std::runtime_error(what)
  {}

  /// returns the same complaint, telling that it arose at `(x, y)`.
  Invalid_metric_tensor_exception at(double x, double y) const
  {
    return Invalid_metric_tensor_exception(what() + (" at the point " + Anisotropic_mesh_2::internal::describe(x, y)));
  }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_INVALID_METRIC_TENSOR_EXCEPTION_H

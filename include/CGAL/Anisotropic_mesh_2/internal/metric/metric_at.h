// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AT_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <CGAL/number_utils.h>

#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// Within a handler of `e`; apart, since evaluations stand everywhere.
[[noreturn]] inline void rethrow_at(double x, double y, const Invalid_metric_tensor_exception& e)
{
  if(std::string(e.what()).find(" at the point (") != std::string::npos)
    throw;
  throw e.at(x, y);
}

// asks the field, and lets a complaint about the tensor name the point
template <class Field, class Point>
auto metric_at(const Field& field, const Point& p) -> decltype(field(p))
{
  try {
    return field(p);
  } catch(const Invalid_metric_tensor_exception& e) {
    rethrow_at(CGAL::to_double(p.x()), CGAL::to_double(p.y()), e);
  }
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_METRIC_AT_H

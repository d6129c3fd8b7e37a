// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_DEGENERATE_PARAMETRIZATION_EXCEPTION_H
#define CGAL_ANISOTROPIC_MESH_2_DEGENERATE_PARAMETRIZATION_EXCEPTION_H

#include <CGAL/Anisotropic_mesh_2/Invalid_metric_tensor_exception.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <string>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a parametric surface has no finite point or no tangent plane somewhere.
///
/// The message says what is wrong and names the parameters u and v.
class Degenerate_parametrization_exception
  : public Invalid_metric_tensor_exception
{
public:
  /// the complaint `what` about the surface at the parameters `(u, v)`.
  Degenerate_parametrization_exception(const std::string& what, double u, double v)
    : Invalid_metric_tensor_exception(what + " at the point " + Anisotropic_mesh_2::internal::describe(u, v)
                                      + " of the parameters (u, v)")
  {}
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_DEGENERATE_PARAMETRIZATION_EXCEPTION_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_APPROXIMATION_ERROR_H
#define CGAL_ANISOTROPIC_MESH_2_APPROXIMATION_ERROR_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how far an approximation is from a function, in units of its values (section 2.6 of \cgalCite{dw-acvt-05}).
///
/// \sa `CGAL::piecewise_constant_approximation_error_2()`
/// \sa `CGAL::piecewise_linear_approximation_error_2()`
struct Approximation_error
{
  double l2 = 0;      ///< the root of the integral of the squared difference; in units of the values times a length
  double largest = 0; ///< the largest absolute difference at the points where the function was sampled
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_APPROXIMATION_ERROR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_REGION_INTEGRALS_2_H
#define CGAL_ANISOTROPIC_MESH_2_REGION_INTEGRALS_2_H

#include <array>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the integrals over the region of a generator (section 2.4 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a class with the type `Point_2`, for example a kernel of \cgal
template <class K>
struct Region_integrals_2
{
  typename K::Point_2 mass_centre;           ///< the generator itself, if the region is empty
  double              mass_centre_error = 0; ///< a bound of the error of the quadrature, as a length in the mean tensor
  double              area = 0;              ///< in the measure
  double              energy = 0;            ///< the integral of the squared distance to the generator
  /// the entries a, b, c of the matrix \f$ A \f$ with the rows (a, b) and (b, c), the integral of the tensor
  std::array<double, 3> matrix = {{0, 0, 0}};
  /// the derivatives of the energy by the coordinates of the generator, for the
  /// directional distance: \f$ 2 A \f$ times the vector from the mass centre to the generator
  std::array<double, 2> energy_gradient = {{0, 0}};
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_REGION_INTEGRALS_2_H

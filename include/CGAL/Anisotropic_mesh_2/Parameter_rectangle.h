// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the range of the parameters of a surface, and how its sides are glued.
struct Parameter_rectangle
{
  double u_min = 0, u_max = 1;
  double v_min = 0, v_max = 1;
  bool u_is_periodic = false; ///< with the extent as period
  bool v_is_periodic = false;
  /// all of the side is one point of the surface, and u is periodic. The surface is a smooth function of
  /// \f$ (r \cos \alpha, r \sin \alpha) \f$, where \f$ r \f$ is the difference of v
  /// from this side, and \f$ \alpha \f$ grows by \f$ 2 \pi \f$ over the range of u.
  bool v_min_is_pole = false;
  bool v_max_is_pole = false; ///< the same for the other side
};

} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H

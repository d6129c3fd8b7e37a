// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the range of the parameters of a surface (\f$ \Omega \f$ in section 5.2 of \cgalCite{dw-acvt-05}), and how its
/// sides are glued.
struct Parameter_rectangle
{
  double u_min = 0, ///< the left side
         u_max = 1; ///< the right side
  double v_min = 0, ///< the lower side
         v_max = 1; ///< the upper side
  bool u_is_periodic = false; ///< with the extent as period
  bool v_is_periodic = false; ///< with the extent as period
  /// all of the side is one point of the surface, and u is periodic. The surface is a smooth function of
  /// \f$ (r \cos \alpha, r \sin \alpha) \f$, where \f$ r \f$ is the difference of v
  /// from this side, and \f$ \alpha \f$ grows by \f$ 2 \pi \f$ over the range of u.
  bool v_min_is_pole = false;
  bool v_max_is_pole = false; ///< the same for the other side

  /// the width.
  double u_extent() const { return u_max - u_min; }

  /// the height.
  double v_extent() const { return v_max - v_min; }

  bool is_periodic() const { return u_is_periodic || v_is_periodic; } ///< in at least one parameter
  bool has_pole() const { return v_min_is_pole || v_max_is_pole; }    ///< on at least one side

  /// whether the sides and their distances are finite, the extents positive, and poles only
  /// where u is periodic and v is not.
  bool is_valid() const
  {
    return std::isfinite(u_min) && std::isfinite(v_min) && std::isfinite(u_extent()) && std::isfinite(v_extent())
        && u_extent() > 0 && v_extent() > 0
        && (!has_pole() || (u_is_periodic && !v_is_periodic));
  }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETER_RECTANGLE_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VIEW_DIRECTION_3_H
#define CGAL_ANISOTROPIC_MESH_2_VIEW_DIRECTION_3_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2IO
///
/// from where a surface is seen in a picture, which has the z-axis upwards.
struct View_direction_3
{
  double azimuth = -1;     ///< the direction to the eye in the xy-plane, in radians from the x-axis
  double elevation = 0.5;  ///< that direction above the xy-plane, in radians
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VIEW_DIRECTION_3_H

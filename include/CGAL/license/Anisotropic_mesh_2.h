// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_ANISOTROPIC_MESH_2_H
#define CGAL_LICENSE_ANISOTROPIC_MESH_2_H

#include <CGAL/config.h>
#include <CGAL/license.h>

// There is no commercial license of this package, so only the notices of CGAL for the terms of the GPL are here.
#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("\nYou use the CGAL 2D Anisotropic Meshes package under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "You use the CGAL 2D Anisotropic Meshes package under the terms of the GPLv3+. \
        You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_ANISOTROPIC_MESH_2_H

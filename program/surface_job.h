// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_SURFACE_JOB_H
#define ANISOTROPIC_MESH_2_PROGRAM_SURFACE_JOB_H

#include "Options.h"
#include "Progress.h"

namespace program {

// Meshes a built-in surface and writes what was asked for.
void run_surface(const Options& options, Progress& progress);

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_SURFACE_JOB_H

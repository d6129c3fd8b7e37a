// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_OUTPUT_H
#define ANISOTROPIC_MESH_2_PROGRAM_OUTPUT_H

#include "Options.h"
#include "mesh_job.h"

#include <CGAL/anisotropic_surface_mesh_statistics_3.h>

#include <string>

namespace program {

// Throws Unusable_input if an output file cannot be created, so that this is
// known before the work.
void check_outputs(const Options& options);

// Throws Unusable_input if a planar mesh is to be written in a format for surfaces.
void check_planar_outputs(const Options& options);

void write_statistics(const std::string& path, const CGAL::Anisotropic_mesh_2::Surface_mesh_statistics& statistics,
                      const Run_report& report);

void write_outputs(const Mesh& mesh, const Options& options, const Run_report& report);

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_OUTPUT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_INPUT_H
#define ANISOTROPIC_MESH_2_PROGRAM_INPUT_H

#include "Options.h"
#include "builtin_domains.h"

namespace program {

// Reads the domain and builds the metric. Throws Unusable_input and
// CGAL::Anisotropic_mesh_2::Invalid_domain_exception.
Domain_with_metric read_input(const Options& options);

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_INPUT_H

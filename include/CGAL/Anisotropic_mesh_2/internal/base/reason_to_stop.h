// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_REASON_TO_STOP_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_REASON_TO_STOP_H

#include <CGAL/Mesh_optimization_return_code.h>

namespace CGAL::Anisotropic_mesh_2::internal {

inline const char* reason_to_stop(Mesh_optimization_return_code code)
{
  switch(code) {
  case TIME_LIMIT_REACHED:           return "time limit";
  case CANT_IMPROVE_ANYMORE:         return "no more improvement";
  case CONVERGENCE_REACHED:          return "convergence";
  case MAX_ITERATION_NUMBER_REACHED: return "number of iterations";
  case BOUND_REACHED:                return "interrupted";
  case ALL_VERTICES_FROZEN:          return "all vertices frozen";
  default:                           return "not run";
  }
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_REASON_TO_STOP_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZE_CLOSED_SURFACE_MESH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZE_CLOSED_SURFACE_MESH_H

#include <CGAL/Anisotropic_mesh_2/internal/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/acvt_optimize_mesh_2.h>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Optimizes the part in each chart of the atlas in turn, with its rim fixed, in
// some rounds: what is fixed in one chart is free in another, so that the seams
// of the parameters leave no trace. Bad faces are improved in the last round only,
// since that moves vertices away from their mass centres.
template <class ConcurrencyTag, class Field, class NamedParameters>
Mesh_optimization_return_code optimize_closed_surface_mesh(Anisotropic_surface_mesh_3<Field>& surface_mesh,
                                                           const NamedParameters& np)
{
  constexpr int rounds = 3;
  const Surface_atlas<Field> atlas(surface_mesh.field());
  Mesh_optimization_return_code code = MAX_ITERATION_NUMBER_REACHED;
  for(int round = 1; round <= rounds; ++round)
    for(const auto& part : atlas.parts) {
      Chart_mesh<Field> part_mesh(surface_mesh, part);
      if(part_mesh.faces().empty() || !part_mesh.triangulate())
        continue;
      code = round < rounds
           ? acvt_optimize_mesh_2<ConcurrencyTag>(part_mesh.mesh(), parameters::topological_moves(false, np))
           : acvt_optimize_mesh_2<ConcurrencyTag>(part_mesh.mesh(), np);
      part_mesh.write_to(surface_mesh);
      if(code == BOUND_REACHED || code == TIME_LIMIT_REACHED)
        return code;
    }
  return code;
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZE_CLOSED_SURFACE_MESH_H

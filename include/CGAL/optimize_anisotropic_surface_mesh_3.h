// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H
#define CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// why two optimizers together stopped, of which the first one was not stopped from outside
inline Mesh_optimization_return_code combined_return_code(Mesh_optimization_return_code a,
                                                          Mesh_optimization_return_code b)
{
  const auto has_done_nothing = [](Mesh_optimization_return_code code) {
    return code == ALL_VERTICES_FROZEN || code == MESH_OPTIMIZATION_UNKNOWN_ERROR;
  };
  if(has_done_nothing(a) || is_stopped_from_outside(b))
    return b;
  return a == MAX_ITERATION_NUMBER_REACHED || has_done_nothing(b) ? a : b;
}

inline void add(const Optimization_result& of_chart, Optimization_result& sum)
{
  sum.return_code = combined_return_code(sum.return_code, of_chart.return_code);
  sum.iterations += of_chart.iterations;
  sum.evaluations += of_chart.evaluations;
  sum.energy += of_chart.energy;
  sum.largest_move = (std::max)(sum.largest_move, of_chart.largest_move);
  sum.is_better = sum.is_better || of_chart.is_better;
  sum.quality.return_code = combined_return_code(sum.quality.return_code, of_chart.quality.return_code);
  sum.quality.trials += of_chart.quality.trials;
  sum.quality.improvements += of_chart.quality.improvements;
}

// Optimizes the part in each chart of an atlas in turn, with its border fixed. The
// iterations and evaluations of earlier rounds are kept in the result.
template <class ConcurrencyTag, class Field, class NamedParameters>
void optimize_charts(Anisotropic_surface_mesh_3<Field>& surface_mesh, const Surface_atlas<Field>& atlas,
                     const Time_budget& time, const NamedParameters& np, Optimization_result& result)
{
  Optimization_result sum;
  sum.iterations = result.iterations;
  sum.evaluations = result.evaluations;
  result = sum;
  for(const auto& part : atlas.parts) {
    Chart_mesh<Field> chart(surface_mesh, part);
    if(chart.faces().empty() || !chart.triangulate())
      continue;
    if(time.is_spent()) {
      result.return_code = TIME_LIMIT_REACHED;
      return;
    }
    const Optimization_result of_chart
      = optimize_anisotropic_mesh_2<ConcurrencyTag>(chart.mesh(), np.maximum_running_time(time.remaining()));
    add(of_chart, result);
    if(of_chart.iterations > 0 || of_chart.quality.improvements > 0)
      chart.write_to(surface_mesh);
    if(is_stopped_from_outside(result.return_code))
      return;
  }
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// minimizes the energy of the anisotropic Voronoi tessellation of the vertices of a mesh of a
/// surface (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// The part of the mesh in each chart of an atlas is optimized by `optimize_anisotropic_mesh_2()`,
/// with its border fixed. Charts are cut at different places, so that each vertex is free in at least one of
/// them; where there are several, they take three rounds, after which seams and poles of the parameters have left no
/// trace. Bad faces are improved in the last round only, since that moves vertices away from their mass centres.
///
/// Vertices on edges with a face on one side only stay where they are.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param surface_mesh the mesh. Vertices may be inserted, removed and renumbered.
/// \param np an optional sequence of named parameters, those of `optimize_anisotropic_mesh_2()`
/// except for `vertex_is_constrained_map`.
/// `maximum_running_time` is that of the whole; `number_of_iterations` and the other criteria hold for each chart in
/// each round. The visitor is copied for each, and is shown the state of a chart.
///
/// \return what `optimize_anisotropic_mesh_2()` returns, over all charts: the numbers of iterations and evaluations
/// are those of all rounds, the rest is of the last one. The energy is the sum over the charts, which overlap. The
/// return code is `MAX_ITERATION_NUMBER_REACHED` if that is so of any chart. The mesh is valid in each case, and as
/// it was if `number_of_iterations` is 0.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface; the mesh
/// is valid then, with the charts before optimized.
template <class ConcurrencyTag = Sequential_tag, class Field, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_mesh_2::Optimization_result
optimize_anisotropic_surface_mesh_3(Anisotropic_surface_mesh_3<Field>& surface_mesh,
                                    const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Time_budget time(choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.));
  const internal::Surface_atlas<Field> atlas(surface_mesh.field());
  const int rounds = atlas.parts.size() > 1 ? 3 : 1;
  Anisotropic_mesh_2::Optimization_result result;
  for(int round = 1; round < rounds && !internal::is_stopped_from_outside(result.return_code); ++round)
    internal::optimize_charts<ConcurrencyTag>(surface_mesh, atlas, time,
                                              Anisotropic_mesh_2::parameters::quality_moves(false, np), result);
  if(!internal::is_stopped_from_outside(result.return_code))
    internal::optimize_charts<ConcurrencyTag>(surface_mesh, atlas, time, np, result);
  return result;
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H

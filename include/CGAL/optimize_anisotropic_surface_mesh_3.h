// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H
#define CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H

#include <CGAL/Anisotropic_mesh_2/internal/surface/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The seconds that are left of a limit, where 0 stands for none, as in the named parameter.
class Time_budget
{
public:
  explicit Time_budget(double limit) : m_limit(limit)
  {
    CGAL_precondition(limit >= 0);
    m_timer.start();
  }

  bool is_spent() const { return m_limit > 0 && m_timer.time() >= m_limit; }
  double remaining() const { return m_limit > 0 ? (std::max)(m_limit - m_timer.time(), 1e-9) : 0; }

private:
  double     m_limit;
  Real_timer m_timer;
};

inline bool is_stopped_from_outside(Mesh_optimization_return_code code)
{
  return code == BOUND_REACHED || code == TIME_LIMIT_REACHED;
}

// why two optimizers together stopped, of which none was stopped from outside
inline Mesh_optimization_return_code joined(Mesh_optimization_return_code a, Mesh_optimization_return_code b)
{
  if(a == ALL_VERTICES_FROZEN)
    return b;
  return a == MAX_ITERATION_NUMBER_REACHED || b == ALL_VERTICES_FROZEN ? a : b;
}

// Optimizes the part in each chart of an atlas in turn, with its rim fixed.
template <class ConcurrencyTag, class Field, class NamedParameters>
Mesh_optimization_return_code optimize_charts(Anisotropic_surface_mesh_3<Field>& surface_mesh,
                                              const Surface_atlas<Field>& atlas, const Time_budget& time,
                                              const NamedParameters& np)
{
  Mesh_optimization_return_code result = ALL_VERTICES_FROZEN;
  for(const auto& part : atlas.parts) {
    Chart_mesh<Field> chart(surface_mesh, part);
    if(chart.faces().empty() || !chart.triangulate())
      continue;
    if(time.is_spent())
      return TIME_LIMIT_REACHED;
    const Mesh_optimization_return_code code
      = optimize_anisotropic_mesh_2<ConcurrencyTag>(chart.mesh(), np.maximum_running_time(time.remaining()));
    chart.write_to(surface_mesh);
    if(is_stopped_from_outside(code))
      return code;
    result = joined(result, code);
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// minimizes the energy of the anisotropic Voronoi tessellation of the vertices of a mesh of a
/// surface (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// The part of the mesh in each chart of an atlas is optimized by `optimize_anisotropic_mesh_2()`,
/// with its rim fixed. Charts are cut at different places, so that each vertex is free in at least one of
/// them; where there are several, they take three rounds, after which seams and poles of the parameters have left no
/// trace. Bad faces are improved in the last round only, since that moves vertices away from their mass centres.
///
/// Vertices on edges with a face on one side only stay where they are.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param surface_mesh the mesh. Vertices may be inserted, removed and renumbered.
/// \param np an optional sequence of named parameters, those of `optimize_anisotropic_mesh_2()`. `maximum_running_time` is
/// that of the whole; `number_of_iterations` and the other criteria hold for each chart in each round. The
/// visitor is copied for each, and is shown the state of a chart.
///
/// \return why it stopped, as `optimize_anisotropic_mesh_2()`, which for several charts is
/// `MAX_ITERATION_NUMBER_REACHED` if that is so of any in the last round. The mesh is valid in each case, and as it
/// was if `number_of_iterations` is 0.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface.
template <class ConcurrencyTag = Sequential_tag, class Field, class CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_optimization_return_code
optimize_anisotropic_surface_mesh_3(Anisotropic_surface_mesh_3<Field>& surface_mesh,
                           const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Time_budget time(choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.));
  const std::size_t iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations), std::size_t(1));
  if(iterations == 0)
    return MAX_ITERATION_NUMBER_REACHED;
  const internal::Surface_atlas<Field> atlas(surface_mesh.field());
  const int preliminary_rounds = atlas.parts.size() > 1 ? 2 : 0;
  for(int round = 0; round < preliminary_rounds; ++round) {
    const Mesh_optimization_return_code code = internal::optimize_charts<ConcurrencyTag>
      (surface_mesh, atlas, time, Anisotropic_mesh_2::parameters::quality_moves(false, np));
    if(internal::is_stopped_from_outside(code))
      return code;
  }
  return internal::optimize_charts<ConcurrencyTag>(surface_mesh, atlas, time, np);
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_ANISOTROPIC_SURFACE_MESH_3_H

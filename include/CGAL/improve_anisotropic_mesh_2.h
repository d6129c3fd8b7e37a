// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMPROVE_ANISOTROPIC_MESH_2_H
#define CGAL_IMPROVE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/reason_to_stop.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Required_for_now.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Quality_improver.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// what `CGAL::improve_anisotropic_mesh_2()` returns.
struct Quality_improvement
{
  /// why it stopped; `MESH_OPTIMIZATION_UNKNOWN_ERROR` if it was not called
  Mesh_optimization_return_code return_code = MESH_OPTIMIZATION_UNKNOWN_ERROR;
  std::size_t trials = 0;       ///< the number of faces whose surroundings were examined
  std::size_t improvements = 0; ///< how many of the trials have changed the mesh

  /// returns why it stopped, in words; `not run` if it was not called.
  const char* reason() const { return internal::reason_to_stop(return_code); }

  /// writes all that on one line, without its end.
  friend std::ostream& operator<<(std::ostream& os, const Quality_improvement& q)
  {
    return os << q.reason() << " after " << q.trials << " trials with " << q.improvements << " improvements";
  }
};

namespace internal {

template <class Mesh>
Quality_improvement improve_qualities(Mesh& mesh, Sampled_metric<Mesh>& metric, const Time_budget& time)
{
  Quality_improver<Mesh> improve(mesh, metric, time);
  const Mesh_optimization_return_code code = improve();
  return {code, improve.number_of_trials(), improve.number_of_improvements()};
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// improves the faces of low quality of a mesh.
///
/// Where the tessellation of least energy has badly shaped faces, next to pairs of vertices of degree 5 and 7 or where
/// the metric changes much within a face, vertices are moved, and vertices are inserted or removed if that helps (edge
/// swapping and vertex smoothing in section 3.2 of \cgalCite{dw-acvt-05}). Faces of a quality below 0.88 are tried, the
/// worst ones first. The sum of the penalties \f$ q^{-6} - 1 \f$ of the faces falls with each change, the least quality
/// around it does not, and no more edges than before are outside of \f$ [\sqrt{1/2}, \sqrt 2] \f$. No vertex is removed
/// once there are three percent less than the metric asks for, or than there were if these are less.
///
/// `optimize_anisotropic_mesh_2()` calls this function at the end unless it is told not to; alone it is of use for
/// meshes that are optimized already.
///
/// The field is sampled at the beginning, 5 to 50 times per vertex, see \ref AnisotropicMesh2Sampling; afterwards it is
/// evaluated for the vertices that are moved, and where the samples say too little, up to 29 times per vertex.
///
/// Fixed vertices stay where they are. Handles to vertices that are not removed stay valid; vertices that are not
/// required may get the indices of removed ones. The time is proportional to the number of bad faces, apart from some
/// passes over all faces.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, with its domain marked.
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{real time in seconds after which no new face is tried; 0 for no limit}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{the vertices that stay during this call, besides those that are fixed anyway; it is read
///       once, at the start. `set_required()` of a vertex fixes it for good.}
///     \cgalParamType{a model of `ReadablePropertyMap` with the key type `Mesh::Vertex_handle` and the value type
///                    `bool`}
///     \cgalParamDefault{`false` for every vertex}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return why it stopped: `CONVERGENCE_REACHED` if no face of low quality is left,
/// `CANT_IMPROVE_ANYMORE` if trials change nothing any more, `MAX_ITERATION_NUMBER_REACHED` after three rounds, if
/// the number of trials has reached 512 plus a 16th of the number of faces, or if faces were passed over because the
/// evaluations of the field are used up, or `TIME_LIMIT_REACHED`; and the numbers of
/// trials and improvements. The mesh is valid in each case.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain; the mesh is
/// valid then, and improved in some places.
template <class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_mesh_2::Quality_improvement
improve_anisotropic_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Required_for_now<Mesh> required(mesh, np);
  const internal::Time_budget time(choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.));
  internal::Sampled_metric<Mesh> metric(mesh);
  return internal::improve_qualities(mesh, metric, time);
}

} // namespace CGAL

#endif // CGAL_IMPROVE_ANISOTROPIC_MESH_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H
#define CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Quality_improver.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/optimize_acvt.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// whether topological moves are to follow an optimization that has ended with `code`
template <class NamedParameters>
bool are_quality_moves_due(Mesh_optimization_return_code code, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Measure measure = choose_parameter(get_parameter(np, measure_t()), Measure::RIEMANNIAN);
  const bool makes_unit_mesh = measure == Measure::RIEMANNIAN;
  return choose_parameter(get_parameter(np, quality_moves_t()), makes_unit_mesh)
      && choose_parameter<std::size_t>(get_parameter(np, internal_np::number_of_iterations), 1) > 0
      && code != BOUND_REACHED && code != TIME_LIMIT_REACHED;
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// minimizes the energy of the anisotropic Voronoi tessellation of the vertices
/// of a mesh by a quasi-Newton method.
///
/// The gradient of the energy and the mass centres come from the same
/// integrals, since the directional distance to a generator does not depend on
/// the tessellation to first order: Lloyd's iteration is the gradient method
/// preconditioned by the matrices \f$ A_i \f$ of the mass centres. The motion of the bisectors
/// gives the rest of the Hessian. The L-BFGS method \cgalCite{ln-lmbm-89} is preconditioned by two steps
/// of Chebyshev's iteration with that Hessian, which reaches the energy of
/// a hundred iterations of Lloyd in ten to fifteen. A step is shortened if the energy after it
/// exceeds that of the last eight iterates \cgalCite{gll-nls-86}, and so are moves that would invert a face. The
/// triangulation is updated in place by flips. An iteration takes time linear in the number of vertices
/// with the default `region_evaluation`. Section 6 of \cgalCite{dw-acvt-05} names the acceleration of Lloyd's
/// iteration as an open problem.
///
/// At the end, faces of low quality are improved if the measure is the
/// Riemannian one: where the tessellation of least energy has badly shaped faces, next to pairs of vertices of
/// degree 5 and 7 or where the metric changes much within a face, vertices leave their mass centres,
/// and vertices are inserted or removed if that helps (edges swapping and vertex
/// smoothing in section 3.2 of \cgalCite{dw-acvt-05}). The sum of the demerits of
/// the faces falls with each such move, the least quality around it does not, and
/// no more edges than before are outside of \f$ [\sqrt{1/2}, \sqrt 2] \f$. Handles
/// to vertices that are not removed stay valid; vertices that are not on
/// constrained edges may get the indices of removed ones.
///
/// Vertices on constrained edges stay where they are.
///
/// \tparam ConcurrencyTag as for `lloyd_optimize_anisotropic_mesh_2()`; the vertices are moved by all threads as well.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, with its domain marked.
/// \param np an optional sequence of named parameters, those of
/// `lloyd_optimize_anisotropic_mesh_2()`, with the same defaults but for `energy_reduction`
/// (\f$ 3 \cdot 10^{-4} \f$; with 0 it stops when more than ten iterations have not lowered the energy at all), and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{quality_moves}
///     \cgalParamDescription{whether faces of low quality are improved at the end, unless the time
///       limit or the visitor has stopped the optimization, or `number_of_iterations` is 0. If not, handles to
///       vertices and their indices stay.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{whether the measure is `RIEMANNIAN`: with that of Lebesgue the optimum is no unit
///       mesh and has faces of less quality, and these moves would raise its energy by some percent}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// See \ref AnisotropicMesh2NamedParameters for all of them.
///
/// \return why the moves of the first kind stopped: a `Mesh_optimization_return_code` of \cgal, as
/// `lloyd_optimize_anisotropic_mesh_2()` returns it; `CANT_IMPROVE_ANYMORE` also if no step lowers the energy within
/// the accuracy to which it is evaluated. The mesh is valid in each case.
/// \pre no number given is negative.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class ConcurrencyTag = Sequential_tag, class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_optimization_return_code
optimize_anisotropic_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal = Anisotropic_mesh_2::internal;
  const Mesh_optimization_return_code code
    = internal::optimize_acvt<ConcurrencyTag, internal::Vertex_mover<Mesh, ConcurrencyTag> >
        (mesh, 3e-4, [](auto& optimizer) { return optimizer.quasi_newton(); }, np);
  if(internal::are_quality_moves_due(code, np))
    internal::Quality_improver<Mesh>{mesh}();
  return code;
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H

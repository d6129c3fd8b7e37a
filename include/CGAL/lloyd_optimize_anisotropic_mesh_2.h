// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LLOYD_OPTIMIZE_ANISOTROPIC_MESH_2_H
#define CGAL_LLOYD_OPTIMIZE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/internal/optimization/optimize_acvt.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_reinserter.h>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// moves the vertices of a mesh to the mass centres of their anisotropic
/// Voronoi regions, again and again (section 4 of \cgalCite{dw-acvt-05}).
///
/// After each iteration all vertices are inserted again into the stored empty
/// mesh. Vertices on constrained edges stay where they are. Vertices keep their
/// indices and what else their type stores, faces do not; handles to both do not stay valid.
/// An iteration takes \f$ O(n \log n) \f$ time for \f$ n \f$ vertices of a mesh of good quality.
///
/// `optimize_anisotropic_mesh_2()` reaches the same energy in a fraction of the
/// iterations; this function is the reference.
///
/// \tparam ConcurrencyTag enables sequential or parallel assembly of the regions: `Sequential_tag`, `Parallel_tag` or
/// `Parallel_if_available_tag`. `Parallel_tag` needs TBB and calls the metric field from several threads at
/// the same time. The result is the same to the bit.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, with its domain marked.
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of iterations; 0 for none}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{convergence}
///     \cgalParamDescription{the iteration stops when no vertex is farther from
///       the mass centre of its region than this, measured in the tensor of the vertex}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{0.001, a thousandth of the ideal length of an edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{energy_reduction}
///     \cgalParamDescription{the iteration stops when more than ten iterations have lowered the energy by less than
///       this share of it}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{0: this does not stop it}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{real time in seconds after which no new iteration begins; 0 for no limit}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{measure}
///     \cgalParamDescription{the measure of energies and mass centres}
///     \cgalParamType{`Anisotropic_mesh_2::Measure`}
///     \cgalParamDefault{`RIEMANNIAN`, whose optimum has edges of unit length}
///   \cgalParamNEnd
///   \cgalParamNBegin{region_evaluation}
///     \cgalParamDescription{what energies and mass centres are taken from}
///     \cgalParamType{`Anisotropic_mesh_2::Region_evaluation`}
///     \cgalParamDefault{`BY_FACES`, the fastest}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{an object whose member `bool iteration(const Anisotropic_mesh_2::Optimization_state&)`
///       is called after each iteration, and once before the first; `false` stops the optimizer}
///     \cgalParamType{any class with that member}
///     \cgalParamDefault{`Anisotropic_mesh_2::Default_optimization_visitor`}
///     \cgalParamExtra{The visitor is copied; what it collects it must hold by pointer or reference.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return why it stopped: `CONVERGENCE_REACHED`, `MAX_ITERATION_NUMBER_REACHED`,
/// `CANT_IMPROVE_ANYMORE` if the energy fell too little,
/// `TIME_LIMIT_REACHED`, `BOUND_REACHED` if the visitor stopped it, or
/// `ALL_VERTICES_FROZEN` if no vertex is free to move. The mesh is valid in each case.
/// \pre no number given is negative.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class ConcurrencyTag = Sequential_tag, class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_optimization_return_code
lloyd_optimize_anisotropic_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal = Anisotropic_mesh_2::internal;
  return internal::optimize_acvt<ConcurrencyTag, internal::Vertex_reinserter<Mesh> >
    (mesh, 0., [](auto& optimizer) { return optimizer.lloyd(); }, np);
}

} // namespace CGAL

#endif // CGAL_LLOYD_OPTIMIZE_ANISOTROPIC_MESH_2_H

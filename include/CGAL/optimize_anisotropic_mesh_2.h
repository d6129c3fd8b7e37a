// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H
#define CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/reason_to_stop.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Full_region_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Visibility_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Required_for_now.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Unit_mesh_merit.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Acvt_optimizer.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Best_mesh_keeper.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_reinserter.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/improve_anisotropic_mesh_2.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Enums
///
/// how `CGAL::optimize_anisotropic_mesh_2()` minimizes the energy.
enum class Optimization_method
{
  /// L-BFGS with an approximation of the Hessian \cgalCite{ln-lmbm-89}; ten to fifteen iterations reach the energy of
  /// a hundred of Lloyd. The triangulation is updated in place by flips, and handles to vertices stay valid.
  QUASI_NEWTON,
  /// Lloyd's iteration as in section 4 of \cgalCite{dw-acvt-05}: all vertices move to the mass centres of their regions
  /// and are inserted anew into the stored empty mesh. Vertices keep their indices and what else their type stores;
  /// handles to vertices and faces do not stay valid, and vertices outside of the domain stay only if they are fixed.
  /// An iteration takes \f$ O(n \log n) \f$ time.
  LLOYD
};

/// \ingroup PkgAnisotropicMesh2Enums
///
/// from what the optimizers take energies and mass centres.
enum class Region_evaluation
{
  /// from the faces, each divided among the vertices nearby by their bisectors: the fastest. The
  /// field is sampled once, at the beginning, and interpolated from then on.
  BY_FACES,
  /// the same with the field itself, whose derivatives are differences: for comparison.
  BY_FACES_EXACTLY,
  /// from the visibility regions of section 4.1 of \cgalCite{dw-acvt-05}, see
  /// `CGAL::anisotropic_visibility_region_2()`.
  VISIBILITY_REGIONS,
  /// from the full anisotropic Voronoi regions, orphans included, see
  /// `CGAL::Anisotropic_Voronoi_diagram_2`.
  FULL_REGIONS
};

/// \ingroup PkgAnisotropicMesh2Classes
///
/// what `CGAL::optimize_anisotropic_mesh_2()` and `CGAL::optimize_anisotropic_surface_mesh_3()` return.
///
/// Energy and largest move are those of the vertices at the end of the iteration, before faces of low quality are
/// improved.
struct Optimization_result
{
  Mesh_optimization_return_code return_code = ALL_VERTICES_FROZEN; ///< why the iteration stopped
  std::size_t iterations = 0;  ///< how many were done
  std::size_t evaluations = 0; ///< how many times the energy was evaluated
  double energy = 0;           ///< in the measure of the optimizer
  double largest_move = 0;     ///< the largest metric length of a Lloyd move, from a vertex to its mass centre
  /// whether the iteration has left a mesh of no less merit than it got; if not, the vertices are where they were
  bool is_better = true;
  Quality_improvement quality; ///< the result of `CGAL::improve_anisotropic_mesh_2()`

  /// returns why the iteration stopped, in words.
  const char* reason() const { return internal::reason_to_stop(return_code); }

  /// writes all that on one line, without its end.
  friend std::ostream& operator<<(std::ostream& os, const Optimization_result& r)
  {
    os << r.reason() << " after " << r.iterations << " iterations and " << r.evaluations << " evaluations, energy "
       << r.energy << ", largest move " << r.largest_move;
    return r.quality.trials == 0 ? os : os << "; quality: " << r.quality;
  }
};

namespace internal {

template <class NamedParameters>
Stopping_criteria stopping_criteria(double energy_reduction, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Stopping_criteria criteria;
  criteria.number_of_iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations),
                                                   criteria.number_of_iterations);
  criteria.time_limit = choose_parameter(get_parameter(np, internal_np::maximum_running_time), criteria.time_limit);
  criteria.convergence = choose_parameter(get_parameter(np, convergence_t()), criteria.convergence);
  criteria.energy_reduction = choose_parameter(get_parameter(np, energy_reduction_t()), energy_reduction);
  CGAL_precondition(criteria.time_limit >= 0);
  CGAL_precondition(criteria.energy_reduction >= 0);
  CGAL_precondition(criteria.convergence >= 0);
  return criteria;
}

inline bool is_stopped_from_outside(Mesh_optimization_return_code code)
{
  return code == BOUND_REACHED || code == TIME_LIMIT_REACHED;
}

// Runs `method` on an optimizer with this energy. The mesh is as it was if that
// throws, and if its merit has become less.
template <class ConcurrencyTag, class Mesh, class Energy, class Metric, class Mover, class Method, class NamedParameters>
Optimization_result optimize_energy(Mesh& mesh, Energy& energy, Metric& metric, Mover& mover, const Method& method,
                                    const Stopping_criteria& criteria, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Default_optimization_visitor());
  const bool is_unit_mesh_wanted
    = choose_parameter(get_parameter(np, measure_t()), Measure::RIEMANNIAN) == Measure::RIEMANNIAN;
  const auto merit = [&](const Optimization_state& s) {
    return is_unit_mesh_wanted ? Unit_mesh_merit<ConcurrencyTag, Mesh, Metric>(mesh, metric)() : -s.energy;
  };
  const auto judge = [&](double merit) {
    if(!is_unit_mesh_wanted || metric.is_accurate())
      return merit;
    const Field_metric<Mesh> field(mesh);
    return Unit_mesh_merit<ConcurrencyTag, Mesh, Field_metric<Mesh> >(mesh, field)();
  };
  Best_mesh_keeper<decltype(merit), decltype(judge), Mover, decltype(visitor)> keeper(merit, judge, mover, visitor);
  Acvt_optimizer<ConcurrencyTag, Energy, Mover, decltype(keeper)> optimizer(energy, mover, criteria, keeper);
  Optimization_result result;
  try {
    result.return_code = method(optimizer);
    mover.finish();
    const Optimization_state kept = keeper.choose(optimizer.state());
    result.is_better = keeper.is_better();
    result.energy = kept.energy;
    result.largest_move = kept.largest_move;
  }
  catch(...) {
    mover.restore_given();
    throw;
  }
  if(!result.is_better && !is_stopped_from_outside(result.return_code))
    result.return_code = CANT_IMPROVE_ANYMORE;
  result.iterations = optimizer.state().iteration;
  result.evaluations = optimizer.state().evaluations;
  return result;
}

// Chooses the energy, and what both it and the mover take the metric from; samples are left in `sampled`. The
// tolerance is that of `Facewise_energy`.
template <class ConcurrencyTag, template <class, class, class> class Mover, class Mesh, class Method,
          class NamedParameters>
Optimization_result optimize_acvt(Mesh& mesh, std::optional<Sampled_metric<Mesh> >& sampled, const Method& method,
                                  const Stopping_criteria& criteria, double tolerance, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Measure measure = choose_parameter(get_parameter(np, measure_t()), Measure::RIEMANNIAN);
  const auto optimize = [&](auto& energy, auto& metric) {
    Mover<Mesh, std::decay_t<decltype(metric)>, ConcurrencyTag> mover(mesh, metric);
    return optimize_energy<ConcurrencyTag>(mesh, energy, metric, mover, method, criteria, np);
  };
  // without the parameter, users do not pay for the compilation of the others
  typedef std::decay_t<decltype(get_parameter(np, region_evaluation_t()))> Given;
  if constexpr(!std::is_same<Given, internal_np::Param_not_found>::value) {
    const Region_evaluation evaluation = get_parameter(np, region_evaluation_t());
    Field_metric<Mesh> field(mesh);
    if(evaluation == Region_evaluation::BY_FACES_EXACTLY) {
      Facewise_energy<Mesh, ConcurrencyTag> energy(mesh, field, measure, tolerance);
      return optimize(energy, field);
    }
    if(evaluation == Region_evaluation::VISIBILITY_REGIONS) {
      Visibility_energy<Mesh> energy(mesh, measure);
      return optimize(energy, field);
    }
    if(evaluation == Region_evaluation::FULL_REGIONS) {
      Full_region_energy<Mesh, ConcurrencyTag> energy(mesh, measure);
      return optimize(energy, field);
    }
  }
  typedef Sampled_metric<Mesh> Metric;
  sampled.emplace(ConcurrencyTag(), mesh);
  Facewise_energy<Mesh, ConcurrencyTag, Metric> energy(mesh, *sampled, measure, tolerance);
  return optimize(energy, *sampled);
}

template <class ConcurrencyTag, class Mesh, class NamedParameters>
Optimization_result optimize_by_lloyd(Mesh& mesh, std::optional<Sampled_metric<Mesh> >& sampled,
                                      const NamedParameters& np)
{
  return optimize_acvt<ConcurrencyTag, Vertex_reinserter>
    (mesh, sampled, [](auto& optimizer) { return optimizer.lloyd(); }, stopping_criteria(0., np),
     accurate_tolerance, np);
}

template <class ConcurrencyTag, class Mesh, class NamedParameters>
Optimization_result optimize_by_quasi_newton(Mesh& mesh, std::optional<Sampled_metric<Mesh> >& sampled,
                                             const NamedParameters& np)
{
  return optimize_acvt<ConcurrencyTag, Vertex_mover>
    (mesh, sampled, [](auto& optimizer) { return optimizer.quasi_newton(); }, stopping_criteria(3e-4, np),
     quick_tolerance, np);
}

template <class NamedParameters>
bool are_quality_moves_wanted(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const bool makes_unit_mesh
    = choose_parameter(get_parameter(np, measure_t()), Measure::RIEMANNIAN) == Measure::RIEMANNIAN
   && choose_parameter(get_parameter(np, method_t()), Optimization_method::QUASI_NEWTON)
        == Optimization_method::QUASI_NEWTON;
  return choose_parameter(get_parameter(np, quality_moves_t()), makes_unit_mesh)
      && choose_parameter<std::size_t>(get_parameter(np, internal_np::number_of_iterations), 1) > 0;
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// minimizes the energy of the anisotropic Voronoi tessellation of the vertices
/// of a mesh, by a quasi-Newton method or by Lloyd's iteration.
///
/// The energy by faces is positive for any metric and has an exact gradient, see \ref AnisotropicMesh2Assembly. The
/// L-BFGS method \cgalCite{ln-lmbm-89} follows it, preconditioned by two steps of Chebyshev's iteration with an
/// approximation of the Hessian: the matrices \f$ A_i \f$ of the mass centres and the motion of the bisectors. A
/// step is shortened if the energy after it exceeds that of the last eight iterates \cgalCite{gll-nls-86}, and so
/// are moves that would invert a face. An iteration takes time linear in the number of vertices with the default
/// `region_evaluation`. Section 6 of \cgalCite{dw-acvt-05} names the acceleration of Lloyd's iteration as an open
/// problem.
///
/// With the quasi-Newton method and the Riemannian measure, faces of low quality are improved at the end by
/// `improve_anisotropic_mesh_2()`, which also inserts and removes vertices; `quality_moves` changes that.
///
/// Fixed vertices stay where they are: those on constrained edges, required ones, and those of
/// `vertex_is_constrained_map`.
///
/// Vertices stay as well where the metric has a jump: there the energy says nothing about the shapes of faces.
///
/// The mesh is never worse afterwards: if its merit, the sum of the share of unit edges, of the mean quality and of
/// a tenth of the least one, has become less by the iteration, the vertices return to where they were. With the
/// measure of Lebesgue the energy decides.
///
/// By faces, the field is evaluated 6 times per vertex if the metric is mild and at most about 70 times else,
/// whatever the number of iterations, see \ref AnisotropicMesh2Sampling. The quality moves take tensors from the same
/// samples and evaluate the field where the mesh is changed, at most about 40 times per vertex.
///
/// \tparam ConcurrencyTag enables sequential or parallel work: `Sequential_tag`, `Parallel_tag` or
/// `Parallel_if_available_tag`. `Parallel_tag` needs TBB and calls the metric field from several threads at
/// the same time. The result is the same to the bit.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, with its domain marked.
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{method}
///     \cgalParamDescription{how the energy is minimized}
///     \cgalParamType{`Anisotropic_mesh_2::Optimization_method`}
///     \cgalParamDefault{`QUASI_NEWTON`}
///   \cgalParamNEnd
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
///     \cgalParamDescription{the iteration stops when more than five iterations have lowered the energy by less than
///       this share of it; with 0, the quasi-Newton method stops if they have not lowered it at all, and Lloyd's
///       iteration does not stop for this reason}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{\f$ 3 \cdot 10^{-4} \f$, or 0 for Lloyd's iteration}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{real time in seconds after which no new iteration begins and no new face is improved;
///       0 for no limit}
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
///   \cgalParamNBegin{quality_moves}
///     \cgalParamDescription{whether `improve_anisotropic_mesh_2()` is called at the end, unless the time
///       limit or the visitor has stopped the optimization, or `number_of_iterations` is 0. Without it no vertex is
///       inserted, removed or renumbered.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{whether `measure` is `RIEMANNIAN` and `method` is `QUASI_NEWTON`: with the measure of
///       Lebesgue the optimum is no unit mesh and has faces of less quality, and these moves would raise its energy
///       by some percent}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{the vertices that stay during this call, besides those that are fixed anyway; it is read
///       once, at the start. `set_required()` of a vertex fixes it for good.}
///     \cgalParamType{a model of `ReadablePropertyMap` with the key type `Mesh::Vertex_handle` and the value type
///                    `bool`}
///     \cgalParamDefault{`false` for every vertex}
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
/// See \ref AnisotropicMesh2NamedParameters for all of them.
///
/// \return why the iteration stopped, and the numbers at its end. The return code is `CONVERGENCE_REACHED`,
/// `MAX_ITERATION_NUMBER_REACHED`, `CANT_IMPROVE_ANYMORE` if the energy fell too little, no step lowers it, or
/// the mesh would be worse afterwards, `TIME_LIMIT_REACHED`, `BOUND_REACHED` if the visitor stopped it, or
/// `ALL_VERTICES_FROZEN` if no vertex is free to move. The mesh is valid in each case.
/// \pre no number given is negative.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain. Whatever is
/// thrown, also by the visitor, the mesh is as it was, unless it is thrown by the quality moves.
template <class ConcurrencyTag = Sequential_tag, class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_mesh_2::Optimization_result
optimize_anisotropic_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Required_for_now<Mesh> required(mesh, np);
  const internal::Time_budget time(choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.));
  std::optional<internal::Sampled_metric<Mesh> > sampled;
  const auto optimize = [&] {
    // without the parameter, users do not pay for the compilation of Lloyd's iteration
    typedef std::decay_t<decltype(get_parameter(np, internal::method_t()))> Given;
    if constexpr(!std::is_same<Given, internal_np::Param_not_found>::value)
      if(get_parameter(np, internal::method_t()) == Anisotropic_mesh_2::Optimization_method::LLOYD)
        return internal::optimize_by_lloyd<ConcurrencyTag>(mesh, sampled, np);
    return internal::optimize_by_quasi_newton<ConcurrencyTag>(mesh, sampled, np);
  };
  Anisotropic_mesh_2::Optimization_result result = optimize();
  if(internal::are_quality_moves_wanted(np) && !internal::is_stopped_from_outside(result.return_code)) {
    if(!sampled)
      sampled.emplace(ConcurrencyTag(), mesh);
    result.quality = internal::improve_qualities(mesh, *sampled, time);
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_ANISOTROPIC_MESH_2_H

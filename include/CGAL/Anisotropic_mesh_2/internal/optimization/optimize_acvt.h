// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_OPTIMIZE_ACVT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_OPTIMIZE_ACVT_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Acvt_optimizer.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Full_region_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Visibility_energy.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>
#include <CGAL/Anisotropic_mesh_2/Region_evaluation.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <type_traits>

namespace CGAL::Anisotropic_mesh_2::internal {

// Reads the named parameters that both optimizers share, sets up an optimizer
// with the given way to move vertices, and runs `method` on it.
template <class ConcurrencyTag, class Mover, class Mesh, class Method, class NamedParameters>
Mesh_optimization_return_code optimize_acvt(Mesh& mesh, double energy_reduction, const Method& method,
                                           const NamedParameters& np)
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
  const Measure measure = choose_parameter(get_parameter(np, measure_t()), Measure::RIEMANNIAN);

  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Default_optimization_visitor());

  Mover mover(mesh);
  const auto run = [&](auto energy) {
    Acvt_optimizer<ConcurrencyTag, decltype(energy), Mover, decltype(visitor)>
      optimizer(energy, mover, criteria, visitor);
    return method(optimizer);
  };

  // without the parameter, users do not pay for the compilation of the others
  typedef std::decay_t<decltype(get_parameter(np, region_evaluation_t()))> Given;
  if constexpr(!std::is_same<Given, internal_np::Param_not_found>::value) {
    const Region_evaluation evaluation = get_parameter(np, region_evaluation_t());
    if(evaluation == Region_evaluation::VISIBILITY_REGIONS)
      return run(Visibility_energy<Mesh>(mesh, measure));
    if(evaluation == Region_evaluation::FULL_REGIONS)
      return run(Full_region_energy<Mesh, ConcurrencyTag>(mesh, measure));
  }
  return run(Facewise_energy<Mesh, ConcurrencyTag>(mesh, measure));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_OPTIMIZE_ACVT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_ACVT_OPTIMIZER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_ACVT_OPTIMIZER_H

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Lbfgs_history.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_hessian.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Region_preconditioner.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/vector_operations.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

struct Stopping_criteria
{
  std::size_t number_of_iterations = 100;
  double convergence = 1e-3;   // on the largest metric length of a Lloyd move
  double energy_reduction = 0; // relative, by five iterations; 0 for any
  double time_limit = 0;       // in seconds; 0 for none
};

// Minimizes the energy of the tessellation over the free vertices of a mesh.
//
// `Energy` evaluates the energy and the moments of the regions, `Mover` brings
// the vertices to new places and updates the triangulation.
template <class ConcurrencyTag, class Energy, class Mover, class Visitor>
class Acvt_optimizer
{
  typedef std::vector<double> Array; // of coordinates, as `Free_vertices` has them

public:
  Acvt_optimizer(Energy& energy, Mover& mover, const Stopping_criteria& criteria, Visitor& visitor)
    : m_evaluate(energy), m_mover(mover), m_criteria(criteria), m_visitor(visitor),
      m_free(mover.free_vertices().indices()), m_precondition(m_free)
  {
    m_timer.start();
  }

  // The iteration of section 4 of the paper: every vertex moves to the mass
  // centre of its region.
  Mesh_optimization_return_code lloyd()
  {
    m_state.energy = m_evaluate(m_moments);
    summarize();
    for(;;) {
      Mesh_optimization_return_code code;
      if(is_finished(code))
        return code;
      Array target = positions();
      add_multiple<ConcurrencyTag>(target, 1, lloyd_moves());
      m_mover.move_to(target);
      m_state.energy = m_evaluate(m_moments);
      summarize();
      if(m_criteria.energy_reduction > 0 && is_stalled())
        return stop_without_improvement();
    }
  }

  // L-BFGS, preconditioned by an approximation of the inverse of the Hessian.
  Mesh_optimization_return_code quasi_newton()
  {
    evaluate();
    for(;;) {
      Mesh_optimization_return_code code;
      if(is_finished(code))
        return code;
      if((!descend() && !restart()) || is_stalled())
        return stop_without_improvement();
    }
  }

  const Optimization_state& state() const { return m_state; }

private:
  // Longest step, in the metric: beyond, the model of the energy is void.
  static constexpr double longest_step = 0.5;
  static constexpr int    maximum_trials = 3;
  static constexpr std::size_t patience = 5;
  // A step may raise the energy as long as it stays below the highest one of some
  // steps before: that saves many evaluations, and the flips after it do not stop the method.
  static constexpr std::size_t memory_of_energies = 8;

  void evaluate()
  {
    if constexpr(Energy::has_couplings)
      m_state.energy = m_evaluate(m_moments, m_couplings);
    else
      m_state.energy = m_evaluate(m_moments);
    summarize();
  }

  Array positions() const { return m_mover.free_vertices().positions(); }

  // what f makes of the moments of each region, a vector
  template <class Function>
  Array gathered(const Function& f) const
  {
    Array result(2 * m_free.size());
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
      const Vector_of_doubles v = f(m_moments[m_free[i]]);
      result[2*i] = v.x;
      result[2*i + 1] = v.y;
    });
    return result;
  }

  Array gradient() const
  {
    return gathered([](const Region_moments& m) { return Vector_of_doubles{-2*m.gx, -2*m.gy}; });
  }

  // from the free vertices to their mass centres
  Array lloyd_moves() const
  {
    return gathered([](const Region_moments& m) { return m.lloyd_move(); });
  }

  void summarize()
  {
    ++m_state.evaluations;
    const Array moves = lloyd_moves();
    m_state.displacement = scalar_product<ConcurrencyTag>(moves, moves);
    m_state.largest_move = 0;
    for(std::size_t i = 0; i < m_free.size(); ++i)
      m_state.largest_move = (std::max)(m_state.largest_move, m_mover.free_vertices().metric_length(moves, i));
  }

  // whether the visitor lets the optimizer go on
  bool report()
  {
    m_state.seconds = m_timer.time();
    return m_visitor.iteration(static_cast<const Optimization_state&>(m_state));
  }

  Mesh_optimization_return_code stop_without_improvement()
  {
    report();
    return CANT_IMPROVE_ANYMORE;
  }

  bool is_finished(Mesh_optimization_return_code& code)
  {
    const bool go_on = report();
    if(m_free.empty())
      code = ALL_VERTICES_FROZEN;
    else if(!go_on)
      code = BOUND_REACHED;
    else if(m_state.largest_move <= m_criteria.convergence)
      code = CONVERGENCE_REACHED;
    else if(m_state.iteration >= m_criteria.number_of_iterations)
      code = MAX_ITERATION_NUMBER_REACHED;
    else if(m_criteria.time_limit > 0 && m_state.seconds >= m_criteria.time_limit)
      code = TIME_LIMIT_REACHED;
    else {
      ++m_state.iteration;
      return false;
    }
    return true;
  }

  Array direction(const Array& gradient)
  {
    Array d = gradient;
    m_history.direction(d, [&](Array& v) { precondition(v); });
    for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
      const double length = m_mover.free_vertices().metric_length(d, i);
      for(std::size_t k = 2*i; k < 2*i + 2 && length > longest_step; ++k)
        d[k] = d[k] * longest_step / length;
    });
    return d;
  }

  void precondition(Array& v)
  {
    if constexpr(Energy::has_couplings)
      m_precondition(m_moments, m_couplings, v);
    else
      for_each_index<ConcurrencyTag>(m_free.size(), [&](std::size_t i) {
        const Vector_of_doubles d = m_moments[m_free[i]].solve(v[2*i] / 2, v[2*i + 1] / 2);
        v[2*i] = d.x;
        v[2*i + 1] = d.y;
      });
  }

  // A step along the quasi-Newton direction, shortened until the energy falls.
  bool descend()
  {
    const Array start = positions(), old_gradient = gradient(), d = direction(old_gradient);
    const double old_energy = m_state.energy, bound = highest_recent_energy();
    const double slope = scalar_product<ConcurrencyTag>(old_gradient, d);
    if(!(slope < 0))
      return false;
    double t = 1;
    for(int trial = 0; trial < maximum_trials; ++trial) {
      Array target = start;
      add_multiple<ConcurrencyTag>(target, t, d);
      m_mover.move_to(target);
      evaluate();
      if(m_state.energy <= bound + 1e-4 * t * slope) {
        remember_step(start, old_gradient);
        return true;
      }
      // the minimum of the parabola through both values with the slope at the start
      const double best = -slope*t*t / (2 * (m_state.energy - old_energy - slope*t));
      t = (std::min)(0.5*t, (std::max)(0.1*t, best));
    }
    m_mover.move_to(start);
    evaluate();
    return false;
  }

  double highest_recent_energy()
  {
    m_recent_energies.push_back(m_state.energy);
    if(m_recent_energies.size() > memory_of_energies)
      m_recent_energies.erase(m_recent_energies.begin());
    return *std::max_element(m_recent_energies.begin(), m_recent_energies.end());
  }

  // Whether the lowest energy so far is older than some iterations.
  bool is_stalled()
  {
    if(m_state.energy < m_lowest_energy * (1 - m_criteria.energy_reduction)) {
      m_lowest_energy = m_state.energy;
      m_iteration_of_lowest = m_state.iteration;
    }
    return m_state.iteration > m_iteration_of_lowest + patience;
  }

  void remember_step(const Array& start, const Array& old_gradient)
  {
    Array step = positions(), change = gradient();
    add_multiple<ConcurrencyTag>(step, -1, start);
    add_multiple<ConcurrencyTag>(change, -1, old_gradient);
    m_history.add(step, change);
  }

  // Forgets what was learnt; nothing is left to try if that was nothing.
  bool restart()
  {
    const bool had_learnt = !m_history.empty();
    m_history.clear();
    return had_learnt;
  }

  Energy&                     m_evaluate;
  Mover&                      m_mover;
  Stopping_criteria           m_criteria;
  Visitor&                    m_visitor;
  Real_timer                  m_timer;
  Optimization_state          m_state;
  std::vector<int>            m_free;     // the indices of the free vertices
  std::vector<Region_moments> m_moments;  // by index
  Bisector_hessian            m_couplings;
  Region_preconditioner<ConcurrencyTag> m_precondition;
  Lbfgs_history<ConcurrencyTag>         m_history;
  std::vector<double>         m_recent_energies;
  double                      m_lowest_energy = std::numeric_limits<double>::infinity();
  std::size_t                 m_iteration_of_lowest = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_ACVT_OPTIMIZER_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_OPTIMIZER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_OPTIMIZER_H

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>
#include <CGAL/Anisotropic_mesh_2/internal/Lbfgs_history.h>
#include <CGAL/Anisotropic_mesh_2/internal/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

struct Stopping_criteria
{
  std::size_t number_of_iterations = 100;
  double convergence = 1e-3;   // on the largest metric length of a Lloyd move
  double time_limit = 0;       // in seconds; 0 for none
};

// Minimizes the energy of the tessellation over the free vertices of a mesh.
//
// `Energy` evaluates the energy and the moments of the regions, `Mover` brings
// the vertices to new places and updates the triangulation.
template <class Mesh, class Energy, class Mover, class Visitor>
class Acvt_optimizer
{
public:
  Acvt_optimizer(Energy& energy, Mover& mover, const Stopping_criteria& criteria, Visitor& visitor)
    : m_evaluate(energy), m_mover(mover), m_criteria(criteria), m_visitor(visitor)
  {
    m_timer.start();
    evaluate();
  }

  // The iteration of section 4 of the paper: every vertex moves to the mass
  // centre of its region.
  Mesh_optimization_return_code lloyd()
  {
    for(;;) {
      Mesh_optimization_return_code code;
      if(is_finished(code))
        return code;
      Vectors target = m_mover.positions();
      add_multiple(target, 1, m_pull);
      m_mover.move_to(target);
      evaluate();
    }
  }

  // L-BFGS, preconditioned by the matrices of the mass centres so that its
  // first step is a Lloyd step.
  Mesh_optimization_return_code quasi_newton()
  {
    for(;;) {
      Mesh_optimization_return_code code;
      if(is_finished(code))
        return code;
      if((!descend() && !restart()) || is_stalled())
        return CANT_IMPROVE_ANYMORE;
    }
  }

private:
  // Longest step, in the metric: beyond, the model of the energy is void.
  static constexpr double longest_step = 0.5;
  static constexpr int    maximum_trials = 6;
  // The energy jumps a little where elements are quartered or edges flipped.
  static constexpr double energy_noise = 1e-4;
  static constexpr double least_progress = 1e-6;
  static constexpr int    patience = 10;

  void evaluate()
  {
    m_state.energy = m_evaluate(m_moments);
    ++m_state.evaluations;
    const auto& vertices = m_mover.free_vertices();
    m_pull.resize(vertices.size());
    m_state.largest_move = m_state.displacement = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      Vector_of_doubles& p = m_pull[i];
      m_moments[vertices[i]->index()].pull(p.x, p.y);
      m_state.displacement += p.x*p.x + p.y*p.y;
      m_state.largest_move = std::max(m_state.largest_move, metric_length(i, p));
    }
  }

  double metric_length(std::size_t i, const Vector_of_doubles& v) const
  {
    return Symmetric_form(m_mover.free_vertices()[i]->metric_tensor()).length(v.x, v.y);
  }

  bool is_finished(Mesh_optimization_return_code& code)
  {
    m_state.seconds = m_timer.time();
    const bool go_on = m_visitor.iteration(static_cast<const Optimization_state&>(m_state));
    if(m_pull.empty())
      code = ALL_VERTICES_FROZEN;
    else if(m_state.largest_move <= m_criteria.convergence)
      code = CONVERGENCE_REACHED;
    else if(!go_on)
      code = BOUND_REACHED;
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

  Vectors gradient() const
  {
    const auto& vertices = m_mover.free_vertices();
    Vectors g(vertices.size());
    for(std::size_t i = 0; i < g.size(); ++i) {
      const Region_moments& m = m_moments[vertices[i]->index()];
      g[i] = {-2*m.gx, -2*m.gy};
    }
    return g;
  }

  Vectors direction() const
  {
    Vectors d = gradient();
    const auto& vertices = m_mover.free_vertices();
    m_history.direction(d, [&](Vectors& v) {
      for(std::size_t i = 0; i < v.size(); ++i)
        m_moments[vertices[i]->index()].solve(v[i].x / 2, v[i].y / 2, v[i].x, v[i].y);
    });
    for(std::size_t i = 0; i < d.size(); ++i) {
      const double length = metric_length(i, d[i]);
      if(length > longest_step)
        d[i] = {d[i].x * longest_step / length, d[i].y * longest_step / length};
    }
    return d;
  }

  // A step along the quasi-Newton direction, shortened until the energy falls.
  bool descend()
  {
    const Vectors start = m_mover.positions(), old_gradient = gradient(), d = direction();
    const double old_energy = m_state.energy, slope = scalar_product(old_gradient, d);
    if(!(slope < 0))
      return false;
    double t = 1;
    for(int trial = 0; trial < maximum_trials; ++trial) {
      Vectors target = start;
      add_multiple(target, t, d);
      m_mover.move_to(target);
      evaluate();
      if(m_state.energy <= old_energy + 1e-4 * t * slope || is_level(old_energy, slope, d)) {
        remember_step(start, old_gradient);
        return true;
      }
      // the minimum of the parabola through both values with the slope at the start
      const double best = -slope*t*t / (2 * (m_state.energy - old_energy - slope*t));
      t = std::min(0.5*t, std::max(0.1*t, best));
    }
    m_mover.move_to(start);
    evaluate();
    return false;
  }

  // Whether the energy has not risen by more than noise while its slope along d
  // has lost a good part of its steepness, so that d has been of use.
  bool is_level(double old_energy, double old_slope, const Vectors& d) const
  {
    return m_state.energy <= old_energy * (1 + energy_noise)
        && scalar_product(gradient(), d) >= 0.8 * old_slope
        && scalar_product(gradient(), d) <= -0.8 * old_slope;
  }

  // Whether the lowest energy so far is older than some iterations.
  bool is_stalled()
  {
    if(m_state.energy < m_lowest_energy * (1 - least_progress)) {
      m_lowest_energy = m_state.energy;
      m_iteration_of_lowest = m_state.iteration;
    }
    return m_state.iteration > m_iteration_of_lowest + patience;
  }

  void remember_step(const Vectors& start, const Vectors& old_gradient)
  {
    Vectors step = m_mover.positions(), difference = gradient();
    add_multiple(step, -1, start);
    add_multiple(difference, -1, old_gradient);
    m_history.add(std::move(step), std::move(difference));
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
  std::vector<Region_moments> m_moments;
  Vectors                     m_pull; // from the free vertices to their mass centres
  Lbfgs_history               m_history;
  double                      m_lowest_energy = std::numeric_limits<double>::infinity();
  std::size_t                 m_iteration_of_lowest = 0;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_OPTIMIZER_H

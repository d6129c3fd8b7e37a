// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_REMAINING_TIME_H
#define ANISOTROPIC_MESH_2_PROGRAM_REMAINING_TIME_H

#include "Options.h"

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

namespace program {

// Estimates when an optimizer will stop: at the bound on iterations or on time
// or, if the moves have become shorter over the last iterations and go on to do
// so at the same rate, when they are short enough.
class Remaining_time
{
public:
  explicit Remaining_time(const Options& options)
    : m_iterations(options.iterations), m_tolerance(options.tolerance), m_limit(options.time_limit)
  {}

  // in seconds; negative while nothing is known
  double operator()(const CGAL::Anisotropic_mesh_2::Optimization_state& state)
  {
    m_moves.push_back(state.largest_move);
    if(m_moves.size() > window)
      m_moves.pop_front();
    if(state.iteration == 0)
      return -1;
    double iterations = double(m_iterations) - double(state.iteration);
    const double rate = std::log(m_moves.front() / m_moves.back()) / double(m_moves.size() - 1);
    if(m_tolerance > 0 && m_moves.size() == window && rate > 0)
      iterations = (std::min)(iterations, std::log(m_moves.back() / m_tolerance) / rate);
    const double seconds = (std::max)(0., iterations) * state.seconds / double(state.iteration);
    return m_limit ? (std::min)(seconds, (std::max)(0., *m_limit - state.seconds)) : seconds;
  }

private:
  static constexpr std::size_t window = 8;

  std::size_t           m_iterations;
  double                m_tolerance;
  std::optional<double> m_limit;
  std::deque<double>    m_moves;
};

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_REMAINING_TIME_H

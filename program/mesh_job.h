// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_MESH_JOB_H
#define ANISOTROPIC_MESH_2_PROGRAM_MESH_JOB_H

#include "Interruption.h"
#include "Metric_field.h"
#include "Options.h"
#include "Progress.h"
#include "Remaining_time.h"
#include "builtin_domains.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

// Everything that the program asks of the mesher and the optimizers.
namespace program {

typedef CGAL::Riemannian_metric_traits_2<Kernel, Metric_field>  Traits;
typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits>               Mesh;

// The result is the same with every number of threads, of which there is one unless the options ask for more.
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

// What the statistics of the mesh alone do not say.
struct Run_report
{
  std::size_t iterations = 0;
  std::string stop_reason = "no optimizer";
  double      seconds_mesh = 0, seconds_optimize = 0;
};

inline CGAL::Anisotropic_mesh_2::Measure measure_of(const Options& options)
{
  return options.measure == Measure::RIEMANNIAN ? CGAL::Anisotropic_mesh_2::Measure::RIEMANNIAN
                                                : CGAL::Anisotropic_mesh_2::Measure::LEBESGUE;
}

inline Mesh make_mesh(const Domain_with_metric& input, const Options& options, Run_report& report)
{
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  CGAL::Real_timer timer;
  timer.start();
  Mesh mesh = CGAL::make_anisotropic_mesh_2(input.domain, input.metric,
                                            np::keep_boundary_points(options.keep_boundary)
                                              .maximum_running_time(options.time_limit.value_or(0)));
  report.seconds_mesh = timer.time();
  return mesh;
}

// Follows an optimizer: progress to the user, the count to the report. An
// interrupt from the keyboard stops it.
class Progress_visitor
{
public:
  Progress_visitor(const Options& options, Progress& progress, Run_report& report)
    : m_remaining_time(options), m_progress(&progress), m_report(&report)
  {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& state)
  {
    m_report->iterations = state.iteration;
    std::ostringstream line;
    line << "iteration " << state.iteration << ", energy " << state.energy << ", largest move "
         << state.largest_move << ", " << state.seconds << " s";
    const double remaining = m_remaining_time(state);
    if(remaining >= 0)
      line << ", " << std::lround(std::ceil(remaining)) << " s left at most";
    m_progress->update(line.str());
    return !Interruption::is_wanted();
  }

private:
  Remaining_time m_remaining_time;
  Progress*      m_progress;
  Run_report*    m_report;
};

inline void optimize(Mesh& mesh, const Options& options, Progress& progress, Run_report& report)
{
  if(options.optimizer == Optimizer::NONE)
    return;
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  const auto parameters = np::convergence(options.tolerance).measure(measure_of(options))
    .number_of_iterations(options.iterations)
    .maximum_running_time(options.time_limit ? (std::max)(*options.time_limit - report.seconds_mesh, 1e-9) : 0)
    .method(options.optimizer == Optimizer::LLOYD ? CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD
                                                  : CGAL::Anisotropic_mesh_2::Optimization_method::QUASI_NEWTON)
    .visitor(Progress_visitor(options, progress, report));
  const Interruption interruption;
  CGAL::Real_timer timer;
  timer.start();
  const auto result = CGAL::optimize_anisotropic_mesh_2<Concurrency_tag>(mesh, parameters);
  report.seconds_optimize = timer.time();
  report.stop_reason = result.reason();
}

// for the user, who may have asked for no statistics; empty if all is well
inline std::string warning(const Mesh& mesh) { return CGAL::anisotropic_mesh_warning_2(mesh); }

inline auto statistics(const Mesh& mesh, const Options& options)
{
  return CGAL::anisotropic_mesh_statistics_2<Concurrency_tag>(mesh, measure_of(options));
}

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_MESH_JOB_H

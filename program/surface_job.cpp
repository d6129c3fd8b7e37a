// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_job.h"

#include "Interruption.h"
#include "builtin_surfaces.h"
#include "mesh_job.h"
#include "output.h"
#include "Safe_output_file.h"

#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/PLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/optimize_anisotropic_surface_mesh_3.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/anisotropic_surface_Voronoi_regions_3.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>

#include <string>

namespace program {

namespace {

typedef CGAL::Surface_metric_field_2<Any_surface, Surface_metric>  Surface_field;
typedef CGAL::Anisotropic_surface_mesh_3<Surface_field>            Surface_mesh;

void check_options(const Options& options)
{
  const std::string name = name_of_domain(options);
  if(options.metric_source != Metric_source::BUILTIN)
    throw Unusable_input(name + ": a surface has its own metric; only --scale changes it");
  if(options.optimizer == Optimizer::LLOYD)
    throw Unusable_input("--optimizer lloyd: not for surfaces; lbfgs or none");
  if(options.window != CGAL::Bbox_2())
    throw Unusable_input("--window: not for surfaces");
  if(options.keep_boundary)
    throw Unusable_input("--keep-boundary: not for surfaces");
  if(options.measure != Measure::RIEMANNIAN)
    throw Unusable_input("--measure lebesgue: not for surfaces");
  for(const Output& output : options.meshes)
    if(output.format == File_format::MESH || output.format == File_format::VTU)
      throw Unusable_input("-o " + output.path + ": a surface is written as .off, .ply or .svg");
}

// Several charts are optimized one after the other, each by a copy of the visitor.
class Surface_visitor
{
public:
  Surface_visitor(Progress& progress, const CGAL::Real_timer& timer, Run_report& report)
    : m_progress(&progress), m_timer(&timer), m_report(&report)
  {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& state)
  {
    if(state.iteration > 0)
      ++m_report->iterations;
    m_progress->update("iteration " + std::to_string(m_report->iterations) + " of all charts, "
                       + std::to_string(m_timer->time()) + " s");
    return !Interruption::is_wanted();
  }

private:
  Progress*               m_progress;
  const CGAL::Real_timer* m_timer;
  Run_report*             m_report;
};

Surface_mesh make_unit_mesh(const Options& options, Run_report& report)
{
  const Surface_with_metric input = builtin_surface(options.domain, options.scale);
  CGAL::Real_timer timer;
  timer.start();
  Surface_mesh mesh = CGAL::make_anisotropic_surface_mesh_3<Concurrency_tag>(Surface_field(input.surface, input.metric),
                                                          CGAL::parameters::number_of_iterations(0));
  report.seconds_mesh = timer.time();
  return mesh;
}

void optimize(Surface_mesh& mesh, const Options& options, Progress& progress, Run_report& report)
{
  if(options.optimizer == Optimizer::NONE)
    return;
  const Interruption interruption;
  CGAL::Real_timer timer;
  timer.start();
  report.stop_reason = CGAL::optimize_anisotropic_surface_mesh_3<Concurrency_tag>
    (mesh, CGAL::Anisotropic_mesh_2::parameters::convergence(options.tolerance)
             .number_of_iterations(options.iterations)
             .maximum_running_time(options.time_limit.value_or(0)) // 0: no limit
             .visitor(Surface_visitor(progress, timer, report))).reason();
  report.seconds_optimize = timer.time();
}

void write_mesh(const Surface_mesh& mesh, const Output& output)
{
  write_safely(output.path, [&](std::ostream& os) {
    switch(output.format) {
    case File_format::OFF: return CGAL::IO::write_OFF(os, mesh);
    case File_format::PLY: return CGAL::IO::write_PLY(os, mesh);
    default:               return CGAL::IO::write_SVG(os, mesh);
    }
  });
}

} // namespace

void run_surface(const Options& options, Progress& progress)
{
  check_options(options);
  Run_report report;
  progress.say("meshing");
  Surface_mesh mesh = make_unit_mesh(options, report);
  progress.say(std::to_string(mesh.number_of_vertices()) + " vertices");
  optimize(mesh, options, progress, report);
  for(const Output& output : options.meshes)
    write_mesh(mesh, output);
  if(!options.voronoi.empty())
    write_safely(options.voronoi, [&](std::ostream& os) {
      CGAL::IO::write_SVG(os, CGAL::anisotropic_surface_Voronoi_regions_3<Concurrency_tag>(mesh, 1e-2),
                          mesh.is_closed());
    });
  if(!options.stats.empty())
    write_statistics(options.stats, CGAL::anisotropic_surface_mesh_statistics_3<Concurrency_tag>(mesh), report);
}

} // namespace program

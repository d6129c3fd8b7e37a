// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#include "surface_job.h"

#include "Interruption.h"
#include "builtin_surfaces.h"
#include "mesh_job.h"
#include "output.h"

#include <CGAL/Anisotropic_mesh_2/IO/surface.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/anisotropic_surface_statistics.h>
#include <CGAL/anisotropic_surface_voronoi_regions.h>
#include <CGAL/make_anisotropic_surface_mesh.h>

#include <CGAL/Real_timer.h>

#include <optional>
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
  if(options.keep_boundary)
    throw Unusable_input("--keep-boundary: not for surfaces");
  if(options.measure != Measure::RIEMANNIAN)
    throw Unusable_input("--measure lebesgue: not for surfaces");
  for(const Output& output : options.meshes)
    if(output.format == File_format::MESH || output.format == File_format::VTU)
      throw Unusable_input("-o " + output.path + ": a surface is written as .off, .ply or .svg");
}

// Several charts are optimized one after the other, each with the time that is left.
class Surface_visitor
{
public:
  Surface_visitor(const Options& options, Progress& progress, const CGAL::Real_timer& timer, Run_report& report)
    : m_time_limit(options.time_limit), m_progress(&progress), m_timer(&timer), m_report(&report)
  {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& state)
  {
    if(state.iteration > 0)
      ++m_report->iterations;
    m_progress->update("iteration " + std::to_string(m_report->iterations) + " of all charts, "
                       + std::to_string(m_timer->time()) + " s");
    return !Interruption::is_wanted() && !(m_time_limit && m_timer->time() >= *m_time_limit);
  }

private:
  std::optional<double>   m_time_limit;
  Progress*               m_progress;
  const CGAL::Real_timer* m_timer;
  Run_report*             m_report;
};

Surface_mesh mesh_of(const Options& options, Progress& progress, Run_report& report)
{
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  const Surface_with_metric input = builtin_surface(options.domain, options.scale);
  const bool is_optimized = options.optimizer != Optimizer::NONE;
  const Interruption interruption;
  CGAL::Real_timer timer;
  timer.start();
  Surface_mesh mesh = CGAL::make_anisotropic_surface_mesh
    (Surface_field(input.surface, input.metric),
     np::convergence(options.tolerance, np::topological_moves(is_optimized))
       .number_of_iterations(is_optimized ? options.iterations : 0)
       .visitor(Surface_visitor(options, progress, timer, report)));
  report.seconds_mesh = timer.time();
  if(is_optimized)
    report.stop_reason = Interruption::is_wanted() ? "interrupted"
                       : options.time_limit && timer.time() >= *options.time_limit ? "time limit" : "all charts done";
  return mesh;
}

void write_mesh(const Surface_mesh& mesh, const Output& output)
{
  switch(output.format) {
  case File_format::OFF: return CGAL::IO::write_off(output.path, mesh);
  case File_format::PLY: return CGAL::IO::write_ply(output.path, mesh);
  default:               return CGAL::IO::write_SVG(output.path, mesh);
  }
}

} // namespace

void run_surface(const Options& options, Progress& progress)
{
  check_options(options);
  Run_report report;
  progress.say("meshing");
  const Surface_mesh mesh = mesh_of(options, progress, report);
  progress.say(std::to_string(mesh.number_of_vertices()) + " vertices");
  for(const Output& output : options.meshes)
    write_mesh(mesh, output);
  if(!options.voronoi.empty())
    CGAL::IO::write_SVG(options.voronoi, CGAL::anisotropic_surface_voronoi_regions(mesh, 1e-2), mesh.is_closed());
  if(!options.stats.empty())
    write_statistics(options.stats, CGAL::anisotropic_surface_statistics(mesh), report);
}

} // namespace program

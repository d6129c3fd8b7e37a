// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"
#include "Progress.h"
#include "builtin_surfaces.h"
#include "input.h"
#include "mesh_job.h"
#include "output.h"
#include "surface_job.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/assertions_behaviour.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace program {

enum Exit_status { DONE = 0, FAILED = 1, UNUSABLE = 2 };

Mesh meshed(const Options& options, Progress& progress, Run_report& report)
{
  const Domain_with_metric input = read_input(options);
  progress.say("meshing");
  Mesh mesh = make_mesh(input, options, report);
  progress.say(std::to_string(mesh.number_of_vertices()) + " vertices");
  return mesh;
}

void run(const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
#endif
  Progress progress(options.verbosity);
  check_outputs(options);
  try {
    if(options.domain_is_builtin && is_builtin_surface(options.domain))
      return run_surface(options, progress);
    check_planar_outputs(options);
    Run_report report;
    Mesh mesh = meshed(options, progress, report);
    optimize(mesh, options, progress, report);
    progress.say("stopped by " + report.stop_reason);
    const std::string complaint = warning(mesh);
    if(!complaint.empty())
      progress.warn(complaint);
    write_outputs(mesh, options, report);
  }
  catch(const CGAL::Anisotropic_mesh_2::Invalid_domain_exception& e) {
    throw Unusable_input(name_of_domain(options) + ": " + e.what());
  }
  catch(const CGAL::Anisotropic_mesh_2::Too_many_vertices_exception& e) {
    throw Unusable_input(name_of_metric(options) + ": " + e.what());
  }
  catch(const CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception& e) {
    throw Unusable_input(name_of_metric(options) + ": " + e.what());
  }
}

int complain(Exit_status status, std::string what)
{
  std::replace_if(what.begin(), what.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::fprintf(stderr, "anisotropic_mesh_2: %s\n", what.c_str());
  return status;
}

void ignore_violation(const char*, const char*, const char*, int, const char*) {}

} // namespace program

int main(int argc, char** argv)
{
  using namespace program;
  CGAL::set_error_handler(ignore_violation); // the exception that follows says the same in one line
  try {
    const Options options = parse_options(argc, argv);
    if(options.answer.empty())
      run(options);
    else
      std::cout << options.answer;
    return DONE;
  }
  catch(const Unusable_input& e) {
    return complain(UNUSABLE, e.what());
  }
  catch(const std::bad_alloc&) {
    return complain(FAILED, "not enough memory");
  }
  catch(const std::exception& e) {
    return complain(FAILED, e.what());
  }
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Discrete_metric_field_2.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>  Graph;
typedef CGAL::Discrete_metric_field_2<Kernel>                           Discrete_metric_field;

Domain domain_of_file(const std::string& path)
{
  if(extension_of(path) != ".poly")
    return Domain(CGAL::IO::read_MEDIT<Kernel>(path));
  Domain domain(CGAL::IO::read_POLY<Kernel>(path));
  domain.set_rule(CGAL::Anisotropic_mesh_2::Domain_rule::FLOOD_FROM_SEEDS);
  return domain;
}

Metric_field metric_of_files(const std::string& metric_file, const std::string& background_file)
{
  const Graph background = CGAL::IO::read_MEDIT<Kernel>(background_file);
  const std::vector<Metric_tensor_2> tensors = CGAL::IO::read_MEDIT_metric<Kernel>(metric_file);
  try {
    return Discrete_metric_field(background, tensors);
  }
  catch(const CGAL::Anisotropic_mesh_2::Invalid_triangle_mesh_exception& e) {
    throw Unusable_input("--metric " + metric_file + ", --background " + background_file + ": " + e.what());
  }
}

Metric_field metric_of(const Options& options)
{
  const std::vector<Formula>& f = options.formulas;
  switch(options.metric_source) {
  case Metric_source::SIZES:   return Formula_metric_field::from_sizes(f[0], f[1], f[2]);
  case Metric_source::ENTRIES: return Formula_metric_field::from_entries(f[0], f[1], f[2]);
  case Metric_source::SIZE:    return Formula_metric_field::from_size(f[0]);
  case Metric_source::FILE:    return metric_of_files(options.metric_file, options.background_file);
  case Metric_source::BUILTIN: break;
  }
  return builtin_domain(options.domain).metric;
}

Metric_field scaled(const Metric_field& metric, double scale)
{
  if(scale == 1)
    return metric;
  return [metric, scale](const Point_2& p) { return metric(p).scaled(scale); };
}

} // namespace

Domain_with_metric read_input(const Options& options)
{
  try {
    const Metric_field metric = metric_of(options); // first, as errors in formulas take no reading to find
    Domain domain = options.domain_is_builtin ? builtin_domain(options.domain).domain
                                              : domain_of_file(options.domain);
    return Domain_with_metric{std::move(domain), scaled(metric, options.scale)};
  }
  catch(const CGAL::Mesh_io_exception& e) {
    throw Unusable_input(e.what());
  }
  catch(const Formula_error& e) {
    throw Unusable_input(e.what());
  }
}

} // namespace program

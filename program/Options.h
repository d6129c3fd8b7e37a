// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_OPTIONS_H
#define ANISOTROPIC_MESH_2_PROGRAM_OPTIONS_H

#include "Formula_metric_field.h"

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

// thrown for arguments and input that cannot be used: exit status 2
class Unusable_input
  : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

enum class File_format { MESH, VTU, OFF, PLY, SVG };
enum class Optimizer   { NONE, LLOYD, LBFGS };
enum class Measure     { RIEMANNIAN, LEBESGUE };
enum class Verbosity   { QUIET, NORMAL, VERBOSE };

// What the metric is made of.
enum class Metric_source { BUILTIN, SIZES, ENTRIES, SIZE, FILE };

struct Output
{
  std::string path;
  File_format format;
};

// The command line as the user wrote it, checked for all that can be known
// without opening a file.
struct Options
{
  bool        domain_is_builtin = false;
  std::string domain;                          // a path, or the name of a built-in domain

  Metric_source        metric_source = Metric_source::BUILTIN;
  std::vector<Formula> formulas;               // in the order of the constructors of the field
  std::string          metric_file, background_file;
  double               scale = 1;

  Optimizer   optimizer = Optimizer::LBFGS;
  Measure     measure = Measure::RIEMANNIAN;
  std::size_t iterations = 100;
  double      tolerance = 1e-3;
  std::optional<double> time_limit;            // in seconds
  bool        keep_boundary = false;
  unsigned    threads = 1;
  unsigned    seed = 0;

  std::vector<Output> meshes;
  std::string         voronoi;                 // empty: not asked for
  CGAL::Bbox_2        window;                  // of pictures; empty: all
  std::string         stats;                   // the same; "-" is standard output
  Verbosity           verbosity = Verbosity::NORMAL;

  std::string answer;                          // not empty: print it and do nothing else
};

// throws Unusable_input
Options parse_options(int argc, const char* const* argv);

// the extension with its dot, in lower case
std::string extension_of(const std::string& path);

// what complaints about the domain and the metric should name
std::string name_of_domain(const Options& options);
std::string name_of_metric(const Options& options);

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_OPTIONS_H

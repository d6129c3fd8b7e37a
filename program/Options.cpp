// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace program {

namespace {

const std::string builtin_prefix = "builtin:";

// The values of the options as text, before they are understood together.
struct Raw_options
{
  std::string domain;
  std::map<std::string, std::string> metric;   // by the name of the option, with its dashes
  std::vector<std::string> outputs;
  std::string window;
  bool quiet = false, verbose = false;
};

CLI::Validator positive_number()
{
  return CLI::Validator([](std::string& text) {
    double value = 0;
    const bool ok = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
    return ok ? std::string() : "\"" + text + "\" is not a positive finite number";
  }, "");
}

CLI::Validator number_from_zero()
{
  return CLI::Validator([](std::string& text) {
    double value = 0;
    const bool ok = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0;
    return ok ? std::string() : "\"" + text + "\" is not a finite number from 0 on";
  }, "");
}

CLI::Validator integer_from(unsigned least)
{
  return CLI::Validator([least](std::string& text) {
    const bool digits = !text.empty() && text.size() < 10
      && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
    return digits && std::stoul(text) >= least
      ? std::string() : "\"" + text + "\" is not an integer from " + std::to_string(least) + " to 999999999";
  }, "");
}

void declare_metric(CLI::App& app, Raw_options& raw, double& scale)
{
  const auto option = [&](const std::string& name, const std::string& type, const std::string& text) {
    app.add_option_function<std::string>(name, [&raw, name](const std::string& v) { raw.metric[name] = v; }, text)
      ->type_name(type)->group("Metric");
  };
  option("--h1", "E", "size along theta, a formula in x and y");
  option("--h2", "E", "size across theta");
  option("--theta", "E", "the direction of the size h1, in radians; default 0");
  option("--m11", "E", "first entry of the metric tensor");
  option("--m12", "E", "second entry; default 0");
  option("--m22", "E", "third entry");
  option("--size", "E", "isotropic size");
  option("--metric", "F.sol", "a size or the entries m11 m12 m22 for each vertex of the background mesh");
  option("--background", "F.mesh", "the mesh of --metric; default: DOMAIN");
  app.add_option("--scale", scale, "multiplies all sizes; default 1")
    ->type_name("S")->group("Metric")->check(positive_number());
}

// an option with one of the given names as its value
template <class Enum>
void declare_choice(CLI::App& app, const std::string& name, Enum& value,
                    const std::vector<std::pair<std::string, Enum>>& choices, const std::string& text)
{
  std::vector<std::string> names;
  for(const auto& choice : choices)
    names.push_back(choice.first);
  const auto assign = [&value, choices](const std::string& given) {
    for(const auto& choice : choices)
      if(choice.first == given)
        value = choice.second;
  };
  app.add_option_function<std::string>(name, assign, text)
    ->type_name("NAME")->group("Methods")->check(CLI::IsMember(names).description(""));
}

void declare_methods(CLI::App& app, Options& options)
{
  const std::string group = "Methods";
  declare_choice(app, "--optimizer", options.optimizer,
                 {{"none", Optimizer::NONE}, {"lloyd", Optimizer::LLOYD}, {"lbfgs", Optimizer::LBFGS}},
                 "none, lloyd or lbfgs; default lbfgs");
  app.add_option("--iterations", options.iterations, "the largest number of iterations; default 100")
    ->type_name("N")->group(group)->check(integer_from(0));
  app.add_option("--tolerance", options.tolerance,
                 "stop when no vertex would move by more, measured in the metric; default 0.001")
    ->type_name("T")->group(group)->check(number_from_zero());
  app.add_option("--time-limit", options.time_limit, "stop meshing and the optimizer after this number of seconds")
    ->type_name("SEC")->group(group)->check(positive_number());
  declare_choice(app, "--measure", options.measure,
                 {{"riemannian", Measure::RIEMANNIAN}, {"lebesgue", Measure::LEBESGUE}},
                 "riemannian or lebesgue; default riemannian");
  app.add_flag("--keep-boundary", options.keep_boundary, "take the given boundary points as they are")
    ->group(group);
  app.add_option("--threads", options.threads, "number of threads; the result is the same; default 1")
    ->type_name("N")->group(group)->check(integer_from(1));
  app.add_option("--seed", options.seed, "accepted; the method has no random choices")
    ->type_name("N")->group(group)->check(integer_from(0));
}

void declare_output(CLI::App& app, Options& options, Raw_options& raw)
{
  const std::string group = "Output";
  app.add_option("-o", raw.outputs, "the mesh, by extension .mesh, .vtu, .off, .svg, or .ply of a surface; repeatable")
    ->type_name("FILE")->group(group)->allow_extra_args(false);
  app.add_option("--voronoi", options.voronoi, "a picture of the tessellation")
    ->type_name("FILE.svg")->group(group);
  app.add_option("--window", raw.window, "the part of the plane that .svg files show, XMIN,YMIN,XMAX,YMAX; default all")
    ->type_name("NUMBERS")->group(group);
  app.add_option("--stats", options.stats,
                 "statistics, - for standard output, which is the default if no output is asked for")
    ->type_name("FILE.json")->group(group);
  app.add_flag("--quiet", raw.quiet, "no progress on standard error")->group(group);
  app.add_flag("--verbose", raw.verbose, "progress on standard error even if it is not a terminal")
    ->group(group);
}

Output output_of(const std::string& path)
{
  static const std::map<std::string, File_format> formats
    = {{".mesh", File_format::MESH}, {".vtu", File_format::VTU},
       {".off", File_format::OFF}, {".ply", File_format::PLY}, {".svg", File_format::SVG}};
  const auto format = formats.find(extension_of(path));
  if(format == formats.end())
    throw Unusable_input("-o " + path + ": the extension is none of .mesh, .vtu, .off, .ply, .svg");
  return Output{path, format->second};
}

void understand_window(const std::string& text, Options& options)
{
  if(text.empty())
    return;
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double bounds[4] = {};
  char comma = ',';
  for(int i = 0; i < 4 && comma == ','; ++i) {
    in >> bounds[i];
    if(i < 3)
      in >> comma;
  }
  if(!in || comma != ',' || !in.eof() || !(bounds[0] < bounds[2]) || !(bounds[1] < bounds[3]))
    throw Unusable_input("--window " + text + ": needs XMIN,YMIN,XMAX,YMAX with XMIN < XMAX and YMIN < YMAX");
  options.window = CGAL::Bbox_2(bounds[0], bounds[1], bounds[2], bounds[3]);
}

void understand_outputs(const Raw_options& raw, Options& options)
{
  understand_window(raw.window, options);
  for(const std::string& path : raw.outputs)
    options.meshes.push_back(output_of(path));
  if(options.meshes.empty() && options.voronoi.empty() && options.stats.empty())
    options.stats = "-";
  if(!options.voronoi.empty() && extension_of(options.voronoi) != ".svg")
    throw Unusable_input("--voronoi " + options.voronoi + ": the extension is not .svg");

  std::set<std::string> paths;
  for(std::string path : raw.outputs)
    if(!paths.insert(path).second)
      throw Unusable_input("-o " + path + ": the same file twice");
  if(!options.voronoi.empty() && !paths.insert(options.voronoi).second)
    throw Unusable_input("--voronoi " + options.voronoi + ": the same file as -o");
  if(!options.stats.empty() && paths.count(options.stats) > 0)
    throw Unusable_input("--stats " + options.stats + ": the same file as another output");
}

void understand_domain(const Raw_options& raw, Options& options)
{
  options.domain_is_builtin = raw.domain.compare(0, builtin_prefix.size(), builtin_prefix) == 0;
  options.domain = options.domain_is_builtin ? raw.domain.substr(builtin_prefix.size()) : raw.domain;
  if(!options.domain_is_builtin && extension_of(raw.domain) != ".poly" && extension_of(raw.domain) != ".mesh")
    throw Unusable_input("\"" + raw.domain + "\": a domain is a file .poly or .mesh, or builtin:NAME");
}

// A way to give the metric: options that must come together, in the order in
// which they are used, and those of them that have a default.
struct Metric_group
{
  Metric_source                      source;
  std::vector<std::string>           options;
  std::map<std::string, std::string> defaults;
};

const std::vector<Metric_group>& metric_groups()
{
  static const std::vector<Metric_group> groups = {
    {Metric_source::SIZES,   {"--h1", "--h2", "--theta"},  {{"--theta", "0"}}},
    {Metric_source::ENTRIES, {"--m11", "--m12", "--m22"},  {{"--m12", "0"}}},
    {Metric_source::SIZE,    {"--size"},                   {}},
    {Metric_source::FILE,    {"--metric", "--background"}, {{"--background", ""}}}};
  return groups;
}

// the first option of the group that was given, empty if none was
std::string given_option(const Metric_group& group, const Raw_options& raw)
{
  for(const std::string& option : group.options)
    if(raw.metric.count(option) > 0)
      return option;
  return std::string();
}

const Metric_group* given_group(const Raw_options& raw)
{
  const Metric_group* given = nullptr;
  for(const Metric_group& group : metric_groups()) {
    const std::string option = given_option(group, raw);
    if(option.empty())
      continue;
    if(given != nullptr)
      throw Unusable_input(option + ": cannot be combined with " + given_option(*given, raw)
                           + ", as each of them gives the metric");
    given = &group;
  }
  return given;
}

Formula value_of(const std::string& option, const Metric_group& group, const Raw_options& raw)
{
  const auto value = raw.metric.find(option);
  if(value != raw.metric.end())
    return Formula{option, value->second};
  const auto preset = group.defaults.find(option);
  if(preset == group.defaults.end())
    throw Unusable_input(given_option(group, raw) + ": needs " + option + " too");
  return Formula{option, preset->second};
}

void understand_metric(const Raw_options& raw, Options& options)
{
  const Metric_group* group = given_group(raw);
  if(group == nullptr) {
    if(!options.domain_is_builtin)
      throw Unusable_input(raw.domain + ": no metric; give --h1 and --h2 (and --theta), --m11 and --m22 "
                           "(and --m12), --size, or --metric");
    return;
  }
  options.metric_source = group->source;
  for(const std::string& option : group->options)
    options.formulas.push_back(value_of(option, *group, raw));
  if(group->source != Metric_source::FILE)
    return;

  options.metric_file = options.formulas[0].text;
  options.background_file = options.formulas[1].text;
  options.formulas.clear();
  if(!options.background_file.empty())
    return;
  if(options.domain_is_builtin || extension_of(options.domain) != ".mesh")
    throw Unusable_input("--metric " + options.metric_file + ": needs --background, as the domain is not a .mesh");
  options.background_file = options.domain;
}

Verbosity verbosity_of(const Raw_options& raw)
{
  if(raw.quiet && raw.verbose)
    throw Unusable_input("--verbose: cannot be combined with --quiet");
  return raw.quiet ? Verbosity::QUIET : raw.verbose ? Verbosity::VERBOSE : Verbosity::NORMAL;
}

} // namespace

Options parse_options(int argc, const char* const* argv)
{
  Options options;
  Raw_options raw;
  CLI::App app("Anisotropic Delaunay meshes and anisotropic centroidal Voronoi tessellations of planar domains"
               " and of surfaces.",
               "anisotropic_mesh_2");
  app.add_option("DOMAIN", raw.domain,
                 "a file .poly or .mesh, or builtin:NAME (disc, square4, square10, layer10, parallelogram; "
                 "the surfaces ellipsoid, paraboloid, torus, saddle-sizes, saddle-curvature)")
    ->required()->type_name("");
  app.footer("Formulas have + - * / ^, comparisons, c ? a : b, pi, and the functions sin cos tan asin acos atan atan2\n"
             "sinh cosh tanh asinh acosh atanh exp log (natural) log10 log2 pow sqrt abs sign rint min max sum avg.\n"
             "The exit status is 0 when done, 1 if the work failed, 2 for arguments or input that cannot be used.\n\n"
             "Example: anisotropic_mesh_2 builtin:layer10 -o layer.mesh -o layer.svg --voronoi cells.svg --stats -");
  app.set_version_flag("--version", "anisotropic_mesh_2 " ANISOTROPIC_MESH_2_VERSION);
  declare_metric(app, raw, options.scale);
  declare_methods(app, options);
  declare_output(app, options, raw);
  try {
    app.parse(argc, argv);
  }
  catch(const CLI::CallForHelp&) {
    options.answer = app.help();
    return options;
  }
  catch(const CLI::CallForVersion& e) {
    options.answer = std::string(e.what()) + "\n";
    return options;
  }
  catch(const CLI::ExtrasError&) { // its message lists them backwards
    const std::string extra = app.remaining().front();
    const bool is_option = extra.compare(0, 1, "-") == 0;
    throw Unusable_input("\"" + extra + "\": " + (is_option ? "unknown option" : "one argument too many"));
  }
  catch(const CLI::ParseError& e) {
    throw Unusable_input(e.what());
  }
  understand_domain(raw, options);
  understand_metric(raw, options);
  understand_outputs(raw, options);
  options.verbosity = verbosity_of(raw);
  return options;
}

std::string extension_of(const std::string& path)
{
  const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
  if(dot == std::string::npos || (slash != std::string::npos && dot < slash))
    return std::string();
  std::string extension = path.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

std::string name_of_domain(const Options& options)
{
  return options.domain_is_builtin ? builtin_prefix + options.domain : options.domain;
}

std::string name_of_metric(const Options& options)
{
  switch(options.metric_source) {
  case Metric_source::BUILTIN: return name_of_domain(options);
  case Metric_source::SIZES:   return "--h1, --h2, --theta";
  case Metric_source::ENTRIES: return "--m11, --m12, --m22";
  case Metric_source::SIZE:    return "--size";
  case Metric_source::FILE:    return "--metric " + options.metric_file;
  }
  return "the metric";
}

} // namespace program

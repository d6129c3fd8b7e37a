// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output.h"

#include "Safe_output_file.h"

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/IO/VTU.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

namespace program {

namespace {

typedef nlohmann::ordered_json  Json;

void check_output(const std::string& option, const std::string& path)
{
  try {
    Safe_output_file unused(path);
  }
  catch(const CGAL::Mesh_io_exception& e) {
    throw Unusable_input(option + " " + e.what());
  }
}

void write_mesh(const Mesh& mesh, const Output& output, const CGAL::Bbox_2& window)
{
  write_safely(output.path, [&](std::ostream& os) {
    switch(output.format) {
    case File_format::MESH: return CGAL::IO::write_MEDIT(os, mesh);
    case File_format::VTU:  return CGAL::IO::write_VTU(os, mesh);
    case File_format::OFF:  return CGAL::IO::write_OFF(os, mesh);
    case File_format::SVG:  return CGAL::IO::write_SVG(os, mesh, "", window);
    case File_format::PLY:  break; // refused before
    }
  });
}

template <class Statistics>
Json json_of(const Statistics& statistics, const Run_report& report)
{
  Json json;
  statistics.for_each([&](const char* name, const auto& value) { json[name] = value; });
  json["iterations"] = report.iterations;
  json["stop_reason"] = report.stop_reason;
  json["seconds_mesh"] = report.seconds_mesh;
  json["seconds_optimize"] = report.seconds_optimize;
  return json;
}

// JSON has no word for what is not finite.
void check_finite(const Json& statistics)
{
  for(const auto& entry : statistics.items())
    if(entry.value().is_number_float() && !std::isfinite(entry.value().get<double>()))
      throw std::runtime_error("the statistics are not finite: " + entry.key());
}

void write_json(const std::string& path, const Json& statistics)
{
  check_finite(statistics);
  const std::string text = statistics.dump(2) + "\n";
  if(path == "-") {
    std::cout << text << std::flush;
    if(!std::cout)
      throw std::runtime_error("standard output: cannot be written");
    return;
  }
  write_safely(path, [&](std::ostream& os) { os << text; });
}

} // namespace

void check_outputs(const Options& options)
{
  for(const Output& output : options.meshes)
    check_output("-o", output.path);
  if(!options.voronoi.empty())
    check_output("--voronoi", options.voronoi);
  if(!options.stats.empty() && options.stats != "-")
    check_output("--stats", options.stats);
}

void check_planar_outputs(const Options& options)
{
  for(const Output& output : options.meshes)
    if(output.format == File_format::PLY)
      throw Unusable_input("-o " + output.path + ": only surfaces are written as .ply");
}

void write_statistics(const std::string& path, const CGAL::Anisotropic_mesh_2::Surface_mesh_statistics& statistics,
                      const Run_report& report)
{
  write_json(path, json_of(statistics, report));
}

void write_outputs(const Mesh& mesh, const Options& options, const Run_report& report)
{
  for(const Output& output : options.meshes)
    write_mesh(mesh, output, options.window);
  if(!options.voronoi.empty())
    write_safely(options.voronoi, [&](std::ostream& os) {
      typedef CGAL::Anisotropic_mesh_2::Directional_distance_2 Distance;
      CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
      drawing.window = options.window;
      CGAL::IO::write_SVG(os, CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Distance, Concurrency_tag>(mesh, {}, 1e-3), "",
                          drawing);
    });
  if(!options.stats.empty())
    write_json(options.stats, json_of(statistics(mesh, options), report));
}

} // namespace program

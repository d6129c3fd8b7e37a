// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The formulas of the program, each on a line.

#include "require.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <Formula_metric_field.h>

#include <sstream>
#include <string>

using program::Formula;
using program::Formula_metric_field;

void evaluate(const Formula_metric_field& field)
{
  for(double x : {0., 0.5, -1e300})
    try {
      field(program::Point_2(x, 1 - x));
    }
    catch(const CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception& e) {
      require_readable(e.what());
    }
}

template <class Construct>
void evaluate_or_refuse(const Construct& construct)
{
  try {
    evaluate(construct());
  }
  catch(const program::Formula_error& e) {
    require(std::string(e.what()).find("--") == 0, "the option first: " + std::string(e.what()));
  }
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream lines(std::string(data, data + size));
  Formula f[3] = {{"--h1", ""}, {"--h2", ""}, {"--theta", ""}};
  for(Formula& formula : f)
    std::getline(lines, formula.text);
  evaluate_or_refuse([&f] { return Formula_metric_field::from_size(f[0]); });
  evaluate_or_refuse([&f] { return Formula_metric_field::from_sizes(f[0], f[1], f[2]); });
  evaluate_or_refuse([&f] { return Formula_metric_field::from_entries(f[0], f[1], f[2]); });
  return 0;
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// .sol files behind a line "---", with the .mesh file of their background before it.

#include "reader.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Discrete_metric_field_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>  Graph;
typedef CGAL::Discrete_metric_field_2<Kernel>                           Field;
typedef CGAL::Metric_tensor_2<Kernel>                                   Tensor;

double log_density(const Tensor& m)
{
  const auto logarithm = m.logarithm();
  return (logarithm[0] + logarithm[2]) / 2;
}

// What Metric_tensor_2 promises to resolve.
bool is_ordinary(const Tensor& m)
{
  const Tensor::Sizes s = m.sizes();
  return s.h1 > 1e-75 && s.h2 < 1e75 && s.h2 < 1e7 * s.h1;
}

std::vector<Kernel::Point_2> places(const Graph& background)
{
  std::vector<Kernel::Point_2> points = {{0, 0}, {0.25, 0.5}, {-3, 1e-200}, {1e100, -1e100}, {-1e300, 1e300}};
  for(const auto& t : background.triangles) {
    const auto &p = background.points[t[0]], &q = background.points[t[1]], &r = background.points[t[2]];
    points.push_back(p);
    points.push_back({p.x()/2 + q.x()/2, p.y()/2 + q.y()/2});
    points.push_back({p.x()/4 + q.x()/4 + r.x()/2, p.y()/4 + q.y()/4 + r.y()/2});
  }
  return points;
}

// Interpolated tensors are tensors, as large as those that were given.
void evaluate(const Graph& background, const std::vector<Tensor>& tensors)
{
  const Field field(background, tensors);
  if(!std::all_of(tensors.begin(), tensors.end(), is_ordinary))
    return;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for(const Tensor& m : tensors) {
    least = (std::min)(least, log_density(m));
    largest = (std::max)(largest, log_density(m));
  }
  for(const auto& p : places(background)) {
    const double density = log_density(field(p));
    require(density >= least - 1e-2 && density <= largest + 1e-2, "a tensor between those that were given");
  }
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Input_files files(data, size, {"input.mesh", "input.sol"});
  const auto tensors = read_or_refuse(files, [&] { return CGAL::IO::read_MEDIT_metric<Kernel>(files[1]); });
  if(!tensors)
    return 0;
  const std::string again = Input_files::directory() / "again.sol";
  CGAL::IO::write_MEDIT_metric(again, *tensors);
  require(*tensors == CGAL::IO::read_MEDIT_metric<Kernel>(again), "the same tensors, written and read again");

  const auto background = read_or_refuse(files, [&] { return CGAL::IO::read_MEDIT<Kernel>(files[0]); });
  if(background)
    try {
      evaluate(*background, *tensors);
    }
    catch(const CGAL::Anisotropic_mesh_2::Invalid_triangle_mesh_exception& e) {
      require_readable(e.what());
    }
  return 0;
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: they chain in any order, with those of CGAL too, and their values arrive.

#include "check.h"

#include <CGAL/Anisotropic_mesh_2/parameters.h>

#include <functional>
#include <string>

using namespace CGAL::Anisotropic_mesh_2::internal;
namespace np = CGAL::Anisotropic_mesh_2::parameters;
namespace internal_np = CGAL::internal_np;

// the value of a name in a list, -1 if it is not there; lists are taken as functions of CGAL take them
template <class Tag, class CGAL_NP_TEMPLATE_PARAMETERS>
int value(const CGAL_NP_CLASS& list = CGAL::parameters::default_values())
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(list, Tag()), -1);
}

// the name alone, first and last in a chain with others, and before a list of CGAL
template <class Tag, class Name, class Append>
void test_name(const std::string& name, const Name& parameter, const Append& append)
{
  CHECK_MSG(value<Tag>() == -1, name);
  CHECK_MSG(value<Tag>(parameter(1)) == 1, name);
  const auto first = parameter(2).number_of_iterations(10).measure(11).vertex_point_map(12);
  CHECK_MSG(value<internal_np::number_of_iterations_t>(first) == 10 && value<measure_t>(first) == 11
            && value<internal_np::vertex_point_t>(first) == 12, name);
  const auto last = append(np::measure(20).maximum_running_time(21), 3);
  CHECK_MSG(value<Tag>(last) == 3, name);
  const auto before = append(np::convergence(30, CGAL::parameters::vertex_point_map(31)), 4).point_placement(32);
  CHECK_MSG(value<Tag>(before) == 4 || value<Tag>(before) == 32, name);
  CHECK_MSG(value<internal_np::vertex_point_t>(before) == 31 && value<point_placement_t>(before) == 32, name);
  CHECK_MSG(value<Tag>(parameter(5, CGAL::parameters::vertex_point_map(31))) == 5, name);
}

void test_names()
{
  test_name<convergence_t>("convergence", np::convergence, [](const auto& l, int v) { return l.convergence(v); });
  test_name<energy_reduction_t>("energy_reduction", np::energy_reduction,
                                [](const auto& l, int v) { return l.energy_reduction(v); });
  test_name<keep_boundary_points_t>("keep_boundary_points", np::keep_boundary_points,
                                    [](const auto& l, int v) { return l.keep_boundary_points(v); });
  test_name<maximum_number_of_vertices_t>("maximum_number_of_vertices", np::maximum_number_of_vertices,
                                          [](const auto& l, int v) { return l.maximum_number_of_vertices(v); });
  test_name<internal_np::maximum_running_time_t>("maximum_running_time", np::maximum_running_time,
                                                 [](const auto& l, int v) { return l.maximum_running_time(v); });
  test_name<measure_t>("measure", np::measure, [](const auto& l, int v) { return l.measure(v); });
  test_name<internal_np::number_of_iterations_t>("number_of_iterations", np::number_of_iterations,
                                                 [](const auto& l, int v) { return l.number_of_iterations(v); });
  test_name<point_placement_t>("point_placement", np::point_placement,
                               [](const auto& l, int v) { return l.point_placement(v); });
  test_name<quality_moves_t>("quality_moves", np::quality_moves, [](const auto& l, int v) { return l.quality_moves(v); });
  test_name<region_evaluation_t>("region_evaluation", np::region_evaluation,
                                 [](const auto& l, int v) { return l.region_evaluation(v); });
  test_name<internal_np::verbose_t>("verbose", np::verbose, [](const auto& l, int v) { return l.verbose(v); });
  test_name<internal_np::vertex_is_constrained_t>("vertex_is_constrained_map", np::vertex_is_constrained_map,
                                                  [](const auto& l, int v) { return l.vertex_is_constrained_map(v); });
  test_name<internal_np::visitor_t>("visitor", np::visitor, [](const auto& l, int v) { return l.visitor(v); });
}

// CGAL's own names begin a list as well, and a value may be held by reference.
void test_values()
{
  CHECK(value<internal_np::number_of_iterations_t>(CGAL::parameters::number_of_iterations(6)) == 6);
  int seen = 7;
  const auto list = np::visitor(std::ref(seen)).measure(8);
  seen = 9;
  CHECK(CGAL::parameters::get_parameter_reference(list, internal_np::visitor) == 9);
}

int main()
{
  test_names();
  test_values();
  return finish();
}

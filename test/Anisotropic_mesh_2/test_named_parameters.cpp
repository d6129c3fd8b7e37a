// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: they chain in any order, with those of CGAL too, and their values arrive.

#include "check.h"
#include "Recording_visitor.h"
#include "meshes.h"

#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/improve_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

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
  test_name<method_t>("method", np::method, [](const auto& l, int v) { return l.method(v); });
  test_name<internal_np::number_of_iterations_t>("number_of_iterations", np::number_of_iterations,
                                                 [](const auto& l, int v) { return l.number_of_iterations(v); });
  test_name<point_placement_t>("point_placement", np::point_placement,
                               [](const auto& l, int v) { return l.point_placement(v); });
  test_name<quality_moves_t>("quality_moves", np::quality_moves, [](const auto& l, int v) { return l.quality_moves(v); });
  test_name<region_evaluation_t>("region_evaluation", np::region_evaluation,
                                 [](const auto& l, int v) { return l.region_evaluation(v); });
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

std::vector<Point> points_of(const Mesh& mesh)
{
  return std::vector<Point>(mesh.points_begin(), mesh.points_end());
}

std::size_t number_of_constrained_edges(const Mesh& mesh)
{
  return std::size_t(std::distance(mesh.constrained_edges_begin(), mesh.constrained_edges_end()));
}

void test_parameters_of_meshers()
{
  using CGAL::Anisotropic_mesh_2::Point_placement;
  const Case c = paper_cases()[1];
  const Mesh plain = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  CHECK(number_of_constrained_edges(CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::keep_boundary_points(true))) == 4);
  CHECK(number_of_constrained_edges(plain) > 20);
  CHECK(points_of(CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::point_placement(Point_placement::ADVANCING_FRONT)))
        == points_of(plain));
  CHECK(points_of(CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::point_placement(Point_placement::EDGE_SUBDIVISION)))
        != points_of(plain));
  const std::size_t n = plain.number_of_vertices();
  CHECK(CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::maximum_number_of_vertices(n)).number_of_vertices() == n);
  try {
    CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::maximum_number_of_vertices(n - 1));
    CHECK_MSG(false, "more vertices than allowed");
  }
  catch(const CGAL::Anisotropic_mesh_2::Too_many_vertices_exception& e) {
    CHECK(e.limit() == n - 1);
  }
}

// A mesh is copied and optimized; what is returned agrees with what a visitor has seen last, or of the mesh that was
// kept because it is better.
template <class NamedParameters>
CGAL::Anisotropic_mesh_2::Optimization_result optimized(Mesh mesh, const NamedParameters& parameters)
{
  std::vector<CGAL::Anisotropic_mesh_2::Optimization_state> states;
  const auto result = CGAL::optimize_anisotropic_mesh_2(mesh, parameters.visitor(Recording_visitor(states)));
  CHECK(states.size() == result.iterations + 1 && states.back().iteration == result.iterations);
  CHECK(std::any_of(states.begin(), states.end(), [&](const auto& s) {
          return s.energy == result.energy && s.largest_move == result.largest_move;
        }));
  CHECK(states.back().evaluations == result.evaluations && mesh.is_valid());
  for(std::size_t i = 0; i + 1 < states.size() && result.return_code == CGAL::CONVERGENCE_REACHED; ++i)
    CHECK(states[i].largest_move > result.largest_move);
  return result;
}

void test_criteria()
{
  const Case c = paper_cases()[1];
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const auto endless = np::convergence(0.).energy_reduction(0.);
  const auto five = optimized(mesh, endless.number_of_iterations(5));
  CHECK(five.iterations == 5 && five.return_code == CGAL::MAX_ITERATION_NUMBER_REACHED);
  const auto near = optimized(mesh, np::convergence(0.03));
  CHECK(near.return_code == CGAL::CONVERGENCE_REACHED && near.largest_move <= 0.03);
  // the energy never falls to a half, and at the first iterate begins the count of five more
  const auto half = optimized(mesh, np::convergence(0.).energy_reduction(0.5));
  CHECK(half.return_code == CGAL::CANT_IMPROVE_ANYMORE && half.iterations == 7);
  const auto brief = optimized(mesh, endless.maximum_running_time(1e-9));
  CHECK(brief.return_code == CGAL::TIME_LIMIT_REACHED && brief.iterations == 0);
  const auto slow = optimized(mesh, lloyd_method.convergence(0.).number_of_iterations(20));
  CHECK(slow.evaluations == 21 && slow.return_code == CGAL::MAX_ITERATION_NUMBER_REACHED);
  CHECK(slow.energy > optimized(mesh, endless.number_of_iterations(20)).energy);
}

// In a constant metric, the energies of both measures differ by the root of its determinant.
void test_measure()
{
  using CGAL::Anisotropic_mesh_2::Measure;
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), Field([](const Point&) { return Tensor::from_sizes(0.1, 0.4); }));
  const auto none = np::number_of_iterations(0);
  const double riemannian = optimized(mesh, none).energy;
  CHECK(std::abs(riemannian / optimized(mesh, none.measure(Measure::LEBESGUE)).energy - 25) < 1e-9);
  CHECK(optimized(mesh, none.measure(Measure::RIEMANNIAN)).energy == riemannian);
}

void test_quality_moves()
{
  const Case c = unit_square_cases()[2];
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const auto few = np::number_of_iterations(5);
  CHECK(optimized(mesh, few.quality_moves(false)).quality.trials == 0);
  CHECK(optimized(mesh, few.method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)).quality.trials == 0);
  const auto brief = CGAL::improve_anisotropic_mesh_2(mesh, np::maximum_running_time(1e-9));
  const auto both = CGAL::optimize_anisotropic_mesh_2(mesh, few);
  CHECK(both.quality.improvements > 0 && both.quality.trials >= both.quality.improvements);
  CHECK(brief.return_code == CGAL::TIME_LIMIT_REACHED && brief.trials == 0);
  std::ostringstream os;
  os << brief;
  CHECK_MSG(os.str() == "time limit after 0 trials with 0 improvements", os.str());
}

int main()
{
  test_names();
  test_values();
  test_parameters_of_meshers();
  test_criteria();
  test_measure();
  test_quality_moves();
  return finish();
}

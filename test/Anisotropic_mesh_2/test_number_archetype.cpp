// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Domains, fields, files and meshes over a kernel of CGAL whose number type has
// the least that is promised.

#include "include/archetypes/Number_archetype.h"
#include "include/check.h"
#include "include/concept_checks.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/Oriented_sizes_metric_field_2.h>
#include <CGAL/Discrete_metric_field_2.h>
#include <CGAL/Gradient_metric_field_2.h>
#include <CGAL/Hessian_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mass_centre_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/anisotropic_visibility_region_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>
#include <CGAL/approximation_error_2.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

typedef CGAL::Simple_cartesian<Number_archetype>                   K;
typedef K::FT                                                      FT;
typedef K::Point_2                                                 Point;
typedef CGAL::Metric_tensor_2<K>                                   Tensor;
typedef CGAL::Anisotropic_mesh_2::Curve_piece_2<K>                                     Piece;
typedef CGAL::Anisotropic_mesh_domain_2<K>                         Domain;
typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K>  Graph;

static_assert(models_riemannian_metric_traits<
                CGAL::Riemannian_metric_traits_2<K, CGAL::Constant_metric_field_2<K> > >(), "");

void test_tensor()
{
  const Tensor m = Tensor::from_sizes(FT(0.5), 2, 0.25);
  CHECK(std::abs(CGAL::to_double(m.determinant()) - 1) < 1e-12 && std::abs(m.sizes().h1 - 0.5) < 1e-12);
  CHECK(std::abs(Tensor::from_logarithm(m.logarithm()).sizes().h2 - 2) < 1e-12);
  CHECK(m.squared_length(K::Vector_2(1, 0)) == m.m11() && m.scaled(2).m22() == m.m22() / 4);
  CHECK(m.scalar_product(K::Vector_2(1, 0), K::Vector_2(0, 1)) == m.m12() && m != Tensor());
  CHECK_THROWS(Tensor::from_entries(1, 2, 1), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "positive definite");
}

// [0, 4] x [0, 4] with a hole, a bulge, and inner curves
Domain domain()
{
  Domain domain;
  domain.add_loop(std::vector<Piece>{
    Piece::segment(Point(0, 0), Point(4, 0)),
    Piece::parametrized([](double t) { return Point(FT(4 + t*(1 - t)), FT(4*t)); }, 0, 1),
    Piece::segment(Point(4, 4), Point(0, 4)), Piece::segment(Point(0, 4), Point(0, 0))});
  domain.add_circle(Point(2, 2), FT(0.5));
  domain.add_polyline(std::vector<Point>{Point(1, 1), Point(1, 3)});
  domain.add_constraint(Piece::arc(Point(3, 3), FT(0.25), 0, 1));
  domain.add_region(Point(FT(0.5), FT(0.5)), 7);
  domain.validate();
  return domain;
}

template <class Field>
void test_mesh(const Domain& domain, const Field& field)
{
  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CHECK(mesh.is_valid(true) && mesh.number_of_vertices() > 20);
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(3));
  const auto lloyd_method = CGAL::Anisotropic_mesh_2::parameters::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD);
  CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.number_of_iterations(3));
  CGAL::optimize_anisotropic_mesh_2
    (mesh, CGAL::Anisotropic_mesh_2::parameters::region_evaluation
             (CGAL::Anisotropic_mesh_2::Region_evaluation::VISIBILITY_REGIONS)
             .number_of_iterations(1).method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD));
  CGAL::optimize_anisotropic_mesh_2
    (mesh, CGAL::Anisotropic_mesh_2::parameters::region_evaluation
             (CGAL::Anisotropic_mesh_2::Region_evaluation::FULL_REGIONS)
             .number_of_iterations(1).method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD));
  CHECK(mesh.is_valid(true));
  CHECK(CGAL::anisotropic_mesh_statistics_2(mesh).quality_mean > 0.7);
  const CGAL::Anisotropic_Voronoi_diagram_2<decltype(mesh)> diagram(mesh);
  CHECK(diagram.number_of_regions() == mesh.number_of_vertices());
  for(auto v : mesh.finite_vertex_handles()) {
    CHECK(!CGAL::anisotropic_visibility_region_2(mesh, v).empty());
    const Point centre = CGAL::anisotropic_mass_centre_2(mesh, v, CGAL::Anisotropic_mesh_2::Measure::LEBESGUE);
    CHECK(CGAL::to_double(v->metric_tensor().squared_length(centre - v->point())) < 2);
  }
  CHECK(CGAL::piecewise_linear_approximation_error_2(mesh, [](const Point& p) { return p.x() * p.x(); }).l2 > 0);
  std::ostringstream os;
  CGAL::IO::write_SVG(os, mesh);
  CGAL::IO::write_SVG(os, diagram);
  CGAL::IO::write_MEDIT(os, mesh);
  CGAL::IO::write_MEDIT_metric(os, mesh);
  CHECK(os.str().find("SolAtVertices") != std::string::npos);
}

void test_fields()
{
  test_mesh(domain(), CGAL::make_isotropic_metric_field_2<K>([](const Point& p) { return FT(0.5) + p.x() / 8; }));
  test_mesh(domain(), CGAL::make_oriented_sizes_metric_field_2<K>([](const Point& p) {
    return std::array<double, 3>{0.5, 0.5 + CGAL::to_double(p.y()) / 8, 0.5};
  }));
  const auto gradient = CGAL::make_gradient_metric_field_2<K>(
    [](const Point& p) { return std::array<FT, 2>{p.x(), p.y()}; }, 1, 0.5);
  const auto hessian = CGAL::make_hessian_metric_field_2<K>(
    [](const Point& p) { return std::array<FT, 3>{p.x(), FT(0), p.y()}; }, 0.5, 0.1, 2);
  CHECK(std::abs(CGAL::to_double(gradient(Point(1, 2)).m12()) - 8) < 1e-12);
  CHECK(std::abs(CGAL::to_double(hessian(Point(1, 2)).m22()) - 4) < 1e-12);
}

// a square as two triangles
Graph graph()
{
  Graph graph;
  graph.points = {Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4)};
  graph.edges = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  graph.triangles = {{0, 1, 2}, {0, 2, 3}};
  graph.regions = {{Point(1, 1), 3}};
  return graph;
}

void test_files()
{
  const Scratch_directory scratch;
  CGAL::IO::write_MEDIT(scratch / "square.mesh", graph());
  CGAL::IO::write_POLY(scratch / "square.poly", graph());
  CGAL::IO::write_MEDIT_metric(scratch / "square.sol", std::vector<Tensor>(4, Tensor::from_size(FT(0.5))));
  const Graph background = CGAL::IO::read_MEDIT<K>(scratch / "square.mesh");
  const CGAL::Discrete_metric_field_2<K> field(background, CGAL::IO::read_MEDIT_metric<K>(scratch / "square.sol"));
  CHECK(CGAL::to_double(field(Point(1, 2)).m11()) > 3.99);
  CHECK(Domain(CGAL::IO::read_POLY<K>(scratch / "square.poly")).number_of_pieces() == 4);
  test_mesh(Domain(background), field);
}

int main()
{
  test_tensor();
  test_fields();
  test_files();
  return finish();
}

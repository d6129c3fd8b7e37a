// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors of piecewise constant and of piecewise linear approximations: integrals
// in closed form, orders of convergence, and what the metrics promise.

#include "check.h"
#include "marked_triangulation.h"
#include "meshes.h"

#include <CGAL/Gradient_metric_field_2.h>
#include <CGAL/Hessian_metric_field_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/approximation_error_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Approximation_error;
using CGAL::Anisotropic_mesh_2::Measure;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

bool are_close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

// ---------------------------------------------------------------- the quadrature

double factorial(int n) { return n == 0 ? 1 : n * factorial(n - 1); }

// On the triangle (0, 0), (1, 0), (0, 1) the integral of x^i y^j is i! j! / (i + j + 2)!.
void test_quadrature()
{
  for(int i = 0; i <= 7; ++i)
    for(int j = 0; i + j <= 7; ++j) {
      const auto monomial = [=](double x, double y) { return std::pow(x, i) * std::pow(y, j); };
      const double exact = factorial(i) * factorial(j) / factorial(i + j + 2);
      Adaptive_triangle_integral<decltype(monomial)> integral(monomial, 1e-10, 100000, 24, 1e-10 * exact);
      if(i + j <= 5)
        CHECK(are_close(integral.rule({{{0, 0}, {1, 0}, {0, 1}}}), exact, 1e-14));
      CHECK(are_close(integral({{{0, 0}, {1, 0}, {0, 1}}}), exact, 1e-9));
    }
}

// what is not refined, and how far the rest is
void test_effort_of_quadrature()
{
  long calls = 0;
  const auto jump = [&calls](double x, double) { ++calls; return x < 0.3 ? 1. : 0.; };
  typedef Adaptive_triangle_integral<decltype(jump)> Integral;
  const Integral::Triangle t = {{{0, 0}, {1, 0}, {0, 1}}};
  CHECK(are_close(Integral(jump, 1e-9, 1000000, 10)(t), (1 - 0.49) / 2, 1e-3));
  CHECK(calls > 10000 && calls < 100000);
  calls = 0;
  Integral(jump, 1e-9, 1000000, 10, 2)(t); // the jump is negligible
  CHECK(calls == 7 + 28);
  calls = 0;
  Integral(jump, 1e-9, 10, 10)(t);
  CHECK(calls == 7 + 10*28);
}

// ---------------------------------------------------------------- piecewise linear approximations

// the unit square in n*n squares of two triangles
Marked_cdt square_mesh(int n)
{
  Marked_cdt cdt;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      cdt.insert(Point(double(i) / n, double(j) / n));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    f->set_in_domain(true);
  return cdt;
}

double smooth(const Point& p) { return std::exp(p.x()) * std::sin(3 * p.y()); }

void test_linear_in_closed_form()
{
  const auto mesh = square_mesh(4);
  const double h = 0.25;
  const Approximation_error parabola
    = CGAL::piecewise_linear_approximation_error_2(mesh, [](const Point& p) { return p.x() * p.x(); });
  CHECK(are_close(parabola.l2, h*h / std::sqrt(30.), 1e-12));
  CHECK(are_close(parabola.largest, h*h / 4, 1e-12));
  const Approximation_error plane
    = CGAL::piecewise_linear_approximation_error_2(mesh, [](const Point& p) { return 1e9 * (1 + p.x() - 3*p.y()); });
  CHECK(plane.l2 < 1e-5 && plane.largest < 1e-5);
}

// only what is in the domain counts
void test_linear_in_domain()
{
  auto mesh = square_mesh(4);
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    f->set_in_domain(CGAL::centroid(mesh.triangle(f)).x() < 0.25);
  const auto f = [](const Point& p) { return p.x() < 0.25 ? p.x() * p.x() : 7 * std::exp(p.y()); };
  const auto g = [](const Point& p) { return p.x() <= 0.25 ? p.x() * p.x() : 7 * std::exp(p.y()); };
  CHECK(CGAL::piecewise_linear_approximation_error_2(mesh, f).largest > 1); // at the border
  CHECK(are_close(CGAL::piecewise_linear_approximation_error_2(mesh, g).l2, 0.0625 / std::sqrt(120.), 1e-12));
  for(auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face)
    face->set_in_domain(false);
  CHECK(CGAL::piecewise_linear_approximation_error_2(mesh, f).l2 == 0);
}

void test_tolerance()
{
  const auto mesh = square_mesh(2);
  const double exact = CGAL::piecewise_linear_approximation_error_2(mesh, smooth, 1e-12).l2;
  CHECK(are_close(CGAL::piecewise_linear_approximation_error_2(mesh, smooth).l2, exact, 1e-5));
  // a layer thinner than the faces
  const auto step = [](const Point& p) { return std::tanh((p.y() - 0.37) * 50); };
  const double tight = CGAL::piecewise_linear_approximation_error_2(mesh, step, 1e-8).l2;
  CHECK(are_close(CGAL::piecewise_linear_approximation_error_2(mesh, step).l2, tight, 1e-5));
}

// ---------------------------------------------------------------- piecewise constant approximations

struct Region
{
  Point                              generator;
  std::vector<std::array<Point, 3> > tiles;
};

// what `piecewise_constant_approximation_error_2()` asks of a diagram, and no more
struct Diagram
{
  std::vector<Region> regions;

  std::size_t number_of_regions() const { return regions.size(); }
  const Region& region(std::size_t i) const { return regions[i]; }
};

// the unit square in n*n squares around their generators
Diagram squares(int n)
{
  const double h = 1. / n;
  Diagram diagram;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const Point a(i*h, j*h), b(i*h + h, j*h), c(i*h + h, j*h + h), d(i*h, j*h + h);
      diagram.regions.push_back({Point(i*h + h/2, j*h + h/2), {{a, b, c}, {a, c, d}}});
    }
  return diagram;
}

template <class Mesh>
CGAL::Anisotropic_Voronoi_diagram_2<Mesh> regions(const Mesh& mesh)
{
  return CGAL::Anisotropic_Voronoi_diagram_2<Mesh>(mesh, {}, 1e-3);
}

void test_constant_in_closed_form()
{
  const int n = 5;
  const double h = 1. / n;
  const Approximation_error linear
    = CGAL::piecewise_constant_approximation_error_2(squares(n), [](const Point& p) { return 3 * p.x(); });
  CHECK(are_close(linear.l2, 3 * h / std::sqrt(12.), 1e-12));
  CHECK(are_close(linear.largest, 3 * h/2, 1e-12));

  const Approximation_error parabola
    = CGAL::piecewise_constant_approximation_error_2(squares(n), [](const Point& p) { return p.x() * p.x(); });
  double squared = 0; // with x = c + t, the integral of (2ct + t^2)^2
  for(int i = 0; i < n; ++i)
    squared += 4 * std::pow(i*h + h/2, 2) * std::pow(h, 3) / 12 + std::pow(h, 5) / 80;
  CHECK(are_close(parabola.l2, std::sqrt(squared), 1e-12));
  CHECK(are_close(parabola.largest, 1 - std::pow(1 - h/2, 2), 1e-12));

  const auto jump = [](const Point& p) { return p.x() < 0.3 ? 1 : 0; };
  CHECK(are_close(CGAL::piecewise_constant_approximation_error_2(squares(1), jump).l2, std::sqrt(0.3), 1e-3));
  CHECK(CGAL::piecewise_constant_approximation_error_2(squares(1), jump).largest == 1);
  CHECK(CGAL::piecewise_constant_approximation_error_2(squares(n), [](const Point&) { return 1e9; }).l2 == 0);
  CHECK(CGAL::piecewise_constant_approximation_error_2(Diagram(), smooth).l2 == 0);
}

// Each refinement halves the error, or quarters it.
void test_orders()
{
  for(int n : {8, 16, 32}) {
    const Approximation_error constant = CGAL::piecewise_constant_approximation_error_2(squares(n), smooth);
    const Approximation_error finer = CGAL::piecewise_constant_approximation_error_2(squares(2*n), smooth);
    CHECK_MSG(std::abs(std::log2(constant.l2 / finer.l2) - 1) < 0.02, std::to_string(constant.l2 / finer.l2));
    CHECK(std::abs(std::log2(constant.largest / finer.largest) - 1) < 0.1);
    const Approximation_error linear = CGAL::piecewise_linear_approximation_error_2(square_mesh(n), smooth);
    const Approximation_error fine = CGAL::piecewise_linear_approximation_error_2(square_mesh(2*n), smooth);
    CHECK_MSG(std::abs(std::log2(linear.l2 / fine.l2) - 2) < 0.02, std::to_string(linear.l2 / fine.l2));
    CHECK(std::abs(std::log2(linear.largest / fine.largest) - 2) < 0.2);
  }
}

// ---------------------------------------------------------------- metrics of functions

// a layer with its derivatives
double layer(const Point& p) { return std::tanh(10 * (p.x() + p.y()/2 - 0.7)); }

std::array<double, 2> gradient_of_layer(const Point& p)
{
  const double slope = 10 * (1 - layer(p) * layer(p));
  return {slope, slope / 2};
}

std::array<double, 3> hessian_of_layer(const Point& p)
{
  const double second = -200 * layer(p) * (1 - layer(p) * layer(p));
  return {second, second / 2, second / 4};
}

Mesh optimized(const Field& field, Measure measure)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::measure(measure).number_of_iterations(30));
  return mesh;
}

// (2.4): to first order, the squared error is at most the energy; and it is not much less. With regions as large as the
// layer the function turns within them, and there is no such bound.
void test_bound()
{
  for(double e : {0.1, 0.05}) {
    const Mesh mesh = optimized(CGAL::make_gradient_metric_field_2<K>(gradient_of_layer, 0.1, e), Measure::LEBESGUE);
    const double error = CGAL::piecewise_constant_approximation_error_2(regions(mesh), layer).l2;
    const double bound = e*e * CGAL::anisotropic_mesh_statistics_2(mesh, Measure::LEBESGUE).energy;
    const double ratio = error * error / bound;
    std::cout << mesh.number_of_vertices() << " vertices: squared error over its bound: " << ratio << std::endl;
    CHECK_MSG(ratio > 0.3 && ratio < 1, std::to_string(ratio));
  }
}

// the error of adapted generators or vertices against that of at least as many uniform ones
void test_gain()
{
  const Mesh generators = optimized(CGAL::make_gradient_metric_field_2<K>(gradient_of_layer, 0.1, 0.1, 2),
                                    Measure::RIEMANNIAN);
  const Mesh vertices = optimized(CGAL::make_hessian_metric_field_2<K>(hessian_of_layer, 0.02, 1e-3, 0.5, 2),
                                  Measure::RIEMANNIAN);
  const std::size_t n = (std::max)(generators.number_of_vertices(), vertices.number_of_vertices());
  const double h = 1 / std::sqrt(n * std::sqrt(0.75));
  const Mesh uniform = optimized([h](const Point&) { return Tensor::from_size(h); }, Measure::RIEMANNIAN);
  CHECK(uniform.number_of_vertices() >= n);
  const double constant_gain = CGAL::piecewise_constant_approximation_error_2(regions(uniform), layer).l2
                             / CGAL::piecewise_constant_approximation_error_2(regions(generators), layer).l2;
  const double linear_gain = CGAL::piecewise_linear_approximation_error_2(uniform, layer).l2
                           / CGAL::piecewise_linear_approximation_error_2(vertices, layer).l2;
  std::cout << generators.number_of_vertices() << " generators: " << constant_gain << " times better; "
            << vertices.number_of_vertices() << " vertices: " << linear_gain << "; of " << n << std::endl;
  CHECK_MSG(constant_gain > 2, std::to_string(constant_gain));
  CHECK_MSG(linear_gain > 4, std::to_string(linear_gain));
}

int main()
{
  test_quadrature();
  test_effort_of_quadrature();
  test_linear_in_closed_form();
  test_linear_in_domain();
  test_tolerance();
  test_constant_in_closed_form();
  test_orders();
  test_bound();
  test_gain();
  return finish();
}

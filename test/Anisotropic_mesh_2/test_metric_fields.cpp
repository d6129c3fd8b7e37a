// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The metric fields; the discrete one against a search through all triangles; and what samples of a field tell.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Control_space.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Oriented_sizes_metric_field_2.h>
#include <CGAL/Discrete_metric_field_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gradient_metric_field_2.h>
#include <CGAL/Hessian_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Random.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

using CGAL::Anisotropic_mesh_2::Invalid_triangle_mesh_exception;
typedef CGAL::Exact_predicates_inexact_constructions_kernel             Kernel;
typedef Kernel::Point_2                                                 Point;
typedef CGAL::Metric_tensor_2<Kernel>                                   Tensor;
typedef CGAL::Discrete_metric_field_2<Kernel>                           Discrete;
typedef Discrete::Background                                            Background;
typedef CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception                           Invalid;

struct Sizes { double h1, h2, angle; };

bool are_close(const Tensor& m, const Tensor& n, double tolerance)
{
  const double size = n.m11() + n.m22();
  return std::abs(m.m11() - n.m11()) <= tolerance*size && std::abs(m.m12() - n.m12()) <= tolerance*size
      && std::abs(m.m22() - n.m22()) <= tolerance*size;
}

void test_callables()
{
  const Tensor m = Tensor::from_sizes(1, 2, 0.3);
  const CGAL::Constant_metric_field_2 constant(m); // deduces the kernel
  CHECK(constant(Point(5, 6)) == m);
  CHECK(CGAL::Constant_metric_field_2<Kernel>()(Point(0, 0)) == Tensor());

  const auto isotropic = CGAL::make_isotropic_metric_field_2<Kernel>([](const Point& p) { return 1 + p.x(); });
  CHECK(isotropic(Point(1, 0)) == Tensor::from_size(2));
  CHECK_THROWS(isotropic(Point(-1, 3)), Invalid, "the metric of size 0 is not positive definite at the point (-1, 3)");

  const auto of_array = CGAL::make_oriented_sizes_metric_field_2<Kernel>(
    [](const Point& p) { return std::array<double, 3>{p.x(), p.y(), 0.3}; });
  const auto of_tuple = CGAL::make_oriented_sizes_metric_field_2<Kernel>(
    [](const Point& p) { return std::make_tuple(p.x(), p.y(), 0.3); });
  const auto of_struct = CGAL::make_oriented_sizes_metric_field_2<Kernel>(
    [](const Point& p) { return Sizes{p.x(), p.y(), 0.3}; });
  CHECK(of_array(Point(1, 2)) == m && of_tuple(Point(1, 2)) == m && of_struct(Point(1, 2)) == m);
  CHECK_THROWS(of_struct(Point(1, -2)), Invalid, "h2 = -2, theta = 0.3 is not positive definite at the point (1, -2)");
  auto copy = of_struct;
  CHECK(copy(Point(1, 2)) == m);
}

typedef std::array<double, 2> Gradient;
typedef std::array<double, 3> Hessian;

void test_gradient_field()
{
  CGAL::Random random(11);
  const auto gradient = [](const Point& p) { return Gradient{p.x(), p.y()}; };
  const double alpha = 0.04, e = 0.5;
  const auto field = CGAL::make_gradient_metric_field_2<Kernel>(gradient, alpha, e);
  const auto square_norm = CGAL::make_gradient_metric_field_2<Kernel>(gradient, alpha, e, 2);
  for(int i = 0; i < 100; ++i) {
    const double x = random.get_double(-3, 3), y = random.get_double(-3, 3);
    const Tensor m = Tensor::from_entries(alpha + x*x, x*y, alpha + y*y);
    CHECK(are_close(field(Point(x, y)), m.scaled(e), 1e-13));
    // the Riemannian energy of one is the Lebesgue energy of the other
    const Tensor n = square_norm(Point(x, y));
    CHECK(are_close(n.scaled(1 / std::sqrt(n.area_density())), m.scaled(e*e), 1e-13));
  }
  CHECK(are_close(field(Point(0, 0)), Tensor::from_size(2.5), 1e-14));
  CHECK(std::abs(field(Point(1e5, -1e5)).sizes().h2 / 2.5 - 1) < 1e-3);
  CHECK(field(Point(1e10, 1e9)).sizes().h1 < 1e-10); // rounding does not make it indefinite
  CHECK_THROWS(field(Point(1e200, 3)), Invalid, "is not positive definite at the point (1e+200, 3)");
  const auto nan = CGAL::make_gradient_metric_field_2<Kernel>(
    [](const Point&) { return std::make_tuple(std::numeric_limits<double>::quiet_NaN(), 0.f); }, alpha, e);
  CHECK_THROWS(nan(Point(1, 2)), Invalid, "at the point (1, 2)");
}

Hessian symmetric(double first, double second, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {first*c*c + second*s*s, (first - second)*c*s, first*s*s + second*c*c};
}

Tensor tensor_of(const Hessian& h) { return Tensor::from_entries(h[0], h[1], h[2]); }

// The tensor of the Hessian with these eigenvalues, for sizes between 0.01 and 10.
Tensor hessian_tensor(double first, double second, double angle, double e, double norm)
{
  return CGAL::make_hessian_metric_field_2<Kernel>(
    [=](const Point&) { return symmetric(first, second, angle); }, e, 0.01, 10, norm)(Point(1, 2));
}

void test_hessian_field()
{
  CGAL::Random random(12);
  const double infinity = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 100; ++i) {
    const double first = random.get_double(1, 10) * (random.get_bool() ? 1 : -1);
    const double second = random.get_double(1, 10) * (random.get_bool() ? 1 : -1);
    const double angle = random.get_double(-3, 3), det = std::abs(first * second);
    const Tensor absolute = tensor_of(symmetric(std::abs(first), std::abs(second), angle));
    CHECK(are_close(hessian_tensor(first, second, angle, 0.3, infinity), absolute.scaled(std::sqrt(0.3)), 1e-12));
    CHECK(are_close(hessian_tensor(first, second, angle, 0.3, 2),
                    absolute.scaled(std::sqrt(0.3 * std::pow(det, 1./6))), 1e-12));
  }
}

void test_bounds_of_hessian_field()
{
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(hessian_tensor(0, 0, 0, 1, 2) == Tensor::from_size(10));
  CHECK(are_close(hessian_tensor(4, 0, 0.3, 1, infinity), Tensor::from_sizes(0.5, 10, 0.3), 1e-12));
  CHECK(are_close(hessian_tensor(0, -4, 0.3, 1, infinity), Tensor::from_sizes(10, 0.5, 0.3), 1e-12));
  CHECK(are_close(hessian_tensor(1e9, 1e9, 0.3, 1, infinity), Tensor::from_size(0.01), 1e-12));
  CHECK(are_close(hessian_tensor(1e-9, 1e-9, 0, 1, infinity), Tensor::from_size(10), 1e-12));
  const Tensor::Sizes sizes = hessian_tensor(4, 0, 0.3, 1, 2).sizes(); // the determinant is that of the ratio of bounds
  CHECK(std::abs(sizes.h1 / (0.5 * std::pow(16e-6, 1./12)) - 1) < 1e-9 && sizes.h2 <= 10 + 1e-9);
  CHECK_THROWS(hessian_tensor(infinity, 1, 0.3, 1, 2), Invalid, "is not finite at the point (1, 2)");
  const auto off_diagonal = CGAL::make_hessian_metric_field_2<Kernel>(
    [=](const Point&) { return Hessian{0, infinity, 0}; }, 1, 1, 1);
  CHECK_THROWS(off_diagonal(Point(3, 4)), Invalid,
               "the Hessian with the entries 0, inf, 0 is not finite at the point (3, 4)");
}

// a jittered grid over [0,n]^2 whose triangles are oriented at random
Background grid(int n, CGAL::Random& random)
{
  Background g;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double jitter = i > 0 && i < n && j > 0 && j < n ? 0.3 : 0;
      g.points.emplace_back(i + jitter * random.get_double(-1, 1), j + jitter * random.get_double(-1, 1));
    }
  const std::size_t row = static_cast<std::size_t>(n) + 1;
  for(std::size_t i = 0; i + 1 < row; ++i)
    for(std::size_t j = 0; j + 1 < row; ++j) {
      const std::size_t a = i*row + j;
      g.triangles.push_back({a, a + row, a + row + 1});
      g.triangles.push_back({a, a + row + 1, a + 1});
    }
  for(auto& t : g.triangles)
    if(random.get_bool())
      std::swap(t[1], t[2]);
  return g;
}

std::vector<Tensor> random_tensors(std::size_t n, CGAL::Random& random)
{
  std::vector<Tensor> tensors;
  for(std::size_t i = 0; i < n; ++i)
    tensors.push_back(Tensor::from_sizes(random.get_double(0.1, 1), random.get_double(1, 20), random.get_double(-3, 3)));
  return tensors;
}

// The log-Euclidean mean with the barycentric coordinates of the nearest point
// of the nearest triangle, by trying all.
Tensor by_brute_force(const Background& g, const std::vector<Tensor>& tensors, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  std::array<double, 3> logarithm = {};
  for(const auto& t : g.triangles) {
    const Kernel::Triangle_2 triangle(g.points[t[0]], g.points[t[1]], g.points[t[2]]);
    const double distance = CGAL::to_double(CGAL::squared_distance(p, triangle));
    if(distance >= least)
      continue;
    least = distance;
    Point q = p; // the nearest point
    if(triangle.has_on_unbounded_side(p)) {
      double nearest = std::numeric_limits<double>::infinity();
      for(int i = 0; i < 3; ++i) {
        const Point a = triangle[i], b = triangle[i + 1];
        const double s = (std::min)(1., (std::max)(0., (p - a) * (b - a) / (b - a).squared_length()));
        const Point c = a + s * (b - a);
        if(CGAL::squared_distance(p, c) < nearest) {
          nearest = CGAL::squared_distance(p, c);
          q = c;
        }
      }
    }
    logarithm = {};
    for(int i = 0; i < 3; ++i) {
      const double weight = CGAL::area(q, triangle[i + 1], triangle[i + 2]) / triangle.area();
      const std::array<double, 3> l = tensors[t[i]].logarithm();
      for(int j = 0; j < 3; ++j)
        logarithm[j] += weight * l[j];
    }
  }
  return Tensor::from_logarithm(logarithm);
}

void test_discrete_field()
{
  CGAL::Random random(5);
  const Background g = grid(12, random);
  const std::vector<Tensor> tensors = random_tensors(g.points.size(), random);
  const Discrete field(g, tensors);
  for(std::size_t i = 0; i < g.points.size(); ++i)
    CHECK(are_close(field(g.points[i]), tensors[i], 1e-12));
  for(int i = 0; i < 3000; ++i) {
    const Point p(random.get_double(-3, 15), random.get_double(-3, 15)); // half of them outside
    CHECK(are_close(field(p), by_brute_force(g, tensors, p), 1e-9));
  }
  for(const auto& t : g.triangles) { // on edges
    const Point p = CGAL::midpoint(g.points[t[0]], g.points[t[1]]);
    CHECK(are_close(field(p), by_brute_force(g, tensors, p), 1e-9));
  }
  CHECK(are_close(field(Point(1e6, 1e6)), tensors.back(), 1e-12)); // far away
  const Discrete copy = field;
  CHECK(copy(Point(3.3, 4.4)) == field(Point(3.3, 4.4)));
}

void test_interpolation()
{
  Background g;
  g.points = {Point(0, 0), Point(1, 0), Point(0, 1)};
  g.triangles.push_back({0, 2, 1}); // clockwise
  const Discrete field(g, {Tensor::from_size(1), Tensor::from_size(4), Tensor::from_sizes(1, 16)});
  CHECK(are_close(field(Point(0.5, 0)), Tensor::from_size(2), 1e-14)); // geometric means
  CHECK(are_close(field(Point(0, 0.25)), Tensor::from_sizes(1, 2), 1e-14));
  CHECK(are_close(field(Point(0.5, -7)), Tensor::from_size(2), 1e-14));
  CHECK(are_close(field(Point(-1, -1)), Tensor::from_size(1), 1e-14));
}

// Coordinates whose squares are no numbers interpolate like all others, and so do very far points.
void test_extreme_coordinates()
{
  const std::vector<Tensor> tensors = {Tensor::from_size(1), Tensor::from_size(4), Tensor::from_sizes(1, 16)};
  for(double s : {1e-300, 1e-200, 1., 1e200, 1e307}) {
    Background g;
    g.points = {Point(0, 0), Point(s, 0), Point(0, s)};
    g.triangles.push_back({0, 1, 2});
    const Discrete field(g, tensors);
    CHECK(are_close(field(Point(0.5*s, 0)), Tensor::from_size(2), 1e-14));
    CHECK(are_close(field(Point(0, 0.25*s)), Tensor::from_sizes(1, 2), 1e-14));
    CHECK(are_close(field(Point(0.5*s, -7*s)), Tensor::from_size(2), 1e-14));
    CHECK(are_close(field(Point(-1e308, 1e308)), tensors[2], 1e-14));
    CHECK(are_close(field(Point(1e308, -1e300)), tensors[1], 1e-14));
  }
}

// a background with a hole, and with triangles of very different sizes
void test_uneven_background()
{
  CGAL::Random random(9);
  Background g = grid(10, random);
  for(Point& p : g.points)
    p = Point(std::expm1(p.x()), 1e-3 * p.y());
  g.triangles.erase(std::remove_if(g.triangles.begin(), g.triangles.end(), [&](const std::array<std::size_t, 3>& t) {
    return CGAL::centroid(g.points[t[0]], g.points[t[1]], g.points[t[2]]).x() > 3000;
  }), g.triangles.end());
  const std::vector<Tensor> tensors = random_tensors(g.points.size(), random);
  const Discrete field(g, tensors);
  for(int i = 0; i < 500; ++i) {
    const Point p(std::exp(random.get_double(-3, 10)), 1e-3 * random.get_double(-3, 13));
    CHECK(are_close(field(p), by_brute_force(g, tensors, p), 1e-6));
  }
}

void test_refusals()
{
  Background g;
  g.points = {Point(0, 0), Point(1, 0), Point(0, 1), Point(2, 0)};
  const std::vector<Tensor> four(4);
  CHECK_THROWS(Discrete(g, four), Invalid_triangle_mesh_exception, "the background mesh has no triangles");
  CHECK_THROWS(Discrete(Background(), {}), Invalid_triangle_mesh_exception, "no triangles");
  g.triangles = {{0, 1, 2}, {0, 1, 3}};
  CHECK_THROWS(Discrete(g, four), Invalid_triangle_mesh_exception, "triangle 2 of the background mesh has no area");
  g.triangles = {{0, 1, 1}};
  CHECK_THROWS(Discrete(g, four), Invalid_triangle_mesh_exception, "triangle 1 of the background mesh has no area");
  g.triangles = {{0, 1, 4}};
  CHECK_THROWS(Discrete(g, four), Invalid_triangle_mesh_exception,
               "triangle 1 of the background mesh names a vertex that does not exist");
  g.triangles = {{0, 1, 2}};
  CHECK_THROWS(Discrete(g, std::vector<Tensor>(3)), Invalid_triangle_mesh_exception,
               "the background has 4 vertices, but 3 metric tensors are given");
  CHECK(Discrete(g, four)(Point(0, 0)) == Tensor());
}

void test_threads()
{
  CGAL::Random random(2);
  const Background g = grid(20, random);
  const Discrete field(g, random_tensors(g.points.size(), random));
  std::vector<Point> points;
  std::vector<Tensor> expected;
  for(int i = 0; i < 5000; ++i) {
    points.emplace_back(random.get_double(-1, 21), random.get_double(-1, 21));
    expected.push_back(field(points.back()));
  }
  std::atomic<int> differences(0);
  std::vector<std::thread> threads;
  for(int k = 0; k < 4; ++k)
    threads.emplace_back([&, copy = field] {
      for(std::size_t i = 0; i < points.size(); ++i)
        differences += copy(points[i]) != expected[i];
    });
  for(std::thread& t : threads)
    t.join();
  CHECK(differences == 0);
}

// Lengths of segments in closed form, along which sizes vary by a factor of 20 000 or not at all.
void test_lengths_of_segments()
{
  const CGAL::Riemannian_metric_traits_2<Kernel> traits([](const Point& p) {
    return Tensor::from_size(std::exp(-10 * p.x()));
  });
  const auto length = traits.compute_riemannian_length_2_object();
  const double expected = (std::exp(10.) - 1) / 10;
  CHECK(std::abs(length(Point(0, 3), Point(1, 3)) - expected) < 3e-6 * expected);
  CHECK(std::abs(length(Point(1, 1), Point(0, 0)) - std::sqrt(2.) * expected) < 3e-6 * expected);
  CHECK(std::abs(length(Point(0.5, 0), Point(0.5, 2)) - 2 * std::exp(5.)) < 1e-10);
}

// ---------------------------------------------------------------- samples of a field

using CGAL::Anisotropic_mesh_2::internal::Control_space;
using CGAL::Anisotropic_mesh_2::internal::Symmetric_form;
using CGAL::Anisotropic_mesh_2::internal::Vector_of_doubles;
typedef std::function<Symmetric_form(const Vector_of_doubles&)> Logarithm;

const int cells = 8; // along each side of the unit square, each of two triangles

// Points on the slit from (0, 1/2) to (3/4, 1/2) are there twice, so that triangles on both sides are no neighbors.
Control_space sampled(const Logarithm& logarithm, bool has_slit)
{
  CGAL::Anisotropic_mesh_2::internal::Vectors points;
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i)
      points.push_back({double(i) / cells, double(j) / cells});
  const int first_of_slit = cells / 2 * (cells + 1), tip = first_of_slit + 3 * cells / 4, first_double = int(points.size());
  for(int p = first_of_slit; p < tip && has_slit; ++p)
    points.push_back(Vector_of_doubles(points[p]));
  const auto above_slit = [&](int p)
                          { return has_slit && p >= first_of_slit && p < tip ? p - first_of_slit + first_double : p; };
  std::vector<Control_space::Indices> corners;
  for(int j = 0; j < cells; ++j)
    for(int i = 0; i < cells; ++i) {
      int a = j*(cells + 1) + i, next = a + 1;
      const int b = a + cells + 1;
      if(j == cells / 2) {
        a = above_slit(a);
        next = above_slit(next);
      }
      corners.push_back({{a, next, b + 1}});
      corners.push_back({{a, b + 1, b}});
    }
  std::vector<Symmetric_form> logarithms;
  for(const Vector_of_doubles& p : points)
    logarithms.push_back(logarithm(p));
  return Control_space(CGAL::Sequential_tag(), CGAL::Anisotropic_mesh_2::internal::sampling_for_iteration, points, corners,
                       logarithms, logarithm);
}

// Quadratic logarithms are interpolated exactly, whichever triangle the search begins in, also around the tip of a
// slit.
void test_samples_around_slit()
{
  const auto quadratic = [](const Vector_of_doubles& x)
                         { return Symmetric_form(1 + x.x - x.y*x.y, x.x*x.y, 2 - x.x*x.x + 3*x.y); };
  const Control_space space = sampled(quadratic, true);
  CGAL::Random random(5);
  for(int trial = 0; trial < 300; ++trial) {
    const Vector_of_doubles x = {random.get_double(0.5, 1), random.get_double(0.35, 0.65)};
    const int row = random.get_int(3, 5), column = random.get_int(4, 8);
    int triangle = 2 * (row*cells + column) + random.get_int(0, 2);
    CHECK((space.logarithm(x, triangle) + (-1.) * quadratic(x)).norm() < 1e-12);
    CHECK(space.is_resolved(triangle));
  }
}

// A bump that is no wider than a cell is sampled more closely, so that the logarithm is right to the five percent that
// samples must agree to, but for places between them.
void test_samples_of_bump()
{
  const auto bump = [](const Vector_of_doubles& x) {
    const double value = 3 * std::exp(-100 * ((x.x - 0.52) * (x.x - 0.52) + (x.y - 0.55) * (x.y - 0.55)));
    return Symmetric_form(value, -value / 2, 1);
  };
  const Control_space space = sampled(bump, false);
  const int trials = 5000;
  double sum = 0;
  CGAL::Random random(6);
  for(int trial = 0; trial < trials; ++trial) {
    const Vector_of_doubles x = {random.get_double(0, 1), random.get_double(0, 1)};
    int triangle = 2 * (cells/2 * cells + cells/2);
    sum += std::pow((space.logarithm(x, triangle) + (-1.) * bump(x)).norm(), 2) / trials;
  }
  CHECK_MSG(std::sqrt(sum) < 0.05, std::to_string(std::sqrt(sum)));
}

// A quartering takes nine samples and four to see whether it was enough. There are two a triangle, however rough the
// field is; and jumps, which remain, are told.
void test_number_of_samples()
{
  int calls = 0;
  const auto noise = [&](const Vector_of_doubles& x) {
    ++calls;
    return Symmetric_form(std::sin(1e6 * x.x), 0, std::cos(1e6 * x.y));
  };
  const Control_space space = sampled(noise, false);
  const int triangles = 2 * cells * cells, edges = cells * (3*cells + 2), corners = (cells + 1) * (cells + 1);
  CHECK_MSG(calls <= corners + edges + triangles + 2 * 13 * triangles, std::to_string(calls));
  const auto step = [](const Vector_of_doubles& x) { return Symmetric_form(x.x < 0.56 ? 0 : 9, 0, 0); };
  const Control_space jump = sampled(step, false);
  for(int triangle = 0; triangle < triangles; ++triangle)
    CHECK(jump.is_resolved(triangle) == (triangle / 2 % cells != 4));
}

int main()
{
  test_samples_around_slit();
  test_samples_of_bump();
  test_number_of_samples();
  test_callables();
  test_lengths_of_segments();
  test_gradient_field();
  test_hessian_field();
  test_bounds_of_hessian_field();
  test_discrete_field();
  test_interpolation();
  test_extreme_coordinates();
  test_uneven_background();
  test_refusals();
  test_threads();
  return finish();
}

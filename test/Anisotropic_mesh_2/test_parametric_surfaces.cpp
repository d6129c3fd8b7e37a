// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parametric surfaces, their derivatives and curvatures, and the metrics they induce, against closed forms.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_2/Callable_surface_3.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_ellipsoid_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_torus_3.h>
#include <CGAL/Anisotropic_mesh_2/Quadratic_graph_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/Anisotropic_mesh_2/principal_curvatures_3.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_chart.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/surface_geometry.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef K::Point_2                                          Point_2;
typedef K::Point_3                                          Point_3;
typedef K::Vector_3                                         Vector_3;
typedef CGAL::Anisotropic_mesh_2::Parameter_rectangle       Rectangle;
typedef CGAL::Metric_tensor_3<K>                            Tensor_3;

namespace {

Rectangle rectangle(double u_min, double u_max, double v_min, double v_max)
{
  Rectangle r;
  r.u_min = u_min;
  r.u_max = u_max;
  r.v_min = v_min;
  r.v_max = v_max;
  return r;
}

double norm(const Vector_3& v) { return std::sqrt(v * v); }

// points all over the rectangle, on its sides and close to them
std::vector<Point_2> places(const Rectangle& r)
{
  CGAL::Random random(7);
  std::vector<Point_2> result;
  const std::vector<double> shares = {0, 1e-6, 3e-4, 0.3, 0.71, 1 - 2e-4, 1};
  for(double s : shares)
    for(double t : shares)
      result.push_back(Point_2(r.u_min + s * (r.u_max - r.u_min), r.v_min + t * (r.v_max - r.v_min)));
  for(int i = 0; i < 50; ++i)
    result.push_back(Point_2(random.get_double(r.u_min, r.u_max), random.get_double(r.v_min, r.v_max)));
  return result;
}

// ------------------------------------------------------------- rectangles

void test_rectangles()
{
  const double infinity = std::numeric_limits<double>::infinity();
  Rectangle r = rectangle(-1, 2, 3, 3.5);
  CHECK(r.is_valid() && r.u_extent() == 3 && r.v_extent() == 0.5 && !r.is_periodic() && !r.has_pole());
  r.v_max_is_pole = true;
  CHECK(!r.is_valid() && r.has_pole());
  r.u_is_periodic = true;
  CHECK(r.is_valid() && r.is_periodic());
  r.v_is_periodic = true;
  CHECK(!r.is_valid());
  CHECK(!rectangle(1, 1, 0, 1).is_valid() && !rectangle(0, 1, 1, 0).is_valid());
  CHECK(!rectangle(0, infinity, 0, 1).is_valid() && !rectangle(0, 1, -infinity, 0).is_valid());
  CHECK(!rectangle(0, 1, 0, infinity - infinity).is_valid());
}

// ------------------------------------------------------------- derivatives

// A surface against the same as a function that is differentiated numerically,
// and that complains about parameters outside of its rectangle.
template <class Surface>
void test_derivatives(const Surface& surface)
{
  const Rectangle r = surface.parameters();
  const auto numerical = CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([&](const Point_2& p) {
    CHECK(r.u_is_periodic || (r.u_min <= p.x() && p.x() <= r.u_max));
    CHECK(r.v_is_periodic || (r.v_min <= p.y() && p.y() <= r.v_max));
    return surface.point(p);
  }, r);
  for(const Point_2& p : places(r)) {
    const auto d = surface.first_derivatives(p), e = numerical.first_derivatives(p);
    const auto dd = surface.second_derivatives(p), ee = numerical.second_derivatives(p);
    for(int i = 0; i < 2; ++i)
      CHECK_MSG(norm(d[i] - e[i]) < 1e-9, "first: " + std::to_string(std::log10(norm(d[i] - e[i]))));
    for(int i = 0; i < 3; ++i)
      CHECK_MSG(norm(dd[i] - ee[i]) < 1e-6, "second: " + std::to_string(std::log10(norm(dd[i] - ee[i]))));
  }
}

void test_periods()
{
  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> torus(3, 1);
  const CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K> ellipsoid(3, 2, 1);
  const double period = 2 * CGAL_PI;
  CHECK(norm(torus.point(Point_2(1, 2)) - torus.point(Point_2(1 + period, 2 - period))) < 1e-14);
  CHECK(norm(ellipsoid.point(Point_2(1, 0.4)) - ellipsoid.point(Point_2(1 - period, 0.4))) < 1e-14);
  CHECK(norm(ellipsoid.point(Point_2(1, CGAL_PI / 2)) - ellipsoid.point(Point_2(2, CGAL_PI / 2))) < 1e-15);
}

// ------------------------------------------------------------- metrics

void check_tensor(const CGAL::Metric_tensor_2<K>& m, double a, double b, double c, const std::string& what)
{
  const double scale = 1e-12 * (a + c);
  CHECK_MSG(std::abs(m.m11() - a) < scale && std::abs(m.m12() - b) < scale && std::abs(m.m22() - c) < scale, what);
}

double size_at(const Point_3& p) { return 0.1 + 0.01 * (p.x() + p.y() + p.z()); }

void test_induced_metrics()
{
  const Point_2 p(0.7, 0.4);
  const CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K> sphere(2, 2, 2);
  double q = 1 / (size_at(sphere.point(p)) * size_at(sphere.point(p)));
  check_tensor(CGAL::make_surface_metric_field_2(sphere, size_at)(p),
               q * 4 * std::cos(0.4) * std::cos(0.4), 0, q * 4, "sphere");

  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> torus(3, 1);
  const double w = 3 + std::cos(0.4);
  q = 1 / (size_at(torus.point(p)) * size_at(torus.point(p)));
  check_tensor(CGAL::make_surface_metric_field_2(torus, size_at)(p), q * w*w, 0, q, "torus");

  const CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> saddle(2, -4, rectangle(-1, 1, -1, 1));
  const double zx = 4 * 0.7, zy = -8 * 0.4;
  q = 1 / (size_at(saddle.point(p)) * size_at(saddle.point(p)));
  check_tensor(CGAL::make_surface_metric_field_2(saddle, size_at)(p), q * (1 + zx*zx), q * zx*zy, q * (1 + zy*zy),
               "saddle");
  const auto sizes = [](const Point_3&) { return Tensor_3::from_sizes(0.1, 1, 0.2); };
  check_tensor(CGAL::make_surface_metric_field_2(saddle, sizes)(p), 100 + 25*zx*zx, 25*zx*zy, 1 + 25*zy*zy,
               "saddle, three sizes");

  const auto unit = [](const Point_3&) { return 1.; };
  const auto cone = CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& x) {
    return Point_3(x.y() * std::cos(x.x()), x.y() * std::sin(x.x()), 2 * x.y());
  }, rectangle(0, 1, 0.1, 1));
  const CGAL::Metric_tensor_2<K> m = CGAL::make_surface_metric_field_2(cone, unit)(p);
  CHECK(std::abs(m.m11() - 0.16) < 1e-10 && std::abs(m.m12()) < 1e-10 && std::abs(m.m22() - 5) < 1e-10);
}

void test_tensors()
{
  const Tensor_3 m = Tensor_3::from_sizes(1, 2, 4);
  CHECK(m.squared_length(Vector_3(1, 2, 4)) == 3 && m.scalar_product(Vector_3(1, 0, 4), Vector_3(2, 7, 4)) == 3);
  CHECK(m.determinant() == 1. / 64 && Tensor_3().squared_length(Vector_3(1, 2, 2)) == 9);
  const double c = 0.6, s = 0.8;
  const std::array<Vector_3, 3> axes = {Vector_3(c, s, 0), Vector_3(-s, c, 0), Vector_3(0, 0, 1)};
  const Tensor_3 turned = Tensor_3::from_directions(axes, {0.5, 3., 7.});
  for(int i = 0; i < 3; ++i) {
    const double h = i == 0 ? 0.5 : i == 1 ? 3 : 7;
    CHECK(std::abs(turned.squared_length(axes[i]) - 1 / (h*h)) < 1e-14);
    CHECK(std::abs(turned.scalar_product(axes[i], axes[(i + 1) % 3])) < 1e-14);
  }
  CHECK(turned.entries() == Tensor_3::from_entries(turned.entries()).entries());
  typedef CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception Refusal;
  CHECK_THROWS(Tensor_3::from_sizes(1, -2, 1), Refusal, "the size -2 is not positive definite");
  CHECK_THROWS(Tensor_3::from_size(std::nan("")), Refusal, "nan");
  CHECK_THROWS(Tensor_3::from_entries({1, 2, 0, 1, 0, 1}), Refusal, "entries 1 2 0 1 0 1 is not positive definite");
  CHECK_THROWS(Tensor_3::from_entries({1, 0, 0, std::nan(""), 0, 1}), Refusal, "entries 1 0 0 nan 0 1 is not finite");
}

// ------------------------------------------------------------- curvatures

template <class Surface>
void check_curvatures(const Surface& surface, const Point_2& p, double k_min, double k_max, const std::string& what)
{
  const auto k = CGAL::Anisotropic_mesh_2::principal_curvatures_3(surface, p);
  CHECK_MSG(std::abs(k.k_min - k_min) < 1e-6 && std::abs(k.k_max - k_max) < 1e-6,
            what + ": " + std::to_string(k.k_min) + ", " + std::to_string(k.k_max));
  CHECK(std::abs(norm(k.v_min) - 1) < 1e-12 && std::abs(norm(k.v_max) - 1) < 1e-12 && std::abs(norm(k.normal) - 1) < 1e-12);
  CHECK(std::abs(k.v_min * k.v_max) < 1e-12 && std::abs(k.v_min * k.normal) < 1e-12);
  const auto d = surface.first_derivatives(p);
  CHECK(std::abs(d[0] * k.normal) < 1e-8 * norm(d[0]) && cross_product(d[0], d[1]) * k.normal > 0);
}

void test_curvatures()
{
  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> torus(3, 0.5);
  for(const Point_2& p : places(torus.parameters())) {
    const double along = -std::cos(p.y()) / (3 + 0.5 * std::cos(p.y()));
    check_curvatures(torus, p, -2, along, "torus");
    const auto k = CGAL::Anisotropic_mesh_2::principal_curvatures_3(torus, p);
    CHECK(std::abs(std::abs(k.v_min * torus.first_derivatives(p)[1]) - 0.5) < 1e-12); // around the tube
  }
  const CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K> sphere(2, 2, 2); // umbilic everywhere
  check_curvatures(sphere, Point_2(0.3, 0.8), -0.5, -0.5, "sphere");
  const Rectangle r = rectangle(-1, 1, -1, 1);
  check_curvatures(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(2, -4, r), Point_2(0, 0), -8, 4, "saddle");
  const double zx = 2, zy = -4, w = 1 + zx*zx + zy*zy; // at (0.5, 0.5)
  const double gauss = 4 * -8 / (w*w), mean = ((1 + zy*zy) * 4 + (1 + zx*zx) * -8) / (2 * std::pow(w, 1.5));
  const double root = std::sqrt(mean*mean - gauss);
  check_curvatures(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(2, -4, r), Point_2(0.5, 0.5), mean - root, mean + root, "saddle");
  const auto cylinder = CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& x) {
    return Point_3(2 * std::cos(x.x()), 2 * std::sin(x.x()), x.y());
  }, rectangle(0, 3, 0, 1));
  check_curvatures(cylinder, Point_2(1, 0.5), -0.5, 0, "cylinder");
}

// An edge of unit length around the tube of a torus is as far from it as promised.
void test_chord_error()
{
  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> torus(3, 0.5);
  for(double epsilon : {0.1, 0.01, 1e-3}) {
    const CGAL::Anisotropic_mesh_2::Curvature_metric_3<CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> > metric(epsilon, 1e-6, 1e6);
    const auto m = metric(torus, Point_2(0, 0));
    const double size = 1 / std::sqrt(m.squared_length(Vector_3(0, 0, 1)));
    const double sagitta = 0.5 - std::sqrt(0.25 - size*size / 4);
    CHECK_MSG(std::abs(sagitta / (0.5 * epsilon) - 1) < 1e-9, std::to_string(sagitta));
    CHECK(std::abs(1 / std::sqrt(m.squared_length(Vector_3(0, 1, 0))) / size - 3.5 / 0.5) < 1e-9);
  }
}

void test_bounds_of_sizes()
{
  const CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> plane(0, 0, rectangle(0, 1, 0, 1)), trough(0, 5, rectangle(-1, 1, -1, 1));
  typedef CGAL::Anisotropic_mesh_2::Curvature_metric_3<CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> > Metric;
  const Tensor_3 flat = Metric(0.01, 0.1, 3)(plane, Point_2(0.5, 0.5));
  CHECK(std::abs(flat.squared_length(Vector_3(1, 0, 0)) - 1./9) < 1e-14);
  const auto size = [](const Tensor_3& m, const Vector_3& v) { return 1 / std::sqrt(m.squared_length(v)); };
  const Tensor_3 bent = Metric(0.01, 0.1, 30, 4)(trough, Point_2(0, 0));
  CHECK(std::abs(size(bent, Vector_3(0, 1, 0)) - 0.1) < 1e-12); // g / 10 would be 0.028
  CHECK(std::abs(size(bent, Vector_3(1, 0, 0)) - 0.4) < 1e-12);
  CHECK(std::abs(size(bent, Vector_3(0, 0, 1)) - 0.1) < 1e-12);
}

// ------------------------------------------------------------- charts

using CGAL::Anisotropic_mesh_2::internal::Surface_chart;
using CGAL::Anisotropic_mesh_2::internal::Symmetric_form;
using CGAL::Anisotropic_mesh_2::internal::Vector_of_doubles;

// parameters with a metric that is oblique to them everywhere, and periodic
struct Oblique_field
{
  struct Surface
  {
    typedef K Kernel;

    Rectangle r;
    const Rectangle& parameters() const { return r; }
  };

  Surface s;
  const Surface& surface() const { return s; }
  CGAL::Metric_tensor_2<K> operator()(const Point_2& p) const
  {
    const double u = 2 * CGAL_PI / 3 * p.x(), v = CGAL_PI * p.y();
    return CGAL::Metric_tensor_2<K>::from_entries(2 + std::sin(u), 0.7 + 0.2 * std::sin(v), 1.5 + 0.5 * std::cos(v));
  }
};

Oblique_field sphere_like() // poles at both ends, and u not in radians
{
  Oblique_field field{{rectangle(1, 4, -1, 1)}};
  field.s.r.u_is_periodic = field.s.r.v_min_is_pole = field.s.r.v_max_is_pole = true;
  return field;
}

// A chart is a map without mirroring and its inverse, and its tensor is that of the parameters, by differences.
void test_chart(const Surface_chart<Oblique_field>& chart, const Oblique_field& field)
{
  const Rectangle& r = field.s.r;
  CGAL::Random random(3);
  for(int i = 0; i < 40; ++i) {
    const Vector_of_doubles p = {random.get_double(r.u_min, r.u_max), random.get_double(-0.9, 0.9)};
    const Vector_of_doubles x = chart.coordinates(p), q = chart.parameters(x);
    CHECK(std::hypot(p.x - q.x, p.y - q.y) < 1e-12);
    const double step = 1e-5;
    const auto derivative = [&](double dx, double dy) {
      const Vector_of_doubles a = chart.parameters({x.x + dx, x.y + dy}), b = chart.parameters({x.x - dx, x.y - dy});
      return Vector_of_doubles{std::remainder(a.x - b.x, r.u_extent()) / (2*step),
                               std::remainder(a.y - b.y, r.v_extent()) / (2*step)};
    };
    const Vector_of_doubles dx = derivative(step, 0), dy = derivative(0, step);
    CHECK(dx.x * dy.y - dx.y * dy.x > 0);
    const Symmetric_form m(field(Point_2(p.x, p.y))), n(chart(Point_2(x.x, x.y)));
    const double scale = 1e-6 * (n.a + n.c);
    CHECK(std::abs(n.a - m(dx.x, dx.y)) < scale && std::abs(n.b - m(dx.x, dx.y, dy.x, dy.y)) < scale
          && std::abs(n.c - m(dy.x, dy.y)) < scale);
  }
}

void test_charts()
{
  const Oblique_field sphere = sphere_like();
  test_chart(Surface_chart<Oblique_field>::cap(sphere, true), sphere);
  test_chart(Surface_chart<Oblique_field>::cap(sphere, false), sphere);
  test_chart(Surface_chart<Oblique_field>::window(sphere, 2.3, -1), sphere);
  Oblique_field torus{{rectangle(1, 4, -1, 1)}};
  torus.s.r.u_is_periodic = torus.s.r.v_is_periodic = true;
  const auto window = Surface_chart<Oblique_field>::window(torus, 2.3, 0.4);
  test_chart(window, torus);
  // what is near across a seam is far in the window
  CHECK(!window.is_cut_between({2.5, 0.5}, {3.9, 1.4}));
  CHECK(window.is_cut_between({2.5, 0.5}, {4.1, 0.5}) && window.is_cut_between({2.5, 0.5}, {2.5, 1.6}));
  CHECK(window.is_cut_between(window.coordinates({2.2, 0}), window.coordinates({2.4, 0})));
  CHECK(window.is_cut_between(window.coordinates({3, 0.3}), window.coordinates({3, 0.5})));
}

// ------------------------------------------------------------- triangles in space

void test_triangles()
{
  namespace internal = CGAL::Anisotropic_mesh_2::internal;
  const double height = std::sqrt(0.75);
  const std::array<Point_3, 3> equilateral{Point_3(0, 0, 1), Point_3(1, 0, 1), Point_3(0.5, height, 1)};
  const std::array<Point_3, 3> stretched{Point_3(0, 0, 0), Point_3(0, 0, 4), Point_3(0, 3 * height, 2)};
  CHECK(std::abs(internal::surface_quality(equilateral, Tensor_3()) - 1) < 1e-12);
  CHECK(std::abs(internal::surface_quality(stretched, Tensor_3::from_sizes(9, 3, 4)) - 1) < 1e-12);
  // 4 sqrt(3) times the area over the sum of the squares, 1/2 and 1 + 1 + 2
  CHECK(std::abs(internal::surface_quality(std::array<Point_3, 3>{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 0, 1)},
                                           Tensor_3()) - std::sqrt(3.) / 2) < 1e-12);
  // of lengths 1, 5 and 2
  CHECK(std::abs(internal::chord_length(Vector_3(0, 2, 0), Tensor_3::from_size(2), Tensor_3::from_size(0.4),
                                        Tensor_3::from_size(1)) - 23./6) < 1e-12);
  const CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> plane(0, 0, rectangle(0, 1, 0, 1));
  for(double angle : {0., 0.3, 1.5, 2.}) {
    const std::array<Point_3, 3> t{Point_3(0, 0, 0), Point_3(std::cos(angle), 0, std::sin(angle)), Point_3(0, 1, 0)};
    CHECK(std::abs(internal::normal_deviation(plane, Point_2(0.5, 0.5), t) - angle) < 1e-12);
  }
}

// On a torus in closed form; where the closest point is beyond the rectangle, it is on its side.
void test_distances()
{
  namespace internal = CGAL::Anisotropic_mesh_2::internal;
  const CGAL::Anisotropic_mesh_2::Parametric_torus_3<K> torus(3, 1);
  CGAL::Random random(4);
  for(int i = 0; i < 30; ++i) {
    const Point_2 p(random.get_double(0, 6), random.get_double(0, 6));
    const Point_3 near = torus.point(Point_2(p.x() + 0.2, p.y() - 0.3));
    const Point_3 x = CGAL::ORIGIN + 1.02 * (near - CGAL::ORIGIN);
    const double distance = std::abs(std::hypot(std::hypot(x.x(), x.y()) - 3, x.z()) - 1);
    CHECK_MSG(std::abs(internal::distance_to_surface(torus, p, x) - distance) < 1e-6, std::to_string(distance));
  }
  const CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> plane(0, 0, rectangle(0, 1, 0, 1));
  CHECK(std::abs(internal::distance_to_surface(plane, Point_2(0.5, 0.5), Point_3(0.7, 5, 3)) - 5) < 1e-12);
  CHECK(std::abs(internal::distance_to_surface(plane, Point_2(0.5, 0.5), Point_3(-4, 0.2, 3)) - 5) < 1e-12);
}

// ------------------------------------------------------------- refusals

template <class Function>
void check_refusal(const Function& function, const Point_2& p, const std::string& words)
{
  const auto field = CGAL::make_surface_metric_field_2
    (CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>(function, rectangle(-1, 1, -1, 1)), [](const Point_3&) { return 1.; });
  CHECK_THROWS(field(p), CGAL::Anisotropic_mesh_2::Degenerate_parametrization_exception, words);
}

void test_refusals()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_refusal([](const Point_2& p) { return Point_3(p.x(), 1, 2); }, Point_2(0.25, 0.5),
                "the derivative of the surface by v is zero at the point (0.25, 0.5)");
  check_refusal([](const Point_2& p) { return Point_3(p.y(), 1, 2); }, Point_2(0.25, 0.5), "by u is zero");
  check_refusal([](const Point_2& p) { return Point_3(p.x() + p.y(), 1, 0); }, Point_2(0.25, -0.5),
                "parallel at the point (0.25, -0.5)");
  check_refusal([=](const Point_2& p) { return Point_3(p.x(), p.y(), p.x() > 0.3 ? nan : 0); }, Point_2(0.5, 0),
                "not finite at the point (0.5, 0)");
  const auto pole = CGAL::make_surface_metric_field_2
    (CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& p) { return Point_3(p.y() * p.x(), p.y(), p.y()); },
                                      rectangle(-1, 1, 0, 1)), [](const Point_3&) { return 1.; });
  CHECK_THROWS(pole(Point_2(0.5, 0)), CGAL::Anisotropic_mesh_2::Degenerate_parametrization_exception, "by u is zero at the point (0.5, 0)");
  const auto bad_size = CGAL::make_surface_metric_field_2
    (CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 1), [](const Point_3&) { return -1.; });
  CHECK_THROWS(bad_size(Point_2(0, 0)), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "the size -1");
}

void test_other_kernel()
{
  typedef CGAL::Simple_cartesian<double> S;
  const auto field = CGAL::make_surface_metric_field_2(CGAL::Anisotropic_mesh_2::Parametric_torus_3<S>(3, 1), [](const S::Point_3&) { return 2.; });
  CHECK(std::abs(field(S::Point_2(0, 0)).m11() - 4) < 1e-14);
}

} // namespace

int main()
{
  test_rectangles();
  test_derivatives(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(3, 1));
  test_derivatives(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(3, 2, 1));
  test_derivatives(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(2, -4, rectangle(-1, 2, -1, 1)));
  test_periods();
  test_induced_metrics();
  test_tensors();
  test_curvatures();
  test_chord_error();
  test_bounds_of_sizes();
  test_charts();
  test_triangles();
  test_distances();
  test_refusals();
  test_other_kernel();
  return finish();
}

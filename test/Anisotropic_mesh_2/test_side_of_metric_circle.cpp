// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cavity predicate against the definition of alpha, in exact rationals.

#include "include/check.h"
#include "include/Random_numbers.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Exact_predicates_exact_constructions_kernel     Lazy;
typedef Lazy::Exact_kernel::FT                                Rational;
typedef CGAL::Simple_cartesian<Rational>                      Exact;
typedef K::Point_2                                            Point;
typedef CGAL::Metric_tensor_2<K>                              Tensor;

const double pi = 3.14159265358979323846;

// a counterclockwise triangle, a point, and the tensor of each
template <class Kernel_>
struct Configuration
{
  std::array<typename Kernel_::Point_2, 4>          points;
  std::array<CGAL::Metric_tensor_2<Kernel_>, 4>     tensors;
};
typedef Configuration<K> Case;

template <class Kernel_>
Configuration<Kernel_> converted(const Case& c)
{
  CGAL::Cartesian_converter<K, Kernel_> convert;
  Configuration<Kernel_> result;
  for(int i = 0; i < 4; ++i) {
    result.points[i] = convert(c.points[i]);
    result.tensors[i] = CGAL::Metric_tensor_2<Kernel_>(c.tensors[i], convert);
  }
  return result;
}

template <class Kernel_>
using Side = typename CGAL::Riemannian_metric_traits_2<Kernel_,
  std::function<CGAL::Metric_tensor_2<Kernel_>(const typename Kernel_::Point_2&)> >::Side_of_metric_circle_2;

template <class Predicate, class Kernel_>
auto apply(const Predicate& predicate, const Configuration<Kernel_>& c)
{
  return predicate(c.points[0], c.points[1], c.points[2], c.points[3],
                   c.tensors[0], c.tensors[1], c.tensors[2], c.tensors[3]);
}

template <class Kernel_>
CGAL::Oriented_side side(const Configuration<Kernel_>& c) { return apply(Side<Kernel_>(), c); }

// the stages of the filter
CGAL::Uncertain<CGAL::Oriented_side> by_doubles(const Case& c)
{
  return apply([](const auto&... args) { return Side<K>().by_doubles(args...); }, c);
}
template <class Kernel_>
CGAL::Uncertain<CGAL::Oriented_side> by_intervals(const Configuration<Kernel_>& c)
{
  return apply([](const auto&... args) { return Side<Kernel_>().by_intervals(args...); }, c);
}
template <class Kernel_>
CGAL::Oriented_side exactly(const Configuration<Kernel_>& c)
{
  return apply([](const auto&... args) { return Side<Kernel_>().exactly(args...); }, c);
}

// The definition: the circumcentre a + u solves 2 u^T M (b - a) = |b - a|^2 and
// the same for c; alpha is the distance of p from it over the radius.
Rational squared_alpha(const std::array<Exact::Point_2, 4>& x, const CGAL::Metric_tensor_2<Exact>& m)
{
  const auto squared = [&](const Rational& x, const Rational& y) -> Rational
                       { return m.m11()*x*x + m.m12()*x*y + m.m12()*y*x + m.m22()*y*y; };
  const Rational bx = x[1].x() - x[0].x(), by = x[1].y() - x[0].y();
  const Rational cx = x[2].x() - x[0].x(), cy = x[2].y() - x[0].y();
  const Rational px = x[3].x() - x[0].x(), py = x[3].y() - x[0].y();
  const Rational b1 = m.m11()*bx + m.m12()*by, b2 = m.m12()*bx + m.m22()*by, lb = squared(bx, by);
  const Rational c1 = m.m11()*cx + m.m12()*cy, c2 = m.m12()*cx + m.m22()*cy, lc = squared(cx, cy);
  const Rational det = 2 * (b1*c2 - b2*c1);
  const Rational ux = (lb*c2 - lc*b2) / det, uy = (b1*lc - c1*lb) / det;
  const Rational distance = squared(px - ux, py - uy), radius = squared(ux, uy);
  return distance / radius;
}

CGAL::Oriented_side side_by_definition(const Configuration<Exact>& c)
{
  Rational product = 1;
  for(const auto& m : c.tensors)
    product *= squared_alpha(c.points, m);
  return CGAL::compare(Rational(1), product);
}

std::string description(const Case& c)
{
  std::ostringstream os;
  os.precision(17);
  for(int i = 0; i < 4; ++i)
    os << "(" << c.points[i] << " | " << c.tensors[i] << ") ";
  return os.str();
}

// makes the triangle counterclockwise; false if it is flat
bool orient(Case& c)
{
  const CGAL::Orientation o = CGAL::orientation(c.points[0], c.points[1], c.points[2]);
  if(o == CGAL::RIGHT_TURN) {
    std::swap(c.points[0], c.points[1]);
    std::swap(c.tensors[0], c.tensors[1]);
  }
  return o != CGAL::COLLINEAR;
}

Case rotated(const Case& c)
{
  return Case{{c.points[1], c.points[2], c.points[0], c.points[3]},
              {c.tensors[1], c.tensors[2], c.tensors[0], c.tensors[3]}};
}

Case with_other_units(Case c)
{
  for(int i = 0; i < 4; ++i) {
    const double s = std::ldexp(1., 2*i - 6);
    c.tensors[i] = Tensor::from_entries(s*c.tensors[i].m11(), s*c.tensors[i].m12(), s*c.tensors[i].m22());
  }
  return c;
}

struct Counts { long cases = 0, ties = 0, mixed_ties = 0, certain = 0; };

bool is_mixed(const Configuration<Exact>& c)
{
  bool on = true;
  for(const auto& m : c.tensors)
    on = on && squared_alpha(c.points, m) == 1;
  return !on;
}

// every path of the predicate says what the definition says
void verify(Case c, Counts& counts)
{
  if(!orient(c))
    return;
  const Configuration<Exact> exact = converted<Exact>(c);
  const CGAL::Oriented_side expected = side_by_definition(exact);
  const bool right = side(c) == expected
                  && side(rotated(c)) == expected
                  && side(rotated(rotated(c))) == expected
                  && side(with_other_units(c)) == expected
                  && side(exact) == expected
                  && side(converted<Lazy>(c)) == expected
                  && exactly(c) == expected
                  && exactly(converted<Lazy>(c)) == expected;
  CHECK_MSG(right, description(c));

  const CGAL::Uncertain<CGAL::Oriented_side> estimate = by_doubles(c);
  for(const auto& uncertain : {estimate, by_intervals(c), by_intervals(converted<Lazy>(c))})
    CHECK_MSG(!CGAL::is_certain(uncertain) || CGAL::get_certain(uncertain) == expected, "a filter of " + description(c));
  ++counts.cases;
  counts.certain += CGAL::is_certain(estimate);
  if(expected == CGAL::ON_ORIENTED_BOUNDARY) {
    ++counts.ties;
    counts.mixed_ties += is_mixed(exact);
  }
}

void report(const char* name, const Counts& counts)
{
  std::cout << name << ": " << counts.cases << " cases, " << counts.certain << " certain by the estimate, "
            << counts.ties << " ties, " << counts.mixed_ties << " of them with different alphas" << std::endl;
}

typedef std::function<Case(Random_numbers&)> Generator;

Counts run(const char* name, int n, const Generator& generator)
{
  Random_numbers random(20240601);
  Counts counts;
  for(int i = 0; i < n; ++i)
    verify(generator(random), counts);
  report(name, counts);
  CHECK(counts.cases > n / 4);
  return counts;
}

Point random_point(Random_numbers& random, double size = 1)
{
  const double x = random.real(-size, size);
  return Point(x, random.real(-size, size));
}

Tensor rotating_tensor(Random_numbers& random, double ratio)
{
  return Tensor::from_sizes(1, ratio, random.real(0, 2*pi));
}

Case independent(Random_numbers& random, double ratio)
{
  Case c;
  for(int i = 0; i < 4; ++i) {
    c.points[i] = random_point(random);
    c.tensors[i] = rotating_tensor(random, ratio);
  }
  return c;
}

// sizes and directions that vary little over the configuration, which is about
// as anisotropic as the metric
Case smooth(Random_numbers& random, double ratio, double variation)
{
  const double angle = random.real(0, 2*pi), s = std::sin(angle), r = std::cos(angle);
  Case c;
  for(int i = 0; i < 4; ++i) {
    const Point p = random_point(random);
    const double u = p.x(), v = p.y() * ratio;
    c.points[i] = Point(r*u - s*v, s*u + r*v);
    c.tensors[i] = Tensor::from_sizes(1 + random.real(0, variation), ratio * (1 + random.real(0, variation)),
                                      angle + random.real(0, variation / ratio));
  }
  return c;
}

// four points on one ellipse, up to rounding, in tensors that are equal or nearly so
Case nearly_cocircular(Random_numbers& random, double ratio, double variation)
{
  Case c = smooth(random, ratio, 0);
  const double angle = random.real(0, 2*pi), s = std::sin(angle), r = std::cos(angle);
  for(int i = 0; i < 4; ++i) {
    const double t = random.real(0, 2*pi), u = std::cos(t), v = std::sin(t) * ratio;
    c.points[i] = Point(r*u - s*v, s*u + r*v);
    c.tensors[i] = Tensor::from_sizes(1, ratio * (1 + random.real(0, variation)), angle);
  }
  return c;
}

Tensor small_integer_tensor(Random_numbers& random)
{
  const int a = 1 + random.integer(3), c = 1 + random.integer(3);
  return Tensor::from_entries(a, a*c > 1 ? random.integer(3) - 1 : 0, c);
}

Case grid(Random_numbers& random, bool constant)
{
  Case c;
  const Tensor m = small_integer_tensor(random);
  for(int i = 0; i < 4; ++i) {
    const int x = random.integer(4);
    c.points[i] = Point(x, random.integer(4));
    c.tensors[i] = constant ? m : small_integer_tensor(random);
  }
  return c;
}

// the corners of a square, on which diagonal tensors have alpha = 1, and two
// tensors whose alphas are the inverse of each other
Case tie_of_different_alphas(Random_numbers& random)
{
  static const int pairs[3][2][3] = {{{1, 1, 2}, {1, -1, 2}}, {{1, 1, 4}, {3, -3, 4}}, {{3, 1, 4}, {4, -3, 5}}};
  const auto& chosen = pairs[random.integer(3)];
  const int first = 2 * random.integer(2);
  std::array<int, 4> order = {0, 1, 2, 3};
  random.shuffle(order);
  Case c;
  for(int i = 0; i < 4; ++i) {
    const int corner = (i + first) % 4;
    c.points[i] = Point(corner == 1 || corner == 2, corner >= 2);
    const int j = order[i];
    c.tensors[i] = j < 2 ? Tensor::from_entries(chosen[j][0], chosen[j][1], chosen[j][2])
                         : Tensor::from_entries(1 + random.integer(5), 0, 1 + random.integer(5));
  }
  return c;
}

Case moved_and_scaled(Case c, double dx, double dy, double scale)
{
  for(Point& p : c.points)
    p = Point((p.x() + dx) * scale, (p.y() + dy) * scale);
  return c;
}

// moves the last point to where the product of the alphas is 1, as close as
// the doubles permit
Case nearly_tied(Case c, Random_numbers& random)
{
  if(!orient(c))
    return c;
  Point inside = CGAL::centroid(c.points[0], c.points[1], c.points[2]), outside = c.points[3];
  for(int i = 0; i < 120 && inside != outside; ++i) {
    c.points[3] = CGAL::midpoint(inside, outside);
    if(c.points[3] == inside || c.points[3] == outside)
      break;
    (side(c) == CGAL::ON_POSITIVE_SIDE ? inside : outside) = c.points[3];
  }
  for(int i = random.integer(4); i > 0; --i)
    c.points[3] = Point(std::nextafter(c.points[3].x(), 1e300), c.points[3].y());
  return c;
}

void test_regular_cases()
{
  const Counts easy = run("smooth", 2000, [](Random_numbers& r) { return smooth(r, 2, 0.5); });
  CHECK(easy.certain > 0.99 * easy.cases);
  const Counts rotated = run("1000:1, independent", 2000, [](Random_numbers& r) { return independent(r, 1e3); });
  CHECK(rotated.certain > 0.99 * rotated.cases);
  run("1000:1, smooth", 2000, [](Random_numbers& r) { return smooth(r, 1e3, 0.5); });
  run("1e6:1, independent", 1500, [](Random_numbers& r) { return independent(r, 1e6); });
  run("1e6:1, smooth", 2000, [](Random_numbers& r) { return smooth(r, 1e6, 0.5); });
}

void test_degenerate_cases()
{
  for(double ratio : {1., 1e3, 1e6}) {
    run("nearly cocircular", 1000, [=](Random_numbers& r) { return nearly_cocircular(r, ratio, 0); });
    run("nearly cocircular, nearly constant", 1000,
        [=](Random_numbers& r) { return nearly_cocircular(r, ratio, 1e-13); });
  }
  const Counts constant = run("grid, constant", 3000, [](Random_numbers& r) { return grid(r, true); });
  CHECK(constant.ties > 100);
  const Counts varying = run("grid, varying", 6000, [](Random_numbers& r) { return grid(r, false); });
  CHECK(varying.ties > 100);
  const Counts mixed = run("ties of different alphas", 500, tie_of_different_alphas);
  CHECK(mixed.mixed_ties == mixed.cases);
  const Counts tied = run("nearly tied", 2000,
                          [](Random_numbers& r) { return nearly_tied(independent(r, 3), r); });
  CHECK(tied.certain < 0.9 * tied.cases); // else the cases do not test the bound
  run("nearly tied, rotating 20:1", 2000,
      [](Random_numbers& r) { return nearly_tied(smooth(r, 20, 2), r); });
  run("nearly tied, rotating 1000:1", 2000,
      [](Random_numbers& r) { return nearly_tied(smooth(r, 1e3, 1), r); });
}

void test_scaled_cases()
{
  for(double scale : {1e-30, 1e30}) {
    run("scaled", 700, [=](Random_numbers& r) { return moved_and_scaled(independent(r, 100), 0, 0, scale); });
    run("scaled, nearly tied", 700,
        [=](Random_numbers& r) { return nearly_tied(moved_and_scaled(independent(r, 3), 0, 0, scale), r); });
    run("scaled grid", 700,
        [=](Random_numbers& r) { return moved_and_scaled(grid(r, true), 0, 0, std::ldexp(1., std::ilogb(scale))); });
  }
  for(double offset : {1e3, 1e8, 1e12}) {
    run("far away", 700,
        [=](Random_numbers& r) { return moved_and_scaled(independent(r, 10), offset, -3*offset, 1); });
    run("far away, grid", 700,
        [=](Random_numbers& r) { return moved_and_scaled(grid(r, true), offset, -3*offset, 1); });
  }
}

// The four tensors sized by the point set, each up to 10^spread smaller or larger.
Case of_any_size(Random_numbers& random, double scale, double size, double spread)
{
  Case c = moved_and_scaled(independent(random, 2), 0, 0, scale);
  for(Tensor& m : c.tensors) {
    const double h = size * random.power_of_ten(-spread, spread);
    m = Tensor::from_sizes(h, h * random.power_of_ten(0, 1), random.real(0, pi));
  }
  return c;
}

// thin triangles seen from far away, where area and determinant are nearly lost in rounding
Case thin_and_far(Random_numbers& random)
{
  Case c = independent(random, 2);
  const double thin = random.power_of_ten(-17, -13), far = random.power_of_ten(3, 7);
  for(int i = 0; i < 3; ++i)
    c.points[i] = Point(c.points[i].x(), c.points[i].x() * 0.7 + thin * c.points[i].y());
  c.points[3] = Point(far * c.points[3].x(), far * c.points[3].y());
  return c;
}

// the ratio of the sizes is lost in rounding, and so may be lengths along the larger size
Case at_the_limit_of_ratios(Random_numbers& random)
{
  const double angle = random.real(0, pi), s = std::sin(angle), r = std::cos(angle);
  Case c;
  for(int i = 0; i < 4; ++i) {
    const double u = random.real(-1, 1), v = random.real(-1e-9, 1e-9);
    c.points[i] = Point(r*u - s*v, s*u + r*v);
    c.tensors[i] = Tensor::from_sizes(1e-8, 1 + random.integer(2), angle + pi/2 + random.real(-1e-9, 1e-9));
  }
  return c;
}

// The estimate is right whenever it is certain: tensors and coordinates of sizes
// that make the products of doubles underflow or overflow.
void test_estimate_at_its_limits()
{
  for(double scale : {1e-200, 1e-100, 1e-60, 1e-45, 1e-41, 1e-37, 1e-20, 1e-6,
                      1e20, 1e35, 1e45, 1e50, 1e55, 1e60, 1e100, 1e150}) {
    run("any size", 300, [=](Random_numbers& r) { return of_any_size(r, scale, 1, 3); });
    if(scale > 1e-70 && scale < 1e70)
      run("any size, sized like the points", 300, [=](Random_numbers& r) { return of_any_size(r, scale, scale, 3); });
    run("any size, any tensor", 300, [=](Random_numbers& r) { return of_any_size(r, scale, 1, 70); });
  }
  run("thin and far", 3000, [](Random_numbers& r) { return thin_and_far(r); });
  run("at the limit of ratios", 3000, [](Random_numbers& r) { return at_the_limit_of_ratios(r); });
}

int main()
{
  test_regular_cases();
  test_degenerate_cases();
  test_scaled_cases();
  test_estimate_at_its_limits();
  return finish();
}

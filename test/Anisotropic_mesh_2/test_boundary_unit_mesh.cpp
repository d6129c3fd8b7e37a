// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Riemannian lengths against closed forms and brute force, and the boundary
// meshes that are made of them.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Boundary_unit_mesher.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Riemannian_length_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Metric_tensor_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel       K;
typedef K::Point_2                                                Point;
typedef std::vector<Point>                                        Points;
typedef CGAL::Metric_tensor_2<K>                                  Tensor;
typedef CGAL::Anisotropic_mesh_domain_2<K>                        Domain;
typedef CGAL::Anisotropic_mesh_2::Curve_piece_2<K>                                    Piece;
namespace internal = CGAL::Anisotropic_mesh_2::internal;
typedef CGAL::Anisotropic_mesh_2::Boundary_graph_2<K>                Mesh;

const double pi = 3.141592653589793;
const std::size_t limit = 10000000;

template <class Field>
internal::Riemannian_length_2<K, Field> length_of(const Piece& piece, const Field& field)
{
  return internal::Riemannian_length_2<K, Field>(piece, field);
}

void check_close(double value, double expected, double tolerance, const std::string& what)
{
  CHECK_MSG(std::abs(value - expected) <= tolerance * std::abs(expected),
            what + ": " + internal::describe(value) + " instead of " + internal::describe(expected));
}

Domain polygon(const Points& points)
{
  Domain domain;
  domain.add_polygon(points);
  return domain;
}

Points rectangle(double width, double height)
{
  return Points{Point(0, 0), Point(width, 0), Point(width, height), Point(0, height)};
}

double doubled_area(const Mesh& mesh)
{
  double sum = 0;
  for(const auto& s : mesh.segments)
    if(s.is_boundary) {
      const Point &p = mesh.points[s.source], &q = mesh.points[s.target];
      sum += p.x()*q.y() - p.y()*q.x();
    }
  return sum;
}

// each boundary point has one boundary segment in and one out
bool is_oriented(const Mesh& mesh)
{
  std::map<std::size_t, int> in, out;
  for(const auto& s : mesh.segments)
    if(s.is_boundary) {
      ++out[s.source];
      ++in[s.target];
    }
  return in == out && std::all_of(in.begin(), in.end(), [](const auto& n) { return n.second == 1; });
}

std::size_t count(const Mesh& mesh, int reference)
{
  return std::count_if(mesh.segments.begin(), mesh.segments.end(),
                       [reference](const auto& s) { return s.reference == reference; });
}

void test_number_of_parts()
{
  CHECK(internal::number_of_unit_parts(0) == 1);
  CHECK(internal::number_of_unit_parts(1e-30) == 1);
  CHECK(internal::number_of_unit_parts(1) == 1);
  CHECK(internal::number_of_unit_parts(1.41) == 1);
  CHECK(internal::number_of_unit_parts(1.42) == 2);
  CHECK(internal::number_of_unit_parts(2.4494) == 2);
  CHECK(internal::number_of_unit_parts(2.45) == 3);
  CHECK(internal::number_of_unit_parts(1e9) == 1e9);
}

void test_closed_forms()
{
  const auto square4 = [](const Point& p) { return Tensor::from_sizes(0.031 + p.x()/4, 0.031 + p.y()/4); };
  const auto along = [](double x) { return 4 * std::log(1 + x/(4*0.031)); };
  const auto l = length_of(Piece::segment(Point(0, 1), Point(4, 1)), square4);
  check_close(l.total(), along(4), 1e-8, "square4");
  for(double t : {0.001, 0.01, 0.1, 0.5, 0.9}) {
    check_close(l.length(t), along(4*t), 1e-7, "square4, cumulative");
    check_close(l.parameter(along(4*t)), t, 1e-7, "square4, inverse");
  }
  CHECK(l.length(0) == 0 && l.length(1) == l.total() && l.parameter(l.total()) == 1);

  for(double small : {1e-2, 1e-4, 1e-6}) { // sizes from `small` to about 1 along the curve
    const auto steep = [small](const Point& p) { return Tensor::from_size(small + p.x()); };
    const auto steep_length = length_of(Piece::segment(Point(0, 0), Point(1, 0)), steep);
    check_close(steep_length.total(), std::log(1 + 1/small), 1e-7, "steep");
    check_close(steep_length.length(10*small), std::log(11.), 1e-6, "steep, cumulative");
    const auto valley = [small](const Point& p) { return Tensor::from_size(std::hypot(small, p.x() - 0.37)); };
    check_close(length_of(Piece::segment(Point(0, 0), Point(1, 0)), valley).total(),
                std::asinh(0.63/small) + std::asinh(0.37/small), 1e-7, "valley");
    const auto wave = [small](const Point& p) { return Tensor::from_size(std::exp(std::log(small) * (1 - std::cos(2*pi*p.x())) / 2)); };
    const double b = -std::log(small) / 2;
    check_close(length_of(Piece::segment(Point(0, 0), Point(1, 0)), wave).total(), std::exp(b) * std::cyl_bessel_i(0, b),
                1e-7, "wave");
  }
}

void test_jumps()
{
  int calls = 0;
  const auto steps = [&calls](const Point& p) {
    ++calls;
    return Tensor::from_size(p.x() < 0.3 ? 1 : p.x() < 1/std::sqrt(2.) ? 1e-3 : 1e3);
  };
  const auto l = length_of(Piece::segment(Point(0, 0), Point(1, 0)), steps);
  check_close(l.total(), 0.3 + (std::sqrt(0.5) - 0.3)*1e3 + (1 - std::sqrt(0.5))*1e-3, 1e-7, "steps");
  CHECK_MSG(calls < 200000, "calls of the field: " + std::to_string(calls));

  calls = 0;
  const auto noise = [&calls](const Point& p) {
    ++calls;
    return Tensor::from_size(1.5 + std::sin(1e9 * p.x()));
  };
  const double total = length_of(Piece::segment(Point(0, 0), Point(1, 0)), noise).total();
  CHECK(total > 0.4 && total < 2);
  CHECK_MSG(calls < 100000, "calls of the field: " + std::to_string(calls));
}

void test_curves()
{
  const Tensor m = Tensor::from_sizes(0.2, 0.01, 0.4);
  const auto constant = [&m](const Point&) { return m; };
  double ellipse = 0; // the rectangle rule is exact to rounding for periodic functions
  const int n = 200000;
  for(int i = 0; i < n; ++i) {
    const double a = 2*pi*i/n;
    ellipse += std::sqrt(m.squared_length(-3*std::sin(a), 3*std::cos(a))) * 2*pi/n;
  }
  check_close(length_of(Piece::arc(Point(1, 2), 3, 0, 2*pi), constant).total(), ellipse, 1e-7, "ellipse");
  check_close(length_of(Piece::arc(Point(1, 2), 3, pi, -pi), constant).total(), ellipse, 1e-7, "ellipse, clockwise");
  const auto unit = [](const Point&) { return Tensor::from_size(1); };
  const auto uneven = [](double t) { return Point(std::cos(t*t*t), std::sin(t*t*t)); };
  check_close(length_of(Piece::parametrized(uneven, 0, 1.5), unit).total(), 1.5*1.5*1.5, 1e-7, "uneven");
  const auto polar = [](const Point& p) { return Tensor::from_size(0.1 * std::hypot(p.x(), p.y())); };
  check_close(length_of(Piece::arc(Point(0, 0), 7, 1, 2), polar).total(), 10, 1e-7, "around the centre");
  const auto corner = [](double t) { return Point(t, std::abs(t)); };
  check_close(length_of(Piece::parametrized(corner, -1, 2), unit).total(), 3*std::sqrt(2.), 1e-7, "corner");
}

void test_limits()
{
  const auto tiny = [](const Point&) { return Tensor::from_size(1e-12); };
  CHECK_THROWS(internal::unit_boundary_graph(polygon(rectangle(1, 1)), tiny, limit),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "more than the limit of 10000000");
  CHECK_THROWS(internal::unit_boundary_graph(polygon(rectangle(1, 0.1)), [](const Point&) { return Tensor::from_size(0.1); }, 21),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "the metric asks for about 22 vertices on the boundary, more than the limit of 21");
  // the area, before the boundary is subdivided: no point on it is asked for
  int on_boundary = 0;
  const auto dense = [&on_boundary](const Point& p) {
    on_boundary += p.x() == 0 || p.y() == 0 || p.x() == 1 || p.y() == 1;
    return Tensor::from_size(1e-4);
  };
  CHECK_THROWS(internal::unit_boundary_graph(polygon(rectangle(1, 1)), dense, limit),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "1.1547e+08");
  CHECK(on_boundary == 0);
  const auto hollow = [](const Point& p) { return Tensor::from_size(p.x() - 0.5); };
  CHECK_THROWS(internal::unit_boundary_graph(polygon(rectangle(1, 1)), hollow, limit),
               CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "at the point (0, 0)");
}

// Metric lengths of the chords of a straight mesh, in order.
template <class Field>
std::vector<double> lengths(const Mesh& mesh, const Field& field)
{
  std::vector<double> result;
  for(const auto& s : mesh.segments)
    result.push_back(length_of(Piece::segment(mesh.points[s.source], mesh.points[s.target]), field).total());
  return result;
}

void test_equal_lengths()
{
  const auto square4 = [](const Point& p) { return Tensor::from_sizes(0.031 + p.x()/4, 0.031 + p.y()/4); };
  Domain domain;
  const Points corners = rectangle(4, 4);
  for(int i = 0; i < 4; ++i)
    domain.add_loop(std::vector<Piece>{Piece::segment(corners[i], corners[(i+1) % 4], i)});
  const Mesh mesh = internal::unit_boundary_graph(domain, square4, limit);
  const double expected = 4 * std::log(1 + 1/0.031), n = internal::number_of_unit_parts(expected);
  CHECK(is_oriented(mesh));
  check_close(doubled_area(mesh), 32, 1e-12, "area");
  for(int i = 0; i < 4; ++i)
    CHECK(count(mesh, i) == std::size_t(n));
  for(double l : lengths(mesh, square4))
    check_close(l, expected/n, 1e-7, "length of a part");
  for(const Point& p : corners)
    CHECK(std::count(mesh.points.begin(), mesh.points.end(), p) == 1);
  for(const Point& p : mesh.points)
    CHECK(p.x() == 0 || p.x() == 4 || p.y() == 0 || p.y() == 4);

  const Mesh kept = internal::unit_boundary_graph(domain, square4, limit, true);
  CHECK(kept.points.size() == 4 && kept.segments.size() == 4);
}

void test_oblique_area()
{
  const Points points{Point(0.1, 0.3), Point(7.7, -1.3), Point(9.1, 3.3), Point(4.2, 2.9), Point(3.3, 8.7), Point(-2.1, 5.5)};
  const auto field = [](const Point& p) { return Tensor::from_size(0.01 + 0.003 * std::abs(p.x())); };
  const double area = doubled_area(internal::unit_boundary_graph(polygon(points), field, limit, true));
  check_close(doubled_area(internal::unit_boundary_graph(polygon(points), field, limit)), area, 1e-12, "oblique area");
}

void test_circle()
{
  Domain disc;
  disc.add_circle(Point(0, 0), 1, 9);
  const auto huge = [](const Point&) { return Tensor::from_size(1e6); };
  const Mesh coarse = internal::unit_boundary_graph(disc, huge, limit);
  CHECK(coarse.segments.size() == 8 && count(coarse, 9) == 8);
  CHECK(is_oriented(coarse) && doubled_area(coarse) > 0);
  const auto fine = [](const Point&) { return Tensor::from_size(2*pi/100); };
  const Mesh mesh = internal::unit_boundary_graph(disc, fine, limit);
  CHECK(mesh.points.size() == 100);
  check_close(doubled_area(mesh), 100 * std::sin(2*pi/100), 1e-9, "area of the regular 100-gon");
  for(double l : lengths(mesh, fine))
    check_close(l, 2*std::sin(pi/100) / (2*pi/100), 1e-7, "side of the regular 100-gon");

  const Tensor m = Tensor::from_sizes(0.2, 0.05, 0.4); // equal lengths along an ellipse
  const auto constant = [&m](const Point&) { return m; };
  const auto l = length_of(Piece::arc(Point(0, 0), 1, 0, 2*pi), constant);
  const Mesh oval = internal::unit_boundary_graph(disc, constant, limit);
  CHECK(oval.points.size() == internal::number_of_unit_parts(l.total()));
  for(const auto& s : oval.segments) {
    const Point &p = oval.points[s.source], &q = oval.points[s.target];
    const double a = std::atan2(p.y(), p.x()), b = std::remainder(std::atan2(q.y(), q.x()) - a, 2*pi);
    check_close(length_of(Piece::arc(Point(0, 0), 1, a, a + b), constant).total(),
                l.total() / double(oval.points.size()), 1e-6, "part of an ellipse");
  }
}

// The chords of a circle leave it by at most a quarter of the size across it, which is sagitta over that size.
void test_layer_along_circle()
{
  Domain disc;
  disc.add_circle(Point(0, 0), 1);
  for(double across : {0.1, 1e-2, 1e-4, 1e-6}) {
    const auto layer = [across](const Point& p)
      { return Tensor::from_sizes(across + 0.2 * std::abs(1 - std::hypot(p.x(), p.y())), 0.1, std::atan2(p.y(), p.x())); };
    const Mesh mesh = internal::unit_boundary_graph(disc, layer, limit);
    double farthest = 0;
    for(const auto& s : mesh.segments) {
      const Point m = CGAL::midpoint(mesh.points[s.source], mesh.points[s.target]);
      farthest = (std::max)(farthest, (1 - std::hypot(m.x(), m.y())) / across);
    }
    CHECK_MSG(farthest < 0.26, internal::describe(farthest));
    const double enough = 2*pi / (std::min)(0.1, std::sqrt(8 * 0.25 * across)); // arcs of unit length, or that flat
    CHECK_MSG(double(mesh.points.size()) < 1.3 * enough + 2, internal::describe(double(mesh.points.size())));
  }
}

void test_near_curves()
{
  const auto coarse = [](const Point&) { return Tensor::from_size(100); };
  Domain gap; // a hole that almost touches the circle around it
  gap.add_circle(Point(0, 0), 1);
  gap.add_circle(Point(0.5, 0.1), 0.49 - 1e-4);
  const Mesh mesh = internal::unit_boundary_graph(gap, coarse, limit);
  CHECK(is_oriented(mesh));
  CHECK(mesh.points.size() > 16 && mesh.points.size() < 200);
  gap.add_circle(Point(-0.98 * std::cos(0.3), 0.98 * std::sin(0.3)), 1e-3); // between an arc and its chord
  const Mesh with_hole = internal::unit_boundary_graph(gap, coarse, limit);
  Domain again;
  std::vector<Point> outer;
  for(const auto& s : with_hole.segments)
    again.add_loop(std::vector<Piece>{Piece::segment(with_hole.points[s.source], with_hole.points[s.target])});
  const internal::Domain_preparation<K> prepared(again.pieces(), again.rule(), again.holes());
  for(std::size_t i = 0; i < prepared.pieces().size(); ++i) // the polygons have the same inside
    CHECK(prepared.pieces()[i].curve.source() == again.pieces()[i].curve.source());

  Domain lens; // two flat arcs with the same ends
  const auto above = [](double t) { return Point(t, 1e-3 * (1 - t*t)); };
  const auto below = [](double t) { return Point(t, -1e-3 * (1 - t*t)); };
  lens.add_loop(std::vector<Piece>{Piece::parametrized(above, 1, -1), Piece::parametrized(below, -1, 1)});
  CHECK(internal::unit_boundary_graph(lens, coarse, limit).segments.size() == 4);
  const auto kink = [](double t) { return Point(t, std::abs(t - 0.2137)); };
  Domain corner;
  corner.add_loop(std::vector<Piece>{Piece::parametrized(kink, 1, -1), Piece::segment(kink(-1), kink(1))});
  CHECK(internal::unit_boundary_graph(corner, coarse, limit).segments.size() == 3); // no bisection at the corner
}

Domain l_shape(double s)
{
  Domain domain = polygon(Points{Point(0, 0), Point(2*s, 0), Point(2*s, s), Point(s, s), Point(s, 2*s), Point(0, 2*s)});
  domain.add_circle(Point(0.5*s, 0.5*s), 0.25*s, 2);
  domain.add_constraint(Piece::arc(Point(2*s, 0), 0.5*s, pi/2, pi, 3));
  return domain;
}

void test_shapes_and_scales()
{
  std::size_t points = 0;
  for(double s : {1., 1e-30, 1e-9, 1e30}) {
    const auto field = [s](const Point& p) { return Tensor::from_size(0.03*s + p.x()/20 + p.y()/30); };
    const Mesh mesh = internal::unit_boundary_graph(l_shape(s), field, limit);
    CHECK(is_oriented(mesh));
    CHECK(count(mesh, 2) >= 8 && count(mesh, 3) >= 2);
    points = points == 0 ? mesh.points.size() : points;
    CHECK_MSG(mesh.points.size() == points, "points " + std::to_string(mesh.points.size()) + " at scale " + internal::describe(s));
    check_close(doubled_area(mesh) / s / s, 6 - 2*pi/16, 0.01, "area of the L");
    std::map<std::size_t, std::vector<double> > at_point; // lengths of neighbors at the ends of pieces
    const std::vector<double> l = lengths(mesh, field);
    for(std::size_t i = 0; i < l.size(); ++i)
      for(std::size_t v : {mesh.segments[i].source, mesh.segments[i].target})
        at_point[v].push_back(l[i]);
    for(const auto& p : at_point)
      CHECK(*std::max_element(p.second.begin(), p.second.end()) < 2 * *std::min_element(p.second.begin(), p.second.end()));
  }

  Domain annulus;
  annulus.add_circle(Point(0, 0), 1);
  annulus.add_circle(Point(0, 0), 0.5);
  const auto uniform = [](const Point&) { return Tensor::from_size(0.1); };
  const Mesh ring = internal::unit_boundary_graph(annulus, uniform, limit);
  CHECK(ring.segments.size() == 63 + 31 && is_oriented(ring));
  check_close(doubled_area(ring), 2*pi*0.75, 0.01, "area of the annulus");

  const double w = 1e-6; // a slit-like notch
  const Mesh notch = internal::unit_boundary_graph(
    polygon(Points{Point(0, 0), Point(1, 0), Point(1, 1), Point(0.5 + w/2, 1), Point(0.51, 0.2), Point(0.5 - w/2, 1), Point(0, 1)}),
    uniform, limit);
  CHECK(is_oriented(notch));
  check_close(doubled_area(notch), 2 - 0.8*w, 1e-12, "area with a notch");
  Domain again;
  for(const auto& s : notch.segments)
    again.add_loop(std::vector<Piece>{Piece::segment(notch.points[s.source], notch.points[s.target])});
  again.validate();
}

void test_passed_on()
{
  Domain domain = polygon(rectangle(4, 4));
  domain.add_polygon(Points{Point(1, 1), Point(1, 2), Point(2, 2)}, 5);
  domain.add_hole(Point(1.1, 1.5));
  domain.add_region(Point(3, 3), 8);
  domain.add_polyline(Points{Point(3, 0), Point(3, 1)}, 6);
  const auto field = [](const Point&) { return Tensor::from_size(0.5); };
  const Mesh mesh = internal::unit_boundary_graph(domain, field, limit);
  CHECK(mesh.regions.size() == 1 && mesh.regions[0].reference == 8);
  CHECK(count(mesh, 6) == 2 && count(mesh, 5) == 2 + 2 + 3);
  for(const auto& s : mesh.segments)
    CHECK(s.is_boundary == (s.reference != 6));
  CHECK(is_oriented(mesh));
  check_close(doubled_area(mesh), 31, 1e-12, "area with a hole");
}

int main()
{
  test_number_of_parts();
  test_closed_forms();
  test_jumps();
  test_curves();
  test_limits();
  test_equal_lengths();
  test_oblique_area();
  test_circle();
  test_layer_along_circle();
  test_near_curves();
  test_shapes_and_scales();
  test_passed_on();
  return finish();
}

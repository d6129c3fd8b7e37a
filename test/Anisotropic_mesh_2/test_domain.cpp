// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

// Domains: what is accepted, and each kind of bad input with its message.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <random>
#include <set>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel       K;
typedef K::Point_2                                                Point;
typedef std::vector<Point>                                        Points;
typedef CGAL::Anisotropic_mesh_domain_2<K>                        Domain;
typedef CGAL::Curve_piece_2<K>                                    Piece;
typedef CGAL::Anisotropic_mesh_2::Domain_rule                     Rule;
typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K> Graph;
typedef CGAL::Anisotropic_mesh_2::internal::Domain_preparation<K> Preparation;
typedef CGAL::Anisotropic_mesh_2::internal::Piece_role            Role;
typedef CGAL::Invalid_domain_exception                            Bad;

const double pi = 3.141592653589793;
const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Points square(double s, double x = 0, double y = 0)
{
  return Points{Point(x, y), Point(x + s, y), Point(x + s, y + s), Point(x, y + s)};
}

Domain polygon(const Points& points)
{
  Domain domain;
  domain.add_polygon(points);
  return domain;
}

bool is_valid(const Domain& domain)
{
  try {
    domain.validate();
    return true;
  } catch(const Bad& e) {
    std::cerr << "unexpected: " << e.what() << std::endl;
    return false;
  }
}

int count(const Domain& domain, Role role)
{
  const Preparation preparation(domain.pieces(), domain.rule(), domain.holes());
  int n = 0;
  for(const auto& piece : preparation.pieces())
    n += piece.role == role;
  return n;
}

Graph graph_of(const Points& points, const std::vector<std::array<std::size_t, 2> >& edges)
{
  Graph graph;
  graph.points = points;
  for(const auto& e : edges)
    graph.edges.push_back({e[0], e[1], int(10 + graph.edges.size())});
  return graph;
}

void test_curve_pieces()
{
  const Piece quarter = Piece::arc(Point(1, 2), 3, 0, pi/2, 5);
  CHECK(quarter.source() == Point(4, 2));
  CHECK(quarter.target() == Point(1, 5));
  CHECK(quarter.reference() == 5);
  CHECK(!quarter.is_straight() && !quarter.is_closed());
  CHECK(std::abs(quarter.point(0.5).x() - 1 - 3*std::sqrt(0.5)) < 1e-14);
  CHECK(quarter.reversed().source() == Point(1, 5));
  CHECK(quarter.reversed().point(0.25) == quarter.point(0.75));
  CHECK(Piece::arc(Point(0, 0), 2, -pi, pi).is_closed());
  CHECK(Piece::arc(Point(0, 0), 2, 0.3, 0.3 + 2*pi).is_closed());
  CHECK(Piece::arc(Point(0, 0), 2, 3*pi/2, pi).source() == Point(0, -2));

  const Piece edge = Piece::segment(Point(0.1, 0.7), Point(0.1, 0.9));
  for(int i = 0; i <= 10; ++i)
    CHECK(edge.point(i / 10.).x() == 0.1);
  CHECK(edge.is_straight());

  const Piece curve = Piece::parametrized([](double t) { return Point(t, t*t); }, 2, -1);
  CHECK(curve.source() == Point(2, 4) && curve.target() == Point(-1, 1));
  CHECK(curve.point(1/3.) == Point(1, 1));
  CHECK(curve.with_end_points(Point(2, 4 + 1e-12), Point(-1, 1)).source() == Point(2, 4 + 1e-12));
}

void test_bad_pieces()
{
  CHECK_THROWS(Piece::segment(Point(0, nan_value), Point(1, 1)), Bad, "the point (0, nan) is not finite");
  CHECK_THROWS(Piece::segment(Point(0, 0), Point(infinity, 1)), Bad, "the point (inf, 1) is not finite");
  CHECK_THROWS(Piece::arc(Point(0, 0), nan_value, 0, 1), Bad, "the radius nan");
  CHECK_THROWS(Piece::arc(Point(0, 0), -1, 0, 1), Bad, "the radius -1");
  CHECK_THROWS(Piece::arc(Point(0, 0), 1, 0, infinity), Bad, "to inf is empty or more than a full turn");
  CHECK_THROWS(Piece::arc(Point(0, 0), 1, 0, 7), Bad, "more than a full turn");
  CHECK_THROWS(Piece::arc(Point(0, 0), 1, 1, 1), Bad, "from the angle 1 to 1 is empty");
  const auto root = [](double t) { return Point(t, std::sqrt(t)); };
  CHECK_THROWS(Piece::parametrized(root, -1, 1), Bad, "not finite at the parameter -1");
  CHECK_THROWS(Piece::parametrized(root, 0, nan_value), Bad, "has no length");
  const auto pole = [](double t) { return Point(t, 1/t); };
  CHECK_THROWS(Piece::parametrized(pole, -1, 1).point(0.5), Bad, "not finite at the parameter 0:");
  CHECK_THROWS(Piece::arc(Point(0, 0), 1, 0, 1).with_end_points(Point(1, 1), Point(0, 1)), Bad, "are not on the curve");
}

void test_accepted()
{
  CHECK(is_valid(polygon(square(1))));
  CGAL::Polygon_2<K> triangle;
  for(const Point& p : {Point(0, 0), Point(1, 0), Point(0, 1)})
    triangle.push_back(p);
  Domain domain;
  domain.add_polygon(triangle);
  CHECK(is_valid(domain));

  Domain disc;
  disc.add_circle(Point(0, 0), 1);
  CHECK(is_valid(disc));
  disc.add_circle(Point(0.1, 0), 0.899999); // a gap of 1e-6
  CHECK(is_valid(disc));
  disc.add_circle(Point(0.05, 0), 0.01);    // an island
  CHECK(is_valid(disc));

  Domain halves;
  const Piece arc = Piece::arc(Point(0, 0), 1, 0, pi);
  halves.add_loop(std::list<Piece>{arc, Piece::segment(arc.target(), arc.source())});
  CHECK(is_valid(halves));

  const double notch = 1e-6;
  CHECK(is_valid(polygon(Points{Point(0, 0), Point(1, 0), Point(1, 1), Point(0.5 + notch/2, 1), Point(0.5, 0.2),
                                Point(0.5 - notch/2, 1), Point(0, 1)})));
}

void test_scales()
{
  for(double s : {1e-30, 1e-5, 1., 1e30}) {
    Domain domain = polygon(Points{Point(0, 0), Point(2*s, 0), Point(2*s, s), Point(s, s), Point(s, 2*s), Point(0, 2*s)});
    domain.add_circle(Point(0.5*s, 0.5*s), 0.3*s);
    domain.add_constraint(Piece::arc(Point(2*s, 0), 0.5*s, pi/2, pi));
    CHECK(is_valid(domain));
    domain.add_circle(Point(1.1*s, 0.9*s), 0.3*s);
    CHECK_THROWS(domain.validate(), Bad, "cross or overlap near");
  }
}

void test_inner_curves()
{
  Domain domain = polygon(square(1));
  domain.add_polyline(Points{Point(0.5, 0), Point(0.5, 0.5), Point(1, 0.5)}, 3);   // ends within edges
  domain.add_polyline(Points{Point(0, 0), Point(0.25, 0.25)}, 4);                  // starts at a corner
  domain.add_polyline(Points{Point(0.5, 0.25), Point(0.75, 0.25), Point(0.75, 0.5)}, 5); // on inner curves
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 6);
  CHECK(count(domain, Role::CONSTRAINT) == 7);

  Domain oblique = polygon(Points{Point(0, 0), Point(3, 1), Point(0, 7)});
  oblique.add_polyline(Points{Point(0.3, 0.1), Point(1/3., 7 - 2/3.)}); // on the edges up to rounding
  CHECK(is_valid(oblique));
  CHECK(count(oblique, Role::BOUNDARY) == 5);

  Domain disc;
  disc.add_circle(Point(0, 0), 1);
  disc.add_polyline(Points{Point(std::cos(1.), std::sin(1.)), Point(std::cos(4.), std::sin(4.))});
  CHECK(is_valid(disc));
  CHECK(count(disc, Role::BOUNDARY) == 3);

  Domain outside = polygon(square(1));
  outside.add_polyline(Points{Point(2, 0), Point(3, 0)});
  CHECK_THROWS(outside.validate(), Bad, "the segment 5 from (2, 0) to (3, 0) lies outside the domain");
  Domain leaving = polygon(square(1));
  leaving.add_polyline(Points{Point(0.5, 0.5), Point(1.5, 0.6)});
  CHECK_THROWS(leaving.validate(), Bad, "the segment 2 from (1, 0) to (1, 1) and the segment 5 from (0.5, 0.5)");
  Domain crossing = polygon(square(1));
  crossing.add_polyline(Points{Point(0.25, 0.25), Point(0.75, 0.75)});
  crossing.add_polyline(Points{Point(0.25, 0.75), Point(0.75, 0.25)});
  CHECK_THROWS(crossing.validate(), Bad, "cross or overlap near (0.5, 0.5)");
}

void test_coinciding_pieces()
{
  Domain domain = polygon(square(1));
  domain.add_polygon(square(1, 1, 0)); // shares an edge
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 6 && count(domain, Role::CONSTRAINT) == 1);

  Domain lens;
  const Piece left = Piece::arc(Point(0, 0), 1, pi/2, 3*pi/2), right = Piece::arc(Point(0, 0), 1, pi/2, -pi/2);
  const Piece bow = Piece::arc(Point(0, 0), 1, -pi/2, pi/2);
  lens.add_loop(std::vector<Piece>{left, Piece::segment(Point(0, -1), Point(0, 1))});
  lens.add_loop(std::vector<Piece>{right, Piece::segment(Point(0, -1), Point(0, 1))});
  CHECK(is_valid(lens));
  CHECK(count(lens, Role::BOUNDARY) == 2 && count(lens, Role::CONSTRAINT) == 1);
  lens.add_loop(std::vector<Piece>{bow, Piece::parametrized([](double t) { return Point(1.5*std::cos(t), std::sin(t)); },
                                                            pi/2, -pi/2).with_end_points(Point(0, 1), Point(0, -1))});
  CHECK(is_valid(lens));
  CHECK(count(lens, Role::BOUNDARY) == 2 && count(lens, Role::CONSTRAINT) == 2);

  Domain twice = polygon(square(1));
  twice.add_polygon(square(1));
  CHECK_THROWS(twice.validate(), Bad, "encloses no area");
}

void test_bad_boundaries()
{
  CHECK_THROWS(Domain().validate(), Bad, "the domain is empty");
  Domain curves;
  curves.add_polyline(square(1));
  CHECK_THROWS(curves.validate(), Bad, "the domain is empty");
  CHECK_THROWS(polygon(Points{Point(0, nan_value), Point(1, 0), Point(0, 1)}), Bad, "not finite");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 0), Point(1, 0), Point(0, 1)}).validate(), Bad,
               "the segment 2 from (1, 0) to (1, 0) has zero length");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 0)}).validate(), Bad, "encloses no area");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 1), Point(1, 0), Point(0, 1)}).validate(), Bad,
               "the segment 1 from (0, 0) to (1, 1) and the segment 3 from (1, 0) to (0, 1) cross or overlap near (0.5, 0.5)");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 0), Point(0.5, 0.5), Point(1, 1), Point(0, 1), Point(0.5, 0.5)}).validate(),
               Bad, "the boundary touches itself at (0.5, 0.5)");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(2, 0), Point(2, 2), Point(1, 0), Point(0, 2)}).validate(),
               Bad, "the boundary touches itself at (1, 0)");
  Domain corner = polygon(square(1));
  corner.add_polygon(square(1, 1, 1));
  CHECK_THROWS(corner.validate(), Bad, "the boundary touches itself at (1, 1)");
  Domain open;
  open.add_loop(std::vector<Piece>{Piece::segment(Point(0, 0), Point(1, 0)), Piece::segment(Point(1, 0), Point(0, 1)),
                                   Piece::segment(Point(0, 1), Point(0, 1e-15))});
  CHECK_THROWS(open.validate(), Bad, "the boundary is open at (0, 0)");
  Domain tangent;
  tangent.add_circle(Point(0, 0), 1);
  tangent.add_circle(Point(2, 0), 1);
  CHECK_THROWS(tangent.validate(), Bad, "cross or overlap near (1, 0)");
  Domain circles;
  circles.add_circle(Point(0, 0), 1);
  circles.add_circle(Point(1, 0), 1);
  CHECK_THROWS(circles.validate(), Bad, "cross or overlap near");
}

void test_seeds()
{
  Domain domain = polygon(square(4));
  domain.add_polygon(square(1, 1, 1));
  domain.add_polygon(square(0.5, 2.5, 2.5));
  CHECK(count(domain, Role::BOUNDARY) == 12);
  domain.add_hole(Point(1.5, 1.5));
  CHECK(domain.rule() == Rule::SEEDS);
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 8 && count(domain, Role::CONSTRAINT) == 4);
  domain.add_hole(Point(0.5, 0.5));
  CHECK(count(domain, Role::BOUNDARY) == 4);
  domain.add_hole(Point(2.6, 2.6));
  CHECK_THROWS(domain.validate(), Bad, "encloses no area");
  CHECK_THROWS(domain.add_hole(Point(nan_value, 0)), Bad, "the seed (nan, 0) of a hole is not finite");
  CHECK_THROWS(domain.add_region(Point(0, infinity), 1), Bad, "the seed (0, inf) of a region is not finite");

  Domain open;
  open.set_rule(Rule::SEEDS);
  open.add_loop(std::vector<Piece>{Piece::segment(Point(0, 0), Point(1, 0)), Piece::segment(Point(1, 0), Point(1, 1))});
  CHECK_THROWS(open.validate(), Bad, "the boundary is open at (0, 0)");
}

void test_graphs()
{
  Points points = square(4);
  for(const Point& p : square(1, 1, 1))
    points.push_back(p);
  points.push_back(Point(3, 3));
  const Graph annulus = graph_of(points, {{0, 1}, {2, 1}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {2, 8}});
  const Domain domain(annulus);
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 8 && count(domain, Role::CONSTRAINT) == 1);

  Graph linked = annulus;   // a cut from the outer loop to the hole
  linked.edges.push_back({0, 4, 1});
  CHECK(count(Domain(linked), Role::BOUNDARY) == 8 && count(Domain(linked), Role::CONSTRAINT) == 2);
  Graph divided = annulus;  // two cuts: one component with odd vertices
  divided.edges.push_back({0, 4, 1});
  divided.edges.push_back({1, 5, 1});
  CHECK(count(Domain(divided), Role::BOUNDARY) == 4 && count(Domain(divided), Role::CONSTRAINT) == 7);

  Graph open = graph_of(square(1), {{0, 1}, {1, 2}, {2, 3}});
  CHECK_THROWS(Domain(open).validate(), Bad, "the boundary is open at (0, 0)");
  open.edges.push_back({3, 9, 1});
  CHECK_THROWS(Domain{open}, Bad, "the edge 4 names the point 10, but there are 4");
  Graph doubled = annulus;
  doubled.points[8] = doubled.points[5];
  CHECK_THROWS(Domain{doubled}, Bad, "duplicate points: 6 and 9 are both (2, 1)");
  Graph not_finite = annulus;
  not_finite.points[3] = Point(0, -infinity);
  CHECK_THROWS(Domain{not_finite}, Bad, "the point 4 is not finite: (0, -inf)");
  Graph loop = annulus;
  loop.edges.push_back({8, 8, 1});
  CHECK_THROWS(Domain(loop).validate(), Bad, "the segment 10 from (3, 3) to (3, 3) has zero length");
  Graph crossing = graph_of(Points{Point(0, 0), Point(1, 1), Point(1, 0), Point(0, 1)}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK_THROWS(Domain(crossing).validate(), Bad, "the segment 1 from (0, 0) to (1, 1) and the segment 3");
}

void test_triangle_meshes()
{
  Graph graph = graph_of(Points{Point(0, 0), Point(1, 0), Point(2, 0), Point(2, 1), Point(1, 1), Point(0, 1)}, {{0, 1}, {1, 3}});
  graph.triangles = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  graph.triangle_references = {1, 1, 2, 2};
  const Domain domain(graph);
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 6 && count(domain, Role::CONSTRAINT) == 2);
  CHECK(domain.regions().size() == 3);
  CHECK(domain.regions()[0].reference == 1 && domain.regions()[1].reference == 2);
  for(const auto& piece : domain.pieces())
    if(piece.number == 1)
      CHECK(piece.curve.reference() == 10 && piece.role == Role::BOUNDARY);
    else if(piece.number == 2)
      CHECK(piece.curve.reference() == 11 && piece.role == Role::CONSTRAINT);
    else
      CHECK(piece.curve.reference() == 0);

  Graph pages = graph;
  pages.triangles.push_back({1, 4, 5});
  CHECK_THROWS(Domain{pages}, Bad, "the edge from (1, 0) to (1, 1) belongs to more than two triangles");
  Graph out_of_range = graph;
  out_of_range.triangles[2][1] = 6;
  CHECK_THROWS(Domain{out_of_range}, Bad, "the triangle 3 names the point 7, but there are 6");
}

bool has_repeated_edge(const Points& p)
{
  std::set<std::pair<Point, Point> > edges;
  for(std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i+1) % p.size()];
    if(!edges.insert(a < b ? std::make_pair(a, b) : std::make_pair(b, a)).second)
      return true;
  }
  return false;
}

// Random polygons on a small grid, full of degeneracies: valid iff simple.
void test_against_is_simple()
{
  std::mt19937 random(7);
  int simple = 0, others = 0;
  for(int trial = 0; trial < 4000; ++trial) {
    Points points;
    for(std::size_t n = 3 + random() % 5; n > 0; --n)
      points.push_back(Point(random() % 5, random() % 5));
    if(has_repeated_edge(points))
      continue;
    bool valid = true;
    try { polygon(points).validate(); } catch(const Bad&) { valid = false; }
    const bool expected = CGAL::is_simple_2(points.begin(), points.end(), K());
    CHECK(valid == expected);
    ++(expected ? simple : others);
  }
  CHECK(simple > 500 && others > 500);
}

// Edges in any order and direction give the same loops: a square, a divided
// square in it, which is a hole, and a divided square besides.
void test_order_of_edges()
{
  std::mt19937 random(3);
  Points points = square(8);
  for(const Points& p : {square(2, 1, 1), square(2, 10, 1)})
    points.insert(points.end(), p.begin(), p.end());
  std::vector<std::array<std::size_t, 2> > edges;
  for(std::size_t i = 0; i < points.size(); ++i)
    edges.push_back({i, i % 4 == 3 ? i - 3 : i + 1});
  edges.push_back({4, 6});
  edges.push_back({9, 11});
  for(int trial = 0; trial < 50; ++trial) {
    std::shuffle(edges.begin(), edges.end(), random);
    for(auto& e : edges)
      if(random() % 2 == 0)
        std::swap(e[0], e[1]);
    const Domain domain(graph_of(points, edges));
    CHECK(is_valid(domain));
    CHECK(count(domain, Role::BOUNDARY) == 12 && count(domain, Role::CONSTRAINT) == 1);
  }
}

int main()
{
  test_curve_pieces();
  test_bad_pieces();
  test_accepted();
  test_scales();
  test_inner_curves();
  test_coinciding_pieces();
  test_bad_boundaries();
  test_seeds();
  test_graphs();
  test_triangle_meshes();
  test_against_is_simple();
  test_order_of_edges();
  return finish();
}

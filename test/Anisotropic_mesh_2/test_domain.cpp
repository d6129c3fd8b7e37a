// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Domains: what is accepted, and each kind of bad input with its message.

#include "include/domain_test.h"

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <list>
#include <random>
#include <set>
#include <utility>
#include <vector>

const double pi = 3.141592653589793;

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
  CHECK_THROWS(outside.validate(), Bad, "segment 5 from (2, 0) to (3, 0) lies outside the domain");
  Domain leaving = polygon(square(1));
  leaving.add_polyline(Points{Point(0.5, 0.5), Point(1.5, 0.6)});
  CHECK_THROWS(leaving.validate(), Bad, "segment 2 from (1, 0) to (1, 1) and segment 5 from (0.5, 0.5)");
  Domain crossing = polygon(square(1));
  crossing.add_polyline(Points{Point(0.25, 0.25), Point(0.75, 0.75)});
  crossing.add_polyline(Points{Point(0.25, 0.75), Point(0.75, 0.25)});
  CHECK_THROWS(crossing.validate(), Bad, "cross or overlap near (0.5, 0.5)");
}

// Inner curves that end anywhere on a circle, also where that is farthest out in the direction of some box around it.
void test_ends_on_circle()
{
  for(int k = 0; k < 400; ++k) {
    Domain domain;
    domain.add_circle(Point(0, 0), 1);
    const double angle = 2 * pi * (k + 0.37) / 400;
    domain.add_polyline(Points{Point(0, 0), Point(std::cos(angle), std::sin(angle))});
    CHECK(is_valid(domain) && count(domain, Role::BOUNDARY) == 2);
  }
  Domain turned; // none of the points sampled is farthest out along an axis
  turned.add_loop(std::vector<Piece>{Piece::arc(Point(0, 0), 1, pi / 64, pi / 64 + 2 * pi)});
  turned.add_polyline(Points{Point(0, 0), Point(0, 1)});
  CHECK(is_valid(turned) && count(turned, Role::BOUNDARY) == 2);
  Domain flat = polygon(Points{Point(0, 0.3), Point(1, 0.3), Point(1, 1), Point(0, 1)});
  flat.add_polyline(Points{Point(0.5, 0.7), Point(0.5, std::nextafter(0.3, 1))}); // misses its edge by rounding
  CHECK(is_valid(flat) && count(flat, Role::BOUNDARY) == 5);
}

// An inner curve between the boundary and a chord of it, where first approximations have no place for it: inside.
void test_curve_beyond_chords()
{
  for(double r : {0.9995, 1.0005}) {
    Domain domain;
    domain.add_circle(Point(0, 0), 1);
    Points line;
    for(double angle : {pi/64 - 0.01, pi/64 + 0.01})
      line.push_back(Point(r * std::cos(angle), r * std::sin(angle)));
    domain.add_polyline(line);
    if(r < 1)
      CHECK(is_valid(domain));
    else
      CHECK_THROWS(domain.validate(), Bad, "lies outside the domain");
  }
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
               "segment 2 from (1, 0) to (1, 0) has zero length");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 0)}).validate(), Bad, "encloses no area");
  CHECK_THROWS(polygon(Points{Point(0, 0), Point(1, 1), Point(1, 0), Point(0, 1)}).validate(), Bad,
               "segment 1 from (0, 0) to (1, 1) and segment 3 from (1, 0) to (0, 1) cross or overlap near (0.5, 0.5)");
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

void test_polygons_of_cgal()
{
  const Points outer = square(4), inner = square(1, 1, 1), other = square(0.5, 2.5, 2.5);
  CGAL::Polygon_with_holes_2<K> polygon(CGAL::Polygon_2<K>(outer.begin(), outer.end()));
  polygon.add_hole(CGAL::Polygon_2<K>(inner.begin(), inner.end()));
  polygon.add_hole(CGAL::Polygon_2<K>(other.begin(), other.end()));
  Domain domain;
  domain.add_polygon(polygon, 7);
  const Preparation prepared(domain.pieces(), domain.rule(), domain.holes());
  double area = 0;
  for(const auto& t : prepared.triangles())
    area += CGAL::Anisotropic_mesh_2::internal::area(t);
  CHECK(std::abs(area - (16 - 1 - 0.25)) < 1e-12);
  CHECK(prepared.pieces().size() == 12 && prepared.pieces().back().curve.reference() == 7);
}

void test_seeds()
{
  Domain domain = polygon(square(4));
  domain.add_polygon(square(1, 1, 1));
  domain.add_polygon(square(0.5, 2.5, 2.5));
  CHECK(count(domain, Role::BOUNDARY) == 12);
  domain.add_hole(Point(1.5, 1.5));
  CHECK(domain.rule() == Rule::FLOOD_FROM_SEEDS);
  CHECK(is_valid(domain));
  CHECK(count(domain, Role::BOUNDARY) == 8 && count(domain, Role::CONSTRAINT) == 4);
  domain.add_hole(Point(0.5, 0.5));
  CHECK(count(domain, Role::BOUNDARY) == 4);
  domain.add_hole(Point(2.6, 2.6));
  CHECK_THROWS(domain.validate(), Bad, "encloses no area");
  CHECK_THROWS(domain.add_hole(Point(nan_value, 0)), Bad, "the seed (nan, 0) of a hole is not finite");
  CHECK_THROWS(domain.add_region(Point(0, infinity), 1), Bad, "the seed (0, inf) of a region is not finite");

  for(const Point& seed : {Point(2, 0), Point(1, 1), Point(1, 1.5)}) {
    Domain on_curve = polygon(square(4));
    on_curve.add_polygon(square(1, 1, 1));
    on_curve.add_hole(seed);
    CHECK_THROWS(on_curve.validate(), Bad, "of a hole lies on a curve of the domain");
  }
  Domain across = polygon(square(4));
  across.add_polyline(Points{Point(0, 0), Point(1, 0.3), Point(4, 4)});
  across.add_hole(Point(0.5, std::nextafter(0.15, 1)));
  CHECK(is_valid(across));

  Domain open;
  open.set_rule(Rule::FLOOD_FROM_SEEDS);
  open.add_loop(std::vector<Piece>{Piece::segment(Point(0, 0), Point(1, 0)), Piece::segment(Point(1, 0), Point(1, 1))});
  CHECK_THROWS(open.validate(), Bad, "the boundary is open at (0, 0)");
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

int main()
{
  test_curve_pieces();
  test_bad_pieces();
  test_accepted();
  test_scales();
  test_inner_curves();
  test_ends_on_circle();
  test_curve_beyond_chords();
  test_coinciding_pieces();
  test_polygons_of_cgal();
  test_bad_boundaries();
  test_seeds();
  test_against_is_simple();
  return finish();
}

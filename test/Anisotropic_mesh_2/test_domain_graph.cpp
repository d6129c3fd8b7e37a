// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Domains made of graphs, as files hold them.

#include "include/domain_test.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

Graph graph_of(const Points& points, const std::vector<std::array<std::size_t, 2> >& edges)
{
  Graph graph;
  graph.points = points;
  for(const auto& e : edges)
    graph.edges.push_back({e[0], e[1], int(10 + graph.edges.size())});
  return graph;
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
  linked.edges.push_back({4, 0, 1}); // and back
  CHECK(is_valid(Domain(linked)));
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
  Graph large = annulus;
  large.points[2] = Point(-1e308, 4);
  CHECK_THROWS(Domain(large).validate(), Bad, "segment 2 from (-1e+308, 4) to (4, 0) has a coordinate that is too large");
  Graph loop = annulus;
  loop.edges.push_back({8, 8, 1});
  CHECK_THROWS(Domain(loop).validate(), Bad, "segment 10 from (3, 3) to (3, 3) has zero length");
  Graph crossing = graph_of(Points{Point(0, 0), Point(1, 1), Point(1, 0), Point(0, 1)}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK_THROWS(Domain(crossing).validate(), Bad, "segment 1 from (0, 0) to (1, 1) and segment 3");
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
  test_graphs();
  test_triangle_meshes();
  test_order_of_edges();
  return finish();
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reading and writing of .poly files, and each kind of malformed file with its message.

#include "include/check.h"
#include "include/equal_graphs.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel             Kernel;
typedef Kernel::Point_2                                                 Point;
typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>  Graph;
typedef CGAL::Mesh_io_exception                                         Bad;

void test_reading(const std::string& data)
{
  const Graph ring = CGAL::IO::read_POLY<Kernel>(data + "/ring.poly");
  CHECK(ring.points.size() == 8 && ring.points[2] == Point(9, 9) && ring.points[7] == Point(3, 6));
  CHECK(ring.point_references == std::vector<int>({1, 1, 1, 1, 2, 2, 2, 2}));
  CHECK(ring.edges.size() == 9);
  CHECK(ring.edges[3].source == 3 && ring.edges[3].target == 0 && ring.edges[3].reference == 5);
  CHECK(ring.edges[8].source == 0 && ring.edges[8].target == 4 && ring.edges[8].reference == 0);
  CHECK(ring.holes == std::vector<Point>({Point(4.5, 4.5)}));
  CHECK(ring.regions.size() == 2 && ring.regions[0].seed == Point(1, 2) && ring.regions[0].reference == 3);
  CHECK(ring.regions.back().reference == 4);
  CHECK(ring.triangles.empty());

  const Graph split = CGAL::IO::read_POLY<Kernel>(data + "/split.poly"); // with split.node
  CHECK(split.points == std::vector<Point>({Point(0, 0), Point(2, 0), Point(0, 2)}));
  CHECK(split.edges.size() == 3 && split.edges[2].source == 2 && split.edges[2].target == 0);
}

void test_round_trip(const std::string& data, const Scratch_directory& scratch)
{
  Graph g = CGAL::IO::read_POLY<Kernel>(data + "/ring.poly");
  g.points[0] = Point(-1. / 3, 1e-300 / 7);
  CGAL::IO::write_POLY(scratch / "again.poly", g);
  CHECK(are_equal(g, CGAL::IO::read_POLY<Kernel>(scratch / "again.poly")));
  CGAL::IO::write_POLY(scratch / "split_again.poly", CGAL::IO::read_POLY<Kernel>(data + "/split.poly"));
  CHECK(CGAL::IO::read_POLY<Kernel>(scratch / "split_again.poly").points.size() == 3);
}

void test_missing_markers(const Scratch_directory& scratch)
{
  const std::string name = scratch.file("plain.poly", "3 2 0\n1 0 0\n2 1 0\n3 0 1\n3\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const Graph plain = CGAL::IO::read_POLY<Kernel>(name);
  CHECK(plain.point_references == std::vector<int>({0, 0, 0}) && plain.edges.size() == 3);
  for(const auto& e : plain.edges)
    CHECK(e.reference == 1);
}

void test_malformed_files(const Scratch_directory& scratch)
{
  const std::string vertices = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  const std::string segments = vertices + "3 0\n1 1 2\n2 2 3\n3 3 1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"", "the file is empty"},
    {"# nothing\n", "the file is empty"},
    {"garbage\n", ":1: vertices: expected the number of vertices, found 'garbage'"},
    {"-1 2 0 0\n", ":1: vertices: expected the number of vertices, found '-1', which is negative"},
    {"8 3 0 0\n", ":1: vertices: expected the dimension 2, found '3'"},
    {"3 2 0 2\n", ":1: vertices: expected the number of markers, 0 or 1, found '2'"},
    {"3 2 0 1 1\n", ":1: vertices: expected the end of the line, found '1'"},
    {"1000000000000000000 2 0 0\n1 0 0\n", ":2: vertex 2 of 1000000000000000000: expected the index of the vertex, found the end of the file"},
    {"1 2 1000000000000000000 0\n1 0 0\n", ":2: vertex 1 of 1: expected an attribute, found the end of the line"},
    {"2 2 0 0\n1 0 0\n3 1 0\n", ":3: vertex 2 of 2: expected the index 2, found '3'"},
    {"2 2 0 0\n2 0 0\n3 1 0\n", ":2: vertex 1 of 2: expected the index 0 or 1 of the first vertex, found '2'"},
    {"2 2 0 0\n1 0 0\n2 1\n0 0\n0\n", ":3: vertex 2 of 2: expected the y coordinate, found the end of the line"},
    {"1 2 0 0\n1 0 0 5\n", ":2: vertex 1 of 1: expected the end of the line, found '5', which the first line of the section does not announce"},
    {"1 2 0 1\n1 0 0\n0 0\n0\n", ":2: vertex 1 of 1: expected the marker, found the end of the line"},
    {"1 2 0 0\n1 0 nan\n", ":2: vertex 1 of 1: expected the y coordinate, found 'nan', which is not finite"},
    {"1 2 0 0\n1 inf 0\n", "found 'inf', which is not finite"},
    {vertices, "segments: expected the number of segments, found the end of the file"},
    {vertices + "3 0\n1 1 2\n2 2 3\n", ":7: segment 3 of 3: expected the index of the segment, found the end of the file"},
    {vertices + "1 0\n1 1 4\n0\n", ":6: segment 1 of 1: expected the index of a vertex, found '4', which is not between 1 and 3"},
    {vertices + "1 0\n1 0 1\n0\n", "found '0', which is not between 1 and 3"},
    {"1 2 0 0\n0 0 0\n1 0\n0 0 1\n0\n", "found '1', which is not between 0 and 0"},
    {vertices + "1 1\n1 1 2\n0\n", ":6: segment 1 of 1: expected the marker, found the end of the line"},
    {vertices + "1 0\n1 1 2 9\n0\n", ":6: segment 1 of 1: expected the end of the line, found '9'"},
    {vertices + "4 0\n1 1 2\n2 2 3\n3 3 1\n0\n", ":9: segment 4 of 4: expected the index of a vertex, found the end of the line"},
    {vertices + "2 0\n1 1 2\n2 2 3\n3 3 1\n0\n", ":8: holes: expected the end of the line, found '3'"},
    {segments, "holes: expected the number of holes, found the end of the file"},
    {segments + "1\n", ":9: hole 1 of 1: expected the index, found the end of the file"},
    {segments + "1\n1 0.1\n", ":10: hole 1 of 1: expected the y coordinate, found the end of the line"},
    {segments + "0\n1\n1 0.1 0.1\n", ":11: region 1 of 1: expected the regional attribute, found the end of the line"},
    {segments + "0\n1\n1 0.1 0.1 1.5\n", ":11: region 1 of 1: expected a whole number as regional attribute, found '1.5'"},
    {segments + "0\n0\nmore\n", ":11: expected the end of the file, found 'more'"}};
  for(const auto& c : cases) {
    const std::string file = scratch.file("bad.poly", c.first);
    CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(file), Bad, c.second);
    CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(file), Bad, file + ":");
  }
}

void test_node_files(const Scratch_directory& scratch)
{
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(scratch / "none.poly"), Bad, "none.poly: there is no such file");
  const std::string poly = scratch.file("alone.poly", "0 2 0 0\n0 0\n0\n");
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(poly), Bad, "alone.node: there is no such file");
  scratch.file("alone.node", "0 2 0 0\n");
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(poly), Bad, "alone.node: the file announces no vertices");
  scratch.file("alone.node", "1 2 0 0\n1 0 zero\n");
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(poly), Bad, "alone.node:2: vertex 1 of 1: expected the y coordinate");
  scratch.file("alone.node", "1 2 0 0\n1 0 0\n2 1 1\n");
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(poly), Bad, "alone.node:3: expected the end of the file");
  CHECK_THROWS(CGAL::IO::read_POLY<Kernel>(scratch.file("only.node", "0 2 0 0\n")), Bad,
               "the file announces no vertices");
}

// A file cut anywhere is refused, unless only blanks, comments, the end of the last number or
// the regions, which may be missing, are cut off.
void test_truncated_files(const std::string& data, const Scratch_directory& scratch)
{
  const std::string text = content_of(data + "/ring.poly");
  const std::size_t end_of_holes = text.find("4.5 4.5") + 7, end_of_regions = text.find("4.0") + 3;
  for(std::size_t size = 0; size < text.size(); ++size) {
    bool refused = false;
    try {
      CGAL::IO::read_POLY<Kernel>(scratch.file("cut.poly", text.substr(0, size)));
    }
    catch(const Bad&) {
      refused = true;
    }
    const bool may_pass = (size + 2 >= end_of_holes && size <= end_of_holes + 1) || size + 2 >= end_of_regions;
    CHECK_MSG(refused || may_pass, "cut at " + std::to_string(size));
  }
}

int main(int argc, char* argv[])
{
  const std::string data = argc > 1 ? argv[1] : "data";
  const Scratch_directory scratch;
  test_reading(data);
  test_round_trip(data, scratch);
  test_missing_markers(scratch);
  test_malformed_files(scratch);
  test_node_files(scratch);
  test_truncated_files(data, scratch);
  return finish();
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reading and writing of Medit files, and each kind of malformed file with its
// message.

#include "include/check.h"
#include "include/equal_graphs.h"
#include "include/marked_triangulation.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>  Graph;
typedef CGAL::Metric_tensor_2<Kernel>                                   Tensor;
typedef CGAL::Mesh_io_exception                                         Bad;
typedef std::array<std::size_t, 3>                                      Triangle;

void test_reading(const std::string& data)
{
  const Graph g = CGAL::IO::read_MEDIT<Kernel>(data + "/square.mesh");
  CHECK(g.points == std::vector<Kernel::Point_2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}));
  CHECK(g.point_references == std::vector<int>({1, 1, 2, 2, 0}));
  CHECK(g.triangles.size() == 4 && g.triangles[3] == Triangle({3, 0, 4}));
  CHECK(g.triangle_references == std::vector<int>({10, 10, 20, 20}));
  CHECK(g.edges.size() == 4 && g.edges[3].source == 3 && g.edges[3].target == 0 && g.edges[3].reference == -8);
  CHECK(g.holes.empty() && g.regions.empty());

  const std::vector<Tensor> metric = CGAL::IO::read_MEDIT_metric<Kernel>(data + "/square.sol");
  CHECK(metric.size() == 5);
  CHECK(metric[1] == Tensor::from_entries(4, 0.5, 1));
  CHECK(metric[4] == Tensor::from_entries(100, 0, 0.01));

  const Graph plane = CGAL::IO::read_MEDIT<Kernel>(data + "/planar_3d.mesh");
  CHECK(plane.points[1] == Kernel::Point_2(1, 0) && plane.triangles[0] == Triangle({0, 2, 1}));
  const Graph bamg = CGAL::IO::read_MEDIT<Kernel>(data + "/from_bamg.mesh");
  CHECK(bamg.points.size() == 3 && bamg.edges.size() == 3 && bamg.triangles.size() == 1);
}

void test_small_files(const Scratch_directory& scratch)
{
  const auto read = [&](const std::string& text) {
    return CGAL::IO::read_MEDIT<Kernel>(scratch.file("small.mesh", text));
  };
  CHECK(read("Dimension 2 Vertices 1 3 4 5\n").points[0] == Kernel::Point_2(3, 4)); // no version, no End
  CHECK(read("MeshVersionFormatted 4\r\nDimension 2\r\nVertices\r\n1\r\n3 4 5\r\nEnd").point_references[0] == 5);
  CHECK(read("Dimension 2 Vertices 0 Edges 0 Triangles 0 Quadrilaterals 0 Tetrahedra 0 End").points.empty());
  CHECK(read("Dimension 2 Vertices 1 1e-400 -0 0 End").points[0] == Kernel::Point_2(0, 0));
}

void test_round_trips(const std::string& data, const Scratch_directory& scratch)
{
  const Graph g = CGAL::IO::read_MEDIT<Kernel>(data + "/square.mesh");
  CGAL::IO::write_MEDIT(scratch / "again.mesh", g);
  CHECK(are_equal(g, CGAL::IO::read_MEDIT<Kernel>(scratch / "again.mesh")));

  std::mt19937_64 random(7);
  Graph h;
  std::vector<Tensor> tensors;
  for(int i = 0; i < 1000; ++i) {
    const double scale = std::ldexp(1., static_cast<int>(random() % 600) - 300);
    h.points.emplace_back(scale * static_cast<double>(static_cast<std::int64_t>(random())), scale / 3);
    h.point_references.push_back(static_cast<int>(random()));
    tensors.push_back(Tensor::from_sizes(std::ldexp(1., i % 20) / 3, 1 / 7., i));
  }
  h.edges.push_back({0, 999, -3});
  CGAL::IO::write_MEDIT(scratch / "random.mesh", h);
  CHECK(are_equal(h, CGAL::IO::read_MEDIT<Kernel>(scratch / "random.mesh"))); // all digits
  CGAL::IO::write_MEDIT_metric(scratch / "random.sol", tensors);
  CHECK(CGAL::IO::read_MEDIT_metric<Kernel>(scratch / "random.sol") == tensors);
}

void test_triangulations(const Scratch_directory& scratch)
{
  const Marked_cdt cdt = marked_rectangle();
  CGAL::IO::write_MEDIT(scratch / "cdt.mesh", cdt);
  const Graph g = CGAL::IO::read_MEDIT<Kernel>(scratch / "cdt.mesh");
  CHECK(g.points.size() == 5); // none from outside of the domain
  CHECK(g.triangles.size() == 4);
  CHECK(g.edges.size() == 5); // the outline and the diagonal
  for(const Triangle& t : g.triangles)
    CHECK(CGAL::orientation(g.points[t[0]], g.points[t[1]], g.points[t[2]]) == CGAL::COUNTERCLOCKWISE);
  double area = 0; // by the outline, which has the domain to its left
  for(const auto& e : g.edges) {
    const auto &p = g.points[e.source], &q = g.points[e.target];
    CHECK(e.reference == 1);
    if(p.x() == q.x() || p.y() == q.y())
      area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  CHECK(area == 12);

  std::ostringstream first, second;
  CGAL::IO::write_MEDIT(first, With_references<Marked_cdt>(cdt));
  CGAL::IO::write_MEDIT(second, With_references<Marked_cdt>(cdt));
  CHECK(first.str() == second.str());
  const Graph with_references = CGAL::IO::read_MEDIT<Kernel>(scratch.file("references.mesh", first.str()));
  int sum = 0;
  for(const auto& e : with_references.edges)
    sum += e.reference;
  CHECK(sum == 2 + 2 + 3 + 3 + 4);
  for(std::size_t i = 0; i < 5; ++i) // the least reference of the edges there
    CHECK(with_references.point_references[i] == (with_references.points[i].x() == 3 ? 0 : 2));

  CGAL::IO::write_MEDIT(scratch / "callable.mesh", cdt, [](const Marked_cdt::Edge&) { return 42; });
  CHECK(CGAL::IO::read_MEDIT<Kernel>(scratch / "callable.mesh").edges[0].reference == 42);
  CGAL::IO::write_MEDIT(scratch / "empty.mesh", Marked_cdt());
  CHECK(CGAL::IO::read_MEDIT<Kernel>(scratch / "empty.mesh").points.empty());
}

void test_malformed_meshes(const Scratch_directory& scratch)
{
  const std::string head = "MeshVersionFormatted 2\nDimension 2\n";
  const std::string vertices = head + "Vertices\n3\n0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"", "the file is empty"},
    {" \n# only a comment\n", "the file is empty"},
    {"hello world\n", ":1: expected Dimension before hello"},
    {"12 13\n", ":1: expected MeshVersionFormatted, found '12'"},
    {"MeshVersionFormatted 2\nEnd\n", ":2: the keyword Dimension is missing"},
    {"MeshVersionFormatted 2\nVertices\n1\n0 0 0\nEnd\n", ":2: expected Dimension before Vertices"},
    {"MeshVersionFormatted 7\n", ":1: expected a version from 1 to 4, found '7'"},
    {"MeshVersionFormatted two\n", "found 'two'"},
    {"Dimension 4\nEnd\n", ":1: expected the dimension 2, found '4'"},
    {"Dimension\n", "found the end of the file"},
    {head + "End\n", "the section Vertices is missing"},
    {head + "Vertices\n", "found the end of the file"},
    {head + "Vertices\n-3\n", ":4: Vertices: expected the number of lines of the section, found '-3', which is negative"},
    {head + "Vertices\n2.5\n", ":4: Vertices: expected the number of lines of the section, found '2.5', which is not an integer"},
    {head + "Vertices\n1000000000000000000\n0 0 0\nEnd\n", ":6: vertex 2 of 1000000000000000000: expected the x coordinate, found 'End'"},
    {head + "Vertices\n99999999999999999999999\n", "which is out of range"},
    {head + "Vertices\n3\n0 0 0\n1 0 0\n", ":6: vertex 3 of 3: expected the x coordinate, found the end of the file"},
    {head + "Vertices\n3\n0 0 0\n1 0 0\n0 1", ":7: vertex 3 of 3: expected the reference, found the end of the file"},
    {head + "Vertices\n1\n0 0 0\n1 0 0\nEnd\n", ":6: expected a keyword after the section Vertices, found '1'"},
    {head + "Vertices\n1\nnan 0 0\nEnd\n", ":5: vertex 1 of 1: expected the x coordinate, found 'nan', which is not finite"},
    {head + "Vertices\n1\n0 -inf 0\nEnd\n", "found '-inf', which is not finite"},
    {head + "Vertices\n1\n0 1e999 0\nEnd\n", "found '1e999', which is not finite"},
    {head + "Vertices\n1\n0 1,5 0\nEnd\n", "found '1,5'"},
    {head + "Vertices\n1\n0 +-1 0\nEnd\n", "found '+-1'"},
    {head + "Vertices\n1\n0 0 9999999999\nEnd\n", "which is out of range"},
    {head + "Vertices\n1\n0 0 1.5\nEnd\n", "expected the reference, found '1.5', which is not an integer"},
    {vertices + "Vertices\n0\nEnd\n", ":8: the section Vertices is there twice"},
    {vertices + "Edges\n1\n0 1 0\nEnd\n", ":10: edge 1 of 1: expected the index of a vertex, found '0'"},
    {vertices + "Edges\n2\n1 2 0\n3 4 0\nEnd\n", ":11: edge 2 of 2: expected the index of a vertex, found '4', which is not between 1 and 3"},
    {vertices + "Triangles\n2\n1 2 3 0\n1 7 3 0\nEnd\n", ":11: triangle 2 of 2: expected the index of a vertex, found '7', which is not between 1 and 3"},
    {vertices + "Triangles\n1\n1 2 3\nEnd\n", ":11: triangle 1 of 1: expected the reference, found 'End'"},
    {vertices + "Triangles\n1\n-1 2 3 0\nEnd\n", "found '-1'"},
    {head + "Vertices\n0\nEdges\n1\n1 1 1\nEnd\n", "found '1', but there is none"},
    {vertices + "Quadrilaterals\n1\n1 2 3 1 0\nEnd\n", ":9: Quadrilaterals: this section is not supported"},
    {vertices + "Strange\n1\n1 2 3 1 0\nEnd\n", ":8: the section Strange is not supported"},
    {vertices + "Str\033[1m\377ange\nEnd\n", ":8: the section Str?[1m?ange is not supported"},
    {vertices + std::string(50, 'V') + "\n", ":8: the section " + std::string(40, 'V') + "... is not supported"},
    {vertices + "Corners\n2\n1\nEnd\n", ":11: Corners 2 of 2: expected a number, found 'End'"},
    {vertices + "Identifier\nnot quoted\nEnd\n", ":9: expected a text in quotation marks, found 'not'"},
    {vertices + "Edges\n1\n1 2 1", "ends in the middle of a line and without the keyword End"},
    {"Dimension 3\nVertices\n2\n0 0 1 0\n0 1 1.1 0\nEnd\n", ":5: vertex 2 of 2: the mesh does not lie in a plane"},
    {std::string("\1\0\0\0\3\0\0\0", 8), "binary"}};
  for(const auto& c : cases) {
    const std::string file = scratch.file("bad.mesh", c.first);
    CHECK_THROWS(CGAL::IO::read_MEDIT<Kernel>(file), Bad, c.second);
    CHECK_THROWS(CGAL::IO::read_MEDIT<Kernel>(file), Bad, file + ":");
  }
  CHECK_THROWS(CGAL::IO::read_MEDIT<Kernel>(scratch / "none.mesh"), Bad, "none.mesh: there is no such file");
  CHECK_THROWS(CGAL::IO::read_MEDIT<Kernel>(scratch.path().string()), Bad, "it is a directory");
}

void test_malformed_metrics(const Scratch_directory& scratch)
{
  const std::string head = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"", "the file is empty"},
    {"MeshVersionFormatted 2\nDimension 2\nEnd\n", "the section SolAtVertices is missing"},
    {head + "2\n2 1 3\n", ":5: SolAtVertices: expected a single solution field, found '2'"},
    {head + "2\n1 2\n", ":5: SolAtVertices: expected the type of the solution, 1 (size) or 3 (metric tensor), found '2'"},
    {"Dimension 3\nSolAtVertices\n1\n1 3\n1 0 1 0 0 1\nEnd\n", ":4: SolAtVertices: tensors of dimension 3"},
    {head + "1\n1 1\n0\nEnd\n", ":6: the metric of vertex 1 of 1: the metric of size 0"},
    {head + "1\n1 1\n-2\nEnd\n", "of size -2"},
    {head + "2\n1 1\n1\nnan\nEnd\n", ":7: the metric of vertex 2 of 2: expected the size, found 'nan'"},
    {head + "2\n1 3\n1 0 1\n1 2 1\nEnd\n", ":7: the metric of vertex 2 of 2: the metric tensor with m11 = 1, m12 = 2, m22 = 1 is not positive definite"},
    {head + "2\n1 3\n1 0 1\n1 0\nEnd\n", ":8: the metric of vertex 2 of 2: expected the entry m22, found 'End'"},
    {head + "1\n1 3\n1 0 1\n1 0 1\nEnd\n", "expected a keyword after the section SolAtVertices"},
    {head + "1000000000000000000\n1 3\n", "found the end of the file"},
    {head + "0\n1 3\nVertices\n0\nEnd\n", "the section Vertices is not supported"}};
  for(const auto& c : cases)
    CHECK_THROWS(CGAL::IO::read_MEDIT_metric<Kernel>(scratch.file("bad.sol", c.first)), Bad, c.second);
  const std::vector<Tensor> sizes
    = CGAL::IO::read_MEDIT_metric<Kernel>(scratch.file("size.sol", head + "2 1 1 0.5 2 End"));
  CHECK(sizes.size() == 2 && sizes[0] == Tensor::from_size(0.5) && sizes[1] == Tensor::from_size(2));
}

// A file cut anywhere is refused, or holds what the whole file holds up to the cut.
void test_truncated_files(const std::string& data, const Scratch_directory& scratch)
{
  const std::string text = content_of(data + "/square.mesh");
  const std::size_t end_of_elements = text.find("RequiredEdges");
  CHECK(end_of_elements != std::string::npos);
  std::size_t refused = 0;
  for(std::size_t size = 0; size < end_of_elements; ++size)
    try {
      CGAL::IO::read_MEDIT<Kernel>(scratch.file("cut.mesh", text.substr(0, size)));
      CHECK_MSG(text[size - 1] == '\n', "cut at " + std::to_string(size));
    }
    catch(const Bad&) {
      ++refused;
    }
  CHECK(refused + 12 > end_of_elements);
}

// Changed bytes give an exception of ours or a mesh, never anything else.
void test_damaged_files(const std::string& data, const Scratch_directory& scratch)
{
  const std::string text = content_of(data + "/square.mesh");
  std::mt19937 random(3);
  int refused = 0, read = 0;
  for(int i = 0; i < 2000; ++i) {
    std::string damaged = text;
    for(int j = 0; j < 3; ++j)
      damaged[random() % damaged.size()] = "0123456789-+.e#\n \"\0xE"[random() % 20];
    try {
      const Graph g = CGAL::IO::read_MEDIT<Kernel>(scratch.file("damaged.mesh", damaged));
      ++read;
      for(const Triangle& t : g.triangles)
        CHECK(t[0] < g.points.size() && t[1] < g.points.size() && t[2] < g.points.size());
    }
    catch(const Bad&) {
      ++refused;
    }
  }
  CHECK(refused > 500 && read > 100);
}

int main(int argc, char* argv[])
{
  const std::string data = argc > 1 ? argv[1] : "data";
  const Scratch_directory scratch;
  test_reading(data);
  test_small_files(scratch);
  test_round_trips(data, scratch);
  test_triangulations(scratch);
  test_malformed_meshes(scratch);
  test_malformed_metrics(scratch);
  test_truncated_files(data, scratch);
  test_damaged_files(data, scratch);
  return finish();
}

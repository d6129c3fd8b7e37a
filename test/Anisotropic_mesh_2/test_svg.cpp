// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

// Pictures: well-formed, small, complete, the same each time.

#include "include/check.h"
#include "include/marked_triangulation.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_mesh_2/IO/svg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Anisotropic_mesh_2::Voronoi_cell_2<Kernel>  Cell;

// the subset of XML and of path data that pictures use
class Picture
{
public:
  struct Path
  {
    std::string fill, stroke;
    double      width;
    std::size_t lines, segments;
    std::vector<std::array<int, 2>> starts; // of the lines
  };

  explicit Picture(const std::string& text) : m_text(text)
  {
    std::vector<std::string> open;
    for(std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i + 1)) {
      const std::size_t end = text.find('>', i);
      if(end == std::string::npos)
        throw std::runtime_error("a tag without an end");
      const std::string tag = text.substr(i + 1, end - i - 1), name = tag.substr(0, tag.find(' '));
      if(name[0] == '/') {
        if(open.empty() || open.back() != name.substr(1))
          throw std::runtime_error("unexpected " + name);
        open.pop_back();
      } else if(tag.back() != '/')
        open.push_back(name);
      if(name == "path")
        add_path(tag);
    }
    if(!open.empty())
      throw std::runtime_error(open.back() + " is left open");
  }

  bool contains(const std::string& words) const { return m_text.find(words) != std::string::npos; }
  const std::vector<Path>& paths() const { return m_paths; }

  double scale() const { return std::atof(m_text.c_str() + m_text.find("scale(") + 6); }

  std::size_t segments(const std::string& stroke) const
  {
    std::size_t n = 0;
    for(const Path& p : m_paths)
      n += p.fill.empty() && p.stroke == stroke ? p.segments : 0;
    return n;
  }

private:
  static std::string attribute(const std::string& tag, const std::string& name)
  {
    const std::size_t begin = tag.find(' ' + name + "=\"");
    if(begin == std::string::npos)
      return std::string();
    const std::size_t value = begin + name.size() + 3;
    return tag.substr(value, tag.find('"', value) - value);
  }

  void add_path(const std::string& tag)
  {
    Path path = {attribute(tag, "fill"), attribute(tag, "stroke"), std::stod(attribute(tag, "stroke-width")), 0, 0, {}};
    std::string d = attribute(tag, "d");
    int x = 0, y = 0, first_x = 0, first_y = 0;
    char command = 0;
    for(std::size_t i = 0; i < d.size();) {
      if(std::string("mlzh").find(d[i]) != std::string::npos)
        command = d[i++];
      if(command == 'z') {
        x = first_x;
        y = first_y;
        continue;
      }
      x += number(d, i);
      y += command == 'h' ? 0 : number(d, i);
      check_inside(x, y);
      if(command == 'm') {
        first_x = x;
        first_y = y;
        ++path.lines;
        path.starts.push_back({x, y});
      } else
        ++path.segments;
    }
    m_paths.push_back(path);
  }

  static int number(const std::string& d, std::size_t& i)
  {
    std::size_t used = 0;
    const int n = std::stoi(d.substr(i, 12), &used);
    i += used;
    return n;
  }

  void check_inside(int x, int y)
  {
    if(x * scale() < 15.5 || x * scale() > 784.5 || y * scale() < 15.5 || y * scale() > 1300)
      throw std::runtime_error("a point outside of the picture");
  }

  std::string m_text;
  std::vector<Path> m_paths;
};

template <class... Args>
std::string drawn(const Args&... args)
{
  std::ostringstream os;
  CGAL::IO::write_SVG(os, args...);
  return os.str();
}

void test_small_mesh()
{
  const Marked_cdt cdt = marked_rectangle();
  const std::string text = drawn(cdt);
  const Picture picture(text);
  CHECK(picture.contains("viewBox=\"0 0 800 638\"")); // 3/4 of 768, margins, caption
  CHECK(picture.contains("<title>Mesh</title>"));
  CHECK(picture.contains("5 vertices, 4 triangles"));
  CHECK(picture.contains("inner constraints"));
  CHECK(picture.segments("#14202b") == 4); // the boundary
  CHECK(picture.segments("#c2491d") == 1); // the diagonal
  CHECK(picture.segments("#33475b") == 3); // the other edges
  CHECK(text == drawn(marked_rectangle()));
  const Picture named(drawn(cdt, "a < b & c"));
  CHECK(named.contains("<title>a &lt; b &amp; c</title>"));
  CHECK(named.contains(">a &lt; b &amp; c</tspan>"));
}

void test_quality()
{
  const Marked_cdt cdt = marked_rectangle(100);
  const auto quality = [](Marked_cdt::Face_handle f) { return std::min(1., f->vertex(0)->point().x() / 4); };
  const Picture picture(drawn(cdt, "coloured", quality));
  CHECK(picture.contains(">quality</text>"));
  CHECK(picture.contains("quality: mean "));
  std::set<std::string> fills;
  for(const auto& p : picture.paths())
    fills.insert(p.fill);
  CHECK(fills.size() > 3);
  const auto no_quality = [](Marked_cdt::Face_handle) { return std::nan(""); };
  CHECK(Picture(drawn(cdt, "no number", no_quality)).contains("quality"));
}

// Edges get thinner where triangles are small, and files stay small.
void test_large_mesh()
{
  Marked_cdt cdt;
  for(int i = 0; i <= 40; ++i)
    for(int j = 0; j <= 40; ++j)
      cdt.insert(Kernel::Point_2(std::pow(1.2, i), 30 * (j + 0.4 * std::sin(i * j))));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    f->set_in_domain(true);
  const std::string text = drawn(cdt);
  const Picture picture(text);
  CHECK(cdt.number_of_faces() > 3000);
  CHECK_MSG(text.size() < 300000, std::to_string(text.size()));
  std::set<double> widths;
  for(const auto& p : picture.paths())
    if(p.stroke == "#33475b")
      widths.insert(p.width * picture.scale());
  CHECK(widths.size() > 4 && *widths.begin() < 0.1 && *widths.rbegin() > 0.3 && *widths.rbegin() < 1);
}

void test_degenerate_pictures()
{
  CHECK(Picture(drawn(Marked_cdt())).contains("0 vertices, 0 triangles"));
  CHECK(Picture(drawn(std::vector<Cell>())).contains("0 Voronoi regions"));
  Marked_cdt flat = marked_rectangle(); // 10^6 times as wide as high, and far away
  Marked_cdt cdt;
  for(auto v = flat.finite_vertices_begin(); v != flat.finite_vertices_end(); ++v)
    cdt.insert(Kernel::Point_2(1e9 + 1e3 * v->point().x(), 1e-3 * v->point().y()));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    f->set_in_domain(true);
  CHECK(Picture(drawn(cdt)).contains("7 vertices"));
  CHECK(Picture(drawn(cdt, "", [](Marked_cdt::Face_handle) { return 0.5; })).contains("7 vertices"));
}

Kernel::Point_2 corner(double i, double j) { return Kernel::Point_2(i / 3, j / 3); }

// n x n square cells; each is cut into two pieces with a joint that does not match
std::vector<Cell> squares(int n)
{
  std::vector<Cell> cells;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      Cell cell;
      cell.generator = corner(i + 0.5, j + 0.5);
      cell.polygons = {{corner(i, j), corner(i + 1, j), corner(i + 1, j + 0.4), corner(i, j + 0.4)},
                       {corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j + 0.4), corner(i + 0.7, j + 0.4),
                        corner(i, j + 0.4)}}; // clockwise, with a corner more
      cell.is_on_boundary = i == 0 || j == 0 || i == n - 1 || j == n - 1;
      cells.push_back(cell);
    }
  return cells;
}

void test_tessellation()
{
  const std::vector<Cell> cells = squares(4);
  const std::string text = drawn(cells);
  const Picture picture(text);
  CHECK(picture.contains("<title>Tessellation</title>"));
  CHECK(picture.contains("16 Voronoi regions and their generators"));
  CHECK(picture.segments("#14202b") == 4); // the boundary, joined to four straight lines
  CHECK(picture.segments("#1d2b38") == 16); // dots
  CHECK(picture.segments("#4d6073") > 0 && picture.segments("#4d6073") <= 24); // borders, no joints
  std::size_t areas = 0;
  for(const auto& p : picture.paths())
    areas += p.fill.empty() ? 0 : p.lines;
  CHECK(areas == 16);
  CHECK(text == drawn(squares(4)));
  CHECK(Picture(drawn(cells, "a title")).contains("<title>a title</title>"));
}

void test_neighbors_differ()
{
  const int n = 16; // a multiple of the number of colors, which cyclic colors would not do
  const Picture picture(drawn(squares(n)));
  std::map<std::array<long, 2>, std::string> fills; // by row and column
  for(const auto& p : picture.paths())
    for(const std::array<int, 2>& s : p.starts) // the upper left corner of a cell
      if(!p.fill.empty())
        fills[{std::lround((s[0] * picture.scale() - 16) / (768. / n)),
               std::lround((s[1] * picture.scale() - 16) / (768. / n))}] = p.fill;
  CHECK(fills.size() == std::size_t(n * n));
  for(const auto& cell : fills)
    for(const std::array<long, 2>& step : {std::array<long, 2>{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
      const auto neighbor = fills.find({cell.first[0] + step[0], cell.first[1] + step[1]});
      CHECK(neighbor == fills.end() || neighbor->second != cell.second);
    }
  const std::string many = drawn(squares(39));
  CHECK_MSG(many.size() < 300000, std::to_string(many.size()));
}

void test_files(const Scratch_directory& scratch)
{
  CGAL::IO::write_SVG(scratch / "mesh.svg", marked_rectangle(), "in a file");
  CHECK(content_of(scratch / "mesh.svg") == drawn(marked_rectangle(), "in a file"));
  CGAL::IO::write_SVG(scratch / "cells.svg", squares(3));
  CHECK(content_of(scratch / "cells.svg") == drawn(squares(3)));
  CHECK_THROWS(CGAL::IO::write_SVG(scratch / "no/a.svg", squares(3)), CGAL::Mesh_io_exception, "no/a.svg");
}

int main()
{
  const Scratch_directory scratch;
  test_small_mesh();
  test_quality();
  test_large_mesh();
  test_degenerate_pictures();
  test_tessellation();
  test_neighbors_differ();
  test_files(scratch);
  return finish();
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures: well-formed, small, complete, the same each time.

#include "include/check.h"
#include "include/marked_triangulation.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_lines.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Metric_tensor_2<Kernel>                                                  Tensor;
typedef CGAL::Riemannian_metric_traits_2<Kernel, CGAL::Constant_metric_field_2<Kernel> > Traits;
typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits>                                      Mesh;
typedef CGAL::Anisotropic_Voronoi_diagram_2<Mesh>                                      Diagram;

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

  explicit Picture(const std::string& text) : m_text(text), m_is_zoomed(text.find("<svg x=") != std::string::npos)
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
    if(m_is_zoomed)
      return;
    if(x * scale() < 15.5 || x * scale() > 784.5 || y * scale() < 15.5 || y * scale() > 1300)
      throw std::runtime_error("a point outside of the picture");
  }

  std::string m_text;
  bool        m_is_zoomed;
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
  CHECK(picture.contains("inner curves"));
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
  const auto quality = [](Marked_cdt::Face_handle f) { return (std::min)(1., f->vertex(0)->point().x() / 4); };
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

// (n+1) x (n+1) generators whose regions are squares, cut in halves at the border
Mesh grid(int n)
{
  Mesh mesh{Traits(CGAL::Constant_metric_field_2<Kernel>(Tensor()))};
  Mesh::Boundary_graph square;
  square.points = {Kernel::Point_2(0, 0), Kernel::Point_2(n, 0), Kernel::Point_2(n, n), Kernel::Point_2(0, n)};
  for(std::size_t i = 0; i < 4; ++i)
    square.segments.push_back({i, (i + 1) % 4, 1, true});
  mesh.insert_boundary(square);
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      mesh.insert(Kernel::Point_2(i, j));
  return mesh;
}

// A strip of n squares with constraints between them.
Marked_cdt strip(int n)
{
  Marked_cdt cdt;
  for(int i = 0; i <= n; ++i)
    cdt.insert_constraint(Kernel::Point_2(i, 0), Kernel::Point_2(i, 1));
  for(int y : {0, 1})
    cdt.insert_constraint(Kernel::Point_2(0, y), Kernel::Point_2(n, y));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    f->set_in_domain(true);
  return cdt;
}

// Each vertical edge has a reference of its own, the others have 0.
void test_references()
{
  const Marked_cdt cdt = strip(12);
  struct Strip : Marked_cdt
  {
    explicit Strip(const Marked_cdt& tr) : Marked_cdt(tr) {}
    int edge_reference(const Edge& e) const
    {
      const Kernel::Segment_2 s = segment(e);
      return s.is_vertical() ? static_cast<int>(s.source().x()) + 1 : 0;
    }
  };
  const Picture picture(drawn(Strip(cdt)));
  CHECK(picture.contains("references of edges") && !picture.contains("inner curves"));
  CHECK(picture.segments("#14202b") == 0 && picture.segments("#c2491d") == 0);
  std::set<std::string> colors;
  for(const auto& p : picture.paths())
    if(p.fill.empty() && p.stroke != "#33475b")
      colors.insert(p.stroke);
  CHECK_MSG(colors.size() == 8, std::to_string(colors.size())); // that of 0 is used for no other reference
}

// No two of 30 references that all meet at one vertex share a color, and references that do not meet may.
void test_colors()
{
  namespace internal = CGAL::Anisotropic_mesh_2::internal;
  std::vector<std::pair<std::size_t, int> > uses;
  for(int reference = 0; reference < 30; ++reference)
    uses.insert(uses.end(), {{7, reference}, {100 + reference, reference}});
  std::set<std::string> names;
  for(const auto& c : internal::colors_of_references(uses)) {
    names.insert(internal::name_of(internal::strong_color(c.second)));
    names.insert(internal::name_of(internal::soft_color(c.second)));
  }
  CHECK(names.size() == 60);
  uses = {{1, 5}, {2, 5}, {2, 6}, {3, 6}, {3, 5}};
  const auto two = internal::colors_of_references(uses);
  CHECK(two.size() == 2 && two.at(5) != two.at(6));
}

// A window shows a part of the picture, and leaves out what is not seen.
void test_window()
{
  const Marked_cdt cdt = strip(100);
  const Picture all(drawn(cdt)), part(drawn(cdt, "", CGAL::Bbox_2(3.2, 0.2, 5.8, 0.8)));
  CHECK(all.segments("#c2491d") == 99 && part.segments("#c2491d") == 2);
  CHECK(part.contains("<svg x=\"16\" y=\"16\" width=\"768\"") && !all.contains("<svg x="));
  CHECK(part.contains("202 vertices"));
  const Mesh mesh = grid(20);
  CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
  drawing.window = CGAL::Bbox_2(3.2, 3.2, 5.2, 4.2);
  const Picture cells(drawn(Diagram(mesh), "", drawing));
  std::size_t areas = 0;
  for(const auto& p : cells.paths())
    areas += p.fill.empty() ? 0 : p.lines;
  CHECK_MSG(areas == 6, std::to_string(areas)); // those of the columns 3, 4, 5 and of the rows 3, 4
  CHECK(cells.segments("#1d2b38") == 2 && cells.segments("#14202b") == 0);
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
  const Mesh empty{Traits(CGAL::Constant_metric_field_2<Kernel>(Tensor()))};
  CHECK(Picture(drawn(Diagram(empty))).contains("0 Voronoi regions"));
  Marked_cdt flat = marked_rectangle(); // 10^6 times as wide as high, and far away
  Marked_cdt cdt;
  for(auto v = flat.finite_vertices_begin(); v != flat.finite_vertices_end(); ++v)
    cdt.insert(Kernel::Point_2(1e9 + 1e3 * v->point().x(), 1e-3 * v->point().y()));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    f->set_in_domain(true);
  CHECK(Picture(drawn(cdt)).contains("7 vertices"));
  CHECK(Picture(drawn(cdt, "", [](Marked_cdt::Face_handle) { return 0.5; })).contains("7 vertices"));
}

void test_tessellation()
{
  const Mesh mesh = grid(4);
  const std::string text = drawn(Diagram(mesh));
  const Picture picture(text);
  CHECK(picture.contains("<title>Voronoi diagram</title>"));
  CHECK(picture.contains("25 Voronoi regions") && !picture.contains("orphan"));
  CHECK(picture.segments("#14202b") == 4); // the boundary, joined to four straight lines
  CHECK(picture.segments("#1d2b38") == 25); // dots
  // the bisectors, some of them with steps where four regions meet
  CHECK(picture.segments("#4d6073") >= 8 && picture.segments("#4d6073") <= 100);
  std::size_t areas = 0;
  for(const auto& p : picture.paths())
    areas += p.fill.empty() ? 0 : p.lines;
  CHECK(areas == 25);
  CHECK(text == drawn(Diagram(mesh)));
  CHECK(Picture(drawn(Diagram(mesh), "a title")).contains("<title>a title</title>"));
}

void test_what_is_drawn()
{
  const Mesh mesh = grid(4);
  const Diagram diagram(mesh);
  CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
  drawing.generators = false;
  CHECK(Picture(drawn(diagram, "", drawing)).segments("#1d2b38") == 0);
  drawing.mass_centres = true;
  // dots for all, and lines from the 16 generators of the border to theirs
  CHECK(Picture(drawn(diagram, "", drawing)).segments("#c0392b") == 25 + 16);
  drawing.dual_edges = true;
  CHECK(Picture(drawn(diagram, "", drawing)).segments("#a03a3a") >= 10);
}

void test_size()
{
  const Mesh mesh = grid(38);
  const std::string many = drawn(Diagram(mesh));
  CHECK_MSG(many.size() < 300000, std::to_string(many.size()));
}

// A line of many short steps loses points, but never goes further astray than coordinates are rounded.
void test_simplified_lines()
{
  using CGAL::Anisotropic_mesh_2::internal::Svg_line;
  const double radius = 1e6, half_turn = std::acos(-1.);
  Svg_line arc;
  for(int i = 0; i <= 30000; ++i)
    arc.push_back({int(std::lround(radius * std::cos(half_turn * i / 30000))),
                   int(std::lround(radius * std::sin(half_turn * i / 30000)))});
  const Svg_line line = CGAL::Anisotropic_mesh_2::internal::simplified(arc);
  CHECK(line.front() == arc.front() && line.back() == arc.back());
  CHECK_MSG(line.size() < arc.size() / 2, std::to_string(line.size()) + " points");
  double least = radius; // distance of the middle of a step from the centre
  for(std::size_t i = 1; i < line.size(); ++i)
    least = (std::min)(least, std::hypot((line[i-1][0] + line[i][0]) / 2., (line[i-1][1] + line[i][1]) / 2.));
  CHECK_MSG(least > radius - 2, std::to_string(least));
}

void test_files(const Scratch_directory& scratch)
{
  CGAL::IO::write_SVG(scratch / "mesh.svg", marked_rectangle(), "in a file");
  CHECK(content_of(scratch / "mesh.svg") == drawn(marked_rectangle(), "in a file"));
  const Mesh mesh = grid(3);
  const Diagram diagram(mesh);
  CGAL::IO::write_SVG(scratch / "cells.svg", diagram);
  CHECK(content_of(scratch / "cells.svg") == drawn(diagram));
  CHECK_THROWS(CGAL::IO::write_SVG(scratch / "no/a.svg", diagram), CGAL::Mesh_io_exception, "no/a.svg");
}

int main()
{
  const Scratch_directory scratch;
  test_small_mesh();
  test_quality();
  test_references();
  test_colors();
  test_window();
  test_large_mesh();
  test_degenerate_pictures();
  test_tessellation();
  test_what_is_drawn();
  test_size();
  test_simplified_lines();
  test_files(scratch);
  return finish();
}

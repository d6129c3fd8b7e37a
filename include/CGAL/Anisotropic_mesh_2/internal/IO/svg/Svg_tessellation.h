// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_TESSELLATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_TESSELLATION_H

#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_colors.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_picture.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_drawing.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// What is drawn of a Voronoi diagram, in plain numbers.
struct Tessellation_lines
{
  typedef std::array<double, 2> Point;
  typedef std::vector<Point>    Line;

  struct Piece
  {
    std::size_t       region;
    bool              is_main;
    std::vector<Line> boundaries;
  };

  struct Bisector
  {
    std::array<std::size_t, 2> regions;
    Line                       line;
    bool                       is_closed;
  };

  std::vector<Point>                       generators, mass_centres; // the latter only if they are drawn
  std::vector<double>                      areas;                    // of the regions
  std::vector<Piece>                       pieces;
  std::vector<Bisector>                    bisectors;
  std::vector<std::array<std::size_t, 2> > neighbors;   // only if they are drawn
  std::vector<Line>                        constraints; // the boundary of the domain and what else is fixed
  std::size_t                              number_of_orphans = 0;
};

template <class Point_2>
Tessellation_lines::Point plain(const Point_2& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

template <class Point_2>
Tessellation_lines::Line plain(const std::vector<Point_2>& points)
{
  Tessellation_lines::Line line;
  for(const Point_2& p : points)
    line.push_back(plain(p));
  return line;
}

template <class Diagram>
Tessellation_lines tessellation_lines(const Diagram& diagram, const Voronoi_drawing& drawing)
{
  typedef typename Diagram::Mesh Mesh;
  Tessellation_lines lines;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& region = diagram.region(i);
    lines.generators.push_back(plain(region.generator));
    lines.areas.push_back(region.area);
    lines.number_of_orphans += region.number_of_orphans();
    for(const auto& piece : region.pieces) {
      lines.pieces.push_back({i, piece.is_main, {}});
      for(const auto& boundary : piece.boundaries)
        lines.pieces.back().boundaries.push_back(plain(boundary));
    }
    if(drawing.dual_edges)
      for(std::size_t j : diagram.neighbors(i))
        if(i < j)
          lines.neighbors.push_back({i, j});
  }
  for(const auto& b : diagram.bisectors())
    lines.bisectors.push_back({b.regions, plain(b.points), b.is_closed});
  for(const typename Mesh::Edge& e : diagram.mesh().edges_in_domain())
    if(e.first->is_constrained(e.second))
      lines.constraints.push_back({plain(e.first->vertex(Mesh::ccw(e.second))->point()),
                                   plain(e.first->vertex(Mesh::cw(e.second))->point())});
  if(drawing.mass_centres) {
    lines.mass_centres.resize(lines.generators.size());
    for_each_index<typename Diagram::ConcurrencyTag>(lines.generators.size(), [&](std::size_t i) {
      lines.mass_centres[i] = plain(diagram.integrals(i, drawing.measure).mass_centre);
    });
  }
  return lines;
}

// Draws the regions of a Voronoi diagram in soft colors, different for
// neighbors; orphans in a strong tone of the color of their region.
class Svg_tessellation
{
  typedef Tessellation_lines::Point Point;
  typedef Tessellation_lines::Line  Line;

public:
  Svg_tessellation(const Tessellation_lines& lines, const Voronoi_drawing& drawing)
    : m_lines(lines), m_drawing(drawing), m_picture(extent(lines), drawing.window)
  {
    set_widths();
    std::vector<std::vector<std::size_t> > adjacent(lines.generators.size());
    for(const auto& b : lines.bisectors) {
      adjacent[b.regions[0]].push_back(b.regions[1]);
      adjacent[b.regions[1]].push_back(b.regions[0]);
    }
    m_colors = colors_of(adjacent);
  }

  void write(std::ostream& os, const std::string& title) const
  {
    m_picture.write(os, title.empty() ? "Voronoi diagram" : title, [&](std::ostream& out) {
      draw_regions(out);
      draw_bisectors(out);
      draw_dual_edges(out);
      draw_constraints(out);
      draw_mass_centres(out);
      draw_generators(out);
    }, [&](std::ostream& out) { m_picture.write_caption(out, title, caption()); });
  }

private:
  static Bbox_2 extent(const Tessellation_lines& lines)
  {
    Bbox_2 box;
    for(const auto& piece : lines.pieces)
      for(const Line& boundary : piece.boundaries)
        box += box_of(boundary);
    return box;
  }

  // The width of a region is 4 times its area by its perimeter, in pixels.
  void set_widths()
  {
    std::vector<double> perimeters(m_lines.generators.size(), 0);
    for(const auto& piece : m_lines.pieces)
      for(const Line& boundary : piece.boundaries)
        for(std::size_t i = 0; i < boundary.size(); ++i) {
          const Point &p = boundary[i], &q = boundary[(i + 1) % boundary.size()];
          perimeters[piece.region] += std::hypot(q[0] - p[0], q[1] - p[1]);
        }
    std::vector<double> seen;
    for(std::size_t i = 0; i < perimeters.size(); ++i) {
      m_widths.push_back(perimeters[i] > 0 ? 4 * m_lines.areas[i] / perimeters[i] * m_picture.scale() : 0);
      if(m_picture.shows(edge(m_lines.generators[i], m_lines.generators[i])))
        seen.push_back(m_widths[i]);
    }
    m_picture.set_detail(seen, 0.02);
  }

  std::string caption() const
  {
    const std::size_t orphans = m_lines.number_of_orphans;
    const std::string text = svg_count(m_lines.generators.size()) + " Voronoi regions";
    return orphans == 0 ? text : text + ", " + svg_count(orphans) + (orphans == 1 ? " orphan" : " orphans");
  }

  Svg_line line(const Line& points, bool is_closed) const
  {
    Svg_line result;
    for(const Point& p : points)
      if(result.empty() || result.back() != m_picture(p))
        result.push_back(m_picture(p));
    if(is_closed && !result.empty() && result.front() != result.back())
      result.push_back(result.front());
    return simplified(result);
  }

  Svg_edge edge(const Point& p, const Point& q) const { return {m_picture(p), m_picture(q)}; }

  void draw_regions(std::ostream& os) const
  {
    std::map<std::pair<std::size_t, bool>, std::vector<Svg_line> > areas; // by color, and orphans last
    for(const auto& piece : m_lines.pieces)
      for(const Line& boundary : piece.boundaries)
        if(const Svg_line area = line(boundary, true); m_picture.shows(area))
          areas[{m_colors[piece.region], !piece.is_main}].push_back(area);
    for(const auto& c : areas) {
      const Svg_color strong = strong_color(c.first.first);
      m_picture.draw_areas(os, c.second, name_of(mixed(strong, {255, 255, 255}, c.first.second ? 0.25 : 0.75)), 0.3);
    }
  }

  void draw_bisectors(std::ostream& os) const
  {
    Svg_width_classes widths(0.03, 0.7);
    for(const auto& b : m_lines.bisectors) {
      const Svg_line points = line(b.line, b.is_closed);
      for(std::size_t k = 1; k < points.size(); ++k)
        if(const Svg_edge e(points[k - 1], points[k]); m_picture.shows(e))
          widths.add(0.06 * (std::min)(m_widths[b.regions[0]], m_widths[b.regions[1]]), e);
    }
    m_picture.draw_edges(os, widths, "#4d6073");
  }

  void draw_dual_edges(std::ostream& os) const
  {
    Svg_width_classes widths(0.05, 0.9);
    for(const auto& n : m_lines.neighbors)
      if(const Svg_edge e = edge(m_lines.generators[n[0]], m_lines.generators[n[1]]); m_picture.shows(e))
        widths.add(0.05 * (std::min)(m_widths[n[0]], m_widths[n[1]]), e);
    m_picture.draw_edges(os, widths, "#a03a3a");
  }

  void draw_constraints(std::ostream& os) const
  {
    std::vector<Svg_edge> edges;
    for(const Line& constraint : m_lines.constraints)
      if(const Svg_edge e = edge(constraint[0], constraint[1]); m_picture.shows(e))
        edges.push_back(e);
    m_picture.draw_edges(os, edges, "#14202b", 1.8);
  }

  void draw_mass_centres(std::ostream& os) const
  {
    std::vector<Svg_edge> pulls;
    Svg_width_classes dots(0.2, 5);
    for(std::size_t i = 0; i < m_lines.mass_centres.size(); ++i)
      if(const Svg_edge e = edge(m_lines.generators[i], m_lines.mass_centres[i]); m_picture.shows(e)) {
        pulls.push_back(e);
        dots.add(0.2 * m_widths[i], Svg_edge(e.second, e.second));
      }
    m_picture.draw_edges(os, pulls, "#c0392b", 0.5);
    m_picture.draw_dots(os, dots, "#c0392b");
  }

  void draw_generators(std::ostream& os) const
  {
    Svg_width_classes dots(0.15, 4);
    for(std::size_t i = 0; i < m_lines.generators.size() && m_drawing.generators; ++i)
      if(const Svg_edge e = edge(m_lines.generators[i], m_lines.generators[i]); m_picture.shows(e))
        dots.add((m_drawing.mass_centres ? 0.12 : 0.17) * m_widths[i], e);
    m_picture.draw_dots(os, dots, "#1d2b38");
  }

  const Tessellation_lines& m_lines;
  const Voronoi_drawing&    m_drawing;
  Svg_picture               m_picture;
  std::vector<double>       m_widths;
  std::vector<std::size_t>  m_colors;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_TESSELLATION_H

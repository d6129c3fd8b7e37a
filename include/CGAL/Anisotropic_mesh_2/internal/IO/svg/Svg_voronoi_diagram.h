// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_VORONOI_DIAGRAM_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_VORONOI_DIAGRAM_H

#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_picture.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_drawing.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Draws the regions of a Voronoi diagram in soft colors, different for
// neighbors; orphans in a strong tone of the color of their region.
//
// Layers are drawn at the same time, if the diagram has a parallel tag.
template <class Diagram>
class Svg_voronoi_diagram
{
  typedef typename Diagram::ConcurrencyTag ConcurrencyTag;
  typedef typename Diagram::Mesh           Mesh;
  typedef typename Diagram::Region         Region;
  typedef typename Diagram::Piece          Piece;
  typedef typename Diagram::Bisector       Bisector;
  typedef typename Diagram::Point_2        Point_2;

public:
  Svg_voronoi_diagram(const Diagram& diagram, const Voronoi_drawing& drawing)
    : m_diagram(diagram), m_drawing(drawing), m_picture(window(diagram), 0)
  {
    m_widths.resize(diagram.number_of_regions());
    for_each_index<ConcurrencyTag>(m_widths.size(), [&](std::size_t i) { m_widths[i] = width(diagram.region(i)); });
    if(!m_widths.empty()) {
      std::vector<double> widths = m_widths;
      const auto at = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 50);
      std::nth_element(widths.begin(), at, widths.end());
      m_picture.set_detail(*at);
    }
    choose_colors();
  }

  void write(std::ostream& os, const std::string& title) const
  {
    typedef Svg_voronoi_diagram Self;
    std::vector<void (Self::*)(std::ostream&) const> layers = {&Self::draw_regions, &Self::draw_bisectors};
    if(m_drawing.dual_edges)
      layers.push_back(&Self::draw_dual_edges);
    layers.push_back(&Self::draw_boundary);
    if(m_drawing.mass_centres)
      layers.push_back(&Self::draw_mass_centres);
    if(m_drawing.generators)
      layers.push_back(&Self::draw_generators);
    m_picture.write(os, title.empty() ? "Voronoi diagram" : title, [&](std::ostream& out) {
      draw_parts(out, layers.size(), [&](std::size_t i, std::ostream& part) { (this->*layers[i])(part); });
    }, [&](std::ostream& out) { m_picture.write_caption(out, title, caption()); });
  }

private:
  static constexpr std::size_t number_of_colors = 8;
  static constexpr std::size_t regions_of_chunk = 128;

  static double x(const Point_2& p) { return CGAL::to_double(p.x()); }
  static double y(const Point_2& p) { return CGAL::to_double(p.y()); }
  Svg_point at(const Point_2& p) const { return m_picture(x(p), y(p)); }

  static Svg_window window(const Diagram& diagram)
  {
    Svg_window result;
    for(const Region& r : diagram.regions())
      for(const Piece& p : r.pieces)
        for(const auto& boundary : p.boundaries)
          for(const Point_2& q : boundary)
            result.add(x(q), y(q));
    return result;
  }

  // The width of a region is 4 times its area by its perimeter, in pixels.
  double width(const Region& r) const
  {
    double perimeter = 0;
    for(const Piece& piece : r.pieces)
      for(const auto& boundary : piece.boundaries)
        for(std::size_t i = 0; i < boundary.size(); ++i) {
          const Point_2 &p = boundary[i], &q = boundary[(i + 1) % boundary.size()];
          perimeter += std::hypot(x(q) - x(p), y(q) - y(p));
        }
    return perimeter > 0 ? 4 * r.area / perimeter * m_picture.scale() : 0;
  }

  // Neighbors get different colors, and all colors are used about as often.
  void choose_colors()
  {
    std::vector<std::vector<std::size_t> > adjacent(m_diagram.number_of_regions());
    for(const Bisector& b : m_diagram.bisectors()) {
      adjacent[b.regions[0]].push_back(b.regions[1]);
      adjacent[b.regions[1]].push_back(b.regions[0]);
    }
    std::array<std::size_t, number_of_colors> uses = {};
    m_colors.assign(adjacent.size(), number_of_colors);
    for(std::size_t i = 0; i < adjacent.size(); ++i) {
      std::array<std::size_t, number_of_colors> conflicts = {};
      for(std::size_t j : adjacent[i])
        if(m_colors[j] < number_of_colors)
          ++conflicts[m_colors[j]];
      std::size_t best = 0;
      for(std::size_t c = 1; c < number_of_colors; ++c)
        if(std::make_pair(conflicts[c], uses[c]) < std::make_pair(conflicts[best], uses[best]))
          best = c;
      m_colors[i] = best;
      ++uses[best];
    }
  }

  std::string caption() const
  {
    std::size_t orphans = 0;
    for(const Region& r : m_diagram.regions())
      orphans += r.number_of_orphans();
    const std::string text = svg_count(m_diagram.number_of_regions()) + " Voronoi regions";
    return orphans == 0 ? text : text + ", " + svg_count(orphans) + (orphans == 1 ? " orphan" : " orphans");
  }

  Svg_line line(const std::vector<Point_2>& points, bool is_closed) const
  {
    Svg_line result;
    for(const Point_2& p : points)
      if(result.empty() || result.back() != at(p))
        result.push_back(at(p));
    if(is_closed && !result.empty() && result.front() != result.back())
      result.push_back(result.front());
    return simplified(result);
  }

  // Calls `draw(i, part)` for n parts, which are written one after the other.
  template <class Draw>
  static void draw_parts(std::ostream& os, std::size_t n, const Draw& draw)
  {
    std::vector<std::string> parts(n);
    for_each_task<ConcurrencyTag>(n, [&](std::size_t i) {
      std::ostringstream part;
      part.imbue(std::locale::classic());
      draw(i, part);
      parts[i] = part.str();
    });
    for(const std::string& part : parts)
      os << part;
  }

  void draw_regions(std::ostream& os) const
  {
    static const char* const main_colors[number_of_colors] =
      {"#cfe3f1", "#fbe3c4", "#d5ecd2", "#f6d3d0", "#e1d9ef", "#fbf3c6", "#cdebe7", "#e4e0d6"};
    static const char* const orphan_colors[number_of_colors] =
      {"#5b9bc8", "#e9a23b", "#6cb563", "#dd7169", "#9a83c9", "#dcc53e", "#4fb3a6", "#a89f8b"};
    draw_parts(os, number_of_colors, [&](std::size_t c, std::ostream& part) {
      m_picture.draw_areas(part, areas(c, true), main_colors[c], 0.3);
      m_picture.draw_areas(part, areas(c, false), orphan_colors[c], 0.3);
    });
  }

  std::vector<Svg_line> areas(std::size_t color, bool are_main) const
  {
    std::vector<Svg_line> lines;
    for(std::size_t i = 0; i < m_colors.size(); ++i)
      if(m_colors[i] == color)
        for(const Piece& p : m_diagram.region(i).pieces)
          if(p.is_main == are_main)
            for(const auto& boundary : p.boundaries)
              lines.push_back(line(boundary, true));
    return lines;
  }

  void draw_bisectors(std::ostream& os) const
  {
    const std::vector<Bisector>& bisectors = m_diagram.bisectors();
    std::vector<Svg_line> lines(bisectors.size());
    for_each_index<ConcurrencyTag>(lines.size(), [&](std::size_t i) {
      lines[i] = line(bisectors[i].points, bisectors[i].is_closed);
    });
    Svg_width_classes widths(0.03, 0.7);
    for(std::size_t i = 0; i < lines.size(); ++i) {
      const double w = 0.06 * (std::min)(m_widths[bisectors[i].regions[0]], m_widths[bisectors[i].regions[1]]);
      for(std::size_t k = 1; k < lines[i].size(); ++k)
        widths.add(w, Svg_edge(lines[i][k - 1], lines[i][k]));
    }
    draw(os, widths, "#4d6073");
  }

  void draw(std::ostream& os, const Svg_width_classes& widths, const char* color) const
  {
    std::vector<std::pair<double, const std::vector<Svg_edge>*> > classes;
    widths.for_each([&](double line_width, const std::vector<Svg_edge>& edges) {
      classes.emplace_back(line_width, &edges);
    });
    draw_parts(os, classes.size(), [&](std::size_t i, std::ostream& part) {
      draw(part, *classes[i].second, color, classes[i].first);
    });
  }

  void draw(std::ostream& os, const std::vector<Svg_edge>& edges, const char* color, double line_width) const
  {
    std::vector<Svg_line> lines;
    for(const Svg_line& l : Svg_line_joiner(edges, false).lines())
      lines.push_back(simplified(l));
    m_picture.draw_lines(os, lines, color, line_width);
  }

  void draw_dual_edges(std::ostream& os) const
  {
    Svg_width_classes widths(0.05, 0.9);
    for(std::size_t i = 0; i < m_diagram.number_of_regions(); ++i)
      for(std::size_t j : m_diagram.neighbors(i))
        if(i < j)
          widths.add(0.05 * (std::min)(m_widths[i], m_widths[j]),
                     Svg_edge(at(m_diagram.region(i).generator), at(m_diagram.region(j).generator)));
    draw(os, widths, "#a03a3a");
  }

  // the constrained edges: the boundary of the domain and what else is fixed
  void draw_boundary(std::ostream& os) const
  {
    std::vector<Svg_edge> edges;
    for(const typename Mesh::Edge& e : m_diagram.mesh().edges_in_domain())
      if(e.first->is_constrained(e.second))
        edges.emplace_back(at(e.first->vertex(Mesh::ccw(e.second))->point()),
                           at(e.first->vertex(Mesh::cw(e.second))->point()));
    draw(os, edges, "#14202b", 1.8);
  }

  void draw_mass_centres(std::ostream& os) const
  {
    std::vector<Svg_edge> pulls(m_diagram.number_of_regions());
    for_each_chunk<ConcurrencyTag>(pulls.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        pulls[i] = Svg_edge(at(m_diagram.region(i).generator),
                            at(m_diagram.integrals(i, m_drawing.measure).mass_centre));
    }, regions_of_chunk);
    Svg_width_classes dots(0.2, 5);
    for(std::size_t i = 0; i < pulls.size(); ++i)
      dots.add(0.2 * m_widths[i], Svg_edge(pulls[i].second, pulls[i].second));
    draw(os, pulls, "#c0392b", 0.5);
    draw_dots(os, dots, "#c0392b");
  }

  void draw_generators(std::ostream& os) const
  {
    Svg_width_classes dots(0.15, 4);
    for(std::size_t i = 0; i < m_diagram.number_of_regions(); ++i) {
      const Svg_point p = at(m_diagram.region(i).generator);
      dots.add((m_drawing.mass_centres ? 0.12 : 0.17) * m_widths[i], Svg_edge(p, p));
    }
    draw_dots(os, dots, "#1d2b38");
  }

  void draw_dots(std::ostream& os, const Svg_width_classes& dots, const char* color) const
  {
    dots.for_each([&](double diameter, const std::vector<Svg_edge>& places) {
      std::vector<Svg_line> lines;
      for(const Svg_edge& place : places)
        lines.push_back({place.first, place.second});
      m_picture.draw_lines(os, lines, color, diameter);
    });
  }

  const Diagram&            m_diagram;
  const Voronoi_drawing     m_drawing;
  Svg_picture               m_picture;
  std::vector<double>       m_widths;
  std::vector<std::size_t>  m_colors;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_VORONOI_DIAGRAM_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_INTERNAL_SVG_TESSELLATION_H
#define CGAL_ANISOTROPIC_MESH_2_IO_INTERNAL_SVG_TESSELLATION_H

#include <CGAL/Anisotropic_mesh_2/IO/internal/Svg_picture.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_cell_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Draws the regions of a tessellation. Their pieces are put together on the
// grid of the picture, so that only borders between regions are seen.
template <class K>
class Svg_tessellation
{
public:
  typedef Voronoi_cell_2<K> Cell;

  explicit Svg_tessellation(const std::vector<Cell>& cells) : m_cells(cells), m_picture(window(cells), 0)
  {
    measure_cells();
    std::vector<double> widths = m_widths;
    const auto at = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 50);
    if(!widths.empty())
      std::nth_element(widths.begin(), at, widths.end());
    m_picture.set_detail(widths.empty() ? 1 : *at);
    place_sides();
    find_neighbors();
    find_outlines();
    choose_colors();
  }

  void write(std::ostream& os, const std::string& title) const
  {
    m_picture.write(os, title.empty() ? "Tessellation" : title, [&](std::ostream& out) {
      draw_cells(out);
      draw_borders(out);
      draw_generators(out);
    }, [&](std::ostream& out) {
      m_picture.write_caption(out, title, svg_count(m_cells.size()) + " Voronoi regions and their generators");
    });
  }

private:
  static constexpr std::size_t number_of_colors = 8;

  // an edge of an outline, ordered as undirected
  struct Border
  {
    Svg_edge    edge;
    std::size_t cell;
    bool        is_reversed;

    bool operator<(const Border& b) const { return edge != b.edge ? edge < b.edge : cell < b.cell; }
  };

  static double x(const typename Cell::Point_2& p) { return CGAL::to_double(p.x()); }
  static double y(const typename Cell::Point_2& p) { return CGAL::to_double(p.y()); }

  static Svg_window window(const std::vector<Cell>& cells)
  {
    Svg_window result;
    for(const Cell& c : cells)
      for(const auto& polygon : c.polygons)
        for(const auto& p : polygon)
          result.add(x(p), y(p));
    return result;
  }

  // The width of a cell is 4 times its area by its perimeter, in pixels; inner
  // sides of pieces make it a little smaller.
  void measure_cells()
  {
    for(const Cell& c : m_cells) {
      double area = 0, perimeter = 0, greatest = 0;
      for(const auto& polygon : c.polygons) {
        const double a = std::abs(signed_area(polygon));
        area += a;
        greatest = (std::max)(greatest, a);
        for(std::size_t i = 0; i < polygon.size(); ++i) {
          const auto& p = polygon[i];
          const auto& q = polygon[(i + 1) % polygon.size()];
          perimeter += std::hypot(x(q) - x(p), y(q) - y(p));
        }
      }
      const double pieces = greatest > 0 ? area / greatest : 1; // their sides count twice
      m_widths.push_back(perimeter > 0 ? 4 * area / perimeter * std::sqrt(pieces) * m_picture.scale() : 0);
    }
  }

  static double signed_area(const std::vector<typename Cell::Point_2>& polygon)
  {
    double area = 0;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const auto& p = polygon[i];
      const auto& q = polygon[(i + 1) % polygon.size()];
      area += (x(p) - x(polygon[0])) * (y(q) - y(polygon[0])) - (y(p) - y(polygon[0])) * (x(q) - x(polygon[0]));
    }
    return area / 2;
  }

  void place_sides()
  {
    m_sides.resize(m_cells.size());
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      for(const auto& polygon : m_cells[i].polygons) {
        const bool is_clockwise = signed_area(polygon) < 0;
        for(std::size_t j = 0; j < polygon.size(); ++j) {
          const auto& p = polygon[j];
          const auto& q = polygon[(j + 1) % polygon.size()];
          const Svg_point from = m_picture(x(p), y(p)), to = m_picture(x(q), y(q));
          if(from != to)
            m_sides[i].push_back(is_clockwise ? Svg_edge(to, from) : Svg_edge(from, to));
        }
      }
  }

  // cells that have a corner in common
  void find_neighbors()
  {
    std::vector<std::pair<Svg_point, std::size_t>> corners;
    for(std::size_t i = 0; i < m_cells.size(); ++i)
      for(const Svg_edge& s : m_sides[i])
        corners.emplace_back(s.first, i);
    sort_unique(corners);
    m_neighbors.assign(m_cells.size(), {});
    for(std::size_t first = 0, last; first < corners.size(); first = last) {
      for(last = first; last < corners.size() && corners[last].first == corners[first].first;)
        ++last;
      // where very many cells meet in a step of the grid, nothing is seen of them
      const std::size_t end = (std::min)(last, first + 50);
      for(std::size_t i = first; i < end; ++i)
        for(std::size_t j = first; j < end; ++j)
          m_neighbors[corners[i].second].push_back(corners[j].second);
    }
    for(auto& n : m_neighbors)
      sort_unique(n);
  }

  template <class T>
  static void sort_unique(std::vector<T>& v)
  {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  }

  // Sides are cut at the corners of all cells around; then those of the same
  // cell in opposite directions cancel.
  void find_outlines()
  {
    m_outlines.resize(m_cells.size());
    for(std::size_t i = 0; i < m_cells.size(); ++i) {
      std::vector<Svg_point> corners;
      for(std::size_t j : m_neighbors[i])
        for(const Svg_edge& s : m_sides[j])
          corners.push_back(s.first);
      sort_unique(corners);
      std::vector<Svg_edge> parts;
      for(const Svg_edge& s : m_sides[i])
        cut(s, corners, parts);
      cancel(parts, i);
    }
    std::sort(m_borders.begin(), m_borders.end());
  }

  // Rounding moves a corner and the side on which it lies apart by less than 1.5 steps.
  static void cut(const Svg_edge& side, const std::vector<Svg_point>& corners, std::vector<Svg_edge>& parts)
  {
    const int x_min = (std::min)(side.first[0], side.second[0]) - 1;
    const int x_max = (std::max)(side.first[0], side.second[0]) + 1;
    std::vector<std::pair<double, Svg_point>> cuts;
    for(auto c = std::lower_bound(corners.begin(), corners.end(), Svg_point{x_min, INT_MIN});
        c != corners.end() && (*c)[0] <= x_max; ++c)
      if(is_between(*c, side.first, side.second, 1.5))
        cuts.emplace_back(svg_distance(side.first, *c), *c);
    std::sort(cuts.begin(), cuts.end());
    Svg_point from = side.first;
    for(const auto& c : cuts) {
      parts.emplace_back(from, c.second);
      from = c.second;
    }
    parts.emplace_back(from, side.second);
  }

  void cancel(const std::vector<Svg_edge>& parts, std::size_t cell)
  {
    std::vector<std::pair<Svg_edge, int>> signs;
    for(const Svg_edge& p : parts)
      signs.emplace_back(p.first < p.second ? p : Svg_edge(p.second, p.first), p.first < p.second ? 1 : -1);
    std::sort(signs.begin(), signs.end());
    for(std::size_t first = 0, last; first < signs.size(); first = last) {
      int sum = 0;
      for(last = first; last < signs.size() && signs[last].first == signs[first].first; ++last)
        sum += signs[last].second;
      if(sum == 0)
        continue;
      const Svg_edge e = signs[first].first;
      m_borders.push_back(Border{e, cell, sum < 0});
      m_outlines[cell].insert(m_outlines[cell].end(), static_cast<std::size_t>(std::abs(sum)),
                              sum > 0 ? e : Svg_edge(e.second, e.first));
    }
  }

  // Neighbors get different colors, and all colors are used about as often.
  void choose_colors()
  {
    std::array<std::size_t, number_of_colors> uses = {};
    m_colors.assign(m_cells.size(), number_of_colors);
    for(std::size_t i = 0; i < m_cells.size(); ++i) {
      std::array<std::size_t, number_of_colors> conflicts = {};
      for(std::size_t j : m_neighbors[i])
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

  void draw_cells(std::ostream& os) const
  {
    static const char* const colors[number_of_colors] =
      {"#cfe3f1", "#fbe3c4", "#d5ecd2", "#f6d3d0", "#e1d9ef", "#fbf3c6", "#cdebe7", "#e4e0d6"};
    for(std::size_t c = 0; c < number_of_colors; ++c) {
      std::vector<Svg_line> lines;
      for(std::size_t i = 0; i < m_cells.size(); ++i)
        if(m_colors[i] == c)
          for(const Svg_line& line : Svg_line_joiner(m_outlines[i], true).lines())
            lines.push_back(simplified(line));
      m_picture.draw_areas(os, lines, colors[c], 0.3);
    }
  }

  void draw_borders(std::ostream& os) const
  {
    Svg_width_classes inner(0.03, 0.7);
    std::vector<Svg_edge> boundary;
    for(std::size_t first = 0, last; first < m_borders.size(); first = last) {
      for(last = first; last < m_borders.size() && m_borders[last].edge == m_borders[first].edge;)
        ++last;
      const std::size_t i = m_borders[first].cell, j = m_borders[last - 1].cell;
      if(i == j && m_cells[i].is_on_boundary)
        boundary.push_back(m_borders[first].edge);
      else
        inner.add(0.06 * (std::min)(m_widths[i], m_widths[j]), m_borders[first].edge);
    }
    inner.for_each([&](double line_width, const std::vector<Svg_edge>& edges) {
      draw(os, edges, "#4d6073", line_width);
    });
    draw(os, boundary, "#14202b", 1.8);
  }

  void draw(std::ostream& os, const std::vector<Svg_edge>& edges, const char* color, double line_width) const
  {
    std::vector<Svg_line> lines;
    for(const Svg_line& line : Svg_line_joiner(edges, false).lines())
      lines.push_back(simplified(line));
    m_picture.draw_lines(os, lines, color, line_width);
  }

  void draw_generators(std::ostream& os) const
  {
    Svg_width_classes dots(0.15, 4);
    for(std::size_t i = 0; i < m_cells.size(); ++i) {
      const Svg_point at = m_picture(x(m_cells[i].generator), y(m_cells[i].generator));
      dots.add(0.17 * m_widths[i], Svg_edge(at, at));
    }
    dots.for_each([&](double diameter, const std::vector<Svg_edge>& places) {
      std::vector<Svg_line> lines;
      for(const Svg_edge& place : places)
        lines.push_back({place.first, place.second});
      m_picture.draw_lines(os, lines, "#1d2b38", diameter);
    });
  }

  const std::vector<Cell>&              m_cells;
  Svg_picture                           m_picture;
  std::vector<double>                   m_widths;
  std::vector<std::vector<Svg_edge>>    m_sides, m_outlines;
  std::vector<std::vector<std::size_t>> m_neighbors;
  std::vector<Border>                   m_borders;
  std::vector<std::size_t>              m_colors;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_IO_INTERNAL_SVG_TESSELLATION_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_picture.h>

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

// Draws a mesh. If there are qualities, there is one for each triangle.
class Svg_mesh
{
public:
  Svg_mesh(const Domain_graph& graph, const std::vector<double>& qualities)
    : m_graph(graph), m_qualities(qualities), m_picture(window(graph), qualities.empty() ? 0 : legend_width)
  {
    collect_edges();
    m_picture.set_detail(size_at(0.02));
  }

  void write(std::ostream& os, const std::string& title) const
  {
    m_picture.write(os, title.empty() ? "Mesh" : title, [&](std::ostream& out) {
      draw_triangles(out);
      draw_edges(out);
    }, [&](std::ostream& out) {
      m_picture.write_caption(out, title, caption());
      if(!m_qualities.empty()) {
        write_legend(out);
        write_quality_summary(out);
      }
    });
  }

private:
  static constexpr double legend_width = 74;

  // an edge and how much room there is around it, in pixels
  struct Edge
  {
    std::size_t source, target;
    double      room;
    int         triangles;
    bool        is_constrained;

    bool operator<(const Edge& e) const
    {
      return source != e.source ? source < e.source : target < e.target;
    }
  };

  static Svg_window window(const Domain_graph& graph)
  {
    Svg_window result;
    for(const auto& p : graph.points)
      result.add(p.x(), p.y());
    return result;
  }

  void collect_edges()
  {
    for(const auto& t : m_graph.triangles)
      for(int i = 0; i < 3; ++i)
        m_edges.push_back(edge_of(t[i], t[(i + 1) % 3], t[(i + 2) % 3]));
    for(const auto& e : m_graph.edges)
      m_edges.push_back(Edge{(std::min)(e.source, e.target), (std::max)(e.source, e.target), 1e300, 0, true});
    std::sort(m_edges.begin(), m_edges.end());
    std::size_t n = 0;
    for(const Edge& e : m_edges)
      if(n > 0 && !(m_edges[n - 1] < e)) {
        m_edges[n - 1].room = (std::min)(m_edges[n - 1].room, e.room);
        m_edges[n - 1].triangles += e.triangles;
        m_edges[n - 1].is_constrained |= e.is_constrained;
      } else
        m_edges[n++] = e;
    m_edges.resize(n);
  }

  // The room is the least of the length and the height of the triangle.
  Edge edge_of(std::size_t a, std::size_t b, std::size_t opposite) const
  {
    const auto& p = m_graph.points[a];
    const auto& q = m_graph.points[b];
    const auto& r = m_graph.points[opposite];
    const double length = std::hypot(q.x() - p.x(), q.y() - p.y());
    const double area = std::abs((q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x()));
    const double room = length > 0 ? (std::min)(length, area / length) : 0;
    return Edge{(std::min)(a, b), (std::max)(a, b), room * m_picture.scale(), 1, false};
  }

  // the room that the given share of the edges does not have
  double size_at(double share) const
  {
    std::vector<double> rooms;
    for(const Edge& e : m_edges)
      if(e.triangles > 0)
        rooms.push_back(e.room);
    if(rooms.empty())
      return 1;
    const auto at = rooms.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(rooms.size() - 1));
    std::nth_element(rooms.begin(), at, rooms.end());
    return *at;
  }

  Svg_point place(std::size_t v) const { return m_picture(m_graph.points[v].x(), m_graph.points[v].y()); }

  // a subdomain, or a class of quality, in one path each
  void draw_triangles(std::ostream& os) const
  {
    std::map<int, std::vector<Svg_edge>> sides;
    for(std::size_t i = 0; i < m_graph.triangles.size(); ++i) {
      const auto& t = m_graph.triangles[i];
      const int c = m_qualities.empty() ? m_graph.triangle_references[i]
                                        : static_cast<int>(std::floor(clamped(m_qualities[i]) * quality_classes));
      for(int j = 0; j < 3; ++j)
        sides[c].emplace_back(place(t[j]), place(t[(j + 1) % 3]));
    }
    std::size_t number = 0;
    for(const auto& c : sides)
      m_picture.draw_areas(os, Svg_line_joiner(outline(c.second), true).lines(),
                           m_qualities.empty() ? subdomain_color(number++)
                                               : quality_color((c.first + 0.5) / quality_classes), 0.2);
  }

  // the sides that do not have a side in opposite direction
  static std::vector<Svg_edge> outline(std::vector<Svg_edge> sides)
  {
    std::sort(sides.begin(), sides.end());
    std::vector<Svg_edge> result;
    for(const Svg_edge& s : sides)
      if(!std::binary_search(sides.begin(), sides.end(), Svg_edge(s.second, s.first)))
        result.push_back(s);
    return result;
  }

  void draw_edges(std::ostream& os) const
  {
    const double thick = (std::min)((std::max)(0.22 * size_at(0.5), 0.8), 1.8);
    Svg_width_classes thin(0.02, 0.6);
    std::vector<Svg_edge> boundary, constraints;
    for(const Edge& e : m_edges) {
      const Svg_edge line(place(e.source), place(e.target));
      if(e.triangles < 2)
        boundary.push_back(line);
      else if(e.is_constrained)
        constraints.push_back(line);
      else
        thin.add(0.11 * e.room, line);
    }
    thin.for_each([&](double line_width, const std::vector<Svg_edge>& edges) {
      m_picture.draw_lines(os, Svg_line_joiner(edges, false).lines(), "#33475b", line_width);
    });
    draw_thick(os, constraints, constraint_color(), 0.8 * thick);
    draw_thick(os, boundary, "#14202b", thick);
  }

  void draw_thick(std::ostream& os, const std::vector<Svg_edge>& edges, const char* color, double line_width) const
  {
    std::vector<Svg_line> lines;
    for(const Svg_line& line : Svg_line_joiner(edges, false).lines())
      lines.push_back(simplified(line));
    m_picture.draw_lines(os, lines, color, line_width);
  }

  static const char* constraint_color() { return "#c2491d"; }

  static std::string subdomain_color(std::size_t number)
  {
    static const char* const colors[] = {"#e9f0f7", "#fbeedb", "#e6f3e6", "#f6e6ee", "#ebe8f6", "#f7f4d8"};
    return colors[number % 6];
  }

  static constexpr int quality_classes = 20;

  static double clamped(double quality) { return quality > 0 ? (std::min)(quality, 0.999999) : 0; }

  static std::string quality_color(double quality)
  {
    static const std::vector<std::array<int, 3>> table = {
      {122, 12, 36}, {178, 24, 43}, {226, 88, 56}, {247, 152, 84}, {252, 205, 131},
      {245, 233, 178}, {206, 229, 214}, {150, 203, 216}, {208, 229, 242}};
    return svg_color(table, quality);
  }

  std::string caption() const
  {
    std::string text = svg_count(m_graph.points.size()) + " vertices, "
                     + svg_count(m_graph.triangles.size()) + " triangles";
    if(std::any_of(m_edges.begin(), m_edges.end(), [](const Edge& e) { return e.triangles > 1 && e.is_constrained; }))
      text += std::string(", <tspan fill=\"") + constraint_color() + "\">inner constraints</tspan>";
    return text;
  }

  // a scale of colors at the right
  void write_legend(std::ostream& os) const
  {
    const double x = Svg_picture::width - Svg_picture::margin - legend_width + 24, y = Svg_picture::margin + 20;
    const double step = (std::min)(10., (std::max)(4., (m_picture.height() - 30) / quality_classes));
    os << "<text x=\"" << x << "\" y=\"" << y - 8 << "\">quality</text>\n";
    for(int i = 0; i < quality_classes; ++i)
      os << "<rect x=\"" << x << "\" y=\"" << y + step * (quality_classes - 1 - i) << "\" width=\"14\" height=\""
         << step + 0.3 << "\" fill=\"" << quality_color((i + 0.5) / quality_classes) << "\"/>\n";
    for(int i = 0; i <= 4; ++i)
      os << "<text x=\"" << x + 19 << "\" y=\"" << y + step * quality_classes * (1 - i / 4.) + 4
         << "\" font-size=\"11\">" << i / 4. << "</text>\n";
  }

  void write_quality_summary(std::ostream& os) const
  {
    double sum = 0, least = 1;
    for(double q : m_qualities) {
      sum += q;
      least = (std::min)(least, q);
    }
    const auto rounded = [](double q) { return std::round(1000 * q) / 1000; };
    os << "<text x=\"" << Svg_picture::width - Svg_picture::margin << "\" y=\"" << m_picture.caption_y()
       << "\" text-anchor=\"end\">quality: mean " << rounded(sum / static_cast<double>(m_qualities.size()))
       << ", least " << rounded(least) << "</text>\n";
  }

  const Domain_graph&        m_graph;
  const std::vector<double>& m_qualities;
  Svg_picture                m_picture;
  std::vector<Edge>          m_edges;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H

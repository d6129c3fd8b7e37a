// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_colors.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_picture.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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
  Svg_mesh(const Domain_graph& graph, std::vector<double> qualities, const Bbox_2& window)
    : m_graph(graph), m_qualities(std::move(qualities)),
      m_picture(box_of(graph.points), window, m_qualities.empty() ? 0 : legend_width)
  {
    collect_edges();
    m_picture.set_detail(rooms(), 0.02);
    choose_colors();
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
  static constexpr double      legend_width = 74;
  static constexpr int         quality_classes = 20;
  static constexpr const char *thin_color = "#33475b", *boundary_color = "#14202b", *constraint_color = "#c2491d";

  // an edge and how much room there is around it, in pixels
  struct Edge
  {
    std::size_t source, target;
    double      room = 1e300;
    int         triangles = 0, reference = 0;
    bool        is_constrained = false;

    bool operator<(const Edge& e) const
    {
      return source != e.source ? source < e.source : target < e.target;
    }
  };

  void collect_edges()
  {
    for(const auto& t : m_graph.triangles)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = t[i], b = t[(i + 1) % 3];
        m_edges.push_back(Edge{(std::min)(a, b), (std::max)(a, b), room(a, b, t[(i + 2) % 3]), 1, 0, false});
      }
    for(const auto& e : m_graph.edges)
      m_edges.push_back(Edge{(std::min)(e.source, e.target), (std::max)(e.source, e.target), 1e300, 0,
                             e.reference, true});
    std::sort(m_edges.begin(), m_edges.end());
    std::size_t n = 0;
    for(const Edge& e : m_edges)
      if(n > 0 && !(m_edges[n - 1] < e)) {
        Edge& same = m_edges[n - 1];
        same.room = (std::min)(same.room, e.room);
        same.triangles += e.triangles;
        if(e.is_constrained) {
          same.is_constrained = true;
          same.reference = e.reference;
        }
      } else
        m_edges[n++] = e;
    m_edges.erase(m_edges.begin() + static_cast<std::ptrdiff_t>(n), m_edges.end());
  }

  // The room is the least of the length of an edge and the height of the triangle.
  double room(std::size_t a, std::size_t b, std::size_t opposite) const
  {
    const auto& p = m_graph.points[a];
    const auto& q = m_graph.points[b];
    const auto& r = m_graph.points[opposite];
    const double length = std::hypot(q.x() - p.x(), q.y() - p.y());
    const double area = std::abs((q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x()));
    return length > 0 ? (std::min)(length, area / length) * m_picture.scale() : 0;
  }

  // of all edges that can be seen
  std::vector<double> rooms() const
  {
    std::vector<double> result;
    for(const Edge& e : m_edges)
      if(e.triangles > 0 && m_picture.shows(line(e)))
        result.push_back(e.room);
    return result;
  }

  // Subdomains get colors if there are several, edges if references differ along the boundary or among the inner
  // curves.
  void choose_colors()
  {
    const Edge* first[2] = {nullptr, nullptr}; // inner one and one of the boundary
    std::vector<std::pair<std::size_t, int> > uses;
    bool differ = false;
    for(const Edge& e : m_edges)
      if(e.is_constrained) {
        const Edge*& like = first[e.triangles < 2];
        like = like == nullptr ? &e : like;
        differ |= like->reference != e.reference;
        uses.insert(uses.end(), {{e.source, e.reference}, {e.target, e.reference}});
      }
    if(differ)
      m_edge_colors = colors_of_references(std::move(uses));
    uses.clear();
    const std::vector<int>& subdomains = m_graph.triangle_references;
    if(std::adjacent_find(subdomains.begin(), subdomains.end(), std::not_equal_to<int>()) == subdomains.end())
      return;
    for(std::size_t i = 0; i < subdomains.size(); ++i)
      for(std::size_t v : m_graph.triangles[i])
        uses.emplace_back(v, subdomains[i]);
    m_subdomain_colors = colors_of_references(std::move(uses));
  }

  Svg_point place(std::size_t v) const { return m_picture(m_graph.points[v]); }
  Svg_edge line(const Edge& e) const { return Svg_edge(place(e.source), place(e.target)); }

  // a subdomain, or a class of quality, in one path each
  void draw_triangles(std::ostream& os) const
  {
    std::map<int, std::vector<Svg_edge>> sides;
    for(std::size_t i = 0; i < m_graph.triangles.size(); ++i) {
      const auto& t = m_graph.triangles[i];
      const Svg_line corners = {place(t[0]), place(t[1]), place(t[2])};
      const int c = m_qualities.empty() ? m_graph.triangle_references[i] : quality_class(m_qualities[i]);
      for(std::size_t j = 0; j < 3 && m_picture.shows(corners); ++j)
        sides[c].emplace_back(corners[j], corners[(j + 1) % 3]);
    }
    for(const auto& c : sides)
      m_picture.draw_areas(os, joined_lines(border(c.second), true), fill_of(c.first), 0.2);
  }

  std::string fill_of(int subdomain_or_class) const
  {
    if(!m_qualities.empty())
      return quality_color(subdomain_or_class);
    return m_subdomain_colors.empty() ? "#e9f0f7" : name_of(soft_color(m_subdomain_colors.at(subdomain_or_class)));
  }

  // the sides that do not have a side in opposite direction
  static std::vector<Svg_edge> border(std::vector<Svg_edge> sides)
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
    std::vector<double> sizes = rooms();
    const double thick = std::clamp(0.22 * (sizes.empty() ? 1 : quantile(sizes, 0.5)), 0.8, 1.8);
    Svg_width_classes thin(0.02, 0.6);
    std::map<int, std::vector<Svg_edge> > thick_edges[2]; // inner ones and those of the boundary, by reference
    for(const Edge& e : m_edges)
      if(m_picture.shows(line(e))) {
        if(e.is_constrained || e.triangles < 2)
          thick_edges[e.triangles < 2][m_edge_colors.empty() ? 0 : e.reference].push_back(line(e));
        else
          thin.add(0.11 * e.room, line(e));
      }
    m_picture.draw_edges(os, thin, thin_color, false);
    for(bool is_boundary : {false, true})
      for(const auto& c : thick_edges[is_boundary])
        m_picture.draw_edges(os, c.second, color_of(c.first, is_boundary), is_boundary ? thick : 0.8 * thick);
  }

  std::string color_of(int reference, bool is_boundary) const
  {
    const auto color = m_edge_colors.find(reference);
    return color != m_edge_colors.end() ? name_of(strong_color(color->second))
                                        : is_boundary ? boundary_color : constraint_color;
  }

  static int quality_class(double quality)
  {
    return quality > 0 ? static_cast<int>((std::min)(quality, 0.999999) * quality_classes) : 0;
  }

  static std::string quality_color(int quality_class)
  {
    static constexpr Svg_color table[] = {
      {122, 12, 36}, {178, 24, 43}, {226, 88, 56}, {247, 152, 84}, {252, 205, 131},
      {245, 233, 178}, {206, 229, 214}, {150, 203, 216}, {208, 229, 242}};
    const double at = (quality_class + 0.5) / quality_classes * 8;
    const std::size_t i = static_cast<std::size_t>(at);
    return name_of(mixed(table[i], table[i + 1], at - static_cast<double>(i)));
  }

  std::string caption() const
  {
    std::string text = svg_count(m_graph.points.size()) + " vertices, "
                     + svg_count(m_graph.triangles.size()) + " triangles";
    const auto colored = [](const std::string& color, const std::string& word) {
      return "<tspan fill=\"" + color + "\">" + word + "</tspan>";
    };
    if(!m_edge_colors.empty()) {
      text += ", references of edges";
      std::size_t room_left = 12;
      for(const auto& c : m_edge_colors)
        if(room_left > 0 && --room_left > 0)
          text += ' ' + colored(name_of(strong_color(c.second)), std::to_string(c.first));
      text += room_left == 0 ? " ..." : "";
    } else if(std::any_of(m_edges.begin(), m_edges.end(),
                          [](const Edge& e) { return e.triangles > 1 && e.is_constrained; }))
      text += ", " + colored(constraint_color, "inner curves");
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
         << step + 0.3 << "\" fill=\"" << quality_color(i) << "\"/>\n";
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
  const std::vector<double>  m_qualities;
  Svg_picture                m_picture;
  std::vector<Edge>          m_edges;
  std::map<int, std::size_t> m_edge_colors, m_subdomain_colors; // of references
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_MESH_H

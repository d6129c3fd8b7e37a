// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_PICTURE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_PICTURE_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_lines.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// the value that the given share of the values does not reach; `values` are not empty
inline double quantile(std::vector<double>& values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// the box of points
template <class Points>
Bbox_2 box_of(const Points& points)
{
  Bbox_2 box;
  for(const auto& p : points)
    box += Bbox_2(p[0], p[1], p[0], p[1]);
  return box;
}

inline bool is_empty(const Bbox_2& box) { return !(box.xmin() <= box.xmax() && box.ymin() <= box.ymax()); }

// lines that have the same width, whose class is a power of 0.75
class Svg_width_classes
{
public:
  Svg_width_classes(double least, double greatest) : m_least(least), m_greatest(greatest) {}

  void add(double width, const Svg_edge& edge)
  {
    const double w = (std::min)((std::max)(width, m_least), m_greatest);
    m_edges[static_cast<int>(std::lround(std::log(w) / std::log(0.75)))].push_back(edge);
  }

  // from wide to narrow
  template <class Draw>
  void for_each(const Draw& draw) const
  {
    for(const auto& c : m_edges)
      draw(std::pow(0.75, c.first), c.second);
  }

private:
  double                               m_least, m_greatest;
  std::map<int, std::vector<Svg_edge>> m_edges;
};

// A picture 800 pixels wide that shows a box of the plane, and a caption
// below. All lengths are in pixels.
class Svg_picture
{
public:
  static constexpr double width = 800, margin = 16, caption_height = 30, greatest_height = 1200,
                          least_height_of_legend = 125;

  // Shows all, which is in `extent`, or what is in `window` if that is not empty. `right_margin` leaves room
  // for a legend.
  Svg_picture(const Bbox_2& extent, const Bbox_2& window = Bbox_2(), double right_margin = 0)
    : m_is_zoomed(!is_empty(window)),
      m_box(m_is_zoomed ? window : is_empty(extent) ? Bbox_2(0, 0, 1, 1) : extent)
  {
    const double available = width - 2*margin - right_margin;
    const double w = m_box.xmax() - m_box.xmin(), h = m_box.ymax() - m_box.ymin();
    m_scale = (std::min)(w > 0 ? available / w : 1e300, h > 0 ? greatest_height / h : 1e300);
    if(m_scale == 1e300)
      m_scale = 1;
    m_width = w * m_scale;
    m_height = (std::max)(h * m_scale, right_margin > 0 ? least_height_of_legend : 1.);
    m_x0 = margin + (available - m_width) / 2;
    m_y0 = margin + (m_height - h * m_scale) / 2;
  }

  double scale() const { return m_scale; }
  double height() const { return m_height; }

  // Coordinates are rounded so that details of that many pixels still have 25 steps. Of many such sizes, those of
  // which the given share is smaller are neglected.
  void set_detail(std::vector<double> pixels, double share)
  {
    const double detail = pixels.empty() ? 1 : quantile(pixels, share);
    for(m_steps = 10; m_steps < 10000 && m_steps * detail < 25;)
      m_steps *= 2;
  }

  template <class Point>
  Svg_point operator()(const Point& p) const
  {
    return {rounded_to_step(m_x0 + (p[0] - m_box.xmin()) * m_scale),
            rounded_to_step(m_y0 + (m_box.ymax() - p[1]) * m_scale)};
  }

  // whether something of the line, of the edge or of the area can be seen
  bool shows(const Svg_line& line) const
  {
    const auto window = [this] {
      return Bbox_2(m_x0 * m_steps, m_y0 * m_steps, (m_x0 + m_width) * m_steps, (m_y0 + m_height) * m_steps);
    };
    return !m_is_zoomed || CGAL::do_overlap(box_of(line), window());
  }
  bool shows(const Svg_edge& edge) const { return !m_is_zoomed || shows(Svg_line{edge.first, edge.second}); }

  // `draw(stream)` draws in steps, `annotate(stream)` writes texts in pixels
  template <class Draw, class Annotate>
  void write(std::ostream& os, const std::string& title, const Draw& draw, const Annotate& annotate) const
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" viewBox=\"0 0 800 "
        << std::lround(m_height + 2*margin + caption_height) << "\">\n<title>" << escaped(title)
        << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    if(m_is_zoomed) // a picture in the picture hides what is outside of the window
      out << "<svg x=\"" << m_x0 << "\" y=\"" << m_y0 << "\" width=\"" << m_width << "\" height=\"" << m_height
          << "\" viewBox=\"" << m_x0 << ' ' << m_y0 << ' ' << m_width << ' ' << m_height << "\">\n";
    out << "<g transform=\"scale(" << 1. / m_steps << ")\" fill=\"none\" stroke-linecap=\"round\""
        << " stroke-linejoin=\"round\">\n";
    draw(out);
    out << (m_is_zoomed ? "</g>\n</svg>\n" : "</g>\n")
        << "<g font-family=\"Helvetica,Arial,sans-serif\" font-size=\"13\" fill=\"#44525f\">\n";
    annotate(out);
    out << "</g>\n</svg>\n";
    os << out.str();
  }

  // the line of text below the picture
  void write_caption(std::ostream& os, const std::string& title, const std::string& text) const
  {
    os << "<text x=\"" << margin << "\" y=\"" << caption_y() << "\">";
    if(!title.empty())
      os << "<tspan font-weight=\"bold\">" << escaped(title) << "</tspan> &#160; ";
    os << text << "</text>\n";
  }

  long caption_y() const { return std::lround(m_height + 2*margin + 12); }

  // lines of a color
  void draw_lines(std::ostream& os, const std::vector<Svg_line>& lines, const std::string& color,
                  double line_width) const
  {
    if(lines.empty())
      return;
    os << "<path stroke=\"" << color << "\" stroke-width=\"" << rounded(line_width) << '"';
    write_path(os, lines, "");
  }

  // edges, joined to lines; with `as_one`, points on straight lines are left out
  void draw_edges(std::ostream& os, const std::vector<Svg_edge>& edges, const std::string& color,
                  double line_width, bool as_one = true) const
  {
    std::vector<Svg_line> lines = joined_lines(edges, false);
    if(as_one)
      std::transform(lines.begin(), lines.end(), lines.begin(), simplified);
    draw_lines(os, lines, color, line_width);
  }

  void draw_edges(std::ostream& os, const Svg_width_classes& widths, const std::string& color, bool as_one = true) const
  {
    widths.for_each([&](double line_width, const std::vector<Svg_edge>& edges) {
      draw_edges(os, edges, color, line_width, as_one);
    });
  }

  // edges without a length
  void draw_dots(std::ostream& os, const Svg_width_classes& diameters, const std::string& color) const
  {
    diameters.for_each([&](double diameter, const std::vector<Svg_edge>& places) {
      std::vector<Svg_line> lines;
      for(const Svg_edge& place : places)
        lines.push_back({place.first, place.second});
      draw_lines(os, lines, color, diameter);
    });
  }

  // closed lines filled with a color, a little beyond their borders so that no gap is seen
  void draw_areas(std::ostream& os, const std::vector<Svg_line>& lines, const std::string& color,
                  double line_width) const
  {
    if(lines.empty())
      return;
    os << "<path fill=\"" << color << "\" stroke=\"" << color << "\" stroke-width=\""
       << rounded(line_width) << '"';
    write_path(os, lines, "z");
  }

  // closed lines with outlines of a color, each filled with its own; later ones hide earlier ones
  void draw_outlined_areas(std::ostream& os, const std::vector<std::pair<Svg_line, std::string> >& areas,
                           const std::string& color, double line_width) const
  {
    os << "<g stroke=\"" << color << "\" stroke-width=\"" << rounded(line_width) << "\">\n";
    for(const auto& area : areas) {
      os << "<path fill=\"" << area.second << '"';
      write_path(os, {area.first}, "z");
    }
    os << "</g>\n";
  }

  static std::string escaped(const std::string& text)
  {
    std::string result;
    for(char c : text)
      if(c == '<')
        result += "&lt;";
      else if(c == '&')
        result += "&amp;";
      else
        result += c;
    return result;
  }

private:
  // far outside of a window, places are drawn nearer than they are
  int rounded_to_step(double pixels) const
  {
    return static_cast<int>(std::lround((std::min)((std::max)(pixels * m_steps, -1e9), 1e9)));
  }

  double rounded(double pixels) const { return std::round(pixels * m_steps * 100) / 100; }

  // The end of a tag: relative moves, as these are small numbers, and a minus sign needs no blank before it.
  static void write_path(std::ostream& os, const std::vector<Svg_line>& lines, const char* ending)
  {
    Text_writer out(os);
    out << " d=\"";
    Svg_point at = {0, 0};
    for(const Svg_line& line : lines) {
      const bool is_dot = line.size() == 2 && line[0] == line[1], is_closed = *ending != 0;
      const std::size_t size = line.size() - (is_dot || (is_closed && line.front() == line.back()) ? 1 : 0);
      for(std::size_t i = 0; i < size; ++i) {
        const int dx = line[i][0] - at[0], dy = line[i][1] - at[1];
        out << (i == 0 ? "m" : i == 1 ? "l" : dx >= 0 ? " " : "") << dx << (dy >= 0 ? " " : "") << dy;
        at = line[i];
      }
      out << (is_dot ? "h0" : ending);
      if(is_closed)
        at = line.front();
    }
    out << "\"/>\n";
    out.flush();
  }

  bool   m_is_zoomed;
  Bbox_2 m_box;
  double m_scale, m_width, m_height, m_x0, m_y0;
  int    m_steps = 10;
};

// a number with blanks between the thousands
inline std::string svg_count(std::size_t n)
{
  std::string digits = std::to_string(n);
  for(std::size_t i = digits.size(); i > 3; i -= 3)
    digits.insert(i - 3, "\xe2\x80\x89"); // a thin space in UTF-8
  return digits;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_PICTURE_H

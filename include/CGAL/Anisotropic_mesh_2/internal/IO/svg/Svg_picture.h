// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_PICTURE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_PICTURE_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_lines.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>

#include <algorithm>
#include <array>
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

// the rectangle of the plane that a picture shows
struct Svg_window
{
  double x_min = 0, y_min = 0, x_max = 1, y_max = 1;
  bool   is_empty = true;

  void add(double x, double y)
  {
    if(is_empty) {
      x_min = x_max = x;
      y_min = y_max = y;
      is_empty = false;
    }
    x_min = (std::min)(x_min, x);
    y_min = (std::min)(y_min, y);
    x_max = (std::max)(x_max, x);
    y_max = (std::max)(y_max, y);
  }
};

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

// A picture 800 pixels wide that shows a window of the plane, and a caption
// below. All lengths are in pixels.
class Svg_picture
{
public:
  static constexpr double width = 800, margin = 16, caption_height = 30, greatest_height = 1200,
                          least_height_of_legend = 125;

  // `right_margin` leaves room for a legend
  Svg_picture(const Svg_window& window, double right_margin) : m_window(window)
  {
    const double available = width - 2*margin - right_margin;
    const double w = window.x_max - window.x_min, h = window.y_max - window.y_min;
    m_scale = (std::min)(w > 0 ? available / w : 1e300, h > 0 ? greatest_height / h : 1e300);
    if(m_scale == 1e300)
      m_scale = 1;
    m_height = (std::max)(h * m_scale, right_margin > 0 ? least_height_of_legend : 1.);
    m_x0 = margin + (available - w * m_scale) / 2;
    m_y0 = margin + (m_height - h * m_scale) / 2;
  }

  double scale() const { return m_scale; }
  double height() const { return m_height; }

  // Coordinates are rounded so that a detail of that many pixels still has 25 steps.
  void set_detail(double pixels)
  {
    m_steps = 10;
    while(m_steps < 10000 && m_steps * pixels < 25)
      m_steps *= 2;
  }

  Svg_point operator()(double x, double y) const
  {
    return {static_cast<int>(std::lround((m_x0 + (x - m_window.x_min) * m_scale) * m_steps)),
            static_cast<int>(std::lround((m_y0 + (m_window.y_max - y) * m_scale) * m_steps))};
  }

  // `draw(stream)` draws in steps, `annotate(stream)` writes texts in pixels
  template <class Draw, class Annotate>
  void write(std::ostream& os, const std::string& title, const Draw& draw, const Annotate& annotate) const
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" viewBox=\"0 0 800 "
        << std::lround(m_height + 2*margin + caption_height) << "\">\n<title>" << escaped(title)
        << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        << "<g transform=\"scale(" << 1. / m_steps << ")\" fill=\"none\" stroke-linecap=\"round\""
        << " stroke-linejoin=\"round\">\n";
    draw(out);
    out << "</g>\n<g font-family=\"Helvetica,Arial,sans-serif\" font-size=\"13\" fill=\"#44525f\">\n";
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
    os << "<path stroke=\"" << color << "\" stroke-width=\"" << rounded(line_width) << "\" d=\"";
    write_path(os, lines, "");
    os << "\"/>\n";
  }

  // closed lines filled with a color, a little beyond their borders so that no gap is seen
  void draw_areas(std::ostream& os, const std::vector<Svg_line>& lines, const std::string& color,
                  double line_width) const
  {
    if(lines.empty())
      return;
    os << "<path fill=\"" << color << "\" stroke=\"" << color << "\" stroke-width=\""
       << rounded(line_width) << "\" d=\"";
    write_path(os, lines, "z");
    os << "\"/>\n";
  }

  // closed lines with outlines of a color, each filled with its own; later ones hide earlier ones
  void draw_outlined_areas(std::ostream& os, const std::vector<std::pair<Svg_line, std::string> >& areas,
                           const std::string& color, double line_width) const
  {
    os << "<g stroke=\"" << color << "\" stroke-width=\"" << rounded(line_width) << "\">\n";
    for(const auto& area : areas) {
      os << "<path fill=\"" << area.second << "\" d=\"";
      write_path(os, {area.first}, "z");
      os << "\"/>\n";
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
  double rounded(double pixels) const { return std::lround(pixels * m_steps * 100) / 100.; }

  // Relative moves: small numbers, and a minus sign needs no blank before it.
  static void write_path(std::ostream& os, const std::vector<Svg_line>& lines, const char* ending)
  {
    Text_writer out(os);
    Svg_point at = {0, 0};
    for(const Svg_line& line : lines) {
      const bool is_dot = line.size() == 2 && line[0] == line[1];
      const bool is_closed = *ending != 0;
      char command = 'm';
      const std::size_t size = line.size() - (is_closed && line.front() == line.back() ? 1 : 0);
      for(std::size_t i = 0; i < size; ++i) {
        const int dx = line[i][0] - at[0], dy = line[i][1] - at[1];
        out << (command == 0 && dx >= 0 ? " " : "");
        if(command != 0)
          out << command;
        out << dx << (dy >= 0 ? " " : "") << dy;
        command = i == 0 ? 'l' : char(0);
        at = line[i];
        if(is_dot)
          break;
      }
      out << (is_dot ? "h0" : ending);
      if(is_closed)
        at = line.front();
    }
  }

  Svg_window m_window;
  double     m_scale, m_height, m_x0, m_y0;
  int        m_steps = 10;
};

// a color between those of a table, at `t` between 0 and 1
inline std::string svg_color(const std::vector<std::array<int, 3>>& table, double t)
{
  const double at = (std::min)((std::max)(t, 0.), 1.) * static_cast<double>(table.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(at), table.size() - 2);
  const double s = at - static_cast<double>(i);
  static const char* const digits = "0123456789abcdef";
  std::string color = "#";
  for(std::size_t c = 0; c < 3; ++c) {
    const long value = std::lround((1 - s) * table[i][c] + s * table[i + 1][c]);
    color += digits[value / 16];
    color += digits[value % 16];
  }
  return color;
}

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

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_SURFACE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_SURFACE_H

#include <CGAL/Anisotropic_mesh_2/View_direction_3.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_lines.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_picture.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Draws small polygons of a surface as they are seen from far away, those in the
// back first, so that those in front hide them. Shades show the angle to the
// light, and widths of lines follow the size of the polygons.
class Svg_surface
{
public:
  // of a closed surface only what faces the eye is drawn
  Svg_surface(const View_direction_3& view, bool is_closed) : m_is_closed(is_closed)
  {
    const double ca = std::cos(view.azimuth), sa = std::sin(view.azimuth);
    const double ce = std::cos(view.elevation), se = std::sin(view.elevation);
    m_right = {-sa, ca, 0};
    m_up = {-se*ca, -se*sa, ce};
    m_to_eye = {ce*ca, ce*sa, se};
  }

  template <class Points>
  void add_polygon(const Points& points)
  {
    if(points.size() < 3)
      return;
    std::vector<Vector> p;
    for(const auto& x : points)
      p.push_back({CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z())});
    Polygon polygon;
    Vector normal{0, 0, 0};
    for(std::size_t i = 0; i < p.size(); ++i) {
      const Vector &a = p[i], &b = p[(i + 1) % p.size()];
      for(int k = 0; k < 3; ++k)
        normal[k] += (a[(k + 1) % 3] - b[(k + 1) % 3]) * (a[(k + 2) % 3] + b[(k + 2) % 3]); // Newell's method
      polygon.depth += product(a, m_to_eye) / double(p.size());
      polygon.points.push_back({product(a, m_right), product(a, m_up)});
    }
    if(m_is_closed && product(normal, m_to_eye) <= 0)
      return;
    polygon.shade = shade(normal);
    m_polygons.push_back(std::move(polygon));
  }

  // `text` follows the title in the line below the picture
  void write(std::ostream& os, const std::string& title, const std::string& text)
  {
    std::stable_sort(m_polygons.begin(), m_polygons.end(),
                     [](const Polygon& p, const Polygon& q) { return p.depth < q.depth; });
    Bbox_2 box;
    for(const Polygon& p : m_polygons)
      box += box_of(p.points);
    const Svg_picture picture(box);
    std::vector<std::pair<Svg_line, std::string> > areas;
    for(const Polygon& p : m_polygons) {
      areas.emplace_back(Svg_line(), color(p.shade));
      for(const Point& x : p.points)
        areas.back().first.push_back(picture(x));
    }
    picture.write(os, title.empty() ? "Surface" : title, [&](std::ostream& out) {
      picture.draw_outlined_areas(out, areas, "#27364a", line_width(picture.scale()));
    }, [&](std::ostream& out) {
      picture.write_caption(out, title, text);
    });
  }

private:
  typedef std::array<double, 3> Vector;
  typedef std::array<double, 2> Point;

  struct Polygon
  {
    std::vector<Point> points;
    double             depth = 0; // towards the eye
    double             shade = 0; // 0 is dark

    double area() const
    {
      double sum = 0;
      for(std::size_t i = 0; i < points.size(); ++i) {
        const Point &a = points[i], &b = points[(i + 1) % points.size()];
        sum += a[0]*b[1] - a[1]*b[0];
      }
      return std::abs(sum) / 2;
    }
  };

  static double product(const Vector& a, const Vector& b) { return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]; }

  // The light comes from the upper left. Both sides of a surface are seen.
  double shade(const Vector& normal) const
  {
    const double length = std::sqrt(product(normal, normal));
    if(!(length > 0))
      return 0;
    const double side = product(normal, m_to_eye) < 0 ? -1 : 1;
    const double light = product(normal, m_to_eye) * 0.8 - product(normal, m_right) * 0.33
                       + product(normal, m_up) * 0.5;
    return (std::max)(0., side * light / length);
  }

  // a fraction of the mean size of the polygons
  double line_width(double scale) const
  {
    double area = 0;
    for(const Polygon& p : m_polygons)
      area += p.area();
    const double size = scale * std::sqrt(area / (std::max<double>)(1, double(m_polygons.size())));
    return std::clamp(0.06 * size, 0.1, 1.);
  }

  static std::string color(double shade)
  {
    const int light = std::clamp(int(std::lround(90 + 165 * std::sqrt(shade))), 0, 255);
    return "rgb(" + std::to_string(4*light/5) + ',' + std::to_string(7*light/8) + ',' + std::to_string(light) + ')';
  }

  const bool           m_is_closed;
  Vector               m_right, m_up, m_to_eye;
  std::vector<Polygon> m_polygons;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_SURFACE_H

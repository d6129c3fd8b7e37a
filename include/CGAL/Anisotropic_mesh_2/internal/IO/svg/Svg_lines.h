// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A place on the fine grid of a picture, x to the right and y downwards.
// Whole numbers: equal places are equal, and relative moves add up exactly.
typedef std::array<int, 2>              Svg_point;
typedef std::pair<Svg_point, Svg_point> Svg_edge;
typedef std::vector<Svg_point>          Svg_line;

// whether `p` lies between `a` and `b`, at most `tolerance` beside the line
inline bool is_between(const Svg_point& p, const Svg_point& a, const Svg_point& b, double tolerance)
{
  const double ux = double(b[0]) - a[0], uy = double(b[1]) - a[1];
  const double vx = double(p[0]) - a[0], vy = double(p[1]) - a[1];
  const double uu = ux*ux + uy*uy, uv = ux*vx + uy*vy, area = ux*vy - uy*vx;
  return uv > 0 && uv < uu && area*area <= tolerance*tolerance * uu;
}

// Leaves out points that lie on the line between those that are kept before and after them.
inline Svg_line simplified(const Svg_line& line)
{
  Svg_line result;
  std::size_t kept = 0;
  for(std::size_t i = 0; i < line.size(); ++i) {
    const auto lies_on_line = [&](const Svg_point& p) { return is_between(p, line[kept], line[i + 1], 0.5); };
    if(i > 0 && i + 1 < line.size()
       && std::all_of(line.begin() + kept + 1, line.begin() + i + 1, lies_on_line))
      continue;
    result.push_back(line[i]);
    kept = i;
  }
  return result;
}

// Joins edges to a few long lines, always the same for the same edges. With
// `are_directed`, edges are followed in their direction only: if as many enter
// as leave at each point, all lines are closed.
inline std::vector<Svg_line> joined_lines(const std::vector<Svg_edge>& edges, bool are_directed)
{
  typedef std::pair<Svg_edge, std::size_t> Step; // with its number among the edges
  std::vector<Step> steps;
  for(std::size_t i = 0; i < edges.size(); ++i)
    if(edges[i].first != edges[i].second) {
      steps.emplace_back(edges[i], i);
      if(!are_directed)
        steps.emplace_back(Svg_edge(edges[i].second, edges[i].first), i);
    }
  std::sort(steps.begin(), steps.end());
  const auto first_from = [&](const Svg_point& p) {
    return std::size_t(std::lower_bound(steps.begin(), steps.end(), p, [](const Step& s, const Svg_point& q) {
                         return s.first.first < q;
                       }) - steps.begin());
  };
  std::vector<bool> is_used(edges.size(), false);
  std::vector<std::size_t> passed(steps.size(), 0); // by the first step from a point: how many of them are used
  const auto line_from = [&](Svg_point p) {
    Svg_line line(1, p);
    for(std::size_t first = first_from(p); first < steps.size();) {
      const std::size_t s = first + passed[first];
      if(s == steps.size() || steps[s].first.first != p)
        break;
      ++passed[first];
      if(!is_used[steps[s].second]) {
        is_used[steps[s].second] = true;
        line.push_back(p = steps[s].first.second);
        first = first_from(p);
      }
    }
    return line;
  };
  std::vector<Svg_line> lines;
  for(bool from_odd_points : {true, false}) // those in which lines must end
    for(std::size_t first = 0, last; first < steps.size(); first = last) {
      const Svg_point p = steps[first].first.first;
      for(last = first; last < steps.size() && steps[last].first.first == p;)
        ++last;
      if(!from_odd_points || (last - first) % 2 == 1)
        for(Svg_line line = line_from(p); line.size() > 1; line = line_from(p))
          lines.push_back(line);
    }
  return lines;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H

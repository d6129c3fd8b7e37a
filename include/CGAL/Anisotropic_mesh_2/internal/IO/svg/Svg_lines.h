// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A place on the fine grid of a picture, x to the right and y downwards.
// Whole numbers: equal places are equal, and relative moves add up exactly.
typedef std::array<int, 2>              Svg_point;
typedef std::pair<Svg_point, Svg_point> Svg_edge;
typedef std::vector<Svg_point>          Svg_line;

inline double svg_distance(const Svg_point& p, const Svg_point& q)
{
  return std::hypot(double(q[0]) - p[0], double(q[1]) - p[1]);
}

// whether `p` lies between `a` and `b`, at most `tolerance` beside the line
inline bool is_between(const Svg_point& p, const Svg_point& a, const Svg_point& b, double tolerance)
{
  const double ux = double(b[0]) - a[0], uy = double(b[1]) - a[1];
  const double vx = double(p[0]) - a[0], vy = double(p[1]) - a[1];
  const double uu = ux*ux + uy*uy, uv = ux*vx + uy*vy, area = ux*vy - uy*vx;
  return uv > 0 && uv < uu && area*area <= tolerance*tolerance * uu;
}

// Leaves out the points that lie on the line between their neighbors.
inline Svg_line simplified(const Svg_line& line)
{
  Svg_line result;
  for(std::size_t i = 0; i < line.size(); ++i) {
    const bool is_inner = i > 0 && i + 1 < line.size();
    if(!is_inner || !is_between(line[i], result.back(), line[i + 1], 0.5))
      result.push_back(line[i]);
  }
  return result;
}

// Joins edges to a few long lines, always the same for the same edges. With
// `are_directed`, edges are followed in their direction only: if as many enter
// as leave at each point, all lines are closed.
class Svg_line_joiner
{
public:
  Svg_line_joiner(const std::vector<Svg_edge>& edges, bool are_directed)
  {
    for(std::size_t i = 0; i < edges.size(); ++i)
      if(edges[i].first != edges[i].second) {
        m_ends.push_back(End{edges[i].first, edges[i].second, i});
        if(!are_directed)
          m_ends.push_back(End{edges[i].second, edges[i].first, i});
      }
    std::sort(m_ends.begin(), m_ends.end());
    m_is_used.assign(edges.size(), false);
  }

  std::vector<Svg_line> lines()
  {
    std::vector<Svg_line> result;
    for(bool from_odd_points : {true, false}) // those in which lines must end
      for(std::size_t first = 0, last; first < m_ends.size(); first = last) {
        for(last = first; last < m_ends.size() && m_ends[last].from == m_ends[first].from;)
          ++last;
        if(from_odd_points && (last - first) % 2 == 0)
          continue;
        Svg_line line;
        while((line = line_from(m_ends[first].from)).size() > 1)
          result.push_back(std::move(line));
      }
    return result;
  }

private:
  struct End
  {
    Svg_point   from, to;
    std::size_t edge;

    bool operator<(const End& e) const
    {
      return from != e.from ? from < e.from : to != e.to ? to < e.to : edge < e.edge;
    }
  };

  Svg_line line_from(Svg_point p)
  {
    Svg_line line(1, p);
    while(true) {
      auto end = std::lower_bound(m_ends.begin(), m_ends.end(), p,
                                  [](const End& e, const Svg_point& q) { return e.from < q; });
      while(end != m_ends.end() && end->from == p && m_is_used[end->edge])
        ++end;
      if(end == m_ends.end() || end->from != p)
        return line;
      m_is_used[end->edge] = true;
      p = end->to;
      line.push_back(p);
    }
  }

  std::vector<End>  m_ends;
  std::vector<bool> m_is_used;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_LINES_H

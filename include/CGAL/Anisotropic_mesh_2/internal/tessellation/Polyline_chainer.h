// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_POLYLINE_CHAINER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_POLYLINE_CHAINER_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A directed segment between numbered points.
struct Link
{
  std::size_t from, to;

  bool operator<(const Link& l) const { return from != l.from ? from < l.from : to < l.to; }
};

// Puts segments together to polygonal lines, first those that end somewhere,
// then the closed ones.
class Polyline_chainer
{
public:
  struct Line
  {
    std::vector<std::size_t> points; // the first one not repeated at the end
    bool                     is_closed = false;
  };

  Polyline_chainer(std::vector<Link> links, const Vectors& points) : m_links(std::move(links)), m_points(points)
  {
    std::sort(m_links.begin(), m_links.end());
    m_is_used.assign(m_links.size(), false);
  }

  std::vector<Line> operator()()
  {
    std::vector<std::size_t> ends;
    for(const Link& l : m_links)
      ends.push_back(l.to);
    std::sort(ends.begin(), ends.end());
    std::vector<Line> lines;
    for(bool is_open : {true, false})
      for(std::size_t k = 0; k < m_links.size(); ++k)
        if(!m_is_used[k] && (!is_open || !std::binary_search(ends.begin(), ends.end(), m_links[k].from)))
          lines.push_back(follow(k));
    return lines;
  }

private:
  Line follow(std::size_t k)
  {
    Line line;
    line.points.push_back(m_links[k].from);
    for(;;) {
      m_is_used[k] = true;
      const std::size_t at = m_links[k].to;
      line.is_closed = at == line.points.front();
      if(line.is_closed)
        return line;
      line.points.push_back(at);
      if(!find_next(m_links[k].from, at, k))
        return line;
    }
  }

  // Of several segments that go on at a point, the one that is the first
  // clockwise from where the line came: what is on the left of it stays together.
  bool find_next(std::size_t from, std::size_t at, std::size_t& next) const
  {
    double least = 7;
    bool is_found = false;
    auto l = std::lower_bound(m_links.begin(), m_links.end(), Link{at, 0});
    for(; l != m_links.end() && l->from == at; ++l) {
      const std::size_t k = static_cast<std::size_t>(l - m_links.begin());
      if(m_is_used[k])
        continue;
      const double turn = clockwise_angle(from, at, l->to);
      if(turn < least) {
        least = turn;
        next = k;
        is_found = true;
      }
    }
    return is_found;
  }

  double clockwise_angle(std::size_t from, std::size_t at, std::size_t to) const
  {
    const Vector_of_doubles &p = m_points[from], &q = m_points[at], &r = m_points[to];
    const double angle = std::atan2(p.y - q.y, p.x - q.x) - std::atan2(r.y - q.y, r.x - q.x);
    return angle > 0 ? angle : angle + 2 * CGAL_PI;
  }

  std::vector<Link> m_links;
  const Vectors& m_points;
  std::vector<bool> m_is_used;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_POLYLINE_CHAINER_H

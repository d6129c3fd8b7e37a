// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_RIEMANNIAN_LENGTH_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_RIEMANNIAN_LENGTH_2_H

#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// One panel of the quadrature: five equidistant nodes in [t0, t0 + 4*step].
// The derivative of the curve is that of the polynomial through its nodes, so
// that nothing but points is asked of a curve and no step size must be guessed.
template <class K, class Tensor>
class Length_panel
{
public:
  struct Node
  {
    typename K::Point_2 point;
    Tensor              tensor;
  };

  double t0, step;                  // of the parameter
  std::array<Node, 5>   nodes;
  std::array<double, 5> speeds;     // metric lengths of the derivative
  double length, error;

  Length_panel(double t0, double step, const std::array<Node, 5>& nodes, bool is_straight)
    : t0(t0), step(step), nodes(nodes)
  {
    for(std::size_t i = 0; i < 5; ++i)
      speeds[i] = speed(i, is_straight);
    length = step/3 * (speeds[0] + 4*speeds[1] + 2*speeds[2] + 4*speeds[3] + speeds[4]);
    error = std::abs(length - coarse_length()) / 15;
  }

  double t1() const { return t0 + 4*step; }
  double coarse_length() const { return 2*step/3 * (speeds[0] + 4*speeds[2] + speeds[4]); }

  double lower_bound() const { return 4*step * *std::min_element(speeds.begin(), speeds.end()); }

private:
  double speed(std::size_t i, bool is_straight) const
  {
    typedef typename K::FT FT;
    FT dx(0), dy(0);
    if(is_straight) {
      dx = nodes[4].point.x() - nodes[0].point.x();
      dy = nodes[4].point.y() - nodes[0].point.y();
    } else {
      static constexpr double weights[5][5] = { {-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1},
                                                {-1, 6, -18, 10, 3}, {3, -16, 36, -48, 25} };
      for(std::size_t j = 0; j < 5; ++j) {
        dx += FT(weights[i][j]/3) * (nodes[j].point.x() - nodes[2].point.x());
        dy += FT(weights[i][j]/3) * (nodes[j].point.y() - nodes[2].point.y());
      }
    }
    const FT square = nodes[i].tensor.squared_length(dx, dy);
    return std::sqrt((std::max)(0., CGAL::to_double(square))) / (4*step);
  }
};

// The Riemannian length of a curve piece as a function of its parameter, and
// the inverse of that function.
//
// Adaptive Simpson quadrature: panels are bisected, the longest first, until
// each is shorter than the threshold, then those with the largest error
// estimate until the estimates add up to 10^-8 of the length. The number of
// panels is bounded, whatever the metric does: jumps cost about 30 panels each,
// and pieces of more than 2000 unit edges get panels longer than the threshold.
template <class K, class Field>
class Riemannian_length_2
{
public:
  typedef Curve_piece_2<K>        Piece;
  typedef typename K::Point_2     Point_2;

  static constexpr int fewest_panels = 7; // odd: symmetric features are not skipped

  // begins with that many panels, and stops as soon as the length is known to exceed `limit`; `total()` exceeds it then
  Riemannian_length_2(const Piece& piece, const Field& field,
                      double limit = std::numeric_limits<double>::infinity(), int panels = fewest_panels)
    : m_piece(piece), m_field(field)
  {
    start(panels);
    bisect_long_panels(limit);
    if(m_lower_bound <= limit)
      bisect_inaccurate_panels();
    tabulate(limit);
  }

  // of the whole piece
  double total() const { return m_total; }

  // from the source to the parameter t
  double length(double t) const
  {
    if(t >= 1)
      return m_total;
    const auto after = [](double value, const Entry& e) { return value < e.t0; };
    const auto e = std::upper_bound(m_table.begin() + 1, m_table.end(), t, after) - 1;
    return e->before + e->length * e->share((t - e->t0) / e->width);
  }

  // where the length from the source is `l`
  double parameter(double l) const
  {
    if(l >= m_total)
      return 1;
    const auto after = [](double value, const Entry& e) { return value < e.before; };
    const auto e = std::upper_bound(m_table.begin() + 1, m_table.end(), l, after) - 1;
    return (std::min)(1., e->t0 + e->width * e->inverse_share((l - e->before) / e->length));
  }

private:
  typedef std::decay_t<decltype(std::declval<const Field&>()(std::declval<const Point_2&>()))> Tensor;
  typedef Length_panel<K, Tensor>          Panel;
  typedef typename Panel::Node             Node;
  typedef std::pair<double, std::size_t>   Ranked; // key, panel
  typedef std::priority_queue<Ranked>      Queue;

  static constexpr double      threshold = 0.4;             // the paper's delta, 0.1, between the nodes of a panel
  static constexpr double      relative_tolerance = 1e-8;
  static constexpr double      smallest_step = 1e-14;
  static constexpr double      many_panels = 2e4;
  static constexpr int         accuracy_bisections = 4096;

  // A panel with its speed as a polynomial of degree four, normalized to length 1.
  struct Entry
  {
    double t0, width, before, length;
    std::array<double, 5> factor; // of s, s^2, ... in the share

    double share(double s) const
    {
      return s * (factor[0] + s * (factor[1] + s * (factor[2] + s * (factor[3] + s * factor[4]))));
    }

    double share_rate(double s) const
    {
      return factor[0] + s * (2*factor[1] + s * (3*factor[2] + s * (4*factor[3] + s * 5*factor[4])));
    }

    // at the middles between the nodes, where the speed might be negative
    bool rises() const
    {
      return share_rate(1./8) > 0 && share_rate(3./8) > 0 && share_rate(5./8) > 0 && share_rate(7./8) > 0;
    }

    // Newton's method, kept within the bounds by bisection
    double inverse_share(double value) const
    {
      double low = 0, high = 1, s = value;
      for(int i = 0; i < 54 && low < high; ++i) {
        const double excess = share(s) - value;
        (excess < 0 ? low : high) = s;
        const double next = s - excess / share_rate(s);
        if(std::abs(next - s) <= 1e-15)
          break;
        s = low < next && next < high ? next : (low + high) / 2; // also if next is NaN
      }
      return s;
    }
  };

  Node node(double t) const
  {
    const Point_2 p = m_piece.point(t);
    return Node{p, metric_at(m_field, p)};
  }

  void start(int panels)
  {
    Node last = node(0);
    for(int i = 0; i < panels; ++i) {
      const double t0 = double(i) / panels, step = 0.25 / panels;
      const Node next = node(double(i + 1) / panels);
      add(Panel(t0, step, {last, node(t0 + step), node(t0 + 2*step), node(t0 + 3*step), next},
                m_piece.is_straight()));
      last = next;
    }
  }

  void add(const Panel& panel)
  {
    m_total += panel.length;
    m_error += panel.error;
    m_lower_bound += panel.lower_bound();
    m_panels.push_back(panel);
  }

  void bisect(std::size_t i)
  {
    const Panel p = m_panels[i];
    const double step = p.step / 2, middle = p.t0 + 4*step;
    const auto& n = p.nodes;
    const bool straight = m_piece.is_straight();
    Panel left(p.t0, step, {n[0], node(p.t0 + step), n[1], node(p.t0 + 3*step), n[2]}, straight);
    Panel right(middle, step, {n[2], node(middle + step), n[3], node(middle + 3*step), n[4]}, straight);
    const double change = std::abs(left.length + right.length - p.length) / 30;
    left.error = (std::max)(left.error, change);
    right.error = (std::max)(right.error, change);
    m_total += left.length - p.length;
    m_error += left.error - p.error;
    m_lower_bound += left.lower_bound() - p.lower_bound();
    m_panels[i] = left;
    add(right);
  }

  bool is_divisible(std::size_t i) const { return m_panels[i].step > smallest_step; }

  void bisect_long_panels(double limit)
  {
    Queue queue;
    for(std::size_t i = 0; i < m_panels.size(); ++i)
      queue.push(Ranked(m_panels[i].length, i));
    while(!queue.empty() && m_lower_bound <= limit) {
      const Ranked top = queue.top();
      queue.pop();
      if(top.first < (std::max)(threshold, m_total / many_panels))
        break;
      if(!is_divisible(top.second))
        continue;
      bisect(top.second);
      queue.push(Ranked(m_panels[top.second].length, top.second));
      queue.push(Ranked(m_panels.back().length, m_panels.size() - 1));
    }
  }

  void bisect_inaccurate_panels()
  {
    Queue queue;
    m_total = m_error = 0; // again, without the rounding that large first estimates left behind
    for(std::size_t i = 0; i < m_panels.size(); ++i) {
      m_total += m_panels[i].length;
      m_error += m_panels[i].error;
      queue.push(Ranked(m_panels[i].error, i));
    }
    for(int k = 0; k < accuracy_bisections && !queue.empty() && m_error > relative_tolerance * m_total; ++k) {
      const std::size_t i = queue.top().second;
      queue.pop();
      if(!is_divisible(i))
        continue;
      bisect(i);
      queue.push(Ranked(m_panels[i].error, i));
      queue.push(Ranked(m_panels.back().error, m_panels.size() - 1));
    }
  }

  static Entry entry(const Panel& p, double before)
  {
    // forward differences of the speeds
    const auto& v = p.speeds;
    const double d1 = v[1] - v[0], d2 = v[2] - 2*v[1] + v[0], d3 = v[3] - 3*v[2] + 3*v[1] - v[0];
    const double d4 = v[4] - 4*v[3] + 6*v[2] - 4*v[1] + v[0];
    Entry e{p.t0, 4*p.step, before, p.length,
            {v[0], 2*d1 - d2 + 2./3*d3 - d4/2, 8./3*d2 - 8./3*d3 + 22./9*d4, 8./3*d3 - 4*d4, 32./15*d4}};
    const double whole = e.share(1);
    for(double& f : e.factor)
      f /= whole;
    if(!e.rises()) // the curve rests, or the speed jumps
      e.factor = {1, 0, 0, 0, 0};
    return e;
  }

  void tabulate(double limit)
  {
    std::vector<std::pair<double, std::size_t> > order; // panels are large to sort
    for(std::size_t i = 0; i < m_panels.size(); ++i)
      order.push_back({m_panels[i].t0, i});
    std::sort(order.begin(), order.end());
    m_table.reserve(m_panels.size());
    double sum = 0;
    for(const auto& panel : order) {
      const Panel& p = m_panels[panel.second];
      m_table.push_back(entry(p, sum));
      sum += p.length;
    }
    m_total = m_lower_bound > limit ? (std::max)(m_lower_bound, sum) : sum;
    std::vector<Panel>().swap(m_panels);
  }

  Piece              m_piece;
  const Field&       m_field;
  std::vector<Panel> m_panels;
  std::vector<Entry> m_table;
  double             m_total = 0, m_error = 0, m_lower_bound = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_RIEMANNIAN_LENGTH_2_H

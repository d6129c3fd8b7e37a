// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_CONFLICTS_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_CONFLICTS_2_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Box_tree.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/exact_predicates.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_graph_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Finds what is wrong with a chord graph: chords that meet elsewhere than in
// common end points, and points of other pieces between a curve and its chord,
// which would change sides. All decisions are exact; the area between a curve
// and its chord is that of a polygon through seven more points of the curve.
template <class K>
class Chord_conflicts_2
{
public:
  typedef Chord_graph_2<K>                         Graph;
  typedef typename Graph::Chord                    Chord;
  typedef std::vector<Domain_piece_2<K> >          Pieces;
  typedef std::vector<std::vector<double> >        Parameters;
  typedef std::pair<std::size_t, std::size_t>      Pair;    // chords, or a chord and a point

  Chord_conflicts_2(const Graph& graph, const Pieces& pieces, const Parameters& parameters)
    : m_graph(graph), m_pieces(pieces), m_parameters(parameters)
  {
    for(const auto& p : graph.points())
      m_points.push_back(exact_point<K>(p));
    find_meeting_chords();
    find_enclosed_points();
  }

  const std::vector<Pair>& meeting_chords() const { return m_meeting; }
  const std::vector<Pair>& enclosed_points() const { return m_enclosed; }

private:
  typedef Exact_predicates_kernel_of<K>                             Exact;
  typedef typename Exact::Point_2                                   Exact_point;
  typedef typename Exact::Segment_2                                 Exact_segment;
  static constexpr std::size_t parts_of_curve = 8;

  Exact_segment segment(const Chord& c) const { return Exact_segment(m_points[c.source], m_points[c.target]); }

  void find_meeting_chords()
  {
    std::vector<Bbox_2> boxes;
    for(const Chord& c : m_graph.chords())
      boxes.push_back(m_points[c.source].bbox() + m_points[c.target].bbox());
    const Box_tree tree(boxes, 1);
    std::vector<std::size_t> found;
    for(std::size_t i = 0; i < boxes.size(); ++i) {
      tree.find_overlapping(boxes[i], found);
      for(std::size_t k : found)
        if(k > i && meet_wrongly(m_graph.chords()[i], m_graph.chords()[k])) {
          m_meeting.push_back(Pair(i, k));
          if(is_segment(i) && is_segment(k)) { // nothing separates them, so that no other pair counts
            m_meeting.assign(1, Pair(i, k));
            return;
          }
        }
    }
  }

  bool is_segment(std::size_t chord) const
  {
    return m_pieces[m_graph.chords()[chord].piece].curve.is_straight();
  }

  bool meet_wrongly(const Chord& a, const Chord& b) const
  {
    const bool source_shared = a.source == b.source || a.source == b.target;
    const bool target_shared = a.target == b.source || a.target == b.target;
    if(!source_shared && !target_shared)
      return Exact().do_intersect_2_object()(segment(a), segment(b));
    if(source_shared && target_shared)
      return true;
    const std::size_t shared = source_shared ? a.source : a.target;
    return overlap(shared, a.source + a.target - shared, b.source + b.target - shared);
  }

  // returns whether the chords from o to p and from o to q have the same direction
  bool overlap(std::size_t o, std::size_t p, std::size_t q) const
  {
    const Exact kernel = Exact();
    return kernel.orientation_2_object()(m_points[o], m_points[p], m_points[q]) == COLLINEAR
        && !kernel.collinear_are_strictly_ordered_along_line_2_object()(m_points[p], m_points[o], m_points[q]);
  }

  typedef std::array<Exact_point, parts_of_curve + 1> Ring;

  Ring ring(const Chord& c) const
  {
    const double t0 = m_parameters[c.piece][c.part], t1 = m_parameters[c.piece][c.part + 1];
    Ring points;
    points.front() = m_points[c.source];
    points.back() = m_points[c.target];
    for(std::size_t k = 1; k < parts_of_curve; ++k)
      points[k] = exact_point<K>(m_pieces[c.piece].curve.point(t0 + double(k)/parts_of_curve * (t1 - t0)));
    return points;
  }

  void find_enclosed_points()
  {
    if(std::all_of(m_pieces.begin(), m_pieces.end(), [](const auto& piece) { return piece.curve.is_straight(); }))
      return;
    std::vector<Bbox_2> boxes;
    for(const Exact_point& p : m_points)
      boxes.push_back(p.bbox());
    const Box_tree tree(boxes, 1);
    std::vector<std::size_t> found;
    for(std::size_t i = 0; i < m_graph.chords().size(); ++i) {
      const Chord& c = m_graph.chords()[i];
      if(is_segment(i))
        continue;
      const Ring r = ring(c);
      Bbox_2 box;
      for(const Exact_point& p : r)
        box += p.bbox();
      tree.find_overlapping(box, found);
      for(std::size_t k : found)
        if(k != c.source && k != c.target && encloses(r, m_points[k]))
          m_enclosed.push_back(Pair(i, k));
    }
  }

  // counts the edges that a ray to the right crosses
  static bool encloses(const Ring& ring, const Exact_point& p)
  {
    bool inside = false;
    for(std::size_t i = 0; i < ring.size(); ++i) {
      Exact_point a = ring[i], b = ring[(i+1) % ring.size()];
      if((a.y() > p.y()) == (b.y() > p.y()))
        continue;
      if(a.y() > b.y())
        std::swap(a, b);
      inside ^= Exact().orientation_2_object()(a, b, p) == LEFT_TURN;
    }
    return inside;
  }

  const Graph&             m_graph;
  const Pieces&            m_pieces;
  const Parameters&        m_parameters;
  std::vector<Exact_point> m_points;
  std::vector<Pair>        m_meeting, m_enclosed;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_CONFLICTS_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SEPARATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SEPARATOR_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_conflicts_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Bisects chords of curves until the chords meet in common end points only and
// lie on the same side of everything else as their curves do.
//
// `middle(piece, t0, t1)` is a parameter between t0 and t1.
// Throws Invalid_domain_exception when segments cross, or when curves still do
// after 24 rounds, each of which brings chords 4 times closer to their curves.
template <class K>
class Chord_separator
{
public:
  typedef Chord_graph_2<K>                                   Graph;
  typedef typename Graph::Chord                              Chord;
  typedef std::vector<Domain_piece_2<K> >                    Pieces;
  typedef std::vector<std::vector<double> >                  Parameters;
  typedef std::function<double(std::size_t, double, double)> Middle;

  Chord_separator(const Pieces& pieces, Parameters& parameters, const Middle& middle)
    : m_pieces(pieces), m_parameters(parameters), m_middle(middle)
  {}

  Graph operator()()
  {
    for(int round = 0; ; ++round) {
      const Graph graph(m_pieces, m_parameters);
      const Chord_conflicts_2<K> conflicts(graph, m_pieces, m_parameters);
      if(conflicts.meeting_chords().empty() && conflicts.enclosed_points().empty())
        return graph;
      const std::set<Part> parts = parts_to_bisect(graph, conflicts, round == maximum_rounds);
      bisect(parts);
    }
  }

private:
  typedef std::pair<std::size_t, std::size_t> Part; // piece, number of the part
  static constexpr int maximum_rounds = 24;

  bool is_straight(const Chord& c) const { return m_pieces[c.piece].curve.is_straight(); }

  std::set<Part> parts_to_bisect(const Graph& graph, const Chord_conflicts_2<K>& conflicts, bool give_up) const
  {
    std::set<Part> parts;
    for(const auto& pair : conflicts.meeting_chords()) {
      const Chord &a = graph.chords()[pair.first], &b = graph.chords()[pair.second];
      if(give_up || (is_straight(a) && is_straight(b)))
        refuse(graph, a, b);
      for(const Chord* c : {&a, &b})
        if(!is_straight(*c))
          parts.insert(Part(c->piece, c->part));
    }
    for(const auto& pair : conflicts.enclosed_points()) {
      const Chord& c = graph.chords()[pair.first];
      if(give_up)
        throw Invalid_domain_exception(describe(m_pieces[c.piece]) + " touches a curve at "
                                       + describe(graph.points()[pair.second]));
      parts.insert(Part(c.piece, c.part));
    }
    return parts;
  }

  void bisect(const std::set<Part>& parts)
  {
    for(auto first = parts.begin(); first != parts.end(); ) {
      const std::size_t piece = first->first;
      std::vector<double>& t = m_parameters[piece];
      const std::size_t old_size = t.size();
      for(; first != parts.end() && first->first == piece; ++first)
        t.push_back(m_middle(piece, t[first->second], t[first->second + 1]));
      std::inplace_merge(t.begin(), t.begin() + old_size, t.end());
    }
  }

  [[noreturn]] void refuse(const Graph& graph, const Chord& a, const Chord& b) const
  {
    throw Invalid_domain_exception(describe(m_pieces[a.piece]) + " and " + describe(m_pieces[b.piece])
                                   + (a.piece == b.piece ? ", which are the same," : "")
                                   + " cross or overlap near " + meeting_point(graph, a, b));
  }

  // where the lines meet, or an end of a chord when they are parallel
  static std::string meeting_point(const Graph& graph, const Chord& a, const Chord& b)
  {
    const auto x = [](const auto& p) { return CGAL::to_double(p.x()); };
    const auto y = [](const auto& p) { return CGAL::to_double(p.y()); };
    const auto &p = graph.source(a), &q = graph.target(a), &r = graph.source(b), &s = graph.target(b);
    const double ux = x(q) - x(p), uy = y(q) - y(p), vx = x(s) - x(r), vy = y(s) - y(r);
    const double t = ((x(r) - x(p))*vy - (y(r) - y(p))*vx) / (ux*vy - uy*vx);
    return std::isfinite(t) && t >= 0 && t <= 1 ? describe(x(p) + t*ux, y(p) + t*uy) : describe(p);
  }

  const Pieces&  m_pieces;
  Parameters&    m_parameters;
  const Middle&  m_middle;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SEPARATOR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_GRAPH_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_GRAPH_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The points and chords of pieces that are cut at given parameters. Pieces
// that end at the same point share it; points inside pieces are their own.
template <class K>
class Chord_graph_2
{
public:
  typedef typename K::Point_2              Point_2;
  typedef std::vector<Domain_piece_2<K> >  Pieces;
  typedef std::vector<double>              Parameters; // ascending, from 0 to 1

  struct Chord
  {
    std::size_t source, target, piece;
    std::size_t part;           // it leads from parameter number `part` to the next
  };

  Chord_graph_2(const Pieces& pieces, const std::vector<Parameters>& parameters)
  {
    std::map<Point_2, std::size_t> ends;
    for(std::size_t i = 0; i < pieces.size(); ++i) {
      const Curve_piece_2<K>& curve = pieces[i].curve;
      std::size_t last = end_point(curve.source(), ends);
      const std::size_t target = end_point(curve.target(), ends);
      for(std::size_t k = 0; k + 1 < parameters[i].size(); ++k) {
        const bool at_end = k + 2 == parameters[i].size();
        const std::size_t next = at_end ? target : add(curve.point(parameters[i][k+1]));
        check_resolution(last, next);
        m_chords.push_back(Chord{last, next, i, k});
        last = next;
      }
    }
  }

  const std::vector<Point_2>& points() const { return m_points; }
  const std::vector<Chord>& chords() const { return m_chords; }
  const Point_2& source(const Chord& c) const { return m_points[c.source]; }
  const Point_2& target(const Chord& c) const { return m_points[c.target]; }

private:
  std::size_t add(const Point_2& p)
  {
    m_points.push_back(p);
    return m_points.size() - 1;
  }

  std::size_t end_point(const Point_2& p, std::map<Point_2, std::size_t>& ends)
  {
    const auto place = ends.emplace(p, m_points.size());
    if(place.second)
      m_points.push_back(p);
    return place.first->second;
  }

  void check_resolution(std::size_t p, std::size_t q) const
  {
    if(p != q && m_points[p] == m_points[q])
      throw Invalid_domain_exception("the coordinates cannot tell two consecutive points of a curve apart at "
                                     + describe(m_points[p]));
  }

  std::vector<Point_2> m_points;
  std::vector<Chord>   m_chords;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_GRAPH_2_H

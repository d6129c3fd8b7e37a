// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_MERGE_COINCIDING_PIECES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_MERGE_COINCIDING_PIECES_H

#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

template <class Point>
bool equal_up_to_rounding(const Point& p, const Point& q)
{
  const double px = CGAL::to_double(p.x()), py = CGAL::to_double(p.y());
  const double qx = CGAL::to_double(q.x()), qy = CGAL::to_double(q.y());
  const double size = (std::max)((std::max)(std::abs(px), std::abs(py)), (std::max)(std::abs(qx), std::abs(qy)));
  return (std::max)(std::abs(px - qx), std::abs(py - qy)) <= 1e-13 * size;
}

// returns whether two pieces with the same ends are the same, in either direction
template <class K>
bool coincide(const Curve_piece_2<K>& a, const Curve_piece_2<K>& b)
{
  if(a.is_straight() || b.is_straight())
    return a.is_straight() && b.is_straight();
  bool same = true, opposite = true;
  for(double t : {0.25, 0.4375, 0.75}) {
    same = same && equal_up_to_rounding(a.point(t), b.point(t));
    opposite = opposite && equal_up_to_rounding(a.point(t), b.point(1 - t));
  }
  return same || opposite;
}

// Leaves one of the pieces that lie in the same place. With the even-odd rule
// two boundary pieces cancel; otherwise boundary wins over inner curves, and
// a given inner curve over boundaries that cancel.
template <class K>
std::vector<Domain_piece_2<K> > merge_coinciding_pieces(const std::vector<Domain_piece_2<K> >& pieces,
                                                        Domain_rule rule)
{
  typedef typename K::Point_2                   Point_2;
  typedef std::pair<Point_2, Point_2>           Ends;
  std::vector<Domain_piece_2<K> > result;
  std::map<Ends, std::vector<std::size_t> > places; // in the result
  for(const Domain_piece_2<K>& piece : pieces) {
    const Point_2 &p = piece.curve.source(), &q = piece.curve.target();
    std::vector<std::size_t>& same_ends = places[p < q ? Ends(p, q) : Ends(q, p)];
    const auto twin = std::find_if(same_ends.begin(), same_ends.end(),
      [&](std::size_t i) { return coincide(result[i].curve, piece.curve); });
    if(twin == same_ends.end()) {
      same_ends.push_back(result.size());
      result.push_back(piece);
      continue;
    }
    Domain_piece_2<K>& kept = result[*twin];
    const bool is_boundary = piece.role == Piece_role::BOUNDARY;
    if(is_boundary && kept.role == Piece_role::BOUNDARY && rule == Domain_rule::EVEN_ODD)
      kept.role = Piece_role::UNDECIDED;
    else if(is_boundary || (piece.role == Piece_role::CONSTRAINT && kept.role != Piece_role::BOUNDARY))
      kept = piece;
  }
  return result;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_MERGE_COINCIDING_PIECES_H

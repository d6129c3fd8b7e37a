// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PREPARATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PREPARATION_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_sides_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Piece_splitter_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/curve_turning.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/merge_coinciding_pieces.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_separator.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Checks the pieces of a domain and makes of them pieces that meet in common
// end points only, of which BOUNDARY ones have the domain on their left side
// alone and CONSTRAINT ones on both.
//
// Throws Invalid_domain_exception for what does not bound a domain. Takes
// O(n log n) time for n segments whose bounding boxes hardly overlap.
template <class K>
class Domain_preparation
{
public:
  typedef typename K::Point_2                  Point_2;
  typedef Domain_piece_2<K>                    Piece;
  typedef std::vector<Piece>                   Pieces;

  Domain_preparation(const Pieces& pieces, Domain_rule rule, const std::vector<Point_2>& holes)
    : m_rule(rule)
  {
    check_lengths(pieces);
    m_pieces = merge_coinciding_pieces(Piece_splitter_2<K>(pieces).split_pieces(), rule);
    if(rule == Domain_rule::EVEN_ODD)
      check_loops();
    find_sides(holes);
    check_loops();
  }

  const Pieces& pieces() const { return m_pieces; }

  // a coarse triangulation of the domain
  const std::vector<Triangle_of_doubles>& triangles() const { return m_triangles; }

private:
  typedef Chord_graph_2<K>                     Graph;
  typedef typename Chord_sides_2<K>::Sides     Sides;
  static constexpr double flat_angle = 0.19634954084936207; // of pi/16
  static constexpr double too_large = 1e150; // squares are to be finite

  [[noreturn]] static void refuse(const std::string& what) { throw Invalid_domain_exception(what); }

  static void check_lengths(const Pieces& pieces)
  {
    if(std::none_of(pieces.begin(), pieces.end(),
                    [](const Piece& piece) { return is_meant_as_boundary(piece.role); }))
      refuse("the domain is empty: no curve bounds it");
    for(const Piece& piece : pieces)
      if(!(largest_coordinate(piece.curve.source()) < too_large
           && largest_coordinate(piece.curve.target()) < too_large))
        refuse(describe(piece) + " has a coordinate that is too large");
      else if(piece.curve.is_closed() && (piece.curve.is_straight() || piece.curve.point(0.3) == piece.curve.source()))
        refuse(describe(piece) + " has zero length; is a point given twice?");
  }

  static double largest_coordinate(const Point_2& p)
  {
    return (std::max)(std::abs(CGAL::to_double(p.x())), std::abs(CGAL::to_double(p.y())));
  }

  static bool is_any(Piece_role) { return true; }
  static bool is_boundary(Piece_role role) { return role == Piece_role::BOUNDARY; }
  static bool is_meant_as_boundary(Piece_role role) { return is_boundary(role) || role == Piece_role::OPEN_CHAIN; }

  // how many pieces whose role counts end at each point
  static std::map<Point_2, std::size_t> count_ends(const Pieces& pieces, bool (*counts)(Piece_role))
  {
    std::map<Point_2, std::size_t> ends;
    for(const Piece& piece : pieces)
      if(counts(piece.role)) {
        ++ends[piece.curve.source()];
        ++ends[piece.curve.target()];
      }
    return ends;
  }

  // at each point, no or two boundary pieces end
  void check_loops() const
  {
    const std::map<Point_2, std::size_t> ends = count_ends(m_pieces, is_boundary);
    for(const auto& end : ends)
      if(end.second == 1)
        refuse_open(end.first);
    for(const auto& end : ends)
      if(end.second > 2)
        refuse("the boundary touches itself at " + describe(end.first));
  }

  [[noreturn]] static void refuse_open(const Point_2& p) { refuse("the boundary is open at " + describe(p)); }

  void find_sides(const std::vector<Point_2>& holes)
  {
    std::vector<std::vector<double> > parameters;
    for(const Piece& piece : m_pieces)
      parameters.push_back(piece.curve.is_straight() ? std::vector<double>{0., 1.}
                                                     : parameters_of_flat_parts(piece.curve, flat_angle));
    const auto middle = [](std::size_t, double t0, double t1) { return (t0 + t1) / 2; };
    const Graph graph = Chord_separator<K>(m_pieces, parameters, middle)();
    const Chord_sides_2<K> chord_sides(graph, m_pieces, m_rule, holes);
    check_area(chord_sides.sides());
    m_triangles = chord_sides.inner_triangles();
    apply(graph, chord_sides.sides());
  }

  void check_area(const std::vector<Sides>& sides) const
  {
    if(std::any_of(sides.begin(), sides.end(), [](const Sides& s) { return s.left || s.right; }))
      return;
    for(const auto& end : count_ends(m_pieces, is_meant_as_boundary))
      if(end.second == 1)
        refuse_open(end.first);
    refuse("the domain encloses no area");
  }

  void apply(const Graph& graph, const std::vector<Sides>& sides)
  {
    Pieces kept, outside;
    for(std::size_t i = 0, j = 0; i < graph.chords().size(); i = j) {
      while(j < graph.chords().size() && graph.chords()[j].piece == graph.chords()[i].piece)
        ++j;
      const Piece& piece = m_pieces[graph.chords()[i].piece];
      for(std::size_t k = i; k < j; ++k)
        if(sides[k].left != sides[i].left || sides[k].right != sides[i].right)
          refuse(describe(piece) + " leaves the domain");
      add(piece, sides[i], kept, outside);
    }
    check_closed(outside);
    m_pieces.swap(kept);
  }

  void add(const Piece& piece, const Sides& side, Pieces& kept, Pieces& outside) const
  {
    if(side.left != side.right)
      kept.push_back(Piece{side.left ? piece.curve : piece.curve.reversed(), Piece_role::BOUNDARY, piece.number});
    else if(side.left)
      kept.push_back(Piece{piece.curve, Piece_role::CONSTRAINT, piece.number});
    else if(piece.role == Piece_role::CONSTRAINT)
      refuse(describe(piece) + " lies outside the domain");
    else if(piece.role != Piece_role::UNDECIDED)
      outside.push_back(piece);
  }

  // Pieces in a hole or beyond the boundary are harmless unless their chain is open.
  void check_closed(const Pieces& outside) const
  {
    const std::map<Point_2, std::size_t> ends = count_ends(m_pieces, is_any);
    for(const Piece& piece : outside)
      for(const Point_2* p : {&piece.curve.source(), &piece.curve.target()})
        if(ends.at(*p) == 1)
          refuse_open(*p);
    for(const Piece& piece : outside)
      if(piece.role == Piece_role::OPEN_CHAIN)
        refuse_open(piece.curve.source());
  }

  Domain_rule                      m_rule;
  Pieces                           m_pieces;
  std::vector<Triangle_of_doubles> m_triangles;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PREPARATION_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_PIECE_SPLITTER_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_PIECE_SPLITTER_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Box_tree.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/exact_predicates.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Splits pieces where ends of others lie on them, so that pieces touch in
// common end points only.
//
// An end lies on a segment if it does so exactly. Ends of inner curves alone
// are also taken to lie on a segment or curve that they miss by the rounding of
// the coordinates, since on oblique lines and on arcs no coordinates are exact.
// Boundary on boundary is refused.
template <class K>
class Piece_splitter_2
{
public:
  typedef typename K::Point_2                 Point_2;
  typedef Domain_piece_2<K>                   Piece;
  typedef std::vector<Piece>                  Pieces;

  explicit Piece_splitter_2(const Pieces& pieces) : m_pieces(pieces), m_cuts(pieces.size())
  {
    for(const Piece& piece : pieces)
      for(const Point_2* p : {&piece.curve.source(), &piece.curve.target()})
        m_boundary_ends[*p] += piece.role == Piece_role::BOUNDARY;
    find_cuts();
  }

  Pieces split_pieces() const
  {
    Pieces result;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      split(m_pieces[i], m_cuts[i], result);
    return result;
  }

private:
  typedef Exact_predicates_kernel_of<K>     Exact;
  typedef std::map<Point_2, std::size_t>    Ends;
  typedef std::pair<double, Point_2>        Cut; // parameter, point
  static constexpr int samples = 64;
  static constexpr double rounding = 1.4210854715202004e-14; // 2^-46, of the coordinates

  static double x(const Point_2& p) { return CGAL::to_double(p.x()); }
  static double y(const Point_2& p) { return CGAL::to_double(p.y()); }
  static double distance(const Point_2& p, const Point_2& q) { return std::hypot(x(p) - x(q), y(p) - y(q)); }

  static Bbox_2 sampled_box(const Curve_piece_2<K>& curve)
  {
    Bbox_2 box = curve.source().bbox() + curve.target().bbox();
    for(int i = 1; i < samples && !curve.is_straight(); ++i)
      box += curve.point(double(i) / samples).bbox();
    return box;
  }

  // the rounding of the largest coordinate
  static double tolerance(const Bbox_2& b)
  {
    return rounding * (std::max)((std::max)(std::abs(b.xmin()), std::abs(b.xmax())),
                                 (std::max)(std::abs(b.ymin()), std::abs(b.ymax())));
  }

  void find_cuts()
  {
    std::vector<const typename Ends::value_type*> ends;
    std::vector<Bbox_2> boxes;
    for(const auto& end : m_boundary_ends) {
      ends.push_back(&end);
      boxes.push_back(end.first.bbox());
    }
    const Box_tree tree(boxes, 1);
    std::vector<std::size_t> found;
    for(std::size_t i = 0; i < m_pieces.size(); ++i) {
      const Curve_piece_2<K>& curve = m_pieces[i].curve;
      const Bbox_2 box = sampled_box(curve);
      const double allowed = tolerance(box), size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
      tree.find_overlapping(enlarged(box, 2 * (allowed + (curve.is_straight() ? 0 : size / samples))), found);
      for(std::size_t k : found)
        consider(i, ends[k]->first, ends[k]->second > 0, allowed);
    }
  }

  void consider(std::size_t i, const Point_2& p, bool on_boundary, double allowed)
  {
    const Curve_piece_2<K>& curve = m_pieces[i].curve;
    if(p == curve.source() || p == curve.target())
      return;
    if(curve.is_straight() && lies_exactly_on(curve, p)) {
      if(on_boundary && m_pieces[i].role == Piece_role::BOUNDARY)
        throw Invalid_domain_exception("the boundary touches itself at " + describe(p) + ", on "
                                       + describe(m_pieces[i]));
      m_cuts[i].push_back(Cut(projection(curve, p), p));
    } else if(!on_boundary) {
      const double t = curve.is_straight() ? projection(curve, p) : nearest_parameter(curve, p);
      if(distance(curve.point(t), p) <= allowed && distance(curve.source(), p) > allowed
         && distance(curve.target(), p) > allowed)
        m_cuts[i].push_back(Cut(t, p));
    }
  }

  static bool lies_exactly_on(const Curve_piece_2<K>& segment, const Point_2& p)
  {
    const auto a = exact_point<K>(segment.source()), b = exact_point<K>(segment.target()), q = exact_point<K>(p);
    const Exact kernel = Exact();
    return kernel.collinear_2_object()(a, b, q)
        && kernel.collinear_are_strictly_ordered_along_line_2_object()(a, q, b);
  }

  static double projection(const Curve_piece_2<K>& segment, const Point_2& p)
  {
    const double ux = x(segment.target()) - x(segment.source()), uy = y(segment.target()) - y(segment.source());
    const double vx = x(p) - x(segment.source()), vy = y(p) - y(segment.source());
    const double scale = (std::max)(std::abs(ux), std::abs(uy));
    const double t = (ux/scale * (vx/scale) + uy/scale * (vy/scale)) / (ux/scale * (ux/scale) + uy/scale * (uy/scale));
    return (std::min)(1., (std::max)(0., t));
  }

  // the best of the samples, then golden section between its neighbors; both ends of a closed curve are as good
  static double nearest_parameter(const Curve_piece_2<K>& curve, const Point_2& p)
  {
    int best = 0;
    for(int i = 1; i <= samples; ++i)
      if(distance(curve.point(double(i) / samples), p) < distance(curve.point(double(best) / samples), p))
        best = i;
    if(best == 0 && curve.is_closed()
       && distance(curve.point(1 - 1. / samples), p) < distance(curve.point(1. / samples), p))
      best = samples;
    double low = (std::max)(0, best - 1) / double(samples), high = (std::min)(samples, best + 1) / double(samples);
    const double golden = 0.6180339887498949;
    double a = high - golden*(high - low), b = low + golden*(high - low);
    double at_a = distance(curve.point(a), p), at_b = distance(curve.point(b), p);
    for(int i = 0; i < 90; ++i) {
      if(at_a < at_b) {
        high = b; b = a; at_b = at_a;
        a = high - golden*(high - low);
        at_a = distance(curve.point(a), p);
      } else {
        low = a; a = b; at_a = at_b;
        b = low + golden*(high - low);
        at_b = distance(curve.point(b), p);
      }
    }
    return (low + high) / 2;
  }

  static void split(const Piece& piece, std::vector<Cut> cuts, Pieces& result)
  {
    std::sort(cuts.begin(), cuts.end());
    cuts.push_back(Cut(1, piece.curve.target()));
    Cut last(0, piece.curve.source());
    for(const Cut& cut : cuts) {
      result.push_back(Piece{piece.curve.part(last.first, cut.first, last.second, cut.second),
                             piece.role, piece.number});
      last = cut;
    }
  }

  const Pieces&                  m_pieces;
  Ends                           m_boundary_ends; // how many pieces of the boundary end at each end point
  std::vector<std::vector<Cut> > m_cuts;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_PIECE_SPLITTER_2_H

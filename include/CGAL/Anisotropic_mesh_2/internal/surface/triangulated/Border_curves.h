// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_BORDER_CURVES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_BORDER_CURVES_H

#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Parametrized_disc.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The border of a disc as curves in the plane of parameters, from corner to corner.
template <class K>
class Border_curves
{
  typedef Parametrized_disc<K>      Disc;
  typedef Curve_piece_2<K>          Piece;
  typedef typename K::Point_2       Point_2;

public:
  Border_curves(std::shared_ptr<const Disc> disc, double corner_angle)
    : m_disc(std::move(disc)), m_corner_angle(corner_angle)
  {}

  // the curves, in a loop
  std::vector<Piece> operator()() const
  {
    const std::size_t n = m_disc->border.size();
    std::vector<std::size_t> corners;
    for(std::size_t i = 0; i < n; ++i)
      if(is_corner(i))
        corners.push_back(i);
    if(corners.empty())
      corners.push_back(0);
    std::vector<Piece> pieces;
    for(std::size_t c = 0; c < corners.size(); ++c)
      pieces.push_back(piece(corners[c], c + 1 < corners.size() ? corners[c + 1] : corners[0] + n));
    return pieces;
  }

private:
  // the turn in the plane that a curve keeps within a piece
  static constexpr double largest_turn = 0.2;

  std::size_t vertex(std::size_t i) const { return m_disc->border[i % m_disc->border.size()]; }

  bool is_corner(std::size_t i) const
  {
    const std::size_t before = i + m_disc->border.size() - 1;
    return turn(m_disc->points, before) > m_corner_angle
        || turn(m_disc->places, before) > (std::min)(largest_turn, m_corner_angle);
  }

  // the angle between the edge after the i-th vertex and the one after that
  template <class Point>
  double turn(const std::vector<Point>& points, std::size_t i) const
  {
    const auto u = points[vertex(i + 1)] - points[vertex(i)], v = points[vertex(i + 2)] - points[vertex(i + 1)];
    const double uu = CGAL::to_double(u * u), vv = CGAL::to_double(v * v);
    return std::acos(std::clamp(CGAL::to_double(u * v) / std::sqrt(uu * vv), -1., 1.));
  }

  Piece piece(std::size_t i, std::size_t j) const
  {
    if(j == i + 1)
      return Piece::segment(m_disc->places[vertex(i)], m_disc->places[vertex(j)]);
    const Border_curves self = *this;
    return Piece::parametrized([self](double t) { return self.point(t); }, double(i), double(j));
  }

  // the point with the parameter `t`, which is `i` at the i-th vertex
  Point_2 point(double t) const
  {
    const std::size_t i = std::size_t(t);
    const Point_2 &p = m_disc->places[vertex(i)], &q = m_disc->places[vertex(i + 1)];
    return p + typename K::FT(t - double(i)) * (q - p);
  }

  std::shared_ptr<const Disc> m_disc;
  double                      m_corner_angle;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_BORDER_CURVES_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_APPROXIMATION_ERROR_INTEGRAL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_APPROXIMATION_ERROR_INTEGRAL_H

#include <CGAL/Anisotropic_mesh_2/Approximation_error.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The difference between a function and one that is linear on each of some triangles.
template <class Point, class F>
class Approximation_error_integral
{
public:
  // `f` must live as long as this
  Approximation_error_integral(const F& f, double relative_tolerance) : m_f(f), m_tolerance(relative_tolerance) {}

  double value_at(const Point& p) const { return CGAL::to_double(m_f(p)); }

  // adds a triangle on which the function is replaced by the linear one with
  // the given values at the corners
  void add(const std::array<Point, 3>& corner, const std::array<double, 3>& value)
  {
    const auto vector = [](const Point& p, const Point& q)
                        { return Vector_of_doubles{CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y())}; };
    m_pieces.push_back({to_doubles(corner[0]), vector(corner[0], corner[1]), vector(corner[0], corner[2]), value});
  }

  Approximation_error operator()() const
  {
    Approximation_error error;
    const double negligible = negligible_density(error.largest);
    double squares = 0;
    for(const Piece& piece : m_pieces)
      squares += piece.doubled_area() * integral(piece, error.largest, negligible)(reference);
    error.l2 = std::sqrt(squares);
    return error;
  }

private:
  // The triangle as an image of the one with the corners (0, 0), (1, 0), (0, 1),
  // on which linear functions need no division by its area.
  struct Piece
  {
    Vector_of_doubles     origin, u, v;
    std::array<double, 3> value;

    double doubled_area() const { return u.x * v.y - u.y * v.x; }

    Point point(double s, double t) const
    {
      return point_at<Point>(origin.x + s * u.x + t * v.x, origin.y + s * u.y + t * v.y);
    }

    double approximation(double s, double t) const
    {
      return value[0] + s * (value[1] - value[0]) + t * (value[2] - value[0]);
    }
  };

  struct Squared_difference
  {
    const Approximation_error_integral& approximation;
    const Piece& piece;
    double& largest; // of all samples

    double operator()(double s, double t) const
    {
      const double d = std::abs(approximation.value_at(piece.point(s, t)) - piece.approximation(s, t));
      largest = (std::max)(largest, d);
      return d * d;
    }
  };

  typedef Adaptive_triangle_integral<Squared_difference> Integral;

  // A function with a jump inside the triangle is followed to a thousandth of its size.
  Integral integral(const Piece& piece, double& largest, double negligible = 0) const
  {
    return Integral(Squared_difference{*this, piece, largest}, m_tolerance, 10000, 10, negligible);
  }

  // Squares that are rounding, or that do not count beside those elsewhere. The
  // corners and the middles of the edges are sampled on the way.
  double negligible_density(double& largest) const
  {
    double doubled_area = 0, squares = 0, magnitude = 0;
    for(const Piece& piece : m_pieces) {
      const Integral of_piece = integral(piece, largest);
      doubled_area += piece.doubled_area();
      squares += 2 * piece.doubled_area() * of_piece.rule(reference);
      for(const Vector_of_doubles& p : {reference[0], reference[1], reference[2], Vector_of_doubles{0.5, 0},
                                        Vector_of_doubles{0, 0.5}, Vector_of_doubles{0.5, 0.5}})
        Squared_difference{*this, piece, largest}(p.x, p.y);
      for(double value : piece.value)
        magnitude = (std::max)(magnitude, std::abs(value));
    }
    const double rounding = 1e-15 * magnitude;
    return (doubled_area > 0 ? m_tolerance * squares / doubled_area : 0) + rounding * rounding;
  }

  static constexpr typename Integral::Triangle reference = {{{0, 0}, {1, 0}, {0, 1}}};

  const F&           m_f;
  double             m_tolerance;
  std::vector<Piece> m_pieces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_APPROXIMATION_ERROR_INTEGRAL_H

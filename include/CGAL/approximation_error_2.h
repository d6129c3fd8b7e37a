// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATION_ERROR_2_H
#define CGAL_APPROXIMATION_ERROR_2_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how far an approximation is from a function, in units of its values (section 2.6 of \cgalCite{dw-acvt-05}).
///
/// \sa `CGAL::piecewise_constant_approximation_error_2()`
/// \sa `CGAL::piecewise_linear_approximation_error_2()`
struct Approximation_error
{
  double l2 = 0;      ///< the root of the integral of the squared difference; in units of the values times a length
  double largest = 0; ///< the largest absolute difference at the points where the function was sampled
};

namespace internal {

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

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures how well a function is approximated by the one that has on each
/// region of a tessellation the value at its generator (section 2.6 of
/// \cgalCite{dw-acvt-05}).
///
/// The squared difference is integrated over the tiles of each region by a rule
/// of degree 5 that is quartered, up to ten times, until the parts agree with the
/// whole. Where the function is a polynomial of degree two the result is exact up to rounding.
/// There are at least 48 samples in a tile; what is much thinner than a tenth of it may stay unseen. The
/// time is linear in the number of tiles.
///
/// \tparam Diagram a class with a member function `std::size_t number_of_regions() const`
/// and a member function `region(std::size_t) const` whose result has the members `generator`, a
/// point, and `tiles`, a range of `std::array`s of the three corners of
/// triangles, counterclockwise, that together are the region
/// \tparam F a functor from points to a number
/// \param diagram the tessellation.
/// \param f the function, defined on the domain.
/// \param relative_tolerance the accuracy to which the integral of the squared
/// difference is wanted, relative to it.
/// \return the error.
/// \pre `relative_tolerance > 0`
/// \sa `Gradient_metric_field_2`
template <class Diagram, class F>
Anisotropic_mesh_2::Approximation_error
piecewise_constant_approximation_error_2(const Diagram& diagram, const F& f, double relative_tolerance = 1e-5)
{
  typedef std::decay_t<decltype(diagram.region(0).generator)> Point;
  CGAL_precondition(relative_tolerance > 0);
  Anisotropic_mesh_2::internal::Approximation_error_integral<Point, F> integral(f, relative_tolerance);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& region = diagram.region(i);
    const double value = integral.value_at(region.generator);
    for(const auto& tile : region.tiles)
      integral.add(tile, {value, value, value});
  }
  return integral();
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures how well a function is approximated by the continuous function that
/// has the same values at the vertices of a mesh and is linear on its faces (compare section 2.6 of
/// \cgalCite{dw-acvt-05}).
///
/// The squared difference is integrated over each face of the domain by a rule of
/// degree 5 that is quartered, up to ten times, until the parts agree with the
/// whole. Where the function is a polynomial of degree two the result is exact up to rounding.
/// There are at least 48 samples in a face; what is much thinner than a tenth of it may stay unseen. The
/// time is linear in the number of faces.
///
/// \tparam Mesh a triangulation whose faces have a member `bool is_in_domain() const`,
/// for example an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam F a functor from `Mesh::Point` to a number
/// \param mesh the mesh, with its domain marked.
/// \param f the function, defined on the domain.
/// \param relative_tolerance the accuracy to which the integral of the squared
/// difference is wanted, relative to it.
/// \return the error.
/// \pre `relative_tolerance > 0`
/// \sa `Hessian_metric_field_2`
template <class Mesh, class F>
Anisotropic_mesh_2::Approximation_error
piecewise_linear_approximation_error_2(const Mesh& mesh, const F& f, double relative_tolerance = 1e-5)
{
  typedef typename Mesh::Point Point;
  CGAL_precondition(relative_tolerance > 0);
  Anisotropic_mesh_2::internal::Approximation_error_integral<Point, F> integral(f, relative_tolerance);
  for(auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face) {
    if(!face->is_in_domain())
      continue;
    const std::array<Point, 3> corners = {face->vertex(0)->point(), face->vertex(1)->point(),
                                          face->vertex(2)->point()};
    integral.add(corners, {integral.value_at(corners[0]), integral.value_at(corners[1]),
                           integral.value_at(corners[2])});
  }
  return integral();
}

} // namespace CGAL

#endif // CGAL_APPROXIMATION_ERROR_2_H

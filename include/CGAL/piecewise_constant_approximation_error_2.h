// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PIECEWISE_CONSTANT_APPROXIMATION_ERROR_2_H
#define CGAL_PIECEWISE_CONSTANT_APPROXIMATION_ERROR_2_H

#include <CGAL/Anisotropic_mesh_2/Approximation_error.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Approximation_error_integral.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

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

} // namespace CGAL

#endif // CGAL_PIECEWISE_CONSTANT_APPROXIMATION_ERROR_2_H

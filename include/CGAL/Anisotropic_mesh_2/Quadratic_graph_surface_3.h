// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_QUADRATIC_GRAPH_SURFACE_3_H
#define CGAL_ANISOTROPIC_MESH_2_QUADRATIC_GRAPH_SURFACE_3_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the graph \f$ \sigma(u, v) = (u, v, a u^2 + b v^2) \f$: a paraboloid if `a` and
/// `b` have the same sign, a saddle if not (figures 5.5 and 5.7 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a model of `Kernel`
/// \cgalModels{ParametricSurface_3}
template <class K>
class Quadratic_graph_surface_3
{
public:
  typedef K                      Kernel;   ///< the kernel
  typedef typename K::FT         FT;       ///< its number type
  typedef typename K::Point_2    Point_2;  ///< a point of the parameters
  typedef typename K::Point_3    Point_3;  ///< a point of space
  typedef typename K::Vector_3   Vector_3; ///< a vector of space

  /// the graph with the coefficients `a` and `b` over a rectangle.
  /// \pre `parameters.is_valid()`, and `parameters` is not periodic, and so has no poles.
  Quadratic_graph_surface_3(double a, double b, const Anisotropic_mesh_2::Parameter_rectangle& parameters)
    : m_a(a), m_b(b), m_parameters(parameters)
  {
    CGAL_precondition(parameters.is_valid() && !parameters.is_periodic());
  }

  /// the rectangle of parameters.
  Anisotropic_mesh_2::Parameter_rectangle parameters() const { return m_parameters; }

  /// the point with the parameters `uv`.
  Point_3 point(const Point_2& uv) const
  {
    return Point_3(uv.x(), uv.y(), m_a * uv.x() * uv.x() + m_b * uv.y() * uv.y());
  }

  /// the derivatives by u and by v.
  std::array<Vector_3, 2> first_derivatives(const Point_2& uv) const
  {
    return {Vector_3(FT(1), FT(0), 2 * m_a * uv.x()), Vector_3(FT(0), FT(1), 2 * m_b * uv.y())};
  }

  /// the derivatives twice by u, by u and v, and twice by v.
  std::array<Vector_3, 3> second_derivatives(const Point_2&) const
  {
    return {Vector_3(FT(0), FT(0), 2 * m_a), Vector_3(FT(0), FT(0), FT(0)), Vector_3(FT(0), FT(0), 2 * m_b)};
  }

private:
  FT                                      m_a, m_b;
  Anisotropic_mesh_2::Parameter_rectangle m_parameters;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_QUADRATIC_GRAPH_SURFACE_3_H

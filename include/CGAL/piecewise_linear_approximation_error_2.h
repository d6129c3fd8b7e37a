// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PIECEWISE_LINEAR_APPROXIMATION_ERROR_2_H
#define CGAL_PIECEWISE_LINEAR_APPROXIMATION_ERROR_2_H

#include <CGAL/Anisotropic_mesh_2/Approximation_error.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Approximation_error_integral.h>

#include <CGAL/assertions.h>

#include <array>

namespace CGAL {

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

#endif // CGAL_PIECEWISE_LINEAR_APPROXIMATION_ERROR_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_EXCEPTIONS_H
#define CGAL_ANISOTROPIC_MESH_2_EXCEPTIONS_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// the base of all exceptions of this package. What a metric field, a surface or a visitor throws passes through.
///
/// After a throw, arguments that a function takes by constant reference are as before, and what it would return does
/// not exist. A mesh that it changes is valid, and has the vertices and the domain that it had up to the failure;
/// functions that promise more or less say so. In any case it may be assigned to, cleared and destroyed.
class Anisotropic_mesh_exception
  : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when the curves given for a domain do not bound one: they are open,
/// cross or touch each other, are not finite, or enclose nothing.
///
/// The message names what is wrong and the coordinates where.
class Invalid_domain_exception
  : public Anisotropic_mesh_exception
{
public:
  using Anisotropic_mesh_exception::Anisotropic_mesh_exception;
};

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a triangle mesh that is given as a background or as a surface, or the values at its vertices, cannot be
/// used.
///
/// The message names what is wrong and the number of the face, if one is concerned.
class Invalid_triangle_mesh_exception
  : public Anisotropic_mesh_exception
{
public:
  using Anisotropic_mesh_exception::Anisotropic_mesh_exception;
};

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a metric tensor is not finite or not positive definite.
///
/// The message names the entries (or the sizes and the angle) and, as soon as
/// the tensor was asked for at a point, the point.
class Invalid_metric_tensor_exception
  : public Anisotropic_mesh_exception
{
public:
  using Anisotropic_mesh_exception::Anisotropic_mesh_exception;

  /// returns the same complaint, telling that it arose at `(x, y)`.
  Invalid_metric_tensor_exception at(double x, double y) const
  {
    return Invalid_metric_tensor_exception(what() + (" at the point " + internal::describe(x, y)));
  }
};

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a parametric surface has no finite point or no tangent plane somewhere.
///
/// The message says what is wrong and names the parameters u and v.
class Degenerate_parametrization_exception
  : public Invalid_metric_tensor_exception
{
public:
  /// the complaint `what` about the surface at the parameters `(u, v)`.
  Degenerate_parametrization_exception(const std::string& what, double u, double v)
    : Invalid_metric_tensor_exception(what + " at the point " + internal::describe(u, v) + " of the parameters (u, v)")
  {}
};

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a metric asks for more vertices than a given limit; if it asks for many more, before the
/// memory for them is taken.
///
/// The message names the number of vertices that the metric asks for, and the limit.
class Too_many_vertices_exception
  : public Anisotropic_mesh_exception
{
public:
  /// \param wanted how many vertices the metric asks for, at least
  /// \param limit how many are allowed
  /// \param where what asks for them, as "the boundary"; may be empty
  Too_many_vertices_exception(double wanted, std::size_t limit, const std::string& where = std::string())
    : Anisotropic_mesh_exception(message(wanted, limit, where)), m_wanted(wanted), m_limit(limit)
  {}

  /// the number of vertices that the metric asks for, at least.
  double wanted() const { return m_wanted; }

  /// the number of vertices that was allowed.
  std::size_t limit() const { return m_limit; }

private:
  static std::string message(double wanted, std::size_t limit, const std::string& where)
  {
    std::ostringstream os;
    os << "the metric asks for about " << wanted << " vertices";
    if(!where.empty())
      os << " on " << where;
    os << ", more than the limit of " << limit;
    return os.str();
  }

  double      m_wanted;
  std::size_t m_limit;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_EXCEPTIONS_H

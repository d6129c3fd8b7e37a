// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_TOO_MANY_VERTICES_EXCEPTION_H
#define CGAL_ANISOTROPIC_MESH_2_TOO_MANY_VERTICES_EXCEPTION_H

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a metric asks for more vertices than a given limit; if it asks for many more, before the
/// memory for them is taken.
///
/// The message names the number of vertices that the metric asks for, and the limit.
class Too_many_vertices_exception
  : public std::runtime_error
{
public:
  /// \param wanted how many vertices the metric asks for, at least
  /// \param limit how many are allowed
  /// \param where what asks for them, as "the boundary"; may be empty
  Too_many_vertices_exception(double wanted, std::size_t limit, const std::string& where = std::string())
    : std::runtime_error(message(wanted, limit, where))
    , m_wanted(wanted)
    , m_limit(limit)
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

#endif // CGAL_ANISOTROPIC_MESH_2_TOO_MANY_VERTICES_EXCEPTION_H

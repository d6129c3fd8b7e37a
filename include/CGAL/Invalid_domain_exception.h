// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_INVALID_DOMAIN_EXCEPTION_H
#define CGAL_INVALID_DOMAIN_EXCEPTION_H

#include <stdexcept>
#include <string>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when the curves given for a domain do not bound one: they are open,
/// cross or touch each other, are not finite, or enclose nothing.
///
/// The message names what is wrong and the coordinates where.
class Invalid_domain_exception
  : public std::runtime_error
{
public:
  /// the complaint `what`.
  explicit Invalid_domain_exception(const std::string& what)
    : std::runtime_error(what)
  {}
};

} // namespace CGAL

#endif // CGAL_INVALID_DOMAIN_EXCEPTION_H

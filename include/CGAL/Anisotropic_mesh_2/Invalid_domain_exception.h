// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INVALID_DOMAIN_EXCEPTION_H
#define CGAL_ANISOTROPIC_MESH_2_INVALID_DOMAIN_EXCEPTION_H

#include <stdexcept>
#include <string>

namespace CGAL::Anisotropic_mesh_2 {

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

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_INVALID_DOMAIN_EXCEPTION_H

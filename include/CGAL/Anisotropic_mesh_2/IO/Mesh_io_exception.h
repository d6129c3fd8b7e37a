// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_MESH_IO_EXCEPTION_H
#define CGAL_ANISOTROPIC_MESH_2_IO_MESH_IO_EXCEPTION_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Exceptions
///
/// thrown when a file cannot be read or written.
///
/// The message has the form `FILE:LINE: what is wrong`, without `LINE:` where
/// no line is concerned.
class Mesh_io_exception
  : public Anisotropic_mesh_2::Anisotropic_mesh_exception
{
public:
  /// the file as a whole is at fault.
  Mesh_io_exception(const std::string& file, const std::string& what)
    : Anisotropic_mesh_exception(file + ": " + what), m_file(file)
  {}

  /// the line (counted from 1) of the file is at fault.
  Mesh_io_exception(const std::string& file, std::size_t line, const std::string& what)
    : Anisotropic_mesh_exception(file + ':' + std::to_string(line) + ": " + what), m_file(file), m_line(line)
  {}

  /// the name of the file.
  const std::string& file() const { return m_file; }

  /// the line, or 0 if no line is concerned.
  std::size_t line() const { return m_line; }

private:
  std::string m_file;
  std::size_t m_line = 0;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_IO_MESH_IO_EXCEPTION_H

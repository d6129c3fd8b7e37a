// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_VTU_H
#define CGAL_ANISOTROPIC_MESH_2_IO_VTU_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Vtu_view.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/Safe_output_file.h>

#include <CGAL/IO/io.h>
#include <CGAL/IO/write_VTU.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// writes the domain of a triangulation in the format of VTK (`.vtu`), with
/// `z = 0`: its faces, counterclockwise, and as line cells the edges that are
/// constrained or bound the domain. Other than `CGAL::IO::write_VTU()`, which does the writing,
/// it leaves out what lies outside of the domain.
///
/// \tparam Tr a constrained triangulation of \cgal whose faces have a member
/// `bool is_in_domain() const`
/// \param os the stream
/// \param tr the triangulation
/// \param mode whether numbers are written in binary form or as text, `BINARY` or `ASCII`
template <class Tr>
void write_vtu(std::ostream& os, const Tr& tr, Mode mode = BINARY)
{
  const auto no_reference = [](const typename Tr::Edge&) { return 0; };
  const Anisotropic_mesh_2::internal::Vtu_view view(
    Anisotropic_mesh_2::internal::domain_graph(tr, no_reference));
  const std::streamsize precision = os.precision(17);
  CGAL::IO::write_VTU(os, view, mode);
  os.precision(precision);
}

/// writes the domain to a file, which appears under its name only when it is complete.
/// \tparam Tr as for the function that writes to a stream
/// \param file the name of the file
/// \param tr the triangulation
/// \param mode as there
/// \throw Mesh_io_exception if the file cannot be written.
template <class Tr>
void write_vtu(const std::string& file, const Tr& tr, Mode mode = BINARY)
{
  Anisotropic_mesh_2::internal::write_safely(
    file, [&](std::ostream& os) { CGAL::IO::write_vtu(os, tr, mode); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_VTU_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_OFF_H
#define CGAL_ANISOTROPIC_MESH_2_IO_OFF_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/Safe_output_file.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// writes the faces of the domain of a triangulation in the Object File Format
/// (`.off`), with `z = 0` and all digits.
///
/// \tparam Tr a triangulation of \cgal whose faces have a member
/// `bool is_in_domain() const`
/// \param os the stream
/// \param tr the triangulation
template <class Tr>
void write_OFF(std::ostream& os, const Tr& tr)
{
  const auto no_reference = [](const typename Tr::Edge&) { return 0; };
  const Anisotropic_mesh_2::internal::Domain_graph graph
    = Anisotropic_mesh_2::internal::domain_graph(tr, no_reference);
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "OFF\n" << graph.points.size() << ' ' << graph.triangles.size() << " 0\n\n";
  for(const auto& p : graph.points)
    out << p.x() << ' ' << p.y() << " 0\n";
  for(const auto& t : graph.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

/// writes the faces of the domain to a file, which appears under its name only when it is complete.
/// \tparam Tr as for the function that writes to a stream
/// \param file the name of the file
/// \param tr the triangulation
/// \throw Mesh_io_exception if the file cannot be written.
template <class Tr>
void write_OFF(const std::string& file, const Tr& tr)
{
  Anisotropic_mesh_2::internal::write_safely(file, [&](std::ostream& os) { write_OFF(os, tr); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_OFF_H

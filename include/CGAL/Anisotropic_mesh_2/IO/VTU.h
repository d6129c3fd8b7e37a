// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_VTU_H
#define CGAL_ANISOTROPIC_MESH_2_IO_VTU_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Vtu_writer.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/write_file.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>

#include <CGAL/IO/io.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// writes the domain of a triangulation in the format of VTK (`.vtu`), with
/// `z = 0`: its faces, counterclockwise, and as line cells the edges that are
/// constrained or bound the domain. Unlike the function of \cgal's package Mesh_2,
/// before which it is chosen, it leaves out vertices and edges outside of the domain.
///
/// \tparam Tr,Parameters an instance of the class template of a constrained triangulation of \cgal
/// whose faces have a member `bool is_in_domain() const`
/// \param os the stream, whose state shows whether everything was written
/// \param tr the triangulation
/// \param mode whether numbers are written in binary form or as text, `BINARY` or `ASCII`
template <template <class...> class Tr, class... Parameters,
          class = Anisotropic_mesh_2::internal::If_marked<Tr<Parameters...>>>
void write_VTU(std::ostream& os, const Tr<Parameters...>& tr, Mode mode = BINARY)
{
  namespace internal = Anisotropic_mesh_2::internal;
  internal::Vtu_writer(os, mode == BINARY).write(internal::domain_graph(tr));
}

/// writes the domain to a file as the function that writes to a stream does.
/// \tparam Tr,Parameters as there
/// \param file the name of the file
/// \param tr the triangulation
/// \param mode as there
/// \throw Mesh_io_exception if the file cannot be written.
template <template <class...> class Tr, class... Parameters,
          class = Anisotropic_mesh_2::internal::If_marked<Tr<Parameters...>>>
void write_VTU(const std::string& file, const Tr<Parameters...>& tr, Mode mode = BINARY)
{
  Anisotropic_mesh_2::internal::write_file(file, [&](std::ostream& os) { CGAL::IO::write_VTU(os, tr, mode); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_VTU_H

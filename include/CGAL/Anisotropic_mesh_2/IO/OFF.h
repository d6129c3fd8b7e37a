// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_OFF_H
#define CGAL_ANISOTROPIC_MESH_2_IO_OFF_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/Triangle_soup.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/write_file.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// writes the faces of the domain of a triangulation, with `z = 0`, or a mesh of a surface in the
/// Object File Format (`.off`), with all digits.
///
/// \tparam Mesh,Parameters an instance of `Anisotropic_surface_mesh_3`, or of the class template of a
/// triangulation of \cgal whose faces have a member `bool is_in_domain() const`
/// \param os the stream, whose state shows whether everything was written
/// \param mesh the triangulation or the mesh
template <template <class...> class Mesh, class... Parameters,
          class = Anisotropic_mesh_2::internal::If_soup<Mesh<Parameters...>>>
void write_OFF(std::ostream& os, const Mesh<Parameters...>& mesh)
{
  const Anisotropic_mesh_2::internal::Triangle_soup soup = Anisotropic_mesh_2::internal::triangle_soup(mesh);
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "OFF\n" << soup.points.size() << ' ' << soup.triangles.size() << " 0\n\n";
  write_elements(out, soup);
  out.flush();
}

/// writes a mesh to a file as the function that writes to a stream does.
/// \tparam Mesh,Parameters as there
/// \param file the name of the file
/// \param mesh the triangulation or the mesh
/// \throw Mesh_io_exception if the file cannot be written.
template <template <class...> class Mesh, class... Parameters,
          class = Anisotropic_mesh_2::internal::If_soup<Mesh<Parameters...>>>
void write_OFF(const std::string& file, const Mesh<Parameters...>& mesh)
{
  Anisotropic_mesh_2::internal::write_file(file, [&](std::ostream& os) { CGAL::IO::write_OFF(os, mesh); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_OFF_H

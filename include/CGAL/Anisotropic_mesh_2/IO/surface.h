// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_SURFACE_H
#define CGAL_ANISOTROPIC_MESH_2_IO_SURFACE_H

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/Safe_output_file.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_surface.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>
#include <CGAL/Anisotropic_mesh_2/Surface_voronoi_region_3.h>
#include <CGAL/Anisotropic_mesh_2/View_direction_3.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {

namespace Anisotropic_mesh_2 {
namespace internal {

template <class Field>
void write_points(Text_writer& out, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const auto p = mesh.point(v);
    out << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z()) << '\n';
  }
}

template <class Field>
void write_faces(Text_writer& out, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  for(const auto& f : mesh.faces())
    out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
}

} // namespace internal
} // namespace Anisotropic_mesh_2

namespace IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// writes a mesh of a surface in the Object File Format (`.off`), with all digits.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param os the stream
/// \param mesh the mesh
template <class Field>
void write_OFF(std::ostream& os, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "OFF\n" << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n\n";
  Anisotropic_mesh_2::internal::write_points(out, mesh);
  Anisotropic_mesh_2::internal::write_faces(out, mesh);
}

/// writes a mesh of a surface in the Polygon File Format (`.ply`), as text with all digits.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param os the stream
/// \param mesh the mesh
template <class Field>
void write_PLY(std::ostream& os, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.number_of_faces()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  Anisotropic_mesh_2::internal::write_points(out, mesh);
  Anisotropic_mesh_2::internal::write_faces(out, mesh);
}

/// draws a mesh of a surface, shaded and with hidden faces behind the others, as a
/// Scalable Vector Graphics file, 800 pixels wide.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param os the stream
/// \param mesh the mesh
/// \param title what the line of text below the picture begins with; may be empty
/// \param view from where the surface is seen
template <class Field>
void write_SVG(std::ostream& os, const Anisotropic_surface_mesh_3<Field>& mesh,
               const std::string& title = std::string(),
               const Anisotropic_mesh_2::View_direction_3& view = Anisotropic_mesh_2::View_direction_3())
{
  namespace internal = Anisotropic_mesh_2::internal;
  internal::Svg_surface picture(view, mesh.is_closed());
  for(const auto& f : mesh.faces())
    picture.add_polygon(std::array<typename Field::Surface::Kernel::Point_3, 3>
                        {mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2])});
  picture.write(os, title, internal::svg_count(mesh.number_of_vertices()) + " vertices, "
                           + internal::svg_count(mesh.number_of_faces()) + " triangles");
}

/// draws the Voronoi regions of the vertices of a mesh of a surface in the same way. Of a surface
/// that `is_closed`, what faces away is left out.
/// \tparam K a model of `Kernel`
/// \param os the stream
/// \param regions what `anisotropic_surface_Voronoi_regions_3()` returns
/// \param is_closed whether the surface is closed
/// \param title what the line of text below the picture begins with; may be empty
/// \param view from where the surface is seen
template <class K>
void write_SVG(std::ostream& os, const std::vector<Anisotropic_mesh_2::Surface_voronoi_region_3<K> >& regions,
               bool is_closed, const std::string& title = std::string(),
               const Anisotropic_mesh_2::View_direction_3& view = Anisotropic_mesh_2::View_direction_3())
{
  namespace internal = Anisotropic_mesh_2::internal;
  internal::Svg_surface picture(view, is_closed);
  for(const auto& region : regions)
    for(const auto& line : region.boundaries)
      picture.add_polygon(line);
  picture.write(os, title, internal::svg_count(regions.size()) + " Voronoi regions");
}

/// writes a mesh of a surface to a file, which appears under its name only when it is complete.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param file the name of the file
/// \param mesh the mesh
/// \throw Mesh_io_exception if the file cannot be written.
template <class Field>
void write_OFF(const std::string& file, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  Anisotropic_mesh_2::internal::write_safely(file, [&](std::ostream& os) { write_OFF(os, mesh); });
}

/// writes a mesh of a surface to a file, which appears under its name only when it is complete.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param file the name of the file
/// \param mesh the mesh
/// \throw Mesh_io_exception if the file cannot be written.
template <class Field>
void write_PLY(const std::string& file, const Anisotropic_surface_mesh_3<Field>& mesh)
{
  Anisotropic_mesh_2::internal::write_safely(file, [&](std::ostream& os) { write_PLY(os, mesh); });
}

/// draws a mesh of a surface to a file, which appears under its name only when it is complete.
/// \tparam Field an instance of `Surface_metric_field_2`
/// \param file the name of the file
/// \param mesh the mesh
/// \param title what the line of text below the picture begins with; may be empty
/// \param view from where the surface is seen
/// \throw Mesh_io_exception if the file cannot be written.
template <class Field>
void write_SVG(const std::string& file, const Anisotropic_surface_mesh_3<Field>& mesh,
               const std::string& title = std::string(),
               const Anisotropic_mesh_2::View_direction_3& view = Anisotropic_mesh_2::View_direction_3())
{
  Anisotropic_mesh_2::internal::write_safely(file, [&](std::ostream& os) { write_SVG(os, mesh, title, view); });
}

/// draws Voronoi regions to a file, which appears under its name only when it is complete.
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \param regions what `anisotropic_surface_Voronoi_regions_3()` returns
/// \param is_closed whether the surface is closed
/// \param title what the line of text below the picture begins with; may be empty
/// \param view from where the surface is seen
/// \throw Mesh_io_exception if the file cannot be written.
template <class K>
void write_SVG(const std::string& file, const std::vector<Anisotropic_mesh_2::Surface_voronoi_region_3<K> >& regions,
               bool is_closed, const std::string& title = std::string(),
               const Anisotropic_mesh_2::View_direction_3& view = Anisotropic_mesh_2::View_direction_3())
{
  Anisotropic_mesh_2::internal::write_safely(file, [&](std::ostream& os) {
    write_SVG(os, regions, is_closed, title, view);
  });
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_IO_SURFACE_H

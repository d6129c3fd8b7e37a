// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_SVG_H
#define CGAL_ANISOTROPIC_MESH_2_IO_SVG_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_surface.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_tessellation.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/write_file.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/Surface_voronoi_region_3.h>
#include <CGAL/Anisotropic_mesh_2/View_direction_3.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_drawing.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {

template <class Mesh, class Distance, class ConcurrencyTag> class Anisotropic_Voronoi_diagram_2;
template <class Field> class Anisotropic_surface_mesh_3;

namespace IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// draws the domain of a triangulation, or what a window shows of it, as a
/// Scalable Vector Graphics file, 800 pixels wide.
///
/// Subdomains are softly filled, in different colors where they touch. The width of the edges follows the size of
/// the triangles around them, so that graded and very anisotropic meshes stay
/// readable; the boundary and inner curves are thick, and have colors by their references if these differ,
/// which are not the same for references that meet at a vertex.
///
/// \tparam Tr a constrained triangulation of \cgal whose faces have a member
/// `bool is_in_domain() const` and possibly `int subdomain_index() const`; references of edges are those
/// that `write_MEDIT()` writes
/// \param os the stream, whose state shows whether everything was written
/// \param tr the triangulation
/// \param title what the line of text below the picture begins with; may be empty
/// \param window the part of the plane that is shown; all if it is empty
template <class Tr>
void write_SVG(std::ostream& os, const Tr& tr, const std::string& title = std::string(),
               const Bbox_2& window = Bbox_2())
{
  const Anisotropic_mesh_2::internal::Domain_graph graph = Anisotropic_mesh_2::internal::domain_graph(tr);
  Anisotropic_mesh_2::internal::Svg_mesh(graph, {}, window).write(os, title);
}

/// draws the domain of a triangulation with triangles colored by quality, and
/// a legend.
///
/// \tparam Tr as above
/// \tparam Quality a functor `double(Tr::Face_handle)` whose values lie between
/// 0 (worst) and 1 (best)
/// \param os the stream
/// \param tr the triangulation
/// \param title what the line of text below the picture begins with; may be empty
/// \param quality the quality of a face
/// \param window as above
template <class Tr, class Quality>
void write_SVG(std::ostream& os, const Tr& tr, const std::string& title, const Quality& quality,
               const Bbox_2& window = Bbox_2())
{
  const Anisotropic_mesh_2::internal::Domain_graph graph = Anisotropic_mesh_2::internal::domain_graph(tr);
  std::vector<double> qualities;
  for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
    if(f->is_in_domain())
      qualities.push_back(quality(typename Tr::Face_handle(f)));
  Anisotropic_mesh_2::internal::Svg_mesh(graph, qualities, window).write(os, title);
}

/// draws a tessellation: its regions in soft colors, different for neighbors,
/// their orphans in a strong tone of the same color, the constrained edges, and
/// what `drawing` asks for.
///
/// The width of lines follows that of the regions.
/// \tparam Mesh,Distance,ConcurrencyTag as for `Anisotropic_Voronoi_diagram_2`
/// \param os the stream
/// \param diagram the tessellation
/// \param title what the line of text below the picture begins with; may be empty
/// \param drawing what is drawn
/// \throw Invalid_metric_tensor_exception if mass centres are asked for and the field fails at a point of the domain.
template <class Mesh, class Distance, class ConcurrencyTag>
void write_SVG(std::ostream& os, const Anisotropic_Voronoi_diagram_2<Mesh, Distance, ConcurrencyTag>& diagram,
               const std::string& title = std::string(),
               const Anisotropic_mesh_2::Voronoi_drawing& drawing = Anisotropic_mesh_2::Voronoi_drawing())
{
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Tessellation_lines lines = internal::tessellation_lines(diagram, drawing);
  internal::Svg_tessellation(lines, drawing).write(os, title);
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

/// draws what the functions that write to a stream draw to a file. The further arguments are those of these
/// functions.
/// \tparam Drawing,Args what a function that writes to a stream takes
/// \param file the name of the file
/// \param drawing the triangulation, the tessellation, the mesh of a surface or its Voronoi regions
/// \param args the further arguments
/// \throw Mesh_io_exception if the file cannot be written.
template <class Drawing, class... Args>
void write_SVG(const std::string& file, const Drawing& drawing, const Args&... args)
{
  Anisotropic_mesh_2::internal::write_file(
    file, [&](std::ostream& os) { CGAL::IO::write_SVG(os, drawing, args...); });
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_IO_SVG_H

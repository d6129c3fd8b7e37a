// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_SVG_H
#define CGAL_ANISOTROPIC_MESH_2_IO_SVG_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/svg/Svg_voronoi_diagram.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/IO/Safe_output_file.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_drawing.h>

#include <ostream>
#include <string>
#include <vector>

namespace CGAL {

template <class Mesh, class Distance, class ConcurrencyTag> class Anisotropic_Voronoi_diagram_2;

namespace IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// draws the domain of a triangulation as a Scalable Vector Graphics file,
/// 800 pixels wide.
///
/// Subdomains are softly filled. The width of the edges follows the size of
/// the triangles around them, so that graded and very anisotropic meshes stay
/// readable; the boundary and inner constraints are thick.
///
/// \tparam Tr a constrained triangulation of \cgal whose faces have a member
/// `bool is_in_domain() const` and possibly `int subdomain_index() const`
/// \param os the stream
/// \param tr the triangulation
/// \param title what the line of text below the picture begins with; may be empty
template <class Tr>
void write_SVG(std::ostream& os, const Tr& tr, const std::string& title = std::string())
{
  const auto no_reference = [](const typename Tr::Edge&) { return 0; };
  const Anisotropic_mesh_2::internal::Domain_graph graph
    = Anisotropic_mesh_2::internal::domain_graph(tr, no_reference);
  Anisotropic_mesh_2::internal::Svg_mesh(graph, std::vector<double>()).write(os, title);
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
template <class Tr, class Quality>
void write_SVG(std::ostream& os, const Tr& tr, const std::string& title, const Quality& quality)
{
  const auto no_reference = [](const typename Tr::Edge&) { return 0; };
  const Anisotropic_mesh_2::internal::Domain_graph graph
    = Anisotropic_mesh_2::internal::domain_graph(tr, no_reference);
  std::vector<double> qualities;
  for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
    if(f->is_in_domain())
      qualities.push_back(quality(typename Tr::Face_handle(f)));
  Anisotropic_mesh_2::internal::Svg_mesh(graph, qualities).write(os, title);
}

/// draws a tessellation: its regions in soft colors, different for neighbors,
/// their orphans in a strong tone of the same color, the constrained edges, and
/// what `drawing` asks for.
///
/// The width of lines follows that of the regions. With the tag `Parallel_tag` all threads draw, and the file is
/// the same.
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
  typedef Anisotropic_Voronoi_diagram_2<Mesh, Distance, ConcurrencyTag> Diagram;
  Anisotropic_mesh_2::internal::Svg_voronoi_diagram<Diagram>(diagram, drawing).write(os, title);
}

/// draws a triangulation or a tessellation to a file, which appears under its
/// name only when it is complete. The further arguments are those of the
/// functions that write to a stream.
/// \tparam Drawing,Args what a function that writes to a stream takes
/// \param file the name of the file
/// \param drawing the triangulation or the tessellation
/// \param args the further arguments
/// \throw Mesh_io_exception if the file cannot be written.
template <class Drawing, class... Args>
void write_SVG(const std::string& file, const Drawing& drawing, const Args&... args)
{
  Anisotropic_mesh_2::internal::write_safely(
    file, [&](std::ostream& os) { CGAL::IO::write_SVG(os, drawing, args...); });
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_IO_SVG_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_POLY_H
#define CGAL_ANISOTROPIC_MESH_2_IO_POLY_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/Poly_reader.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/write_file.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// reads a planar straight line graph from a `.poly` file of the mesh
/// generator Triangle \cgalCite{s-tri-96}.
///
/// Vertices with their markers, segments with their markers, hole seeds and
/// regional attributes are read; attributes of vertices are skipped. Indices
/// start at 0 or 1, which the index of the first vertex decides. If the file announces no
/// vertices, they are read from the `.node` file of the same name. The inside
/// of the domain is that of `Anisotropic_mesh_2::Domain_rule::FLOOD_FROM_SEEDS`.
///
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \return what it holds, without triangles
/// \throw Mesh_io_exception with file and line, if a file is not readable or
/// not well-formed.
template <class K>
Anisotropic_mesh_2::Planar_straight_line_graph_2<K> read_POLY(const std::string& file)
{
  return std::move(Anisotropic_mesh_2::internal::Poly_reader<K>(file).graph());
}

/// writes the points, edges, holes and regions of a graph as a `.poly` file,
/// with indices from 1 and all digits. Triangles are not written.
/// \tparam K a model of `Kernel`
/// \param os the stream
/// \param graph the graph
template <class K>
void write_POLY(std::ostream& os, const Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& graph)
{
  Anisotropic_mesh_2::internal::Text_writer out(os);
  std::size_t index = 0;
  const auto write_line = [&](const auto& p) -> Anisotropic_mesh_2::internal::Text_writer& {
    return out << ++index << ' ' << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y());
  };
  out << "# vertices: number, dimension, attributes, markers\n" << graph.points.size() << " 2 0 1\n";
  for(std::size_t i = 0; i < graph.points.size(); ++i)
    write_line(graph.points[i]) << ' ' << (graph.point_references.empty() ? 0 : graph.point_references[i]) << '\n';
  out << "# segments: number, markers\n" << graph.edges.size() << " 1\n";
  for(std::size_t i = 0; i < graph.edges.size(); ++i)
    out << i + 1 << ' ' << graph.edges[i].source + 1 << ' ' << graph.edges[i].target + 1 << ' '
        << graph.edges[i].reference << '\n';
  out << "# holes\n" << graph.holes.size() << '\n';
  index = 0;
  for(const auto& hole : graph.holes)
    write_line(hole) << '\n';
  if(!graph.regions.empty())
    out << "# regions\n" << graph.regions.size() << '\n';
  index = 0;
  for(const auto& region : graph.regions)
    write_line(region.seed) << ' ' << region.reference << '\n';
  out.flush();
}

/// writes a graph to a file as the function that writes to a stream does.
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \param graph the graph
/// \throw Mesh_io_exception if the file cannot be written.
template <class K>
void write_POLY(const std::string& file, const Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& graph)
{
  Anisotropic_mesh_2::internal::write_file(file, [&](std::ostream& os) { CGAL::IO::write_POLY(os, graph); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_POLY_H

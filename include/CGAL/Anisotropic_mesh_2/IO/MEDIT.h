// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_IO_MEDIT_H
#define CGAL_ANISOTROPIC_MESH_2_IO_MEDIT_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Medit_reader.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/write_file.h>
#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Metric_tensor_2.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::IO {

/// \addtogroup PkgAnisotropicMesh2IO
/// @{

/// reads a plane mesh, or the edges that bound a domain, from an ASCII Medit
/// file (`.mesh`).
///
/// Vertices, edges and triangles are read with their references. What marks
/// corners, ridges, required elements, normals, tangents or relations to a
/// geometry is skipped; all other sections are refused. In a file of dimension
/// 3, all vertices must have the same `z`.
///
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \return what it holds; holes and regions are empty
/// \throw Mesh_io_exception with file and line, if the file is not readable or
/// not well-formed: numbers of elements that do not match, vertices that do
/// not exist, coordinates that are not finite, binary files.
template <class K>
Anisotropic_mesh_2::Planar_straight_line_graph_2<K> read_MEDIT(const std::string& file)
{
  return std::move(Anisotropic_mesh_2::internal::Medit_mesh_reader<K>(file).graph());
}

/// reads a metric at the vertices of a mesh from an ASCII Medit file (`.sol`).
///
/// The file holds one solution: either of type 1, the sizes of isotropic
/// tensors, or of type 3, tensors in the order `m11 m12 m22`.
///
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \return the tensors, in the order of the vertices
/// \throw Mesh_io_exception with file and line, if the file is not readable,
/// not well-formed, or if a tensor is not positive definite.
template <class K>
std::vector<Metric_tensor_2<K>> read_MEDIT_metric(const std::string& file)
{
  return std::move(Anisotropic_mesh_2::internal::Medit_metric_reader<K>(file).tensors());
}

/// writes points, edges and triangles with their references in the Medit
/// format (`.mesh`), with all digits. Seeds are not written.
/// \tparam K a model of `Kernel`
/// \param os the stream
/// \param graph the graph
template <class K>
void write_MEDIT(std::ostream& os, const Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& graph)
{
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "MeshVersionFormatted 2\nDimension 2\n\nVertices\n" << graph.points.size() << '\n';
  for(std::size_t i = 0; i < graph.points.size(); ++i)
    out << CGAL::to_double(graph.points[i].x()) << ' ' << CGAL::to_double(graph.points[i].y()) << ' '
        << (graph.point_references.empty() ? 0 : graph.point_references[i]) << '\n';
  out << "\nEdges\n" << graph.edges.size() << '\n';
  for(const auto& e : graph.edges)
    out << e.source + 1 << ' ' << e.target + 1 << ' ' << e.reference << '\n';
  if(!graph.triangles.empty())
    out << "\nTriangles\n" << graph.triangles.size() << '\n';
  for(std::size_t i = 0; i < graph.triangles.size(); ++i) {
    for(std::size_t v : graph.triangles[i])
      out << v + 1 << ' ';
    out << (graph.triangle_references.empty() ? 0 : graph.triangle_references[i]) << '\n';
  }
  out << "\nEnd\n";
  out.flush();
}

/// writes a graph to a file as the function that writes to a stream does.
/// \tparam K a model of `Kernel`
/// \param file the name of the file
/// \param graph the graph
/// \throw Mesh_io_exception if the file cannot be written.
template <class K>
void write_MEDIT(const std::string& file, const Anisotropic_mesh_2::Planar_straight_line_graph_2<K>& graph)
{
  Anisotropic_mesh_2::internal::write_file(file, [&](std::ostream& os) { CGAL::IO::write_MEDIT(os, graph); });
}

/// writes the domain of a triangulation in the Medit format (`.mesh`): the
/// faces of the domain with their subdomain indices, their vertices in the
/// order of the triangulation, and the edges that are constrained or bound the
/// domain.
///
/// \tparam Tr,Parameters an instance of the class template of a constrained triangulation of \cgal whose
/// faces have a member `bool is_in_domain() const` and possibly `int subdomain_index() const`
/// (else 0 is written). If it has a member `int edge_reference(Edge) const`,
/// this is the default for `edge_reference`; else the default is 1.
/// \tparam EdgeReference a functor, as `edge_reference` is
/// \param os the stream, whose state shows whether everything was written
/// \param tr the triangulation
/// \param edge_reference a functor `int(const Tr::Edge&)`
template <template <class...> class Tr, class... Parameters,
          class EdgeReference = Anisotropic_mesh_2::internal::Stored_edge_reference,
          class = Anisotropic_mesh_2::internal::If_marked<Tr<Parameters...>>>
void write_MEDIT(std::ostream& os, const Tr<Parameters...>& tr, const EdgeReference& edge_reference = EdgeReference())
{
  CGAL::IO::write_MEDIT(os, Anisotropic_mesh_2::internal::domain_graph(tr, edge_reference));
}

/// writes the domain of a triangulation to a file as the function that writes to a stream does.
/// \tparam Tr,Parameters,EdgeReference as there
/// \param file the name of the file
/// \param tr the triangulation
/// \param edge_reference as there
/// \throw Mesh_io_exception if the file cannot be written.
template <template <class...> class Tr, class... Parameters,
          class EdgeReference = Anisotropic_mesh_2::internal::Stored_edge_reference,
          class = Anisotropic_mesh_2::internal::If_marked<Tr<Parameters...>>>
void write_MEDIT(const std::string& file, const Tr<Parameters...>& tr,
                 const EdgeReference& edge_reference = EdgeReference())
{
  CGAL::IO::write_MEDIT(file, Anisotropic_mesh_2::internal::domain_graph(tr, edge_reference));
}

/// writes tensors as the solution of a Medit file (`.sol`), with all digits.
/// \tparam K a model of `Kernel`
/// \param os the stream
/// \param tensors the tensors, in the order of the vertices of a mesh
template <class K>
void write_MEDIT_metric(std::ostream& os, const std::vector<Metric_tensor_2<K>>& tensors)
{
  Anisotropic_mesh_2::internal::Text_writer out(os);
  out << "MeshVersionFormatted 2\nDimension 2\n\nSolAtVertices\n" << tensors.size() << "\n1 3\n";
  for(const Metric_tensor_2<K>& m : tensors)
    out << CGAL::to_double(m.m11()) << ' ' << CGAL::to_double(m.m12()) << ' '
        << CGAL::to_double(m.m22()) << '\n';
  out << "\nEnd\n";
  out.flush();
}

/// writes the tensors of the vertices of a triangulation, which have a member
/// `metric_tensor()`, in the order in which `write_MEDIT()` writes the vertices.
///
/// \tparam Tr as for `write_MEDIT()`; the vertices return a `Metric_tensor_2`
/// \param os the stream
/// \param tr the triangulation
template <class Tr>
void write_MEDIT_metric(std::ostream& os, const Tr& tr)
{
  const Anisotropic_mesh_2::internal::Domain_vertices<Tr> vertices(tr);
  std::vector<std::decay_t<decltype(tr.finite_vertices_begin()->metric_tensor())>> tensors;
  for(typename Tr::Vertex_handle v : vertices.vertices())
    tensors.push_back(v->metric_tensor());
  write_MEDIT_metric(os, tensors);
}

/// writes the tensors of a vector or of a triangulation to a file.
/// \tparam Mesh a vector of tensors or a triangulation, as a function that writes to a stream takes it
/// \param file the name of the file
/// \param mesh the tensors or the triangulation
/// \throw Mesh_io_exception if the file cannot be written.
template <class Mesh>
void write_MEDIT_metric(const std::string& file, const Mesh& mesh)
{
  Anisotropic_mesh_2::internal::write_file(file, [&](std::ostream& os) { CGAL::IO::write_MEDIT_metric(os, mesh); });
}

/// @}

} // namespace CGAL::IO

#endif // CGAL_ANISOTROPIC_MESH_2_IO_MEDIT_H

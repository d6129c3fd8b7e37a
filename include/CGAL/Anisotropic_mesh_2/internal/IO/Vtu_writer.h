// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_WRITER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_WRITER_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>

#include <CGAL/config.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Writes points, triangles and edges as an unstructured grid, with the arrays of
// numbers as text in their elements, or in binary form behind all elements.
class Vtu_writer
{
public:
  Vtu_writer(std::ostream& os, bool is_binary) : m_out(os), m_is_binary(is_binary) {}

  void write(const Domain_graph& graph)
  {
#ifdef CGAL_LITTLE_ENDIAN
    const char* const byte_order = "LittleEndian";
#else
    const char* const byte_order = "BigEndian";
#endif
    m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"" << byte_order
          << "\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n  <Piece NumberOfPoints=\"" << graph.points.size()
          << "\" NumberOfCells=\"" << graph.triangles.size() + graph.edges.size() << "\">\n    <Points>\n";
    std::vector<double> coordinates;
    for(const auto& p : graph.points)
      coordinates.insert(coordinates.end(), {p.x(), p.y(), 0.});
    write_array("type=\"Float64\" NumberOfComponents=\"3\"", coordinates);
    m_out << "    </Points>\n    <Cells>\n";
    write_cells(graph);
    m_out << "    </Cells>\n  </Piece>\n  </UnstructuredGrid>\n";
    if(m_is_binary)
      m_out << "<AppendedData encoding=\"raw\">\n_" << m_appended << "\n</AppendedData>\n";
    m_out << "</VTKFile>\n";
    m_out.flush();
  }

private:
  void write_cells(const Domain_graph& graph)
  {
    enum : std::uint8_t { LINE = 3, TRIANGLE = 5 };
    std::vector<std::uint64_t> vertices, ends;
    std::vector<std::uint8_t>  types(graph.triangles.size(), TRIANGLE);
    types.resize(graph.triangles.size() + graph.edges.size(), LINE);
    for(const auto& t : graph.triangles) {
      vertices.insert(vertices.end(), t.begin(), t.end());
      ends.push_back(vertices.size());
    }
    for(const auto& e : graph.edges) {
      vertices.insert(vertices.end(), {e.source, e.target});
      ends.push_back(vertices.size());
    }
    write_array("Name=\"connectivity\" type=\"UInt64\"", vertices);
    write_array("Name=\"offsets\" type=\"UInt64\"", ends);
    write_array("Name=\"types\" type=\"UInt8\"", types);
  }

  template <class Number>
  void write_array(const char* attributes, const std::vector<Number>& numbers)
  {
    m_out << "      <DataArray " << attributes;
    if(m_is_binary) {
      m_out << " format=\"appended\" offset=\"" << m_appended.size() << "\"/>\n";
      const std::uint64_t size = numbers.size() * sizeof(Number);
      m_appended.append(reinterpret_cast<const char*>(&size), sizeof size);
      m_appended.append(reinterpret_cast<const char*>(numbers.data()), size);
    } else {
      m_out << " format=\"ascii\">\n";
      for(Number x : numbers)
        m_out << x << ' ';
      m_out << "\n      </DataArray>\n";
    }
  }

  Text_writer m_out;
  const bool  m_is_binary;
  std::string m_appended;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_VTU_WRITER_H

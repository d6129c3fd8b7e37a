// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_POLY_READER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_POLY_READER_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_scanner.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// A .poly file of Triangle. In this format lines count: what a header does not
// announce must not be there.
template <class K>
class Poly_reader
{
public:
  typedef Planar_straight_line_graph_2<K> Graph;

  explicit Poly_reader(const std::string& file)
  {
    Text_scanner poly(file);
    if(poly.is_at_end())
      throw Mesh_io_exception(file, "the file is empty, expected the number of vertices");
    if(!read_vertices(poly))
      read_node_file(file);
    read_segments(poly);
    read_holes(poly);
    if(!poly.is_at_end())
      read_regions(poly);
    poly.set_item(nullptr);
    if(!poly.is_at_end())
      poly.mismatch("the end of the file", poly.next_word());
  }

  Graph& graph() { return m_graph; }

private:
  struct Header
  {
    std::size_t items = 0, attributes = 0;
    bool        has_marker = false;
  };

  void read_node_file(const std::string& file)
  {
    const std::string node_file = std::filesystem::path(file).replace_extension(".node").string();
    if(node_file == file)
      throw Mesh_io_exception(file, 1, "the file announces no vertices");
    Text_scanner node(node_file);
    if(!read_vertices(node))
      throw Mesh_io_exception(node_file, "the file announces no vertices");
    if(!node.is_at_end())
      node.mismatch("the end of the file", node.next_word());
  }

  // returns false if the file announces none
  bool read_vertices(Text_scanner& s)
  {
    const Header header = read_vertex_header(s);
    m_graph.points.reserve(s.at_most(header.items, 3));
    m_graph.point_references.reserve(m_graph.points.capacity());
    for(std::size_t i = 0; i < header.items; ++i) {
      s.set_item("vertex", i + 1, header.items);
      s.begin_line();
      read_vertex_index(s, i);
      const double x = s.number("the x coordinate");
      const double y = s.number("the y coordinate");
      m_graph.points.push_back(point_at<typename K::Point_2>(x, y));
      for(std::size_t j = 0; j < header.attributes; ++j)
        s.number("an attribute");
      m_graph.point_references.push_back(header.has_marker ? s.integer<int>("the marker") : 0);
      s.expect_end_of_line("which the first line of the section does not announce");
    }
    s.set_item(nullptr);
    return header.items > 0;
  }

  // number of vertices, dimension, number of attributes, number of markers
  Header read_vertex_header(Text_scanner& s)
  {
    Header header;
    s.set_item("vertices");
    s.begin_line();
    header.items = s.count("the number of vertices");
    if(!s.is_at_end_of_line() && s.integer<int>("the dimension 2") != 2)
      s.mismatch("the dimension 2", s.last_word());
    if(!s.is_at_end_of_line())
      header.attributes = s.count("the number of attributes");
    header.has_marker = read_number_of_markers(s);
    s.expect_end_of_line("");
    return header;
  }

  bool read_number_of_markers(Text_scanner& s)
  {
    const std::size_t markers = s.is_at_end_of_line() ? 0 : s.count("the number of markers, 0 or 1");
    if(markers > 1)
      s.mismatch("the number of markers, 0 or 1", s.last_word());
    return markers == 1;
  }

  void read_vertex_index(Text_scanner& s, std::size_t i)
  {
    const long long index = s.integer<long long>("the index of the vertex");
    if(i == 0 && index != 0 && index != 1)
      s.mismatch("the index 0 or 1 of the first vertex", s.last_word());
    if(i == 0)
      m_first_index = index;
    if(index != m_first_index + static_cast<long long>(i))
      s.mismatch("the index " + std::to_string(m_first_index + static_cast<long long>(i)), s.last_word());
  }

  void read_segments(Text_scanner& s)
  {
    s.set_item("segments");
    s.begin_line();
    const std::size_t n = s.count("the number of segments");
    const bool has_marker = read_number_of_markers(s);
    s.expect_end_of_line("");
    m_graph.edges.reserve(s.at_most(n, 3));
    const long long last_index = m_first_index + static_cast<long long>(m_graph.points.size()) - 1;
    for(std::size_t i = 0; i < n; ++i) {
      s.set_item("segment", i + 1, n);
      s.begin_line();
      s.integer<long long>("the index of the segment");
      const std::size_t source = s.index("the index of a vertex", m_first_index, last_index);
      const std::size_t target = s.index("the index of a vertex", m_first_index, last_index);
      m_graph.edges.push_back({source, target, has_marker ? s.integer<int>("the marker") : 1});
      s.expect_end_of_line("which the first line of the section does not announce");
    }
  }

  void read_holes(Text_scanner& s)
  {
    s.set_item("holes");
    s.begin_line();
    const std::size_t n = s.count("the number of holes");
    s.expect_end_of_line("");
    for(std::size_t i = 0; i < n; ++i) {
      s.set_item("hole", i + 1, n);
      m_graph.holes.push_back(read_seed(s));
      s.expect_end_of_line("");
    }
  }

  void read_regions(Text_scanner& s)
  {
    s.set_item("regions");
    s.begin_line();
    const std::size_t n = s.count("the number of regions");
    s.expect_end_of_line("");
    for(std::size_t i = 0; i < n; ++i) {
      s.set_item("region", i + 1, n);
      const typename K::Point_2 seed = read_seed(s);
      m_graph.regions.push_back({seed, read_regional_attribute(s)});
      if(!s.is_at_end_of_line())
        s.number("the greatest area");
      s.expect_end_of_line("");
    }
  }

  typename K::Point_2 read_seed(Text_scanner& s)
  {
    s.begin_line();
    s.integer<long long>("the index");
    const double x = s.number("the x coordinate");
    return point_at<typename K::Point_2>(x, s.number("the y coordinate"));
  }

  int read_regional_attribute(Text_scanner& s)
  {
    const double attribute = s.number("the regional attribute");
    if(attribute != std::floor(attribute) || std::abs(attribute) > (std::numeric_limits<int>::max)())
      s.mismatch("a whole number as regional attribute", s.last_word());
    return static_cast<int>(attribute);
  }

  Graph     m_graph;
  long long m_first_index = 1;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_POLY_READER_H

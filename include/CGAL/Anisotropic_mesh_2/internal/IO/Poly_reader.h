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

  // the number that the header of a section begins with
  static std::size_t read_count(Text_scanner& s, const char* section, const char* expected)
  {
    s.set_item(section);
    s.begin_line();
    return s.count(expected);
  }

  // the number of markers and the end of the header
  static bool read_has_marker(Text_scanner& s)
  {
    const std::size_t markers = s.is_at_end_of_line() ? 0 : s.count("the number of markers, 0 or 1");
    if(markers > 1)
      s.mismatch("the number of markers, 0 or 1", s.last_word());
    s.expect_end_of_line("");
    return markers == 1;
  }

  // calls `read(i)` on each of n lines
  template <class Read>
  static void read_lines(Text_scanner& s, const char* kind, std::size_t n, const char* why_end, const Read& read)
  {
    s.read_items(kind, n, [&](std::size_t i) {
      s.begin_line();
      read(i);
      s.expect_end_of_line(why_end);
    });
  }

  static typename K::Point_2 read_point(Text_scanner& s)
  {
    const double x = s.number("the x coordinate");
    return point_at<typename K::Point_2>(x, s.number("the y coordinate"));
  }

  // returns whether there are any
  bool read_vertices(Text_scanner& s)
  {
    const std::size_t n = read_count(s, "vertices", "the number of vertices");
    if(!s.is_at_end_of_line() && s.integer<int>("the dimension 2") != 2)
      s.mismatch("the dimension 2", s.last_word());
    const std::size_t attributes = s.is_at_end_of_line() ? 0 : s.count("the number of attributes");
    const bool has_marker = read_has_marker(s);
    m_graph.points.reserve(s.at_most(n, 3));
    m_graph.point_references.reserve(m_graph.points.capacity());
    read_lines(s, "vertex", n, unannounced, [&](std::size_t i) {
      read_vertex_index(s, static_cast<long long>(i));
      m_graph.points.push_back(read_point(s));
      for(std::size_t j = 0; j < attributes; ++j)
        s.number("an attribute");
      m_graph.point_references.push_back(has_marker ? s.integer<int>("the marker") : 0);
    });
    s.set_item(nullptr);
    return n > 0;
  }

  void read_vertex_index(Text_scanner& s, long long i)
  {
    const long long index = s.integer<long long>("the index of the vertex");
    if(i == 0 && index != 0 && index != 1)
      s.mismatch("the index 0 or 1 of the first vertex", s.last_word());
    if(i == 0)
      m_first_index = index;
    if(index != m_first_index + i)
      s.mismatch("the index " + std::to_string(m_first_index + i), s.last_word());
  }

  void read_segments(Text_scanner& s)
  {
    const std::size_t n = read_count(s, "segments", "the number of segments");
    const bool has_marker = read_has_marker(s);
    m_graph.edges.reserve(s.at_most(n, 3));
    const long long last_index = m_first_index + static_cast<long long>(m_graph.points.size()) - 1;
    read_lines(s, "segment", n, unannounced, [&](std::size_t) {
      s.integer<long long>("the index of the segment");
      const std::size_t source = s.index("the index of a vertex", m_first_index, last_index);
      const std::size_t target = s.index("the index of a vertex", m_first_index, last_index);
      m_graph.edges.push_back({source, target, has_marker ? s.integer<int>("the marker") : 1});
    });
  }

  void read_holes(Text_scanner& s)
  {
    const std::size_t n = read_count(s, "holes", "the number of holes");
    s.expect_end_of_line("");
    read_lines(s, "hole", n, "", [&](std::size_t) { m_graph.holes.push_back(read_seed(s)); });
  }

  void read_regions(Text_scanner& s)
  {
    const std::size_t n = read_count(s, "regions", "the number of regions");
    s.expect_end_of_line("");
    read_lines(s, "region", n, "", [&](std::size_t) {
      const typename K::Point_2 seed = read_seed(s);
      m_graph.regions.push_back({seed, read_regional_attribute(s)});
      if(!s.is_at_end_of_line())
        s.number("the greatest area");
    });
  }

  static typename K::Point_2 read_seed(Text_scanner& s)
  {
    s.integer<long long>("the index");
    return read_point(s);
  }

  static int read_regional_attribute(Text_scanner& s)
  {
    const double attribute = s.number("the regional attribute");
    if(attribute != std::floor(attribute) || std::abs(attribute) > (std::numeric_limits<int>::max)())
      s.mismatch("a whole number as regional attribute", s.last_word());
    return static_cast<int>(attribute);
  }

  static constexpr const char* unannounced = "which the first line of the section does not announce";

  Graph     m_graph;
  long long m_first_index = 1;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_POLY_READER_H

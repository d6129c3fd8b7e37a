// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_MEDIT_READER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_MEDIT_READER_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_scanner.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Metric_tensor_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// what the lines of a section hold
struct Medit_section
{
  const char* keyword;
  int words;            // on each line; -1: their number is the dimension
  int words_in_header;  // before or in place of the number of lines
};

// The sections that say nothing about a plane mesh that we need.
inline const Medit_section* find_ignored_medit_section(std::string_view keyword)
{
  static constexpr Medit_section sections[] = {
    {"RequiredVertices", 1, 0}, {"RequiredEdges", 1, 0}, {"RequiredTriangles", 1, 0},
    {"Corners", 1, 0}, {"Ridges", 1, 0}, {"CrackedEdges", 2, 0},
    {"Normals", -1, 0}, {"NormalAtVertices", 2, 0}, {"NormalAtTriangleVertices", 3, 0},
    {"Tangents", -1, 0}, {"TangentAtVertices", 2, 0}, {"TangentAtEdges", 3, 0},
    {"VertexOnGeometricVertex", 2, 0}, {"VertexOnGeometricEdge", 3, 0},
    {"EdgeOnGeometricEdge", 2, 0}, {"VertexOnSupportVertex", 2, 0},
    {"SubDomain", 4, 0}, {"SubDomainFromMesh", 4, 0}, {"SubDomainFromGeom", 4, 0},
    {"AngleOfCornerBound", 0, 1}, {"MaximalEdgeSize", 0, 1}, {"Time", 0, 1}, {"Iterations", 0, 1}};
  for(const Medit_section& s : sections)
    if(keyword == s.keyword)
      return &s;
  return nullptr;
}

// What .mesh and .sol files have in common: keywords in any order, each with
// its section.
class Medit_scanner
  : public Text_scanner
{
public:
  explicit Medit_scanner(const std::string& file) : Text_scanner(file)
  {
    if(text().substr(0, 4096).find('\0') != std::string_view::npos)
      throw Mesh_io_exception(file, "this is a binary file (.meshb, .solb), which is not supported: "
                                    "convert it to an ASCII file");
    if(is_at_end())
      throw Mesh_io_exception(file, "the file is empty, expected MeshVersionFormatted or Dimension");
  }

  int dimension() const { return m_dimension; }

  // Calls `read(keyword)` for every section that is not handled here; it
  // returns false for the keywords that it does not know.
  template <class Read>
  void read_sections(const Read& read)
  {
    std::string keyword;
    while(!is_at_end() && (keyword = next_keyword()) != "End") {
      if(keyword == "MeshVersionFormatted")
        read_version();
      else if(keyword == "Dimension")
        read_dimension();
      else if(m_dimension == 0)
        fail("expected Dimension before " + keyword);
      else if(!read(keyword))
        skip_section(keyword);
      set_item(nullptr);
    }
    if(keyword != "End" && !ends_with_newline())
      fail("the file ends in the middle of a line and without the keyword End");
    if(m_dimension == 0)
      fail("the keyword Dimension is missing");
  }

  std::size_t number_of(const char* items)
  {
    set_item(items);
    return count("the number of lines of the section");
  }

private:
  // all keywords that are known are printable
  std::string next_keyword()
  {
    const std::string w = printable(next_word());
    const bool is_word = (w[0] >= 'A' && w[0] <= 'Z') || (w[0] >= 'a' && w[0] <= 'z');
    if(!is_word)
      mismatch(m_last.empty() ? "MeshVersionFormatted" : "a keyword after the section " + m_last, w,
               m_last.empty() ? "" : "does the section hold more lines than its number says?");
    if(!m_seen.insert(w).second)
      fail("the section " + w + " is there twice");
    m_last = w;
    return w;
  }

  void read_version()
  {
    const int version = integer<int>("a version from 1 to 4");
    if(version < 1 || version > 4)
      mismatch("a version from 1 to 4", last_word());
  }

  void read_dimension()
  {
    m_dimension = integer<int>("the dimension 2");
    if(m_dimension != 2 && m_dimension != 3)
      mismatch("the dimension 2", last_word());
  }

  void skip_section(const std::string& name)
  {
    if(name == "Identifier" || name == "Geometry")
      return skip_string("a text in quotation marks");
    const Medit_section* section = find_ignored_medit_section(name);
    if(section == nullptr)
      fail("the section " + name + " is not supported");
    set_item(section->keyword);
    for(int i = 0; i < section->words_in_header; ++i)
      number("a number");
    if(section->words == 0)
      return;
    const std::size_t lines = count("the number of lines of the section");
    const int words = section->words < 0 ? m_dimension : section->words;
    for(std::size_t i = 0; i < lines; ++i) {
      set_item(section->keyword, i + 1, lines);
      for(int j = 0; j < words; ++j)
        number("a number");
    }
  }

  int m_dimension = 0;
  std::string m_last;
  std::set<std::string> m_seen;
};

// a .mesh file
template <class K>
class Medit_mesh_reader
{
public:
  typedef Planar_straight_line_graph_2<K> Graph;

  explicit Medit_mesh_reader(const std::string& file) : m_scanner(file)
  {
    m_scanner.read_sections([this](const std::string& keyword) { return read(keyword); });
    if(!m_has_vertices)
      m_scanner.fail("the section Vertices is missing");
    check_indices("edge", m_edges_at, 2, m_graph.edges,
                  [](const typename Graph::Edge& e) { return std::array<std::size_t, 2>{e.source, e.target}; });
    check_indices("triangle", m_triangles_at, 3, m_graph.triangles,
                  [](const std::array<std::size_t, 3>& t) { return t; });
  }

  Graph& graph() { return m_graph; }

private:
  bool read(const std::string& keyword)
  {
    if(keyword == "Vertices")
      read_vertices();
    else if(keyword == "Edges")
      read_edges();
    else if(keyword == "Triangles")
      read_triangles();
    else
      return refuse_other_elements(keyword);
    return true;
  }

  void read_vertices()
  {
    m_has_vertices = true;
    const std::size_t n = m_scanner.number_of("Vertices");
    m_graph.points.reserve(m_scanner.at_most(n, 3));
    m_graph.point_references.reserve(m_graph.points.capacity());
    double first_z = 0;
    for(std::size_t i = 0; i < n; ++i) {
      m_scanner.set_item("vertex", i + 1, n);
      const double x = m_scanner.number("the x coordinate");
      const double y = m_scanner.number("the y coordinate");
      if(m_scanner.dimension() == 3)
        check_z(m_scanner.number("the z coordinate"), i, first_z);
      m_graph.points.push_back(point_at<typename K::Point_2>(x, y));
      m_graph.point_references.push_back(m_scanner.integer<int>("the reference"));
    }
  }

  void check_z(double z, std::size_t i, double& first_z)
  {
    if(i == 0)
      first_z = z;
    if(z != first_z)
      m_scanner.fail("the mesh does not lie in a plane of constant z, and only plane meshes are supported");
  }

  void read_edges()
  {
    const std::size_t n = m_scanner.number_of("Edges");
    m_edges_at = m_scanner.position();
    m_graph.edges.reserve(m_scanner.at_most(n, 3));
    for(std::size_t i = 0; i < n; ++i) {
      m_scanner.set_item("edge", i + 1, n);
      const std::size_t source = index(), target = index();
      m_graph.edges.push_back({source, target, m_scanner.integer<int>("the reference")});
    }
  }

  void read_triangles()
  {
    const std::size_t n = m_scanner.number_of("Triangles");
    m_triangles_at = m_scanner.position();
    m_graph.triangles.reserve(m_scanner.at_most(n, 4));
    m_graph.triangle_references.reserve(m_graph.triangles.capacity());
    for(std::size_t i = 0; i < n; ++i) {
      m_scanner.set_item("triangle", i + 1, n);
      const std::size_t a = index(), b = index(), c = index();
      m_graph.triangles.push_back({a, b, c});
      m_graph.triangle_references.push_back(m_scanner.integer<int>("the reference"));
    }
  }

  bool refuse_other_elements(const std::string& keyword)
  {
    for(const char* elements : {"Quadrilaterals", "Tetrahedra", "Prisms", "Pyramids", "Hexahedra"})
      if(keyword == elements) {
        if(m_scanner.number_of(elements) != 0)
          m_scanner.fail("this section is not supported: the mesh must consist of triangles");
        return true;
      }
    return false;
  }

  // Vertices may follow later, so the upper bound is checked at the end.
  std::size_t index() { return m_scanner.index("the index of a vertex", 1, (std::numeric_limits<long long>::max)()); }

  template <class Element, class Indices>
  void check_indices(const char* kind, std::size_t at, int number_of_indices,
                     const std::vector<Element>& elements, const Indices& indices)
  {
    const std::size_t n = m_graph.points.size();
    for(std::size_t i = 0; i < elements.size(); ++i) {
      const auto is = indices(elements[i]);
      for(std::size_t j = 0; j < is.size(); ++j)
        if(is[j] >= n)
          fail_at(kind, at, i, elements.size(), i * (number_of_indices + 1) + j + 1);
    }
  }

  // complains about the word with the number `words` behind the position `at`
  void fail_at(const char* kind, std::size_t at, std::size_t i, std::size_t total, std::size_t words)
  {
    m_scanner.move_to(at);
    for(std::size_t k = 0; k < words; ++k)
      m_scanner.next_word();
    m_scanner.set_item(kind, i + 1, total);
    m_scanner.mismatch("the index of a vertex", m_scanner.last_word(),
                       Text_scanner::out_of_range(1, static_cast<long long>(m_graph.points.size())));
  }

  Medit_scanner m_scanner;
  Graph         m_graph;
  bool          m_has_vertices = false;
  std::size_t   m_edges_at = 0, m_triangles_at = 0;
};

// a .sol file
template <class K>
class Medit_metric_reader
{
public:
  typedef typename K::FT       FT;
  typedef Metric_tensor_2<K>   Tensor;

  explicit Medit_metric_reader(const std::string& file) : m_scanner(file)
  {
    bool found = false;
    m_scanner.read_sections([&](const std::string& keyword) {
      if(keyword != "SolAtVertices")
        return false;
      found = true;
      read_tensors();
      return true;
    });
    if(!found)
      m_scanner.fail("the section SolAtVertices is missing");
  }

  std::vector<Tensor>& tensors() { return m_tensors; }

private:
  void read_tensors()
  {
    const std::size_t n = m_scanner.number_of("SolAtVertices");
    const bool is_tensor = read_type();
    m_tensors.reserve(m_scanner.at_most(n, is_tensor ? 3 : 1));
    for(std::size_t i = 0; i < n; ++i) {
      m_scanner.set_item("the metric of vertex", i + 1, n);
      try {
        m_tensors.push_back(is_tensor ? read_tensor() : read_size());
      } catch(const Invalid_metric_tensor_exception& e) {
        m_scanner.fail(e.what());
      }
    }
  }

  bool read_type()
  {
    const std::size_t fields = m_scanner.count("the number of solution fields");
    if(fields != 1)
      m_scanner.mismatch("a single solution field", m_scanner.last_word());
    const int type = m_scanner.template integer<int>("the type of the solution");
    if(type != 1 && type != 3)
      m_scanner.mismatch("the type of the solution, 1 (size) or 3 (metric tensor)", m_scanner.last_word());
    if(type == 3 && m_scanner.dimension() == 3)
      m_scanner.fail("tensors of dimension 3 are not supported");
    return type == 3;
  }

  Tensor read_size() { return Tensor::from_size(FT(m_scanner.number("the size"))); }

  Tensor read_tensor()
  {
    const FT m11(m_scanner.number("the entry m11"));
    const FT m12(m_scanner.number("the entry m12"));
    const FT m22(m_scanner.number("the entry m22"));
    return Tensor::from_entries(m11, m12, m22);
  }

  Medit_scanner       m_scanner;
  std::vector<Tensor> m_tensors;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_MEDIT_READER_H

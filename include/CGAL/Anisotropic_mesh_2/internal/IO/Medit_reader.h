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
#include <cstddef>
#include <limits>
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
    read_items(section->keyword, lines, [&](std::size_t) {
      for(int j = 0; j < words; ++j)
        number("a number");
    });
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
    check_indices();
  }

  Graph& graph() { return m_graph; }

private:
  // a section of elements between vertices
  struct Section
  {
    const char* kind;
    std::size_t number, begin, indices;
  };

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
    m_scanner.read_items("vertex", n, [&](std::size_t i) {
      const double x = m_scanner.number("the x coordinate");
      const double y = m_scanner.number("the y coordinate");
      const double z = m_scanner.dimension() == 3 ? m_scanner.number("the z coordinate") : 0;
      if(i == 0)
        first_z = z;
      if(z != first_z)
        m_scanner.fail("the mesh does not lie in a plane of constant z, and only plane meshes are supported");
      m_graph.points.push_back(point_at<typename K::Point_2>(x, y));
      m_graph.point_references.push_back(m_scanner.integer<int>("the reference"));
    });
  }

  void read_edges()
  {
    const std::size_t n = m_scanner.number_of("Edges");
    m_graph.edges.reserve(m_scanner.at_most(n, 3));
    read_elements(Section{"edge", n, m_scanner.position(), 2}, [this](const std::size_t* v, int reference) {
      m_graph.edges.push_back({v[0], v[1], reference});
    });
  }

  void read_triangles()
  {
    const std::size_t n = m_scanner.number_of("Triangles");
    m_graph.triangles.reserve(m_scanner.at_most(n, 4));
    m_graph.triangle_references.reserve(m_graph.triangles.capacity());
    read_elements(Section{"triangle", n, m_scanner.position(), 3}, [this](const std::size_t* v, int reference) {
      m_graph.triangles.push_back({v[0], v[1], v[2]});
      m_graph.triangle_references.push_back(reference);
    });
  }

  // Vertices may follow later, so the upper bound of indices is checked at the end.
  template <class Store>
  void read_elements(const Section& section, const Store& store)
  {
    m_sections.push_back(section);
    read_elements(section, (std::numeric_limits<long long>::max)(), [&](const std::size_t* v, int reference) {
      for(std::size_t i = 0; i < section.indices; ++i)
        m_indices_end = (std::max)(m_indices_end, v[i] + 1);
      store(v, reference);
    });
  }

  template <class Store>
  void read_elements(const Section& section, long long last_index, const Store& store)
  {
    m_scanner.read_items(section.kind, section.number, [&](std::size_t) {
      std::size_t v[3];
      for(std::size_t i = 0; i < section.indices; ++i)
        v[i] = m_scanner.index("the index of a vertex", 1, last_index);
      store(v, m_scanner.integer<int>("the reference"));
    });
  }

  // reads again what has an index that no vertex has, which now is complained about
  void check_indices()
  {
    if(m_indices_end > m_graph.points.size())
      for(const Section& section : m_sections) {
        m_scanner.move_to(section.begin);
        read_elements(section, static_cast<long long>(m_graph.points.size()), [](const std::size_t*, int) {});
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

  Medit_scanner        m_scanner;
  Graph                m_graph;
  bool                 m_has_vertices = false;
  std::vector<Section> m_sections;
  std::size_t          m_indices_end = 0;
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
    m_scanner.read_items("the metric of vertex", n, [&](std::size_t) {
      try {
        m_tensors.push_back(is_tensor ? read_tensor() : read_size());
      } catch(const Invalid_metric_tensor_exception& e) {
        m_scanner.fail(e.what());
      }
    });
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

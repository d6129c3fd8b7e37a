// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Bisector_inserter.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_bisector.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The domain of a mesh, its faces divided until each one lies in a single region.
template <class Generators, class ConcurrencyTag>
class Region_subdivision
{
  typedef typename Generators::Mesh Mesh;

public:
  typedef Region_tds                                               Tds;
  typedef Tds::Face_handle                                         Face_handle;
  typedef Iterator_range<std::vector<Face_handle>::const_iterator> Face_range;

  static constexpr std::size_t outside = Labelled_point::none; // the region of faces outside of the domain

  Region_subdivision(const Mesh& mesh, const Generators& generators, double tolerance) : m_generators(generators)
  {
    copy(mesh);
    Face_bisector<Generators, ConcurrencyTag>(generators, tolerance, m_tds)();
    Bisector_inserter{m_tds}();
    sort_faces();
  }

  const Tds& tds() const { return m_tds; }

  // the faces of region i
  Face_range faces(std::size_t i) const
  {
    const auto at = [&](std::size_t k) { return m_faces.begin() + static_cast<std::ptrdiff_t>(m_first_face[k]); };
    return Face_range(at(i), at(i + 1));
  }

private:
  void copy(const Mesh& mesh)
  {
    typedef typename Mesh::Triangulation_data_structure Source;
    struct Convert_vertex
    {
      const Mesh&       mesh;
      const Generators& generators;

      Tds::Vertex operator()(const typename Source::Vertex&) const { return Tds::Vertex(); }
      void operator()(const typename Source::Vertex& v, Tds::Vertex& copy) const
      {
        if(&v == &*mesh.infinite_vertex())
          return;
        copy.point = {generators.metric_point_of(v), generators.numbers()[v.index()]};
        copy.is_generator = true;
      }
    };
    struct Convert_face
    {
      Tds::Face operator()(const typename Source::Face&) const { return Tds::Face(); }
      void operator()(const typename Source::Face& f, Tds::Face& copy) const
      {
        copy.is_in_domain = f.is_in_domain();
      }
    };
    m_tds.copy_tds(mesh.tds(), mesh.infinite_vertex(), Convert_vertex{mesh, m_generators}, Convert_face());
    std::size_t id = 0;
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      v->id = id++;
    // one of two generators that coincide up to rounding has no region
    for(Face_handle f : m_tds.faces_in_domain())
      for(int i = 0; i < 3; ++i) {
        Labelled_point& p = f->vertex(i)->point;
        const std::size_t own = p.label;
        p.label = m_generators.set().nearest(p, own);
        f->vertex(i)->is_generator = f->vertex(i)->is_generator && p.label == own;
      }
  }

  // by regions
  void sort_faces()
  {
    const std::vector<Face_handle> faces = m_tds.faces_in_domain();
    m_first_face.assign(m_generators.set().size() + 1, 0);
    for(Face_handle f : faces) {
      f->division.reset();
      f->region = Tds::label(f);
      ++m_first_face[f->region + 1];
    }
    std::partial_sum(m_first_face.begin(), m_first_face.end(), m_first_face.begin());
    std::vector<std::size_t> next(m_first_face);
    m_faces.resize(faces.size());
    for(Face_handle f : faces)
      m_faces[next[f->region]++] = f;
  }

  const Generators&        m_generators;
  Tds                      m_tds;
  std::vector<Face_handle> m_faces;      // by regions
  std::vector<std::size_t> m_first_face; // of the regions
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

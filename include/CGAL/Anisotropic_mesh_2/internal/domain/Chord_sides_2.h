// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SIDES_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SIDES_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/flood.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/exact_predicates.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/spatial_order.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Which sides of the chords of a graph are inside the domain. The chords must
// meet in common end points only.
template <class K>
class Chord_sides_2
{
public:
  typedef Chord_graph_2<K>                       Graph;
  typedef std::vector<Domain_piece_2<K> >        Pieces;
  struct Sides { bool left, right; };

  Chord_sides_2(const Graph& graph, const Pieces& pieces, Domain_rule rule,
                const std::vector<typename K::Point_2>& holes)
    : m_graph(graph), m_pieces(pieces), m_sides(graph.chords().size(), Sides{false, false})
  {
    triangulate();
    if(m_triangulation.dimension() < 2)
      return;
    number_chords();
    if(rule == Domain_rule::EVEN_ODD)
      toggle_at_boundary();
    else
      flood_from_outside(holes);
    find_sides();
  }

  const std::vector<Sides>& sides() const { return m_sides; }

  // a triangulation of the inside, as far as the chords decide it
  std::vector<Triangle_of_doubles> inner_triangles() const
  {
    std::vector<Triangle_of_doubles> triangles;
    for(auto f = m_triangulation.finite_faces_begin(); f != m_triangulation.finite_faces_end(); ++f)
      if(f->info().inside)
        triangles.push_back(triangle_of_doubles(f));
    return triangles;
  }

private:
  typedef Exact_predicates_kernel_of<K>                                                Exact;
  struct Mark { bool visited = false, inside = true; };
  typedef Triangulation_vertex_base_with_info_2<std::size_t, Exact>                    Vb;
  typedef Constrained_triangulation_face_base_2<Exact>                                 Cfb;
  typedef Triangulation_face_base_with_info_2<Mark, Exact, Cfb>                        Fb;
  typedef Triangulation_data_structure_2<Vb, Fb>                                       Tds;
  typedef Constrained_Delaunay_triangulation_2<Exact, Tds, No_constraint_intersection_tag> Triangulation;
  typedef typename Triangulation::Face_handle                                          Face_handle;
  typedef typename Triangulation::Vertex_handle                                        Vertex_handle;
  typedef std::array<std::size_t, 3>                                                   Numbered; // ends, chord

  void triangulate()
  {
    std::vector<Vertex_handle> vertices(m_graph.points().size());
    Face_handle hint;
    for(std::size_t i : spatial_order(m_graph.points())) {
      vertices[i] = m_triangulation.insert(exact_point<K>(m_graph.points()[i]), hint);
      vertices[i]->info() = i;
      hint = vertices[i]->face();
    }
    for(const auto& c : m_graph.chords())
      m_triangulation.insert_constraint(vertices[c.source], vertices[c.target]);
    for(auto f = m_triangulation.all_faces_begin(); f != m_triangulation.all_faces_end(); ++f)
      f->info() = Mark();
  }

  void number_chords()
  {
    for(std::size_t i = 0; i < m_graph.chords().size(); ++i) {
      const auto ends = std::minmax(m_graph.chords()[i].source, m_graph.chords()[i].target);
      m_numbers.push_back({ends.first, ends.second, i});
    }
    std::sort(m_numbers.begin(), m_numbers.end());
  }

  std::size_t chord(Face_handle f, int i) const
  {
    const auto ends = std::minmax({f->vertex(m_triangulation.ccw(i))->info(),
                                   f->vertex(m_triangulation.cw(i))->info()});
    return (*std::lower_bound(m_numbers.begin(), m_numbers.end(), Numbered{ends.first, ends.second, 0}))[2];
  }

  void toggle_at_boundary()
  {
    const Face_handle outside = m_triangulation.infinite_face();
    outside->info() = Mark{true, false};
    flood(std::vector<Face_handle>(1, outside), [this](Face_handle f, int i) {
      const Face_handle g = f->neighbor(i);
      if(g->info().visited)
        return false;
      const bool toggles = f->is_constrained(i)
                        && m_pieces[m_graph.chords()[chord(f, i)].piece].role == Piece_role::BOUNDARY;
      g->info() = Mark{true, f->info().inside != toggles};
      return true;
    });
  }

  // A hole on a chord has no side; all vertices are ends of chords.
  Face_handle face_at(const typename K::Point_2& hole) const
  {
    typename Triangulation::Locate_type place;
    int i;
    const Face_handle f = m_triangulation.locate(exact_point<K>(hole), place, i);
    if(place == Triangulation::VERTEX || (place == Triangulation::EDGE && f->is_constrained(i)))
      throw Invalid_domain_exception("the seed " + describe(hole) + " of a hole lies on a curve of the domain");
    return f;
  }

  void flood_from_outside(const std::vector<typename K::Point_2>& holes)
  {
    std::vector<Face_handle> outside(1, m_triangulation.infinite_face());
    for(const auto& seed : holes)
      outside.push_back(face_at(seed));
    for(const Face_handle f : outside)
      f->info() = Mark{true, false};
    flood(outside, [](Face_handle f, int i) {
      const Face_handle g = f->neighbor(i);
      const bool enters = !g->info().visited && !f->is_constrained(i);
      if(enters)
        g->info() = Mark{true, false};
      return enters;
    });
  }

  // the face lies to the left of its edges in counterclockwise order
  void find_sides()
  {
    for(auto f = m_triangulation.all_faces_begin(); f != m_triangulation.all_faces_end(); ++f)
      for(int i = 0; i < 3; ++i)
        if(f->is_constrained(i)) {
          const std::size_t c = chord(f, i);
          const bool forward = f->vertex(m_triangulation.ccw(i))->info() == m_graph.chords()[c].source;
          (forward ? m_sides[c].left : m_sides[c].right) = f->info().inside;
        }
  }

  const Graph&          m_graph;
  const Pieces&         m_pieces;
  Triangulation         m_triangulation;
  std::vector<Numbered> m_numbers;
  std::vector<Sides>    m_sides;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CHORD_SIDES_2_H

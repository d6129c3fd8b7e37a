// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_VERTEX_REMOVER_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_VERTEX_REMOVER_2_H

#include <CGAL/Anisotropic_mesh_2/internal/kernel/face_marks.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Removes a vertex that is not fixed from a triangulation of
// dimension 2 that keeps its dimension.
//
// Edges of the vertex are flipped away while that is possible; what remains of
// its star is contracted to a neighbor. Every step is decided before it is
// done, so that no face is ever inverted; where orientation is decided exactly,
// some neighbor always permits the contraction. Faces stay what they are,
// with all that the user stores in them, but for the two that vanish.
template <class Triangulation>
class Vertex_remover_2
{
  typedef typename Triangulation::Edge            Edge;
  typedef typename Triangulation::Face_handle     Face_handle;
  typedef typename Triangulation::Vertex_handle   Vertex_handle;

public:
  Vertex_remover_2(Triangulation& t, Vertex_handle v) : m_t(t), m_v(v) {}

  // Returns whether the vertex was removed, and adds the edges of the faces
  // that took its place, or that were flipped, to `changed`.
  bool operator()(std::vector<Edge>& changed)
  {
    flip_edges_away();
    const std::vector<Face_handle> star = faces_of_star();
    const std::size_t i = removable_edge(star);
    const bool is_found = i < star.size();
    if(is_found)
      contract(star, i);
    else
      m_cut_off.insert(m_cut_off.end(), star.begin(), star.end());
    for(Face_handle f : m_cut_off)
      for(int j = 0; j < 3 && !m_t.is_infinite(f); ++j)
        changed.push_back(Edge(f, j));
    return is_found;
  }

private:
  // from a face at the vertex to the next ones around it
  Face_handle next(Face_handle f) const { return f->neighbor(m_t.ccw(f->index(m_v))); }
  Face_handle previous(Face_handle f) const { return f->neighbor(m_t.cw(f->index(m_v))); }
  Vertex_handle first_neighbor(Face_handle f) const { return f->vertex(m_t.ccw(f->index(m_v))); }

  std::vector<Face_handle> faces_of_star() const
  {
    std::vector<Face_handle> star;
    Face_handle f = m_v->face();
    do {
      star.push_back(f);
      f = next(f);
    } while(f != star.front());
    return star;
  }

  // After a flip the edge before it may have become flippable, therefore one step back.
  void flip_edges_away()
  {
    std::size_t degree = faces_of_star().size();
    Face_handle f = m_v->face();
    for(std::size_t failures = 0; degree > 3 && failures < degree;) {
      const Face_handle g = next(f);
      const int i = m_t.ccw(f->index(m_v));
      if(m_t.is_flippable(f, i)) {
        m_t.flip(f, i);
        const bool is_cut_off = !f->has_vertex(m_v);
        m_cut_off.push_back(is_cut_off ? f : g);
        f = previous(is_cut_off ? g : f);
        --degree;
        failures = 0;
      }
      else {
        f = g;
        ++failures;
      }
    }
  }

  // The face from which on the edge to its first neighbor can be contracted; past the end if there is none.
  std::size_t removable_edge(const std::vector<Face_handle>& star) const
  {
    const std::size_t n = star.size();
    std::size_t outside = n;
    for(std::size_t i = 0; i < n; ++i)
      if(m_t.is_infinite(first_neighbor(star[i])))
        outside = i;
    if(outside == n) {
      for(std::size_t i = 0; i < n; ++i)
        if(can_be_contracted(star, i))
          return i;
      return n;
    }
    if(turns_nowhere_left(star, outside))
      return outside;
    for(std::size_t i : {(outside + 1) % n, (outside + n - 1) % n}) // the neighbors on the hull
      if(can_be_contracted(star, i))
        return i;
    return n;
  }

  // whether all faces remain counterclockwise
  bool can_be_contracted(const std::vector<Face_handle>& star, std::size_t i) const
  {
    const Vertex_handle u = first_neighbor(star[i]);
    for(Face_handle f : star)
      if(!m_t.is_infinite(f) && !f->has_vertex(u)
         && m_t.orientation(u->point(), first_neighbor(f)->point(), first_neighbor(next(f))->point()) != LEFT_TURN)
        return false;
    return true;
  }

  // whether the neighbors of a vertex on the hull become a convex part of it
  bool turns_nowhere_left(const std::vector<Face_handle>& star, std::size_t outside) const
  {
    const std::size_t n = star.size();
    for(std::size_t i = 1; i + 2 < n; ++i) {
      const Face_handle f = star[(outside + i) % n], g = next(f), h = next(g);
      if(m_t.orientation(first_neighbor(f)->point(), first_neighbor(g)->point(), first_neighbor(h)->point())
         == LEFT_TURN)
        return false;
    }
    return true;
  }

  // moves the vertex into its neighbor
  void contract(const std::vector<Face_handle>& star, std::size_t i)
  {
    const Face_handle left = star[i], right = previous(left);
    const Vertex_handle u = first_neighbor(left);
    for(Face_handle vanishing : {left, right})
      glue(vanishing, u);
    for(Face_handle f : star)
      if(f != left && f != right) {
        f->set_vertex(f->index(m_v), u);
        u->set_face(f);
        m_cut_off.push_back(f);
      }
    m_t.tds().delete_face(left);
    m_t.tds().delete_face(right);
    m_t.tds().delete_vertex(m_v);
  }

  // makes the faces beyond the two edges of a face that will coincide neighbors
  void glue(Face_handle f, Vertex_handle u)
  {
    const int i = f->index(u), j = f->index(m_v);
    const Face_handle inner = f->neighbor(i), outer = f->neighbor(j);
    const int k = m_t.mirror_index(f, i);
    m_t.tds().set_adjacency(inner, k, outer, m_t.mirror_index(f, j));
    set_edge_mark(*inner, k, edge_mark(*f, j));
    f->vertex(3 - i - j)->set_face(inner);
  }

  Triangulation& m_t;
  const Vertex_handle m_v;
  std::vector<Face_handle> m_cut_off; // faces that no longer belong to the star
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_VERTEX_REMOVER_2_H

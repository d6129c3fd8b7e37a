// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_TRIANGULATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_TRIANGULATION_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/assertions.h>

#include <array>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The combinatorics of a few triangles: numbered faces and vertices, without
// geometry but for what is noted at the faces. An edge with a face on one side
// only is on the *rim*.
class Patch_triangulation
{
public:
  static constexpr int none = -1;

  // the tensor at the barycentre of a face, and the quality in it, negative unless counterclockwise
  struct Shape
  {
    Symmetric_form metric;
    double         quality = -1;
  };

  struct Face
  {
    std::array<int, 3> vertex, neighbor;
    Shape              shape;
    bool               is_used = true;

    int index(int v) const { return vertex[0] == v ? 0 : vertex[1] == v ? 1 : 2; }
    int index_of_neighbor(int f) const { return neighbor[0] == f ? 0 : neighbor[1] == f ? 1 : 2; }
  };

  static int ccw(int i) { return i == 2 ? 0 : i + 1; }
  static int cw(int i) { return i == 0 ? 2 : i - 1; }

  const std::vector<Face>& faces() const { return m_faces; }
  int number_of_faces() const { return int(m_faces.size()); }
  int number_of_vertices() const { return int(m_face_of.size()); }

  bool is_removed(int v) const { return m_face_of[v] == none; }

  // Calls `visit(f, i)` for the faces f of a vertex that is not on the rim, of
  // which it is the i-th vertex, counterclockwise.
  template <class Visit>
  void for_each_face_at(int v, const Visit& visit) const
  {
    const int first = m_face_of[v];
    int f = first;
    do {
      const int i = m_faces[f].index(v), next = m_faces[f].neighbor[ccw(i)];
      visit(f, i);
      f = next;
    } while(f != first);
  }

  int degree(int v) const
  {
    int n = 0;
    for_each_face_at(v, [&](int, int) { ++n; });
    return n;
  }

  // the vertex beyond an edge that is not on the rim
  int opposite(int f, int i) const
  {
    const Face& g = m_faces[m_faces[f].neighbor[i]];
    return g.vertex[g.index_of_neighbor(f)];
  }

  // the face that has an edge on the rim, and the index of the edge in it
  std::array<int, 2> rim_edge(int source, int target) const
  {
    for(int f = 0; f < number_of_faces(); ++f)
      for(int i = 0; i < 3 && m_faces[f].is_used; ++i)
        if(m_faces[f].neighbor[i] == none && m_faces[f].vertex[ccw(i)] == source && m_faces[f].vertex[cw(i)] == target)
          return {{f, i}};
    CGAL_unreachable();
  }

protected:
  std::vector<Face> m_faces;
  std::vector<int>  m_face_of; // by vertex

  // Replaces an edge that is not on the rim by the other diagonal of its two
  // faces; f gets its i-th vertex as the first one, the other face the vertex beyond.
  void flip_edge(int f, int i)
  {
    const int g = m_faces[f].neighbor[i], j = m_faces[g].index_of_neighbor(f);
    const int p = m_faces[f].vertex[i], a = m_faces[f].vertex[ccw(i)];
    const int b = m_faces[f].vertex[cw(i)], q = m_faces[g].vertex[j];
    const int bp = m_faces[f].neighbor[ccw(i)], aq = m_faces[g].neighbor[ccw(j)];
    const int pa = m_faces[f].neighbor[cw(i)], qb = m_faces[g].neighbor[cw(j)];
    set(f, {{p, a, q}}, {{aq, g, pa}});
    set(g, {{q, b, p}}, {{bp, f, qb}});
    redirect(aq, g, f);
    redirect(bp, f, g);
  }

  // Divides a face into three around a new vertex, the first one of each;
  // opposite to it are the edges 0, 1 and 2 of the old face in f and the two last faces.
  void split_face(int f)
  {
    const int v = number_of_vertices(), g = number_of_faces(), h = g + 1;
    m_face_of.push_back(f);
    m_faces.resize(m_faces.size() + 2);
    const Face old = m_faces[f];
    set(f, {{v, old.vertex[1], old.vertex[2]}}, {{old.neighbor[0], g, h}});
    set(g, {{v, old.vertex[2], old.vertex[0]}}, {{old.neighbor[1], h, f}});
    set(h, {{v, old.vertex[0], old.vertex[1]}}, {{old.neighbor[2], f, g}});
    redirect(old.neighbor[1], f, g);
    redirect(old.neighbor[2], f, h);
  }

  // Removes a vertex of degree 3 that is not on the rim; returns the face in the place of its three.
  int unite_faces(int v)
  {
    const int f = m_face_of[v], i = m_faces[f].index(v);
    const int g = m_faces[f].neighbor[ccw(i)], h = m_faces[f].neighbor[cw(i)];
    const int a = m_faces[f].vertex[ccw(i)], b = m_faces[f].vertex[cw(i)];
    const Face &left = m_faces[g], &right = m_faces[h];
    const int c = left.vertex[cw(left.index(v))];
    const int bc = left.neighbor[left.index(v)], ca = right.neighbor[right.index(v)];
    m_faces[g].is_used = m_faces[h].is_used = false;
    m_face_of[v] = none;
    set(f, {{a, b, c}}, {{bc, ca, m_faces[f].neighbor[i]}});
    redirect(bc, g, f);
    redirect(ca, h, f);
    return f;
  }

private:
  void set(int f, const std::array<int, 3>& vertex, const std::array<int, 3>& neighbor)
  {
    m_faces[f].vertex = vertex;
    m_faces[f].neighbor = neighbor;
    for(int v : vertex)
      m_face_of[v] = f;
  }

  void redirect(int f, int from, int to)
  {
    if(f != none)
      m_faces[f].neighbor[m_faces[f].index_of_neighbor(from)] = to;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_TRIANGULATION_H

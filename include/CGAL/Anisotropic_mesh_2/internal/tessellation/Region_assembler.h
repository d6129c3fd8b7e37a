// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_ASSEMBLER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_ASSEMBLER_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_divider.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Polyline_chainer.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Puts the parts of divided faces together to pieces of regions.
//
// A part belongs to a corner of a face; the parts of corners with the same label
// are one, that of the first of them.
//
// What pieces consist of can be asked for several pieces at the same time.
template <class Subdivision>
class Region_assembler
{
  typedef typename Subdivision::Tds           Tds;
  typedef typename Subdivision::Face_handle   Face_handle;
  typedef typename Tds::Edge                  Edge;

public:
  typedef std::vector<std::size_t> Line; // of the numbers of points

  static constexpr std::size_t outside = static_cast<std::size_t>(-1);

  Region_assembler(const Subdivision& subdivision, std::size_t number_of_regions)
    : m_tds(subdivision.tds()), m_handles(subdivision.faces())
  {
    number_points();
    const std::vector<std::size_t> roots = join_parts();
    number_pieces(roots, number_of_regions);
    sort_parts();
  }

  const Vectors& points() const { return m_points; }

  // The pieces of region i are those from first_piece(i) to first_piece(i + 1), the main ones first.
  std::size_t first_piece(std::size_t i) const { return m_first_piece[i]; }
  std::size_t region(std::size_t piece) const { return m_pieces[piece].region; }
  bool is_main(std::size_t piece) const { return m_pieces[piece].is_main; }

  // Calls `add(triangle)` for triangles that make up the piece: the parts of faces, seen from their first points.
  template <class Add>
  void for_each_triangle(std::size_t piece, const Add& add) const
  {
    Line polygon;
    for(std::size_t i = m_first_part[piece]; i < m_first_part[piece + 1]; ++i) {
      set_polygon(m_parts[i] / 3, m_parts[i] % 3, polygon);
      for(std::size_t k = 2; k < polygon.size(); ++k)
        add(Triangle_of_doubles{m_points[polygon[0]], m_points[polygon[k - 1]], m_points[polygon[k]]});
    }
  }

  // Calls `add(link, beyond)` for each segment of the boundary, which has the
  // piece on its left and the piece `beyond` or the `outside` on its right.
  template <class Add>
  void for_each_border(std::size_t piece, const Add& add) const
  {
    for(std::size_t i = m_first_part[piece]; i < m_first_part[piece + 1]; ++i) {
      add_domain_boundary(m_parts[i] / 3, m_parts[i] % 3, add);
      add_bisectors(m_parts[i] / 3, m_parts[i] % 3, add);
    }
  }

private:
  // the numbers of the points of a divided face
  struct Numbered_face
  {
    std::array<std::size_t, 3> crossing;
    std::size_t                centre;
    std::array<std::size_t, 3> curve; // of the first point, the others follow
  };

  struct Piece
  {
    std::size_t region;
    bool        is_main;
  };

  const Divided_face& division(std::size_t f) const { return m_handles[f]->division; }
  std::size_t id(std::size_t f, int k) const { return m_handles[f]->vertex(k)->id; }

  std::size_t add_point(const Vector_of_doubles& p)
  {
    m_points.push_back(p);
    return m_points.size() - 1;
  }

  void number_points()
  {
    m_points.resize(m_tds.number_of_vertices());
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      m_points[v->id] = v->corner.place.at;
    m_faces.resize(m_handles.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f) {
      number_crossings(f);
      const Divided_face& d = division(f);
      if(d.number_of_labels() == 3)
        m_faces[f].centre = add_point(d.centre.at);
      for(int k = 0; k < 3; ++k) {
        m_faces[f].curve[k] = m_points.size();
        m_points.insert(m_points.end(), d.curve[k].begin(), d.curve[k].end());
      }
    }
  }

  // Both faces of an edge have the same number for its crossing.
  void number_crossings(std::size_t f)
  {
    for(int k = 0; k < 3; ++k) {
      if(!division(f).is_crossed(k))
        continue;
      const Edge mirror = m_tds.mirror_edge(Edge(m_handles[f], k));
      const std::size_t g = mirror.first->is_in_domain ? mirror.first->number : f;
      m_faces[f].crossing[k] = g < f ? m_faces[g].crossing[mirror.second] : add_point(division(f).crossing[k].at);
    }
  }

  static bool is_first_of_label(const Divided_face& d, int k)
  {
    return k == 0 || (d.label[k] != d.label[0] && (k == 1 || d.label[2] != d.label[1]));
  }

  // Returns for each corner of a face the least one of its piece.
  std::vector<std::size_t> join_parts() const
  {
    std::vector<std::size_t> parent(3 * m_faces.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t i) {
      while(parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    const auto join = [&](std::size_t i, std::size_t j) {
      i = root(i);
      j = root(j);
      parent[(std::max)(i, j)] = (std::min)(i, j);
    };
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if(!division(f).is_crossed(k))
          join(3*f + i, 3*f + j);
        const Face_handle g = m_handles[f]->neighbor(k);
        if(g->is_in_domain && g->number < f)
          for(int l : {i, j})
            join(3*f + l, 3 * g->number + g->index(m_handles[f]->vertex(l)));
      }
    for(std::size_t i = 0; i < parent.size(); ++i)
      parent[i] = root(i);
    return parent;
  }

  // in the order of their regions, the main ones first
  void number_pieces(const std::vector<std::size_t>& roots, std::size_t number_of_regions)
  {
    std::vector<char> is_main(roots.size(), false);
    std::vector<std::size_t> order; // the roots of the pieces
    for(std::size_t i = 0; i < roots.size(); ++i) {
      if(roots[i] == i)
        order.push_back(i);
      if(m_handles[i / 3]->vertex(i % 3)->is_generator)
        is_main[roots[i]] = true;
    }
    const auto rank = [&](std::size_t i) { return std::make_tuple(division(i / 3).label[i % 3], !is_main[i], i); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });

    m_piece.resize(roots.size());
    m_first_piece.assign(number_of_regions + 1, 0);
    for(std::size_t i : order) {
      m_piece[i] = m_pieces.size();
      m_pieces.push_back(Piece{division(i / 3).label[i % 3], bool(is_main[i])});
      ++m_first_piece[m_pieces.back().region + 1];
    }
    std::partial_sum(m_first_piece.begin(), m_first_piece.end(), m_first_piece.begin());
    for(std::size_t i = 0; i < roots.size(); ++i)
      m_piece[i] = m_piece[roots[i]];
  }

  // by pieces, those of a piece in the order of their faces
  void sort_parts()
  {
    const auto for_each = [&](const auto& f) {
      for(std::size_t i = 0; i < m_piece.size(); ++i)
        if(is_first_of_label(division(i / 3), i % 3))
          f(i);
    };
    m_first_part.assign(m_pieces.size() + 1, 0);
    for_each([&](std::size_t i) { ++m_first_part[m_piece[i] + 1]; });
    std::partial_sum(m_first_part.begin(), m_first_part.end(), m_first_part.begin());
    std::vector<std::size_t> next(m_first_part);
    m_parts.resize(m_first_part.back());
    for_each([&](std::size_t i) { m_parts[next[m_piece[i]]++] = i; });
  }

  // The points of the part of corner k of face f, counterclockwise from the corner.
  void set_polygon(std::size_t f, int k, Line& line) const
  {
    const Divided_face& d = division(f);
    const Numbered_face& n = m_faces[f];
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const int labels = d.number_of_labels();
    if(labels == 1)
      line = {id(f, k), id(f, i), id(f, j)};
    else if(labels == 3) {
      line = {id(f, k), n.crossing[j]};
      append_curve(f, j, true, line);
      line.push_back(n.centre);
      append_curve(f, i, false, line);
      line.push_back(n.crossing[i]);
    }
    else {
      const int lonely = d.odd_corner();
      const int from = (lonely + 2) % 3, to = (lonely + 1) % 3; // the edges between which the curve leads
      const bool is_lonely = lonely == k;
      line = is_lonely ? Line{id(f, k), n.crossing[from]} : Line{id(f, to), id(f, from), n.crossing[to]};
      append_curve(f, lonely, is_lonely, line);
      line.push_back(n.crossing[is_lonely ? to : from]);
    }
  }

  void append_curve(std::size_t f, int k, bool is_forward, Line& line) const
  {
    const std::size_t n = division(f).curve[k].size();
    for(std::size_t i = 0; i < n; ++i)
      line.push_back(m_faces[f].curve[k] + (is_forward ? i : n - 1 - i));
  }

  // the segments of the part of corner k on edges beyond which there is no face of the domain
  template <class Add>
  void add_domain_boundary(std::size_t f, int k, const Add& add) const
  {
    const Divided_face& d = division(f);
    for(int e = 0; e < 3; ++e) {
      if(m_handles[f]->neighbor(e)->is_in_domain)
        continue;
      const int i = (e + 1) % 3, j = (e + 2) % 3;
      if(d.label[i] == d.label[k])
        add(Link{id(f, i), d.is_crossed(e) ? m_faces[f].crossing[e] : id(f, j)}, outside);
      else if(d.label[j] == d.label[k])
        add(Link{m_faces[f].crossing[e], id(f, j)}, outside);
    }
  }

  // the segments of the part of corner k on the curves within the face
  template <class Add>
  void add_bisectors(std::size_t f, int k, const Add& add) const
  {
    const Divided_face& d = division(f);
    const Numbered_face& n = m_faces[f];
    const int labels = d.number_of_labels();
    if(labels == 3) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      add_curve(f, n.crossing[j], j, n.centre, true, m_piece[3*f + i], add);
      add_curve(f, n.crossing[i], i, n.centre, false, m_piece[3*f + j], add);
    }
    else if(labels == 2) {
      // seen along the curve, the lonely corner is on the left
      const int lonely = d.odd_corner(), i = (lonely + 1) % 3, j = (lonely + 2) % 3;
      const bool is_lonely = lonely == k;
      add_curve(f, n.crossing[j], lonely, n.crossing[i], is_lonely, m_piece[3*f + (is_lonely ? i : lonely)], add);
    }
  }

  template <class Add>
  void add_curve(std::size_t f, std::size_t from, int k, std::size_t to, bool is_on_left, std::size_t beyond,
                 const Add& add) const
  {
    const std::size_t n = division(f).curve[k].size();
    for(std::size_t i = 0; i <= n; ++i) {
      const std::size_t next = i == n ? to : m_faces[f].curve[k] + i;
      add(is_on_left ? Link{from, next} : Link{next, from}, beyond);
      from = next;
    }
  }

  const Tds&                      m_tds;
  const std::vector<Face_handle>& m_handles;
  Vectors                         m_points;
  std::vector<Numbered_face>      m_faces;
  std::vector<std::size_t>        m_piece; // of corners, corner k of face f being 3 f + k
  std::vector<Piece>              m_pieces;
  std::vector<std::size_t>        m_first_piece; // of the regions
  std::vector<std::size_t>        m_parts;       // their corners, by pieces
  std::vector<std::size_t>        m_first_part;  // of the pieces
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_ASSEMBLER_H

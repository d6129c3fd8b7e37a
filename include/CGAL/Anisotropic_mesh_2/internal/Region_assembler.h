// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_REGION_ASSEMBLER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_REGION_ASSEMBLER_H

#include <CGAL/Anisotropic_mesh_2/internal/Face_divider.h>
#include <CGAL/Anisotropic_mesh_2/internal/Polyline_chainer.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vector_of_doubles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Puts the parts of divided faces together to pieces of regions.
//
// A part belongs to a corner of a face; the parts of corners with the same label are one.
template <class Subdivision>
class Region_assembler
{
  typedef typename Subdivision::Tds           Tds;
  typedef typename Subdivision::Face_handle   Face_handle;
  typedef typename Subdivision::Vertex_handle Vertex_handle;
  typedef typename Tds::Edge                  Edge;

public:
  typedef std::vector<std::size_t> Line; // of the numbers of points

  struct Piece
  {
    std::size_t       region;
    bool              is_main = false;
    double            area = 0;
    std::vector<Link> boundary;
  };

  struct Bisector
  {
    std::array<std::size_t, 2> pieces; // on the left and on the right
    Polyline_chainer::Line     line;
  };

  explicit Region_assembler(const Subdivision& subdivision) : m_subdivision(subdivision), m_tds(subdivision.tds())
  {
    number_points();
    join_parts();
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      add_boundaries(f);
    chain_bisectors();
  }

  const Vectors& points() const { return m_points; }
  const std::vector<Piece>& pieces() const { return m_pieces; }
  const std::vector<Bisector>& bisectors() const { return m_bisectors; }

  // calls `add(region, polygon)` for each part of a face; the polygon is seen from its first point
  template <class Add>
  void for_each_part(const Add& add) const
  {
    for(std::size_t f = 0; f < m_faces.size(); ++f) {
      const Divided_face& d = division(f);
      for(int k = 0; k < 3; ++k)
        if(is_first_of_label(d, k))
          add(d.label[k], polygon(f, k));
    }
  }

private:
  // the numbers of the points of a divided face
  struct Numbered_face
  {
    Face_handle                face;
    std::array<std::size_t, 3> crossing;
    std::size_t                centre;
    std::array<Line, 3>        curve;
    std::array<std::size_t, 3> piece; // of the parts, by corner
  };

  const Divided_face& division(std::size_t f) const { return m_subdivision.division(m_faces[f].face); }

  std::size_t number(Face_handle f) const { return m_number[f->division]; }

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
    for(auto f = m_tds.faces_begin(); f != m_tds.faces_end(); ++f)
      if(f->is_in_domain) {
        m_number.resize(std::max(m_number.size(), f->division + 1));
        m_number[f->division] = m_faces.size();
        m_faces.push_back(Numbered_face{f, {}, 0, {}, {}});
      }
    for(std::size_t f = 0; f < m_faces.size(); ++f) {
      number_crossings(f);
      const Divided_face& d = division(f);
      if(d.number_of_labels() == 3)
        m_faces[f].centre = add_point(d.centre.at);
      for(int k = 0; k < 3; ++k)
        for(const Vector_of_doubles& p : d.curve[k])
          m_faces[f].curve[k].push_back(add_point(p));
    }
  }

  // Both faces of an edge have the same number for its crossing.
  void number_crossings(std::size_t f)
  {
    for(int k = 0; k < 3; ++k) {
      if(!division(f).is_crossed(k))
        continue;
      const Edge mirror = m_tds.mirror_edge(Edge(m_faces[f].face, k));
      const std::size_t g = mirror.first->is_in_domain ? number(mirror.first) : f;
      m_faces[f].crossing[k] = g < f ? m_faces[g].crossing[mirror.second] : add_point(division(f).crossing[k].at);
    }
  }

  static bool is_first_of_label(const Divided_face& d, int k)
  {
    return k == 0 || (d.label[k] != d.label[0] && (k == 1 || d.label[2] != d.label[1]));
  }

  void join_parts()
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
      parent[std::max(i, j)] = std::min(i, j);
    };
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if(!division(f).is_crossed(k))
          join(3*f + i, 3*f + j);
        const Edge mirror = m_tds.mirror_edge(Edge(m_faces[f].face, k));
        if(mirror.first->is_in_domain)
          for(int l : {i, j})
            join(3*f + l, 3 * number(mirror.first) + mirror.first->index(m_faces[f].face->vertex(l)));
      }
    std::vector<std::size_t> piece(parent.size());
    for(std::size_t p = 0; p < parent.size(); ++p) {
      if(root(p) == p) {
        piece[p] = m_pieces.size();
        m_pieces.push_back(Piece());
        m_pieces.back().region = division(p / 3).label[p % 3];
      }
      m_faces[p / 3].piece[p % 3] = piece[root(p)];
    }
  }

  // The points of the part of corner k of face f, counterclockwise from the corner.
  Line polygon(std::size_t f, int k) const
  {
    const Divided_face& d = division(f);
    const Numbered_face& n = m_faces[f];
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const int labels = d.number_of_labels();
    if(labels == 1)
      return {id(f, k), id(f, i), id(f, j)};
    if(labels == 3) {
      Line line = {id(f, k), n.crossing[j]};
      line.insert(line.end(), n.curve[j].begin(), n.curve[j].end());
      line.push_back(n.centre);
      line.insert(line.end(), n.curve[i].rbegin(), n.curve[i].rend());
      line.push_back(n.crossing[i]);
      return line;
    }
    const int lonely = d.lonely_corner();
    const int from = (lonely + 2) % 3, to = (lonely + 1) % 3; // the edges between which the curve leads
    Line line = lonely == k ? Line{id(f, k), n.crossing[from]} : Line{id(f, to), id(f, from), n.crossing[to]};
    if(lonely == k)
      line.insert(line.end(), n.curve[lonely].begin(), n.curve[lonely].end());
    else
      line.insert(line.end(), n.curve[lonely].rbegin(), n.curve[lonely].rend());
    line.push_back(n.crossing[lonely == k ? to : from]);
    return line;
  }

  std::size_t id(std::size_t f, int k) const { return m_faces[f].face->vertex(k)->id; }

  void add_boundaries(std::size_t f)
  {
    const Divided_face& d = division(f);
    const Numbered_face& n = m_faces[f];
    for(int k = 0; k < 3; ++k) {
      if(is_first_of_label(d, k))
        m_pieces[n.piece[k]].area += area(polygon(f, k));
      if(n.face->vertex(k)->is_generator)
        m_pieces[n.piece[k]].is_main = true;
      if(!n.face->neighbor(k)->is_in_domain)
        add_domain_boundary(f, k);
    }
    if(d.number_of_labels() == 2) {
      const int k = d.lonely_corner(), i = (k + 1) % 3, j = (k + 2) % 3;
      // seen along the curve, the lonely corner is on the left
      add_bisector(n.piece[k], n.piece[i], n.crossing[j], n.curve[k], n.crossing[i]);
    }
    else if(d.number_of_labels() == 3)
      for(int k = 0; k < 3; ++k)
        add_bisector(n.piece[(k + 1) % 3], n.piece[(k + 2) % 3], n.crossing[k], n.curve[k], n.centre);
  }

  double area(const Line& polygon) const
  {
    const Vector_of_doubles& o = m_points[polygon[0]];
    double sum = 0;
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      const Vector_of_doubles &p = m_points[polygon[i - 1]], &q = m_points[polygon[i]];
      sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    }
    return sum / 2;
  }

  void add_domain_boundary(std::size_t f, int k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Numbered_face& n = m_faces[f];
    if(!division(f).is_crossed(k)) {
      m_pieces[n.piece[i]].boundary.push_back({id(f, i), id(f, j)});
      return;
    }
    m_pieces[n.piece[i]].boundary.push_back({id(f, i), n.crossing[k]});
    m_pieces[n.piece[j]].boundary.push_back({n.crossing[k], id(f, j)});
  }

  void add_bisector(std::size_t left, std::size_t right, std::size_t from, const Line& inner, std::size_t to)
  {
    std::vector<Link>& links = m_links[std::make_pair(std::min(left, right), std::max(left, right))];
    const auto add = [&](std::size_t u, std::size_t v) {
      m_pieces[left].boundary.push_back({u, v});
      m_pieces[right].boundary.push_back({v, u});
      links.push_back(left < right ? Link{u, v} : Link{v, u});
    };
    for(std::size_t point : inner) {
      add(from, point);
      from = point;
    }
    add(from, to);
  }

  void chain_bisectors()
  {
    for(auto& pair_and_links : m_links)
      for(Polyline_chainer::Line& line : Polyline_chainer(std::move(pair_and_links.second), m_points)())
        m_bisectors.push_back(Bisector{{pair_and_links.first.first, pair_and_links.first.second}, std::move(line)});
    m_links.clear();
  }

  const Subdivision&                  m_subdivision;
  const Tds&                          m_tds;
  Vectors                             m_points;
  std::vector<Numbered_face>          m_faces;
  std::vector<std::size_t>            m_number; // of faces, by the index of their divisions
  std::vector<Piece>                  m_pieces;
  std::vector<Bisector>               m_bisectors;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Link> > m_links; // by the pieces on both sides
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_REGION_ASSEMBLER_H

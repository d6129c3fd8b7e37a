// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_PIECES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_PIECES_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The pieces of regions, which are connected sets of faces of a subdivision, and
// their borders. Several regions can be worked on at the same time.
class Region_pieces
{
  typedef Region_tds::Face_handle Face_handle;
  typedef Region_tds::Edge        Edge;

public:
  struct Piece
  {
    std::vector<Face_handle> faces;
    bool                     is_main; // whether the generator is a vertex of it
  };

  typedef std::vector<Edge> Border; // in order, each edge with the face on its left

  explicit Region_pieces(const Region_tds& tds) : m_tds(tds) {}

  // The pieces of a region, the main ones first; their numbers are set in the faces.
  template <class Face_range>
  std::vector<Piece> operator()(const Face_range& faces_of_region) const
  {
    std::vector<Piece> pieces;
    for(Face_handle f : faces_of_region)
      if(!f->is_collected)
        pieces.push_back(collect(f));
    std::stable_partition(pieces.begin(), pieces.end(), [](const Piece& p) { return p.is_main; });
    for(std::size_t i = 0; i < pieces.size(); ++i)
      for(Face_handle f : pieces[i].faces)
        f->piece = i;
    return pieces;
  }

  // The closed lines of edges beyond which the piece does not go on.
  std::vector<Border> borders(const Piece& piece) const
  {
    std::vector<Border> result;
    for(Face_handle f : piece.faces)
      for(int k = 0; k < 3; ++k)
        if(is_border(Edge(f, k)) && !f->is_followed[k])
          result.push_back(follow(Edge(f, k)));
    return result;
  }

private:
  static Piece collect(Face_handle f)
  {
    Piece piece = {{f}, false};
    f->is_collected = true;
    for(std::size_t i = 0; i < piece.faces.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        const auto v = piece.faces[i]->vertex(k);
        piece.is_main = piece.is_main || (v->is_generator && v->point.label == f->region);
        const Face_handle next = piece.faces[i]->neighbor(k);
        if(next->region == f->region && !next->is_collected) {
          next->is_collected = true;
          piece.faces.push_back(next);
        }
      }
    return piece;
  }

  static bool is_border(const Edge& e) { return e.first->neighbor(e.second)->region != e.first->region; }

  // At the end of an edge, the border goes on around the faces of the piece there.
  Border follow(const Edge& start) const
  {
    Border border;
    Edge e = start;
    do {
      border.push_back(e);
      e.first->is_followed[e.second] = true;
      e = Edge(e.first, Region_tds::ccw(e.second));
      while(!is_border(e)) {
        const Edge mirror = m_tds.mirror_edge(e);
        e = Edge(mirror.first, Region_tds::ccw(mirror.second));
      }
    } while(e != start);
    return border;
  }

  const Region_tds& m_tds;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_PIECES_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_COLLAPSE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_COLLAPSE_H

#include <CGAL/enum.h>

#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// The operation "collapse": removes a vertex of a patch and triangulates its
// star without it. Edges are flipped away from the vertex, those that leave the
// best face behind first, and the last three faces are united: whichever
// neighbor it would be contracted into, swaps would lead here.
//
// Returns whether the vertex could be removed; otherwise it may have lost edges.
template <class Patch>
bool collapse(Patch& patch, typename Patch::Vertex_handle v)
{
  typedef typename Patch::Edge Edge;
  if(!patch.is_free(v))
    return false;
  const auto orientation = patch.geom_traits().orientation_2_object();
  while(patch.tds().degree(v) > 3) {
    std::pair<double, Edge> best(0, Edge());
    patch.for_each_face_at(v, [&](typename Patch::Face_handle f, int i) {
      const Edge e(f, Patch::Tds::ccw(i));
      const auto w = patch.quadrilateral(e); // of three neighbors and v, which may come to lie on an edge
      if(orientation(w[2]->point(), v->point(), w[0]->point()) == RIGHT_TURN)
        return;
      const double quality = patch.shape(w[0], w[1], w[2]).quality;
      if(quality > best.first)
        best = {quality, e};
    });
    if(best.first <= 0)
      return false;
    patch.flip(best.second);
  }
  patch.unite(v);
  return true;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_COLLAPSE_H

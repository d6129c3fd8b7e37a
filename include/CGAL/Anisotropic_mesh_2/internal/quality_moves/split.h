// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_SPLIT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_SPLIT_H

namespace CGAL::Anisotropic_mesh_2::internal {

// The operation "split": a new vertex divides the faces of a patch on which it
// lies. What it is worth is decided later, after swaps and moves around it.

// Divides a face into three at its barycentre; that is always possible.
template <class Patch>
bool split_face(Patch& patch, typename Patch::Face_handle f)
{
  const auto &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
  patch.split(f, typename Patch::Point((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3));
  return true;
}

// Divides the two faces of an edge into four at its middle. Returns whether it
// could: edges on the border stay.
template <class Patch>
bool split_edge(Patch& patch, const typename Patch::Edge& e)
{
  if(patch.is_on_border(e))
    return false;
  const auto v = patch.quadrilateral(e);
  const auto &a = v[1]->point(), &b = v[3]->point();
  const auto outside = e.first->neighbor(e.second);
  const typename Patch::Point middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
  patch.split(e.first, middle);
  patch.flip({outside, outside->index(v[2])}); // the edge, now that of a flat face
  return true;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_SPLIT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// Watches over the lengths of edges, which are to be within [1/sqrt(2), sqrt(2)].
template <class Mesh>
class Unit_band
{
  typedef typename Mesh::Geom_traits   Gt;
  typedef Mesh_patch<Mesh>             Patch;
  typedef typename Patch::Vertex       Vertex;
  typedef typename Patch::Point        Point;

public:
  explicit Unit_band(const Mesh& mesh) : m_gt(mesh.geom_traits()) {}

  // Whether an edge is in the band by Simpson's rule, a little within to allow for its error.
  bool permits(const Vertex& u, const Vertex& v) const
  {
    const double l = estimate(u, v);
    return l > 0.715 && l < 1.4;
  }

  // the number of edges of a patch that are out of the band, those on the rim aside
  int edges_outside(const Patch& patch) const
  {
    int n = 0;
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const auto& face = patch.faces()[f];
      for(int i = 0; i < 3 && face.is_used; ++i)
        if(face.neighbor[i] > f) {
          const Vertex& u = patch.vertices()[face.vertex[Patch::ccw(i)]];
          const Vertex& v = patch.vertices()[face.vertex[Patch::cw(i)]];
          n += !is_in_band(u, v);
        }
    }
    return n;
  }

private:
  bool is_in_band(const Vertex& u, const Vertex& v) const
  {
    const double guess = estimate(u, v);
    if(guess > 0.8 && guess < 1.25)
      return true;
    const double l = m_gt.compute_riemannian_length_2_object()(u.point, v.point);
    return l >= std::sqrt(0.5) && l <= std::sqrt(2.);
  }

  double estimate(const Vertex& u, const Vertex& v) const
  {
    const double dx = CGAL::to_double(v.point.x() - u.point.x()), dy = CGAL::to_double(v.point.y() - u.point.y());
    const Point middle((u.point.x() + v.point.x()) / 2, (u.point.y() + v.point.y()) / 2);
    const Symmetric_form m(m_gt.construct_metric_tensor_2_object()(middle));
    return (Symmetric_form(u.tensor).length(dx, dy) + 4 * m.length(dx, dy)
          + Symmetric_form(v.tensor).length(dx, dy)) / 6;
  }

  const Gt& m_gt;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_UNIT_BAND_H

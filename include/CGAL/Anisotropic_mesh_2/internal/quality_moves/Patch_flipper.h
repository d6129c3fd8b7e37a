// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_FLIPPER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_FLIPPER_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// Decides about the edges of a patch.
//
// Where the tensors of the four vertices around an edge are multiples of one,
// the criterion of the triangulation does not depend on the order of insertion
// and decides; elsewhere the lower quality of the two faces does.
template <class Mesh>
class Patch_flipper
{
  typedef Mesh_patch<Mesh>               Patch;
  typedef typename Patch::Point          Point;
  typedef typename Patch::Vertex         Vertex;
  typedef typename Patch::Face           Face;
  typedef typename Patch::Rim_edge       Rim_edge;

public:
  explicit Patch_flipper(const Mesh& mesh) : m_mesh(mesh), m_band(mesh) {}

  // Flips edges until none is wanted, and returns whether it did one.
  bool operator()(Patch& patch) const
  {
    const int maximum = 2 * patch.number_of_faces(); // rounding errors might let them go on
    int flips = 0, before;
    do {
      before = flips;
      for(int f = 0; f < patch.number_of_faces(); ++f)
        for(int i = 0; i < 3; ++i)
          if(patch.faces()[f].is_used && patch.faces()[f].neighbor[i] > f && is_wanted(patch, f, i)) {
            patch.flip(f, i);
            ++flips;
          }
    } while(flips > before && flips < maximum);
    return flips > 0;
  }

  // whether what has changed within makes the criterion ask for no flip of an edge of the rim
  bool keeps_rim(const Patch& patch) const
  {
    for(const Rim_edge& e : patch.rim())
      if(e.beyond != typename Patch::Vertex_handle() && is_to_be_flipped(patch, e))
        return false;
    return true;
  }

private:
  static constexpr double least_rise = 1e-6; // of a quality, so that flips come to an end
  static constexpr double doubt = 0.8;       // about a quality in the tensor of other faces

  bool is_wanted(const Patch& patch, int f, int i) const
  {
    if(!patch.is_flippable(f, i))
      return false;
    const Face &face = patch.faces()[f], &other = patch.faces()[face.neighbor[i]];
    const int p = face.vertex[i], a = face.vertex[Patch::ccw(i)], b = face.vertex[Patch::cw(i)];
    const int q = patch.opposite(f, i);
    const auto& v = patch.vertices();
    if(are_multiples(v[p], v[a], v[b], v[q]))
      return is_in_conflict(v[p], v[a], v[b], v[q]);
    const double least = (std::min)(face.shape.quality, other.shape.quality) + least_rise;
    return looks_better(patch, f, i, least)
        && (std::min)(patch.shape(p, a, q).quality, patch.shape(q, b, p).quality) > least
        && (m_band.permits(v[p], v[q]) || !m_band.permits(v[a], v[b]));
  }

  // whether a flip might lead to a quality of `least`, by the tensors of the two faces as they are
  static bool looks_better(const Patch& patch, int f, int i, double least)
  {
    const Face &face = patch.faces()[f], &other = patch.faces()[face.neighbor[i]];
    const Symmetric_form m = 0.5 * (face.shape.metric + other.shape.metric);
    const auto point = [&](int w) -> const Point& { return patch.vertices()[w].point; };
    const Point &p = point(face.vertex[i]), &q = point(patch.opposite(f, i));
    const Point &a = point(face.vertex[Patch::ccw(i)]), &b = point(face.vertex[Patch::cw(i)]);
    return (std::min)(metric_quality(p, a, q, m), metric_quality(q, b, p, m)) > doubt * least;
  }

  bool is_to_be_flipped(const Patch& patch, const Rim_edge& e) const
  {
    const std::array<int, 2> inside = patch.rim_edge(e.source, e.target);
    const Vertex &p = patch.vertices()[patch.faces()[inside[0]].vertex[inside[1]]], q(e.beyond);
    const Vertex &a = patch.vertices()[e.source], &b = patch.vertices()[e.target];
    return are_multiples(p, a, b, q) && is_in_conflict(p, a, b, q)
        && m_mesh.orientation(p.point, a.point, q.point) == LEFT_TURN
        && m_mesh.orientation(q.point, b.point, p.point) == LEFT_TURN;
  }

  static bool are_multiples(const Vertex& p, const Vertex& a, const Vertex& b, const Vertex& q)
  {
    return is_multiple_of(a.tensor, p.tensor) && is_multiple_of(b.tensor, p.tensor)
        && is_multiple_of(q.tensor, p.tensor);
  }

  bool is_in_conflict(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return m_mesh.geom_traits().side_of_metric_circle_2_object()
             (a.point, b.point, c.point, p.point, a.tensor, b.tensor, c.tensor, p.tensor) == ON_POSITIVE_SIDE;
  }

  const Mesh& m_mesh;
  const Unit_band<Mesh> m_band;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_FLIPPER_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_OPTIMIZER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_OPTIMIZER_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_flipper.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_relaxation.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// Looks for a better patch in the place of a given one, whose first face is
// badly shaped.
//
// What is tried, with a relaxation each: nothing else; to remove a vertex of
// that face; to insert one on its edges or in its middle. Better is what has
// clearly less penalty, no lower least quality, and no more edges out of the
// unit band.
template <class Mesh>
class Patch_optimizer
{
  typedef Mesh_patch<Mesh>         Patch;
  typedef typename Patch::Point    Point;

public:
  // A patch whose least quality reaches `target` is not bettered further.
  Patch_optimizer(const Mesh& mesh, const Patch& start, double target)
    : m_start(start), m_target(target), m_relax(mesh), m_flipper(mesh), m_band(mesh), m_best(start),
      m_least_permitted(std::min(target, start.least_quality())),
      m_edges_permitted(m_band.edges_outside(start)),
      m_goal(m_relax.penalty(start) - margin)
  {}

  // Returns whether something better was found.
  bool operator()()
  {
    try_relaxation(m_target + 0.01); // leaves other vertices at their mass centres
    if(!is_good())
      try_relaxation(1);
    if(!is_good()) {
      try_removals();
      try_insertions();
    }
    return m_is_better;
  }

  const Patch& best() const { return m_best; }

private:
  static constexpr double margin = 0.05; // of penalty, so that improvements come to an end

  bool is_good() const { return m_is_better && m_best.least_quality() >= m_target; }

  // Vertices that have no face of less quality than `threshold` stay where they are.
  void try_relaxation(double threshold)
  {
    Patch patch = m_start;
    consider(patch, threshold);
  }

  void try_removals()
  {
    for(int v : m_start.faces()[0].vertex)
      if(m_start.is_free(v)) {
        Patch patch = m_start;
        if(remove(patch, v))
          consider(patch, 1);
      }
  }

  void try_insertions()
  {
    const std::array<int, 3>& v = m_start.faces()[0].vertex;
    const auto point = [&](int i) -> const Point& { return m_start.vertices()[v[i]].point; };
    for(int i = 0; i < 3; ++i)
      if(m_start.faces()[0].neighbor[i] != Patch::none) {
        Patch patch = m_start;
        const Point &a = point(Patch::ccw(i)), &b = point(Patch::cw(i));
        patch.split(0, Point((a.x() + b.x()) / 2, (a.y() + b.y()) / 2));
        patch.flip(i == 0 ? 0 : m_start.number_of_faces() + i - 1, 0); // the flat one of the three new faces
        consider(patch, 1);
      }
    Patch patch = m_start;
    patch.split(0, Point((point(0).x() + point(1).x() + point(2).x()) / 3,
                         (point(0).y() + point(1).y() + point(2).y()) / 3));
    consider(patch, 1);
  }

  void consider(Patch& patch, double threshold)
  {
    if(!m_relax(patch, threshold, m_goal))
      return;
    const double penalty = m_relax.penalty(patch);
    if(penalty < m_goal && patch.least_quality() >= m_least_permitted && m_flipper.keeps_rim(patch)
       && m_band.edges_outside(patch) <= m_edges_permitted) {
      m_goal = penalty - margin;
      m_is_better = true;
      std::swap(m_best, patch);
    }
  }

  // Cuts the vertex off by flips, the best new faces first.
  static bool remove(Patch& patch, int v)
  {
    while(patch.degree(v) > 3) {
      double best = 0;
      int best_face = Patch::none, best_edge = 0;
      patch.for_each_face_at(v, [&](int f, int i) {
        const int e = Patch::ccw(i); // the edge from the vertex after next to v
        const double q = patch.is_flippable(f, e) ? quality_cut_off(patch, f, e) : 0;
        if(q > best) {
          best = q;
          best_face = f;
          best_edge = e;
        }
      });
      if(best_face == Patch::none)
        return false;
      patch.flip(best_face, best_edge);
    }
    patch.unite(v);
    return true;
  }

  // the quality of the face that no longer has the vertex cw(cw(e)) after the flip of an edge that ends there
  static double quality_cut_off(const Patch& patch, int f, int e)
  {
    const std::array<int, 3>& v = patch.faces()[f].vertex;
    return patch.shape(v[e], v[Patch::ccw(e)], patch.opposite(f, e)).quality;
  }

  const Patch&                 m_start;
  const double                 m_target;
  const Patch_relaxation<Mesh> m_relax;
  const Patch_flipper<Mesh>    m_flipper;
  const Unit_band<Mesh>        m_band;
  Patch  m_best;
  double m_least_permitted;
  int    m_edges_permitted;
  double m_goal;
  bool   m_is_better = false;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_OPTIMIZER_H

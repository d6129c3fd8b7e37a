// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_IMPROVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_IMPROVER_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Edge_swapper.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Vertex_smoother.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/collapse.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/split.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Tries operations at the first face of a patch, each on a copy and followed by
// swaps and moves.
//
// `accept(copy)` decides whether a copy is better than those before. It is asked
// only if swaps and moves come near to `accept.cost_limit()`, and no operation
// is needed any more once it `is_satisfied()`.
template <class Patch, class Acceptance>
class Patch_improver
{
public:
  Patch_improver(const Patch& start, Acceptance& accept, bool may_collapse)
    : m_start(start), m_accept(accept), m_may_collapse(may_collapse)
  {}

  // Returns the last copy that was accepted, or none. The first attempt moves
  // only vertices that have a face of less quality than `threshold`.
  std::unique_ptr<Patch> operator()(double threshold)
  {
    const auto nothing = [](Patch&) { return true; };
    attempt(nothing, threshold);
    if(!m_accept.is_satisfied())
      attempt(nothing, 1);
    const int n = m_accept.is_satisfied() ? 0 : 3; // all of these, for the best
    for(int i = 0; i < n && m_may_collapse; ++i)
      attempt([i](Patch& p) { return collapse(p, p.first_face()->vertex(i)); }, 1);
    for(int i = 0; i < n; ++i)
      attempt([i](Patch& p) { return is_long(p, i) && split_edge(p, {p.first_face(), i}); }, 1);
    if(n > 0)
      attempt([](Patch& p) { return split_face(p, p.first_face()); }, 1);
    return std::move(m_best);
  }

private:
  static constexpr int    maximum_of_sweeps = 5;
  static constexpr double within_reach = 3; // sweeps seldom lower the cost by more

  static bool is_long(const Patch& p, int i)
  {
    const auto f = p.first_face();
    return Unit_band<Patch>::length(p, *f->vertex(Patch::Tds::ccw(i)), *f->vertex(Patch::Tds::cw(i)), 1) >= 1;
  }

  // An operation returns whether it could be done.
  template <class Operation>
  void attempt(const Operation& operation, double threshold)
  {
    auto patch = std::make_unique<Patch>(m_start);
    if(operation(*patch) && relax(*patch, threshold) && m_accept(*patch))
      m_best = std::move(patch);
  }

  // Swaps and moves in turn. Gives up, and returns false, as soon as it does not
  // look as if the limit was within reach: each sweep brings less than the one before.
  bool relax(Patch& patch, double threshold) const
  {
    m_swap(patch);
    std::vector<bool> moved(patch.mesh_vertices().size(), true);
    double before = m_accept.cost(patch);
    if(before > within_reach * m_accept.cost_limit())
      return false;
    for(int i = 0; i < maximum_of_sweeps; ++i) {
      moved = m_smooth(patch, threshold, moved);
      if(m_swap(patch))
        moved.assign(moved.size(), true);
      else if(std::find(moved.begin(), moved.end(), true) == moved.end())
        break;
      const double after = m_accept.cost(patch);
      if(after - m_accept.cost_limit() > before - after)
        return false;
      before = after;
    }
    return true;
  }

  const Patch&                  m_start;
  Acceptance&                   m_accept;
  const bool                    m_may_collapse;
  const Edge_swapper<Patch>     m_swap = {};
  const Vertex_smoother<Patch>  m_smooth = {};
  std::unique_ptr<Patch>        m_best;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_IMPROVER_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_ACCEPTANCE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_ACCEPTANCE_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Edge_swapper.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>

#include <algorithm>
#include <limits>

namespace CGAL::Anisotropic_mesh_2::internal {

// Accepts a patch in the place of another one if it has clearly less penalty
// than any accepted before, no lower least quality unless it reaches a target,
// no more edges out of the unit band, and if the criterion of the triangulation
// wants no flip on its border.
template <class Patch>
class Quality_acceptance
{
  typedef typename Patch::Face_handle   Face_handle;
  typedef typename Patch::Edge          Edge;

public:
  Quality_acceptance(const Patch& start, double target)
    : m_target(target), m_quality_permitted((std::min)(target, least_quality(start))),
      m_edges_permitted(edges_outside(start, 1)),
      m_penalty_limit(cost(start) - margin)
  {}

  bool operator()(const Patch& patch)
  {
    const double penalty = cost(patch), quality = least_quality(patch);
    if(!(penalty < m_penalty_limit && quality >= m_quality_permitted && m_swapper.keeps_border(patch)
         && edges_outside(patch, patch.uses_field() ? 1 : error_of_samples) <= m_edges_permitted))
      return false;
    m_penalty_limit = penalty - margin;
    m_is_satisfied = quality >= m_target;
    return true;
  }

  // whether a patch has been accepted than which no better one is needed
  bool is_satisfied() const { return m_is_satisfied; }

  // the sum of penalties that operations are to lower, and the one under which a patch may be accepted
  static double cost(const Patch& patch)
  {
    double sum = 0;
    patch.for_each_face([&](Face_handle f) { sum += quality_penalty(f->info().quality); });
    return sum;
  }
  double cost_limit() const { return m_penalty_limit; }

private:
  static constexpr double margin = 0.05; // of penalty, so that improvements come to an end
  static constexpr double error_of_samples = 1.015; // of lengths, as a factor

  static double least_quality(const Patch& patch)
  {
    double least = std::numeric_limits<double>::infinity();
    patch.for_each_face([&](Face_handle f) { least = (std::min)(least, f->info().quality); });
    return least;
  }

  // those on the border aside
  static int edges_outside(const Patch& patch, double margin)
  {
    int n = 0;
    patch.for_each_edge([&](const Edge& e) {
      const auto v = patch.quadrilateral(e);
      n += !Unit_band<Patch>::contains(patch, *v[1], *v[3], margin);
    });
    return n;
  }

  const Edge_swapper<Patch> m_swapper = {};
  const double              m_target, m_quality_permitted;
  const int                 m_edges_permitted;
  double                    m_penalty_limit;
  bool                      m_is_satisfied = false;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_QUALITY_ACCEPTANCE_H

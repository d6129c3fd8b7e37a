// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_OPTIMIZATION_STATE_H
#define CGAL_ANISOTROPIC_MESH_2_OPTIMIZATION_STATE_H

#include <cstddef>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// what an optimizer reports to its visitor before the first iteration and after every one.
///
/// The number `displacement` is the `D` of section 4 of \cgalCite{dw-acvt-05}.
struct Optimization_state
{
  std::size_t iteration = 0;    ///< how many iterations are done
  std::size_t evaluations = 0;  ///< how many times the energy was evaluated
  double energy = 0;            ///< of the tessellation of the present vertices, in the measure of the optimizer
  double largest_move = 0;      ///< the largest metric length of a Lloyd move, from a vertex to its mass centre
  double displacement = 0;      ///< the sum of the squared Euclidean lengths of the Lloyd moves
  double seconds = 0;           ///< real time since the start of the optimizer
};

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the visitor that optimizers use unless another one is given: it lets them run.
struct Default_optimization_visitor
{
  /// is called before the first iteration and after every one; returning `false` stops the optimizer.
  bool iteration(const Optimization_state&) const { return true; }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_OPTIMIZATION_STATE_H

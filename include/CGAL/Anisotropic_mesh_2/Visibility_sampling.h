// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VISIBILITY_SAMPLING_H
#define CGAL_ANISOTROPIC_MESH_2_VISIBILITY_SAMPLING_H

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how finely visibility regions are sampled and integrated (sections 4.1 and
/// 4.2 of \cgalCite{dw-acvt-05}).
///
/// Around a generator \f$ P \f$, poly-segments \f$ P Q_j C_i \f$ are followed:
/// the \f$ Q_j \f$ divide the edge opposite to \f$ P \f$ in the `i`-th face at
/// \f$ P \f$, and \f$ C_i \f$ is the vertex beyond that edge. All numbers are at least 1.
struct Visibility_sampling
{
  /// \f$ N_D \f$, the number of parts of each edge opposite to the generator.
  int subdivisions_of_edges = 10;
  /// \f$ M_D \f$, the number of parts of each poly-segment.
  int steps = 10;
  /// whether poly-segments end in the middle between \f$ P \f$ and \f$ C_i \f$, or in
  /// \f$ Q_j \f$ where that is not beyond the edge. Bisectors pass through
  /// midpoints (lemma 2.1 of \cgalCite{dw-acvt-05}).
  bool shrinks_testing_region = false;
  /// whether the point where another vertex becomes nearer is searched for between
  /// two steps; else it is the first step where one is nearer, as in the paper.
  bool refines_crossings = true;
  /// \f$ m_i \f$, the number of parts into which each triangle of the region is
  /// divided along the radius to be integrated.
  int parts_of_radius = 4;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VISIBILITY_SAMPLING_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_WEIGHTS_OF_FIVE_NODES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_WEIGHTS_OF_FIVE_NODES_H

namespace CGAL::Anisotropic_mesh_2::internal {

// weights_of_five_nodes[k][i][j]: the weight of node j in the derivative of order k, at node i, of the
// polynomial through five nodes of distance h; for k > 0 to be divided by 12 h^k.
inline constexpr double weights_of_five_nodes[3][5][5] = {
  { {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1} },
  { {-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}, {-1, 6, -18, 10, 3}, {3, -16, 36, -48, 25} },
  { {35, -104, 114, -56, 11}, {11, -20, 6, 4, -1}, {-1, 16, -30, 16, -1}, {-1, 4, 6, -20, 11},
    {11, -56, 114, -104, 35} } };

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_WEIGHTS_OF_FIVE_NODES_H

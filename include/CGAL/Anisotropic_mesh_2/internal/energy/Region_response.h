// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_REGION_RESPONSE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_REGION_RESPONSE_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// What the integration over a part of the domain adds to a region: its moments
// and, with them, how it responds to moves of its generator. A block of the
// Hessian of the energy is 2 a - response.
struct Region_contribution
{
  Region_moments moments;
  Symmetric_form response;

  Region_contribution& operator+=(const Region_contribution& s)
  {
    moments += s.moments;
    response += s.response;
    return *this;
  }
};

// The mixed blocks of the Hessian for the three edges of a face, by the opposite
// corner k: rows belong to the corner k + 1, columns to the corner k + 2.
struct Face_couplings
{
  struct Block { double xx = 0, xy = 0, yx = 0, yy = 0; };
  std::array<Block, 3> block;

  // adds the block between the corners i and j; k is the third one
  void add(int i, int k, const Block& b)
  {
    Block& sum = block[k];
    const bool is_transposed = i != (k + 1) % 3;
    sum.xx += b.xx;
    sum.xy += is_transposed ? b.yx : b.xy;
    sum.yx += is_transposed ? b.xy : b.yx;
    sum.yy += b.yy;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_REGION_RESPONSE_H

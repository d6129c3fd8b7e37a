// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PIECE_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PIECE_2_H

#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <cstddef>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

enum class Piece_role
{
  BOUNDARY,
  CONSTRAINT, // an inner curve
  OPEN_CHAIN, // edges of a graph on no cycle: an inner curve if inside, else a boundary that is open
  UNDECIDED     // inside a divided cycle, or two boundary pieces in one place: an inner curve if inside, else nothing
};

template <class K>
struct Domain_piece_2
{
  Curve_piece_2<K> curve;
  Piece_role       role;
  std::size_t      number; // for messages, counted from 1; 0 for none
};

template <class K>
std::string describe(const Domain_piece_2<K>& piece)
{
  const std::string kind = piece.curve.is_straight() ? "segment" : "curve";
  const std::string name = piece.number > 0 ? kind + " " + std::to_string(piece.number) : "the " + kind;
  return name + " from " + describe(piece.curve.source()) + " to " + describe(piece.curve.target());
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_DOMAIN_PIECE_2_H

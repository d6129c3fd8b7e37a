// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVISION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVISION_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A point with its nearest generator; points of bisectors have none.
struct Labelled_point
  : Metric_point
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t label = none;
};

// How a face is divided among the nearest generators of its corners. Numbers
// of edges are those of the opposite corners.
struct Face_division
{
  // the inner points of a bisector, with the labels of its sides
  struct Curve
  {
    std::size_t left, right;
    Vectors     points;
  };

  std::array<const Labelled_point*, 3> corner;
  std::array<Metric_point, 3>          crossing; // of the bisector with an edge whose ends have different labels
  Metric_point                         centre;   // where three bisectors meet, if there are three labels
  std::vector<Curve>                   curves;   // from one crossing to the other, or from crossings to the centre

  std::size_t label(int k) const { return corner[k]->label; }
  bool is_crossed(int k) const { return label((k + 1) % 3) != label((k + 2) % 3); }
  int number_of_labels() const
  {
    const int crossed = is_crossed(0) + is_crossed(1) + is_crossed(2);
    return crossed == 0 ? 1 : crossed;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_FACE_DIVISION_H

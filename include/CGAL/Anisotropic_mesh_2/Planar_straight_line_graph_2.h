// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H
#define CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// vertices and straight edges as files hold them, before anything is known
/// of inside and outside.
///
/// Indices start at 0. `point_references` is empty or as long as `points`,
/// `triangle_references` is empty or as long as `triangles`.
///
/// \tparam K a model of `Kernel`
template <class K>
struct Planar_straight_line_graph_2
{
  typedef typename K::Point_2 Point_2; ///< a point

  /// a straight edge between two points.
  struct Edge
  {
    std::size_t source;    ///< the index of a point
    std::size_t target;    ///< the index of another point
    int         reference; ///< any number
  };

  /// a point inside a subdomain, and the reference of that subdomain.
  struct Region
  {
    Point_2 seed;      ///< the point
    int     reference; ///< any number
  };

  std::vector<Point_2>                    points;              ///< the vertices
  std::vector<int>                        point_references;    ///< any numbers, one for each point, or none
  std::vector<Edge>                       edges;               ///< the edges
  std::vector<Point_2>                    holes;               ///< a seed in each hole
  std::vector<Region>                     regions;             ///< the subdomains that have a reference
  std::vector<std::array<std::size_t, 3>> triangles;           ///< indices of points; may be empty
  std::vector<int>                        triangle_references; ///< any numbers, one for each triangle, or none
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H

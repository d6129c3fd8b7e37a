// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H
#define CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H

#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

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
  typedef typename K::Point_2 Point_2;

  /// a straight edge between two points.
  struct Edge
  {
    std::size_t source;
    std::size_t target;
    int         reference;
  };

  /// a point inside a subdomain, and the reference of that subdomain.
  struct Region
  {
    Point_2 seed;
    int     reference;
  };

  std::vector<Point_2>                    points;
  std::vector<int>                        point_references;
  std::vector<Edge>                       edges;
  std::vector<Point_2>                    holes;               ///< a seed in each hole
  std::vector<Region>                     regions;
  std::vector<std::array<std::size_t, 3>> triangles;           ///< may be empty
  std::vector<int>                        triangle_references;
};

} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_PLANAR_STRAIGHT_LINE_GRAPH_2_H

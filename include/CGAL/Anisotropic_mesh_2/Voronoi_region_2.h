// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VORONOI_REGION_2_H
#define CGAL_ANISOTROPIC_MESH_2_VORONOI_REGION_2_H

#include <CGAL/Anisotropic_mesh_2/Voronoi_piece_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the region of a generator, within the domain (definition 2.2 of \cgalCite{dw-acvt-05}).
///
/// \tparam K a class with the type `Point_2`, for example a kernel of \cgal
/// \tparam Vertex_handle_ a handle to vertices of the mesh
template <class K, class Vertex_handle_>
struct Voronoi_region_2
{
  typedef typename K::Point_2       Point_2;       ///< a point
  typedef Vertex_handle_            Vertex_handle; ///< a vertex of the mesh
  typedef std::array<Point_2, 3>    Tile;          ///< the corners of a triangle

  Vertex_handle                     vertex;            ///< the generator in the mesh
  Point_2                           generator;         ///< its position
  bool                              is_fixed = false;  ///< whether the generator is a fixed vertex of the mesh
  double                            area = 0;          ///< the Euclidean area of all pieces
  std::vector<Voronoi_piece_2<K> >  pieces;            ///< the main ones first
  /// triangles that make up the region, counterclockwise; next to bisectors
  /// that turn sharply a few of them may be clockwise, and count as negative.
  std::vector<Tile>                 tiles;

  /// the number of pieces that do not contain the generator.
  std::size_t number_of_orphans() const
  {
    std::size_t n = 0;
    for(const Voronoi_piece_2<K>& p : pieces)
      n += !p.is_main;
    return n;
  }
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VORONOI_REGION_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_SURFACE_VORONOI_REGIONS_3_H
#define CGAL_ANISOTROPIC_SURFACE_VORONOI_REGIONS_3_H

#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Anisotropic_mesh_2/Surface_voronoi_region_3.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_cover.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the anisotropic Voronoi regions of the vertices of a mesh of a surface, on the
/// surface, in the order of the vertices (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// Each region is taken from the `Anisotropic_Voronoi_diagram_2` of a chart in
/// which its generator is far from where the chart is cut. The cost is that of
/// one diagram for each of the up to four charts.
///
/// \tparam ConcurrencyTag as for `Anisotropic_Voronoi_diagram_2`.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \param mesh the mesh.
/// \param tolerance as for `Anisotropic_Voronoi_diagram_2`, whose default is finer.
/// \return the region of each vertex, the `i`-th one that of the vertex `i`; empty if no chart holds it, as at the
/// sides of a seam that is not glued, since the domain goes once around.
/// \pre `tolerance` lies between 10<sup>-9</sup> and 0.1.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface.
template <class ConcurrencyTag = Sequential_tag, class Field>
std::vector<Anisotropic_mesh_2::Surface_voronoi_region_3<typename Field::Surface::Kernel> >
anisotropic_surface_Voronoi_regions_3(const Anisotropic_surface_mesh_3<Field>& mesh, double tolerance = 1e-3)
{
  namespace internal = Anisotropic_mesh_2::internal;
  typedef internal::Chart_mesh<Field>                                                       Part_mesh;
  typedef Anisotropic_mesh_2::Surface_voronoi_region_3<typename Field::Surface::Kernel>     Region;
  typedef typename Region::Point_3                                                          Point_3;
  typedef typename Field::Surface::Kernel::Point_2                                          Point_2;

  const internal::Surface_atlas<Field> atlas(mesh.field());
  const internal::Surface_cover<Field> cover(mesh, atlas);
  std::vector<Region> regions(mesh.number_of_vertices());
  for(std::size_t k = 0; k < atlas.parts.size(); ++k) {
    Part_mesh part(mesh, atlas.parts[k]);
    if(part.faces().empty() || !part.copy_faces())
      continue;
    const auto on_surface = [&](const Point_2& x) -> Point_3 {
      const internal::Vector_of_doubles p = atlas.parts[k].chart.parameters(internal::to_doubles(x));
      return mesh.field().surface().point(internal::point_at<Point_2>(p.x, p.y));
    };
    typedef Anisotropic_mesh_2::Directional_distance_2 Distance;
    const Anisotropic_Voronoi_diagram_2<typename Part_mesh::Mesh, Distance, ConcurrencyTag>
      diagram(part.mesh(), Distance(), tolerance);
    for(const auto& r : diagram.regions()) {
      const std::size_t v = part.number(r.vertex);
      if(cover.part_of_vertex(v) != k)
        continue;
      for(const auto& piece : r.pieces)
        for(const std::vector<Point_2>& line : piece.boundaries) {
          regions[v].boundaries.emplace_back();
          for(const Point_2& x : line)
            regions[v].boundaries.back().push_back(on_surface(x));
        }
      for(const auto& t : r.tiles)
        regions[v].tiles.push_back({on_surface(t[0]), on_surface(t[1]), on_surface(t[2])});
    }
  }
  for(std::size_t v = 0; v < regions.size(); ++v)
    regions[v].vertex = v;
  return regions;
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_SURFACE_VORONOI_REGIONS_3_H

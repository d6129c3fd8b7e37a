// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_VISIBILITY_REGION_2_H
#define CGAL_ANISOTROPIC_VISIBILITY_REGION_2_H

#include <CGAL/Anisotropic_mesh_2/Visibility_sampling.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Visibility_region.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// approximates the part of the anisotropic Voronoi region of a vertex that can
/// be seen from it (section 4.1 of \cgalCite{dw-acvt-05}).
///
/// The region is searched for in the faces of the domain at the vertex and those
/// across their opposite edges; other generators than the vertices of these
/// faces are not looked at. The corners of the polygons are on the boundary of
/// the region unless `sampling.refines_crossings` is `false`; the corners of the
/// region itself are cut off, the less the more parts the edges have. Where the
/// angle of a face at the vertex is obtuse in the metric, the region may extend
/// beyond the opposite edge; of that part, only what the segments to the next
/// vertex sweep is found, however fine the sampling.
///
/// The time is proportional to the square of the degree of the vertex and to the number of samples.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param v a finite vertex of the mesh.
/// \param sampling how finely the region is sampled.
/// \return counterclockwise polygons: one around the vertex if the domain
/// surrounds it, else one for each run of faces of the domain at the vertex,
/// which begins with the vertex itself.
/// \pre `mesh.dimension() == 2`, and the numbers of `sampling` are at least 1.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class Mesh>
std::vector<std::vector<typename Mesh::Point> >
anisotropic_visibility_region_2(const Mesh& mesh, typename Mesh::Vertex_handle v,
                                const Anisotropic_mesh_2::Visibility_sampling& sampling
                                  = Anisotropic_mesh_2::Visibility_sampling())
{
  namespace internal = Anisotropic_mesh_2::internal;
  const internal::Visibility_region<Mesh> region(mesh, v, sampling);
  std::vector<std::vector<typename Mesh::Point> > polygons;
  for(const internal::Vectors& polygon : region.polygons()) {
    polygons.emplace_back();
    for(const internal::Vector_of_doubles& p : polygon)
      polygons.back().push_back(internal::point_at<typename Mesh::Point>(p.x, p.y));
  }
  return polygons;
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_VISIBILITY_REGION_2_H

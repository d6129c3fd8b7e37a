// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MASS_CENTRE_2_H
#define CGAL_ANISOTROPIC_MASS_CENTRE_2_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Visibility_sampling.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Visibility_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// the mass centre of the visibility region of a vertex, by the quadrature of
/// section 4.2 of \cgalCite{dw-acvt-05}; see `anisotropic_visibility_region_2()`.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param v a finite vertex of the mesh.
/// \param measure the measure by which it is integrated.
/// \param sampling how finely the region is sampled and integrated.
/// \return the mass centre, or the vertex itself if no face of the domain is incident to it.
/// \pre `mesh.dimension() == 2`, and the numbers of `sampling` are at least 1.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class Mesh>
typename Mesh::Point
anisotropic_mass_centre_2(const Mesh& mesh, typename Mesh::Vertex_handle v,
                          Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN,
                          const Anisotropic_mesh_2::Visibility_sampling& sampling
                            = Anisotropic_mesh_2::Visibility_sampling())
{
  namespace internal = Anisotropic_mesh_2::internal;
  internal::Region_moments moments;
  internal::Visibility_energy<Mesh>(mesh, measure, sampling).add_region(v, moments);
  const internal::Vector_of_doubles z = internal::to_doubles(v->point()), d = moments.lloyd_move();
  return internal::point_at<typename Mesh::Point>(z.x + d.x, z.y + d.y);
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MASS_CENTRE_2_H

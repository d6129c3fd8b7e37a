// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_ANISOTROPIC_SURFACE_MESH_3_H
#define CGAL_MAKE_ANISOTROPIC_SURFACE_MESH_3_H

#include <CGAL/Anisotropic_mesh_2/internal/surface/Closed_surface_mesher.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_chart.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/append_chart_faces.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/surface_domain.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/optimize_anisotropic_surface_mesh_3.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// generates an optimized mesh of a part of a parametric surface under a metric
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// The domain, in the plane of parameters, is meshed under the metric that the
/// surface induces there, by `make_anisotropic_mesh_2()` and `optimize_anisotropic_mesh_2()`.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`.
/// \tparam K the kernel of the surface.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param domain the domain, within the rectangle of the parameters; periodic
/// parameters are not glued.
/// \param field the surface and its metric.
/// \param np an optional sequence of named parameters, those of
/// `make_anisotropic_mesh_2()` and `optimize_anisotropic_mesh_2()`, with the same defaults
/// (see \ref AnisotropicMesh2NamedParameters)
///
/// \return the mesh.
/// \throw Anisotropic_mesh_2::Degenerate_parametrization_exception if the surface has no tangent plane at a point of
/// the domain.
/// \throw Anisotropic_mesh_2::Invalid_domain_exception if the domain or the rectangle of parameters is not valid.
/// \throw Anisotropic_mesh_2::Too_many_vertices_exception if the metric asks for more vertices than allowed.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface.
template <class ConcurrencyTag = Sequential_tag, class K, class Field, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_surface_mesh_3<Field>
make_anisotropic_surface_mesh_3(const Anisotropic_mesh_domain_2<K>& domain, const Field& field,
                              const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal = Anisotropic_mesh_2::internal;
  Anisotropic_surface_mesh_3<Field> surface_mesh(field);
  const auto r = field.surface().parameters();
  internal::check_parameters(r);
  const auto chart = internal::Surface_chart<Field>::window(surface_mesh.field(), r.u_min, r.v_min);
  auto mesh = make_anisotropic_mesh_2(domain, chart, np);
  optimize_anisotropic_mesh_2<ConcurrencyTag>(mesh, np);
  std::map<typename K::Point_2, std::size_t> numbers;
  std::vector<typename Anisotropic_surface_mesh_3<Field>::Face> faces;
  internal::append_chart_faces(mesh, chart, numbers, surface_mesh, faces);
  surface_mesh.replace_faces(std::move(faces));
  return surface_mesh;
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// generates an optimized mesh of a whole parametric surface under a metric
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// The mesh is that of the rectangle of parameters, or of the `domain()` of a surface that has one and no periodic
/// parameter, such as a `Anisotropic_mesh_2::Triangulated_surface_3`.
/// Where a parameter is periodic, the mesh is closed: the unit mesh of
/// the rectangle of parameters gets the same vertices on the sides that
/// coincide, and discs around the poles in polar coordinates. It is then optimized by
/// `optimize_anisotropic_surface_mesh_3()`, which may also be called on its own, for the sake of its result, if
/// `number_of_iterations(0)` is given here.
///
/// Of the named parameters for unit meshes, `point_placement` and `keep_boundary_points` have no effect on a
/// closed surface; for those of the optimizer see `optimize_anisotropic_surface_mesh_3()`.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param field the surface and its metric.
/// \param np an optional sequence of named parameters, those of the overload for a part of the surface
///
/// \return the mesh, which is closed where the parameters are.
/// \throw Anisotropic_mesh_2::Degenerate_parametrization_exception if the surface has no tangent plane at a point
/// other than a pole.
/// \throw Anisotropic_mesh_2::Too_many_vertices_exception if the metric asks for more vertices than allowed.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface.
/// \throw Anisotropic_mesh_2::Invalid_domain_exception if the rectangle of parameters is not valid, or if the sizes
/// are so large that somewhere fewer than three edges would lead around a closed surface.
template <class ConcurrencyTag = Sequential_tag, class Field, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_surface_mesh_3<Field>
make_anisotropic_surface_mesh_3(const Field& field, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;
  internal::check_parameters(field.surface().parameters());
  if(!field.surface().parameters().is_periodic())
    return make_anisotropic_surface_mesh_3<ConcurrencyTag>(internal::surface_domain(field.surface()), field, np);
  Anisotropic_surface_mesh_3<Field> surface_mesh(field);
  const std::size_t limit = choose_parameter<std::size_t>
    (get_parameter(np, internal::maximum_number_of_vertices_t()), 10000000);
  internal::Closed_surface_mesher<Field>{surface_mesh, limit}();
  if(choose_parameter<std::size_t>(get_parameter(np, internal_np::number_of_iterations), 1) > 0)
    optimize_anisotropic_surface_mesh_3<ConcurrencyTag>(surface_mesh, np);
  return surface_mesh;
}

} // namespace CGAL

#endif // CGAL_MAKE_ANISOTROPIC_SURFACE_MESH_3_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_ANISOTROPIC_MESH_2_H
#define CGAL_MAKE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/refine_anisotropic_mesh_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Boundary_unit_mesher.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>

namespace CGAL {
/// \ingroup PkgAnisotropicMesh2Functions
///
/// generates a unit mesh of a given type, which may have vertex and face bases or traits of the user:
/// `make_anisotropic_mesh_2<Mesh>(domain, traits)`.
///
/// Everything else is as for the overload that takes a metric field.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`, which must be given.
/// \tparam K the kernel of the domain and the mesh.
/// \tparam NamedParameters a sequence of named parameters
/// \param domain the domain.
/// \param traits the traits of the mesh, with the metric field.
/// \param np an optional sequence of named parameters, those of the other overload
///
/// \return the mesh.
/// \throw Anisotropic_mesh_2::Invalid_domain_exception if the domain is not valid; the message names the place.
/// \throw Anisotropic_mesh_2::Too_many_vertices_exception if the metric asks for more vertices than allowed.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class Mesh, class K, class CGAL_NP_TEMPLATE_PARAMETERS>
Mesh make_anisotropic_mesh_2(const Anisotropic_mesh_domain_2<K>& domain, const typename Mesh::Geom_traits& traits,
                             const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace internal = Anisotropic_mesh_2::internal;

  const bool keep_points = choose_parameter(get_parameter(np, internal::keep_boundary_points_t()), false);

  Mesh mesh(traits);
  mesh.insert_boundary(internal::unit_boundary_graph(domain, traits.construct_metric_tensor_2_object(),
                                                     internal::vertex_limit(np), keep_points));
  if(mesh.number_of_faces_in_domain() == 0)
    throw Anisotropic_mesh_2::Invalid_domain_exception("the boundary of the domain encloses no area");
  internal::fill_with_field_points(mesh, np);
  return mesh;
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// generates a unit mesh of a planar domain under a metric field (section 3.2
/// of \cgalCite{dw-acvt-05}).
///
/// The curves of the boundary and the inner curves are divided into parts
/// of equal Riemannian length close to 1, their end points kept. Parts of curves are divided further until none is
/// farther from its chord than a quarter of the unit, in the metric of the curve. Of these edges the empty mesh is
/// built, and `refine_anisotropic_mesh_2()` fills it.
/// The result is what `optimize_anisotropic_mesh_2()` starts from.
///
/// The time is that of `Anisotropic_mesh_domain_2::validate()` and linear in the number of vertices. The field is
/// evaluated about 18 times per vertex if the metric is mild, and 2500 times besides; up to 170 times per vertex have
/// been counted where it jumps from cell to cell or turns by a right angle within an element.
///
/// \tparam K a model of `Kernel`, for example `Exact_predicates_inexact_constructions_kernel`.
/// \tparam MetricField a model of `MetricField_2`, for example a lambda from
/// `K::Point_2` to `Metric_tensor_2<K>`.
/// \tparam NamedParameters a sequence of named parameters
/// \param domain the domain.
/// \param field the metric field, defined on the domain.
/// \param np an optional sequence of named parameters, those of
/// `refine_anisotropic_mesh_2()` and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{keep_boundary_points}
///     \cgalParamDescription{whether straight pieces of the boundary are taken as edges of the mesh as they are}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Anisotropic_mesh_2::Invalid_domain_exception if the domain is not valid; the message names the place.
/// \throw Anisotropic_mesh_2::Too_many_vertices_exception if the metric asks for more vertices than allowed.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
/// \return the mesh, of the same type for all fields: `Anisotropic_Delaunay_mesh_2<Riemannian_metric_traits_2<K> >`.
template <class MetricField, class K, class CGAL_NP_TEMPLATE_PARAMETERS>
Anisotropic_Delaunay_mesh_2<Riemannian_metric_traits_2<K> >
make_anisotropic_mesh_2(const Anisotropic_mesh_domain_2<K>& domain, const MetricField& field,
                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef Riemannian_metric_traits_2<K> Traits;
  return make_anisotropic_mesh_2<Anisotropic_Delaunay_mesh_2<Traits> >(domain, Traits(field), np);
}

} // namespace CGAL

#endif // CGAL_MAKE_ANISOTROPIC_MESH_2_H

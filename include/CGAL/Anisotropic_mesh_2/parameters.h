// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H

#include <CGAL/Anisotropic_mesh_2/internal/base/compatibility.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Anisotropic_mesh_2 {
namespace internal {

struct maximum_number_of_vertices_t {};
struct keep_boundary_points_t {};
struct point_placement_t {};
struct energy_reduction_t {};
struct measure_t {};
struct region_evaluation_t {};
struct topological_moves_t {};

} // namespace internal

/// \ingroup PkgAnisotropicMesh2Ref
///
/// the named parameters of this package that \cgal does not have. Each begins a
/// chain, `p::measure(m).number_of_iterations(50)`, or continues one,
/// `p::measure(m, p::convergence(1e-4))`. The names that \cgal has as well
/// (`number_of_iterations`, `maximum_running_time`, `visitor`) may follow a dot. What they mean, and their defaults:
/// \ref AnisotropicMesh2NamedParameters.
namespace parameters {

/// what a function for a named parameter returns: a list of parameters that begins with it.
template <class Value, class Tag>
using Parameter = Named_function_parameters<Value, Tag>;
/// the same before another list.
template <class Value, class Tag, class T, class OtherTag, class Base>
using Chained_parameter = Named_function_parameters<Value, Tag, Named_function_parameters<T, OtherTag, Base> >;

/// the largest metric length of a Lloyd move at which an optimizer stops.
template <class Value>
Parameter<Value, internal::convergence_t> convergence(const Value& v)
{ return Parameter<Value, internal::convergence_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::convergence_t, T, Tag, Base>
convergence(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::convergence_t, T, Tag, Base>(v, np); }

/// the share of the energy by which ten iterations must lower it, so that the optimizer goes on.
template <class Value>
Parameter<Value, internal::energy_reduction_t> energy_reduction(const Value& v)
{ return Parameter<Value, internal::energy_reduction_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::energy_reduction_t, T, Tag, Base>
energy_reduction(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::energy_reduction_t, T, Tag, Base>(v, np); }

/// the `CGAL::Anisotropic_mesh_2::Measure` of energies and mass centres.
template <class Value>
Parameter<Value, internal::measure_t> measure(const Value& v)
{ return Parameter<Value, internal::measure_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::measure_t, T, Tag, Base>
measure(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::measure_t, T, Tag, Base>(v, np); }

/// the number of vertices that a mesh generator must not exceed.
template <class Value>
Parameter<Value, internal::maximum_number_of_vertices_t> maximum_number_of_vertices(const Value& v)
{ return Parameter<Value, internal::maximum_number_of_vertices_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::maximum_number_of_vertices_t, T, Tag, Base>
maximum_number_of_vertices(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::maximum_number_of_vertices_t, T, Tag, Base>(v, np); }

/// whether straight pieces of the boundary are taken as they are instead of being subdivided.
template <class Value>
Parameter<Value, internal::keep_boundary_points_t> keep_boundary_points(const Value& v)
{ return Parameter<Value, internal::keep_boundary_points_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::keep_boundary_points_t, T, Tag, Base>
keep_boundary_points(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::keep_boundary_points_t, T, Tag, Base>(v, np); }

/// the `CGAL::Anisotropic_mesh_2::Point_placement` of unit meshing.
template <class Value>
Parameter<Value, internal::point_placement_t> point_placement(const Value& v)
{ return Parameter<Value, internal::point_placement_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::point_placement_t, T, Tag, Base>
point_placement(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::point_placement_t, T, Tag, Base>(v, np); }

/// the `CGAL::Anisotropic_mesh_2::Region_evaluation` of an optimizer.
template <class Value>
Parameter<Value, internal::region_evaluation_t> region_evaluation(const Value& v)
{ return Parameter<Value, internal::region_evaluation_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::region_evaluation_t, T, Tag, Base>
region_evaluation(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::region_evaluation_t, T, Tag, Base>(v, np); }

/// whether an optimizer improves faces of low quality at the end, also by insertions and removals.
template <class Value>
Parameter<Value, internal::topological_moves_t> topological_moves(const Value& v)
{ return Parameter<Value, internal::topological_moves_t>(v); }
/// the same, before the parameters `np`.
template <class Value, class T, class Tag, class Base>
Chained_parameter<Value, internal::topological_moves_t, T, Tag, Base>
topological_moves(const Value& v, const Named_function_parameters<T, Tag, Base>& np)
{ return Chained_parameter<Value, internal::topological_moves_t, T, Tag, Base>(v, np); }

} // namespace parameters
} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H

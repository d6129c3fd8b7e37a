// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H
#define CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Anisotropic_mesh_2/internal/base/compatibility.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Anisotropic_mesh_2 {
namespace internal {

struct energy_reduction_t {};
struct keep_boundary_points_t {};
struct maximum_number_of_vertices_t {};
struct measure_t {};
struct method_t {};
struct point_placement_t {};
struct quality_moves_t {};
struct refinement_result_t {};
struct region_evaluation_t {};

// A list of named parameters that any of the names below may continue. For functions it is a list of CGAL.
template <class T, class Tag, class Base = internal_np::No_property>
class Parameter_list
  : public Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base> List;

  template <class Next_tag, class V>
  Parameter_list<V, Next_tag, List> with(const V& value) const
  { return Parameter_list<V, Next_tag, List>(value, *this); }

public:
  using List::List;

  template <class V> auto convergence(const V& value) const { return with<convergence_t>(value); }
  template <class V> auto energy_reduction(const V& value) const { return with<energy_reduction_t>(value); }
  template <class V> auto keep_boundary_points(const V& value) const { return with<keep_boundary_points_t>(value); }
  template <class V> auto maximum_number_of_vertices(const V& value) const
  { return with<maximum_number_of_vertices_t>(value); }
  template <class V> auto measure(const V& value) const { return with<measure_t>(value); }
  template <class V> auto method(const V& value) const { return with<method_t>(value); }
  template <class V> auto point_placement(const V& value) const { return with<point_placement_t>(value); }
  template <class V> auto quality_moves(const V& value) const { return with<quality_moves_t>(value); }
  template <class V> auto refinement_result(const V& value) const { return with<refinement_result_t>(value); }
  template <class V> auto region_evaluation(const V& value) const { return with<region_evaluation_t>(value); }

  // names of CGAL, whose members would return a list that the names above cannot continue
  template <class V> auto maximum_running_time(const V& value) const
  { return with<internal_np::maximum_running_time_t>(value); }
  template <class V> auto number_of_iterations(const V& value) const
  { return with<internal_np::number_of_iterations_t>(value); }
  template <class V> auto vertex_is_constrained_map(const V& value) const
  { return with<internal_np::vertex_is_constrained_t>(value); }
  template <class V> auto visitor(const V& value) const { return with<internal_np::visitor_t>(value); }
};

template <class Tag>
struct Parameter_name
{
  template <class V>
  Parameter_list<V, Tag> operator()(const V& value) const { return Parameter_list<V, Tag>(value); }

  template <class V, class T, class Other_tag, class Base>
  Parameter_list<V, Tag, Named_function_parameters<T, Other_tag, Base> >
  operator()(const V& value, const Named_function_parameters<T, Other_tag, Base>& np) const
  { return Parameter_list<V, Tag, Named_function_parameters<T, Other_tag, Base> >(value, np); }
};

} // namespace internal

/// \ingroup PkgAnisotropicMesh2Ref
///
/// the named parameters of this package, with those of \cgal that it takes. Each is called with its value and begins a
/// list, `p::measure(m)`, or continues one after a dot, `p::number_of_iterations(50).measure(m)`, in any order. A list
/// that a name of `CGAL::parameters` has begun is given as second argument:
/// `p::measure(m, CGAL::parameters::number_of_iterations(50))`. What they mean, and their defaults:
/// \ref AnisotropicMesh2NamedParameters.
namespace parameters {

/// the largest metric length of a Lloyd move at which an optimizer stops.
inline constexpr internal::Parameter_name<internal::convergence_t> convergence{};
/// the share of the energy that five iterations of an optimizer must save if it is to go on.
inline constexpr internal::Parameter_name<internal::energy_reduction_t> energy_reduction{};
/// whether straight pieces of the boundary are taken as they are instead of being subdivided.
inline constexpr internal::Parameter_name<internal::keep_boundary_points_t> keep_boundary_points{};
/// the number of vertices that a mesh generator must not exceed.
inline constexpr internal::Parameter_name<internal::maximum_number_of_vertices_t> maximum_number_of_vertices{};
/// the `CGAL::Anisotropic_mesh_2::Measure` of energies and mass centres.
inline constexpr internal::Parameter_name<internal::measure_t> measure{};
/// the `CGAL::Anisotropic_mesh_2::Optimization_method` of an optimizer.
inline constexpr internal::Parameter_name<internal::method_t> method{};
/// the `CGAL::Anisotropic_mesh_2::Point_placement` of unit meshing.
inline constexpr internal::Parameter_name<internal::point_placement_t> point_placement{};
/// whether faces of low quality are improved after an optimization, also by insertions and removals.
inline constexpr internal::Parameter_name<internal::quality_moves_t> quality_moves{};
/// a reference to the `CGAL::Anisotropic_mesh_2::Refinement_result` that a mesh generator fills in.
inline constexpr internal::Parameter_name<internal::refinement_result_t> refinement_result{};
/// the `CGAL::Anisotropic_mesh_2::Region_evaluation` of an optimizer.
inline constexpr internal::Parameter_name<internal::region_evaluation_t> region_evaluation{};

/// the name of \cgal: the real time in seconds after which no iteration begins, and no vertex is inserted.
inline constexpr internal::Parameter_name<internal_np::maximum_running_time_t> maximum_running_time{};
/// the name of \cgal: the largest number of iterations.
inline constexpr internal::Parameter_name<internal_np::number_of_iterations_t> number_of_iterations{};
/// the name of \cgal: which vertices stay where they are.
inline constexpr internal::Parameter_name<internal_np::vertex_is_constrained_t> vertex_is_constrained_map{};
/// the name of \cgal: the object that is told of iterations.
inline constexpr internal::Parameter_name<internal_np::visitor_t> visitor{};

} // namespace parameters
} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_PARAMETERS_H

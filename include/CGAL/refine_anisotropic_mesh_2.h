// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REFINE_ANISOTROPIC_MESH_2_H
#define CGAL_REFINE_ANISOTROPIC_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/internal/meshing/Field_point_inserter.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/restore_connectivity.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_mesh_2/Point_placement.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {

namespace Anisotropic_mesh_2::internal {

template <class NamedParameters>
std::size_t vertex_limit(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter<std::size_t>
    (CGAL::parameters::get_parameter(np, maximum_number_of_vertices_t()), 10000000);
}

// without a check of how many vertices the metric asks for
template <class Mesh, class NamedParameters>
std::size_t fill_with_field_points(Mesh& mesh, const NamedParameters& np)
{
  const auto placement = CGAL::parameters::choose_parameter
    (CGAL::parameters::get_parameter(np, point_placement_t()), Point_placement::ADVANCING_FRONT);
  const double time_limit = CGAL::parameters::choose_parameter
    (CGAL::parameters::get_parameter(np, internal_np::maximum_running_time), 0.);
  const Refinement_result result = Field_point_inserter<Mesh>(mesh, vertex_limit(np), time_limit)(placement);
  restore_connectivity(mesh);
  Refinement_result unused;
  CGAL::parameters::choose_parameter
    (CGAL::parameters::get_parameter(np, refinement_result_t()), std::ref(unused)).get() = result;
  return result.number_of_insertions;
}

} // namespace Anisotropic_mesh_2::internal

/// \ingroup PkgAnisotropicMesh2Functions
///
/// inserts field points into the domain of a mesh until its edges have about
/// unit length in the metric (section 3.2 of \cgalCite{dw-acvt-05}).
///
/// New vertices keep a distance of \f$ \sqrt 2/2 \f$ in the metric from all
/// others; interior edges longer than \f$ \sqrt 2 \f$ are subdivided as far as
/// that distance allows. Constrained edges stay as they are. The cost is
/// proportional to the number of vertices, apart from the location of the first ones.
///
/// Faces are refined as long as they have more than 2.5 times the area of a unit triangle in the metric, too. For
/// that the field is sampled at the barycentres of faces and at 2500 points in all, which form a lattice: places that
/// are finer than their surroundings are found if they contain a disc of a hundredth of the domain's extent, and thin
/// ones along lines at any rate.
///
/// The distance between vertices ends the insertion. Where the metric varies by a factor of 3 between neighbors, a new
/// vertex also needs area in the metric: its faces 0.7 times that of a unit triangle on average, and the unit disc
/// around it, under the tensor there, as much as if that tensor held in half of it. So places that are fine, but
/// thinner than an element is long, like a single wild tensor among others, are passed over, and edges that cross them
/// remain long; all other places get at least 0.8 times the ideal number of vertices. The number of rounds is limited
/// to 1000, and the number of vertices to four times what the faces ask for.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, whose faces know whether they are in the domain.
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_vertices}
///     \cgalParamDescription{the number of vertices that the mesh must not exceed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{10000000}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the real time in seconds after which no vertex is inserted; 0 means no limit}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{refinement_result}
///     \cgalParamDescription{what is told how the insertion ended}
///     \cgalParamType{`std::ref` of an `Anisotropic_mesh_2::Refinement_result`}
///   \cgalParamNEnd
///   \cgalParamNBegin{point_placement}
///     \cgalParamDescription{where the points come from}
///     \cgalParamType{`Anisotropic_mesh_2::Point_placement`}
///     \cgalParamDefault{`ADVANCING_FRONT`, which leaves far fewer irregular vertices}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Anisotropic_mesh_2::Too_many_vertices_exception if the metric asks for more vertices than
/// allowed: before the first insertion if an estimate exceeds 1.5 times that number, else when that number is
/// reached; the mesh is valid then.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
/// \return the number of vertices inserted.
template <class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t refine_anisotropic_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal = Anisotropic_mesh_2::internal;
  std::vector<internal::Triangle_of_doubles> triangles;
  for(const auto f : mesh.faces_in_domain())
    triangles.push_back(internal::triangle_of_doubles(f));
  internal::check_ideal_number_of_vertices<typename Mesh::Point>
    (triangles, mesh.geom_traits().construct_metric_tensor_2_object(), internal::vertex_limit(np));
  return internal::fill_with_field_points(mesh, np);
}

} // namespace CGAL

#endif // CGAL_REFINE_ANISOTROPIC_MESH_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZE_DISC_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZE_DISC_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Disc_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Factorize_once_solver.h>

#include <CGAL/Default.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Whether all triangles have their orientation and the border does not touch itself, so
// that no two triangles overlap.
template <class K>
bool is_one_to_one(const Disc_mesh& disc, const std::vector<typename K::Point_2>& places)
{
  const K kernel;
  const auto orientation = kernel.orientation_2_object();
  const auto& graph = disc.graph();
  for(auto f : graph.faces()) {
    const auto h = graph.halfedge(f);
    if(orientation(places[graph.source(h)], places[graph.target(h)], places[graph.target(graph.next(h))]) != LEFT_TURN)
      return false;
  }
  std::vector<typename K::Point_2> border;
  for(std::size_t v : disc.border_loop())
    border.push_back(places[v]);
  return is_simple_2(border.begin(), border.end(), kernel);
}

// Maps the disc by a method of CGAL and returns whether that is one to one.
template <class K, class Parameterizer>
bool parametrize_disc_by(Parameterizer method, Disc_mesh& disc, std::vector<typename K::Point_2>& places)
{
  auto place = disc.graph().add_property_map<Disc_mesh::Vertex, Disc_mesh::Kernel::Point_2>("v:place").first;
  if(Surface_mesh_parameterization::parameterize(disc.graph(), method, disc.border(), place)
     != Surface_mesh_parameterization::OK)
    return false;
  places.clear();
  for(Disc_mesh::Vertex v : disc.graph().vertices())
    places.push_back(typename K::Point_2(disc.unit() * place[v].x(), disc.unit() * place[v].y()));
  return is_one_to_one<K>(disc, places);
}

// Places for the vertices of the disc in the plane, such that no triangles overlap and none is
// distorted much: as rigid as possible with a free border, or by mean value coordinates in
// a circle where that folds over. Throws Invalid_triangle_mesh_exception if both do.
template <class K>
std::vector<typename K::Point_2> parametrize_disc(Disc_mesh& disc)
{
  using namespace Surface_mesh_parameterization;
  typedef Disc_mesh::Graph Graph;
  std::vector<typename K::Point_2> places;
  if(!parametrize_disc_by<K>(ARAP_parameterizer_3<Graph, Default, Factorize_once_solver>(), disc, places)
     && !parametrize_disc_by<K>(Mean_value_coordinates_parameterizer_3<Graph>(), disc, places))
    throw Invalid_triangle_mesh_exception("the surface cannot be mapped to the plane without folds");
  return places;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZE_DISC_H

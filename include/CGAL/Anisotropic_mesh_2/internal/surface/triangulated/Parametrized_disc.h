// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZED_DISC_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZED_DISC_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Disc_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Shape_operator_estimator.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Triangle_locator_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/parametrize_disc.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A triangle mesh in space of the topology of a disc, with the places of its vertices in
// the plane of parameters.
template <class K>
struct Parametrized_disc
{
  typedef typename K::Point_2   Point_2;
  typedef typename K::Point_3   Point_3;

  std::vector<Point_3>                     points;
  std::vector<Point_2>                     places;
  std::vector<std::size_t>                 border; // counterclockwise
  std::vector<Shape_operator>              shape_operators;
  std::optional<Triangle_locator_2<K> >    locator;
  Parameter_rectangle                      rectangle;

  // Throws Invalid_triangle_mesh_exception if the faces of the mesh are not a disc of triangles.
  template <class TriangleMesh>
  explicit Parametrized_disc(const TriangleMesh& mesh)
  {
    const std::vector<Disc_mesh::Triangle> triangles = copy(mesh);
    Disc_mesh disc(points, triangles);
    border = disc.border_loop();
    shape_operators = Shape_operator_estimator(disc)();
    places = parametrize_disc<K>(disc);
    locator.emplace(places, triangles);
    Bbox_2 box;
    for(const Point_2& p : places)
      box += p.bbox();
    rectangle.u_min = box.xmin();
    rectangle.u_max = box.xmax();
    rectangle.v_min = box.ymin();
    rectangle.v_max = box.ymax();
  }

private:
  // Copies the points and returns the triangles.
  template <class TriangleMesh>
  std::vector<Disc_mesh::Triangle> copy(const TriangleMesh& mesh)
  {
    const auto point = get(vertex_point, mesh);
    typedef typename boost::property_traits<std::decay_t<decltype(point)> >::value_type Mesh_point;
    const Cartesian_converter<typename Kernel_traits<Mesh_point>::Kernel, K> converted;
    std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::size_t> numbers;
    for(auto v : vertices(mesh)) {
      numbers.emplace(v, points.size());
      points.push_back(converted(get(point, v)));
    }
    std::vector<Disc_mesh::Triangle> triangles;
    for(auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      if(next(next(next(h, mesh), mesh), mesh) != h)
        throw Invalid_triangle_mesh_exception("the surface has a face that is not a triangle: number "
                                    + std::to_string(triangles.size()));
      triangles.push_back({numbers.at(source(h, mesh)), numbers.at(target(h, mesh)),
                           numbers.at(target(next(h, mesh), mesh))});
    }
    return triangles;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_PARAMETRIZED_DISC_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_APPEND_CHART_FACES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_APPEND_CHART_FACES_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Appends the faces of a planar mesh of a chart to `faces`. Vertices whose
// points are not among `numbers` are added to the surface mesh and to these.
template <class Mesh, class Chart, class Surface_mesh>
void append_chart_faces(const Mesh& mesh, const Chart& chart, std::map<typename Mesh::Point, std::size_t>& numbers,
                        Surface_mesh& surface_mesh, std::vector<std::array<std::size_t, 3> >& faces)
{
  typedef typename Mesh::Point Point;
  const auto number = [&](const Point& p)
  {
    const auto found = numbers.find(p);
    if(found != numbers.end())
      return found->second;
    const Vector_of_doubles q = chart.parameters(to_doubles(p));
    return numbers[p] = surface_mesh.add_vertex(point_at<Point>(q.x, q.y));
  };
  for(const auto f : mesh.faces_in_domain())
    faces.push_back({number(f->vertex(0)->point()), number(f->vertex(1)->point()), number(f->vertex(2)->point())});
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_APPEND_CHART_FACES_H

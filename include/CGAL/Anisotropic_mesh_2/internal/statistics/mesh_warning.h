// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_MESH_WARNING_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_MESH_WARNING_H

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Free_vertices.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <cmath>
#include <sstream>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// as far as numbers tell: that of the vertices that are not fixed, the ideal one, and the mean quality
inline bool follows_metric(double free_vertices, double ideal, double mean_quality)
{
  return free_vertices <= 2*ideal && mean_quality >= 0.5;
}

// Tells if a mesh does not follow its metric, and where it is worst; nothing if all is well.
template <class Mesh>
std::string mesh_warning(const Mesh& mesh)
{
  const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
  const auto faces = mesh.faces_in_domain();
  double metric_area = 0, quality = 0, least = 2;
  Vector_of_doubles worst;
  for(const auto f : faces) {
    const auto& a = f->vertex(0)->point();
    const auto& b = f->vertex(1)->point();
    const auto& c = f->vertex(2)->point();
    const Symmetric_form m = metric_at_barycentre(a, b, c, tensor);
    const Triangle_of_doubles t = triangle_of_doubles(f);
    const double q = metric_quality(a, b, c, m);
    metric_area += area(t) * std::sqrt(m.determinant());
    quality += q / double(faces.size());
    if(q < least) {
      least = q;
      worst = barycentre(t);
    }
  }
  const double inner = double(free_vertices(mesh).size()), ideal = ideal_number_of_vertices(metric_area);
  if(faces.empty() || follows_metric(inner, ideal, quality))
    return std::string();
  std::ostringstream os;
  os << "the mesh does not follow the metric: " << inner << " inner vertices where about " << ideal
     << " are ideal, mean quality " << quality << ", worst at " << describe(worst.x, worst.y)
     << "; sizes and directions that vary less within an element would help, or larger ones, or an outline no finer"
        " than they are";
  return os.str();
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_MESH_WARNING_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_FILTER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_FILTER_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Unit_frame.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Weighted_tensor.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// Decides which candidates become vertices: those that are far enough, in the metric, from all vertices that they
// would be joined to, and, where the metric varies much between these, find the area in the metric that the faces of
// a vertex need. Distances alone let far too many in where the metric turns within the length of an element, or is
// fine on a place that is thinner than an element is long: there each point is far from all others in its own metric.
template <class Mesh>
class Field_point_filter
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Edge            Edge;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef typename Mesh::Metric_tensor_2 Metric_tensor;
  typedef typename Mesh::Cavity          Cavity;

public:
  explicit Field_point_filter(const Mesh& mesh)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object())
  {}

  // whether p, whose tensor and cavity these are, becomes a vertex
  bool operator()(const Point& p, const Metric_tensor& m, const Cavity& cavity) const
  {
    for(const Edge& e : cavity.boundary)
      if(distance(p, m, vertex_of(e)) < minimum_distance)
        return false;
    double least, largest; // determinants
    return !is_rough(m, cavity, least, largest)
        || ((largest > squared_ratio_of_jumps * least || has_area(cavity, std::pow(least * largest, 0.25)))
            && is_filled(p, m, cavity));
  }

private:
  static constexpr double minimum_distance = 0.70710678118654752; // the paper's sqrt(2)/2
  static constexpr double squared_roughness = 4;                  // eigenvalues that differ by a factor of 3
  static constexpr double squared_ratio_of_jumps = 16;            // of determinants, beyond which no mean is meant
  static constexpr double least_area = 0.7 * area_of_unit_triangle; // of a face
  static constexpr double least_filling = 0.48;                   // half, which points beside a jump have
  static constexpr int    samples = 6;

  static Vertex_handle vertex_of(const Edge& e) { return e.first->vertex(Mesh::ccw(e.second)); }

  static double distance(const Point& p, const Metric_tensor& m, Vertex_handle v)
  {
    const double x = CGAL::to_double(v->point().x() - p.x()), y = CGAL::to_double(v->point().y() - p.y());
    return (Symmetric_form(m).length(x, y) + Symmetric_form(v->metric_tensor()).length(x, y)) / 2;
  }

  static bool is_rough(const Metric_tensor& m, const Cavity& cavity, double& least, double& largest)
  {
    const Weighted_tensor at_p(Symmetric_form(m), false);
    least = largest = at_p.determinant;
    bool result = false;
    for(const Edge& e : cavity.boundary) {
      const Weighted_tensor at_v(Symmetric_form(vertex_of(e)->metric_tensor()), false);
      result = result || at_p.squared_distance_to(at_v) > squared_roughness
                      || at_v.squared_distance_to(at_p) > squared_roughness;
      least = (std::min)(least, at_v.determinant);
      largest = (std::max)(largest, at_v.determinant);
    }
    return result;
  }

  static bool has_area(const Cavity& cavity, double density)
  {
    double sum = 0;
    for(Face_handle f : cavity.faces)
      sum += area(triangle_of_doubles(f));
    return sum * density > least_area * double(cavity.boundary.size());
  }

  // whether the unit disc around p is about as fine as p; what lies outside of the domain is not
  bool is_filled(const Point& p, const Metric_tensor& m, const Cavity& cavity) const
  {
    const Unit_frame frame(p, Symmetric_form(m));
    const double wanted = m.area_density();
    double sum = 0;
    Face_handle f = cavity.faces.front();
    for(int i = 0; i < samples; ++i) {
      const double angle = 0.3 + i * CGAL_PI / 3; // turned away from the axes of the tensor
      const Point q = frame.point<Point>({std::cos(angle) / 2, std::sin(angle) / 2});
      typename Mesh::Locate_type lt;
      int li;
      f = m_mesh.locate(q, lt, li, f);
      if(m_mesh.is_field_point(lt, f, li))
        sum += (std::min)(wanted, m_tensor(q).area_density());
    }
    return sum > least_filling * samples * wanted;
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_FIELD_POINT_FILTER_H

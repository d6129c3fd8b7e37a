// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_SHAPE_OPERATOR_ESTIMATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_SHAPE_OPERATOR_ESTIMATOR_H

#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Disc_mesh.h>

#include <CGAL/Monge_via_jet_fitting.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

typedef std::array<double, 6> Shape_operator; // entries 11, 12, 13, 22, 23, 33

// Estimates the curvature of a surface at the vertices of its mesh, by a polynomial fitted to
// the vertices around: symmetric tensors that give the second fundamental form of tangent vectors.
class Shape_operator_estimator
{
public:
  explicit Shape_operator_estimator(const Disc_mesh& disc) : m_disc(disc), m_ring(disc.graph().num_vertices(), 0) {}

  std::vector<Shape_operator> operator()()
  {
    std::vector<Shape_operator> result;
    for(Vertex v : m_disc.graph().vertices())
      result.push_back(at(v));
    return result;
  }

private:
  typedef Disc_mesh::Kernel                 Kernel;
  typedef Disc_mesh::Vertex                 Vertex;
  typedef Kernel::Vector_3                  Vector_3;
  typedef Monge_via_jet_fitting<Kernel>     Fitting;

  static constexpr std::size_t wanted_number_of_points = 18, points_for_degree_3 = 10, points_for_degree_2 = 6;

  Shape_operator at(Vertex v)
  {
    const std::vector<Kernel::Point_3> points = points_around(v);
    if(points.size() < points_for_degree_2)
      return Shape_operator{}; // too few to know that it is not flat
    const std::size_t degree = points.size() < points_for_degree_3 ? 2 : 3;
    Fitting::Monge_form form = Fitting()(points.begin(), points.end(), degree, 2);
    form.comply_wrt_given_normal(normal(v));
    Shape_operator s = {};
    add(form.principal_curvatures(0), form.maximal_principal_direction(), s);
    add(form.principal_curvatures(1), form.minimal_principal_direction(), s);
    return std::all_of(s.begin(), s.end(), [](double x) { return std::isfinite(x); }) ? s : Shape_operator{};
  }

  // the point of v, and those of enough rings of neighbours
  std::vector<Kernel::Point_3> points_around(Vertex v)
  {
    ++m_tour;
    std::vector<Vertex> found = {v};
    m_ring[v] = m_tour;
    for(std::size_t begin = 0, end = 1; begin < end && end < wanted_number_of_points; begin = end, end = found.size())
      for(std::size_t i = begin; i < end; ++i)
        for(Vertex w : vertices_around_target(m_disc.graph().halfedge(found[i]), m_disc.graph()))
          if(m_ring[w] != m_tour) {
            m_ring[w] = m_tour;
            found.push_back(w);
          }
    std::vector<Kernel::Point_3> points;
    for(Vertex w : found)
      points.push_back(m_disc.graph().point(w));
    return points;
  }

  Vector_3 normal(Vertex v) const
  {
    Vector_3 sum(0, 0, 0);
    for(Disc_mesh::Halfedge h : halfedges_around_target(m_disc.graph().halfedge(v), m_disc.graph()))
      if(!m_disc.graph().is_border(h)) {
        const auto point = [&](Disc_mesh::Halfedge k) { return m_disc.graph().point(target(k, m_disc.graph())); };
        const auto p = point(h), q = point(next(h, m_disc.graph())), r = point(prev(h, m_disc.graph()));
        sum = sum + cross_product(q - p, r - p);
      }
    return sum;
  }

  // in the unit of the given points
  void add(double curvature, const Vector_3& direction, Shape_operator& s) const
  {
    int k = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i; j < 3; ++j)
        s[k++] += curvature / m_disc.unit() * direction[i] * direction[j];
  }

  const Disc_mesh&   m_disc;
  std::vector<int>   m_ring; // the tour that has been to a vertex last
  int                m_tour = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_SHAPE_OPERATOR_ESTIMATOR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ENERGY_BY_FACES_H
#define ANISOTROPIC_MESH_2_TEST_ENERGY_BY_FACES_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>

#include <vector>

// The energy by faces together with what it takes the metric from: the field itself or samples of it.
template <class Mesh, template <class> class Metric = CGAL::Anisotropic_mesh_2::internal::Field_metric>
class Energy_by_faces
{
  typedef Metric<Mesh> Metric_of_mesh;
  typedef CGAL::Anisotropic_mesh_2::internal::Region_moments Region_moments;

public:
  Energy_by_faces(const Mesh& mesh, CGAL::Anisotropic_mesh_2::Measure measure,
                  double tolerance = CGAL::Anisotropic_mesh_2::internal::accurate_tolerance)
    : m_metric(mesh), m_energy(mesh, m_metric, measure, tolerance)
  {}

  double operator()(std::vector<Region_moments>& moments) { return m_energy(moments); }
  double operator()(std::vector<Region_moments>& moments, CGAL::Anisotropic_mesh_2::internal::Bisector_hessian& hessian)
  {
    return m_energy(moments, hessian);
  }

  double operator()()
  {
    std::vector<Region_moments> ignored;
    return m_energy(ignored);
  }

private:
  Metric_of_mesh m_metric;
  CGAL::Anisotropic_mesh_2::internal::Facewise_energy<Mesh, CGAL::Sequential_tag, Metric_of_mesh> m_energy;
};

#endif // ANISOTROPIC_MESH_2_TEST_ENERGY_BY_FACES_H

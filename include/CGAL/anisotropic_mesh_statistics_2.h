// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_STATISTICS_2_H
#define CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Mesh_statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

template <class Mesh>
class Statistics_collector
{
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Face_handle   Face_handle;

public:
  Statistics_collector(const Mesh& mesh, Measure measure) : m_mesh(mesh), m_measure(measure) {}

  Mesh_statistics operator()()
  {
    count();
    measure_edges();
    measure_faces();
    measure_energy();
    return m_result;
  }

private:
  void count()
  {
    std::vector<bool> is_used(m_mesh.vertex_index_bound(), false);
    for(auto f = m_mesh.finite_faces_begin(); f != m_mesh.finite_faces_end(); ++f)
      if(f->is_in_domain()) {
        ++m_result.triangles;
        for(int i = 0; i < 3; ++i)
          is_used[f->vertex(i)->index()] = true;
      }
    m_result.vertices = std::count(is_used.begin(), is_used.end(), true);
  }

  void measure_edges()
  {
    const auto length = m_mesh.geom_traits().compute_riemannian_length_2_object();
    std::size_t edges = 0, unit = 0;
    double sum = 0, least = std::numeric_limits<double>::infinity(), largest = 0;
    for(auto e = m_mesh.finite_edges_begin(); e != m_mesh.finite_edges_end(); ++e) {
      if(!e->first->is_in_domain() && !e->first->neighbor(e->second)->is_in_domain())
        continue;
      const double l = length(e->first->vertex(Mesh::ccw(e->second))->point(),
                              e->first->vertex(Mesh::cw(e->second))->point());
      ++edges;
      unit += l >= std::sqrt(0.5) && l <= std::sqrt(2.);
      sum += l;
      least = std::min(least, l);
      largest = std::max(largest, l);
    }
    if(edges == 0)
      return;
    m_result.edge_length_mean = sum / double(edges);
    m_result.edge_length_min = least;
    m_result.edge_length_max = largest;
    m_result.edge_length_unit_share = double(unit) / double(edges);
  }

  void measure_faces()
  {
    if(m_result.triangles == 0)
      return;
    const auto tensor = m_mesh.geom_traits().construct_metric_tensor_2_object();
    double sum = 0, sum3 = 0, least = 1, least3 = 1;
    for(auto f = m_mesh.finite_faces_begin(); f != m_mesh.finite_faces_end(); ++f) {
      if(!f->is_in_domain())
        continue;
      const auto &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
      const typename Mesh::Point barycentre((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
      const double q = metric_quality(a, b, c, Symmetric_form(tensor(barycentre)));
      double q3 = 1;
      for(int i = 0; i < 3; ++i)
        q3 = std::min(q3, metric_quality(a, b, c, Symmetric_form(f->vertex(i)->metric_tensor())));
      sum += q;
      sum3 += q3;
      least = std::min(least, q);
      least3 = std::min(least3, q3);
    }
    m_result.quality_mean = sum / double(m_result.triangles);
    m_result.quality_min = least;
    m_result.quality_min3_mean = sum3 / double(m_result.triangles);
    m_result.quality_min3_min = least3;
  }

  void measure_energy()
  {
    const double area = metric_area(m_mesh, 0.5, 1e-5, quarterings());
    m_result.ideal_vertices = ideal_number_of_vertices(area);
    std::vector<Region_moments> moments;
    m_result.energy = Acvt_energy<Mesh>(m_mesh, m_measure, Acvt_accuracy{0.1, 0.1, 4})(moments);
    const double density_integral
      = m_measure == Measure::RIEMANNIAN ? area : metric_area(m_mesh, 0.25, 1e-5, quarterings());
    // the second moment of a regular hexagon of unit area
    const double hexagon = 5 / (18 * std::sqrt(3.));
    m_result.energy_ratio = m_result.energy * double(m_result.triangles) / 2
                          / (hexagon * density_integral * density_integral);
    for(Vertex_handle v : free_vertices(m_mesh)) {
      double x, y;
      moments[v->index()].pull(x, y);
      m_result.gradient_norm = std::max(m_result.gradient_norm,
                                        Symmetric_form(v->metric_tensor()).length(x, y));
    }
  }

  std::size_t quarterings() const { return 1000000 + 4 * m_result.triangles; }

  const Mesh& m_mesh;
  const Measure m_measure;
  Mesh_statistics m_result;
};

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures a mesh in its metric.
///
/// The field is evaluated a few dozen times per vertex, more often where it varies much.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param measure the measure of the energy.
template <class Mesh>
Anisotropic_mesh_2::Mesh_statistics
anisotropic_mesh_statistics_2(const Mesh& mesh,
                              Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN)
{
  return Anisotropic_mesh_2::internal::Statistics_collector<Mesh>(mesh, measure)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

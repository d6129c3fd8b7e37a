// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_STATISTICS_2_H
#define CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/Summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy_of_hexagons.h>
#include <CGAL/Anisotropic_mesh_2/internal/faces_in_domain.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Mesh_statistics.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

template <class Mesh, class ConcurrencyTag>
class Statistics_collector
{
  typedef typename Mesh::Point         Point;
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Face_handle   Face_handle;

public:
  Statistics_collector(const Mesh& mesh, Measure measure) : m_mesh(mesh), m_measure(measure) {}

  Mesh_statistics operator()()
  {
    faces_in_domain(m_mesh, m_faces);
    count();
    if(m_result.triangles == 0)
      return m_result;
    measure_edges();
    measure_faces();
    measure_energy();
    return m_result;
  }

private:
  struct Face_summary
  {
    Summary qualities, qualities_min3;

    Face_summary& operator+=(const Face_summary& s)
    {
      qualities += s.qualities;
      qualities_min3 += s.qualities_min3;
      return *this;
    }
  };

  // what `add(face, summary)` gathers over the faces of the domain
  template <class Sum, class Add>
  Sum summarize(const Add& add) const
  {
    std::vector<Sum> of_chunk(number_of_chunks(m_faces.size()));
    for_each_chunk<ConcurrencyTag>(m_faces.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        add(m_faces[k], of_chunk[chunk]);
    });
    return std::accumulate(of_chunk.begin(), of_chunk.end(), Sum(), [](Sum s, const Sum& t) { return s += t; });
  }

  void count()
  {
    std::vector<bool> is_used(m_mesh.vertex_index_bound(), false);
    for(Face_handle f : m_faces)
      for(int i = 0; i < 3; ++i)
        is_used[f->vertex(i)->index()] = true;
    m_result.triangles = m_faces.size();
    m_result.vertices = std::count(is_used.begin(), is_used.end(), true);
  }

  // whether the edge is to be looked at from this face
  static bool is_own_edge(Face_handle f, int i)
  {
    return !f->neighbor(i)->is_in_domain() || f->vertex(Mesh::ccw(i))->index() < f->vertex(Mesh::cw(i))->index();
  }

  void measure_edges()
  {
    const auto length = m_mesh.geom_traits().compute_riemannian_length_2_object();
    const auto edges = summarize<Edge_summary>([&](Face_handle f, Edge_summary& sum) {
      for(int i = 0; i < 3; ++i)
        if(is_own_edge(f, i))
          sum.add(length(f->vertex(Mesh::ccw(i))->point(), f->vertex(Mesh::cw(i))->point()));
    });
    m_result.edge_length_mean = edges.lengths.mean();
    m_result.edge_length_min = edges.lengths.least;
    m_result.edge_length_max = edges.lengths.largest;
    m_result.edge_length_unit_share = edges.unit_share();
  }

  void measure_faces()
  {
    const auto tensor = m_mesh.geom_traits().construct_metric_tensor_2_object();
    const auto faces = summarize<Face_summary>([&](Face_handle f, Face_summary& sum) {
      const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
      sum.qualities.add(quality_at_barycentre(a, b, c, tensor));
      double q3 = 1;
      for(int i = 0; i < 3; ++i)
        q3 = std::min(q3, metric_quality(a, b, c, Symmetric_form(f->vertex(i)->metric_tensor())));
      sum.qualities_min3.add(q3);
    });
    m_result.quality_mean = faces.qualities.mean();
    m_result.quality_min = faces.qualities.least;
    m_result.quality_min3_mean = faces.qualities_min3.mean();
    m_result.quality_min3_min = faces.qualities_min3.least;
  }

  double area(double exponent) const
  {
    return metric_area<ConcurrencyTag>(m_mesh, m_faces, exponent, 1e-5, 1000000 + 4 * m_faces.size());
  }

  void measure_energy()
  {
    const double riemannian_area = area(0.5);
    m_result.ideal_vertices = ideal_number_of_vertices(riemannian_area);
    std::vector<Region_moments> moments;
    m_result.energy = Acvt_energy<Mesh, ConcurrencyTag>(m_mesh, m_measure, Acvt_accuracy{0.01, 0.05, 0.2, 3})(moments);
    const double density_integral = m_measure == Measure::RIEMANNIAN ? riemannian_area : area(0.25);
    m_result.energy_ratio = m_result.energy / energy_of_hexagons(density_integral, double(m_result.triangles) / 2);
    for(Vertex_handle v : free_vertices(m_mesh)) {
      double x, y;
      moments[v->index()].pull(x, y);
      m_result.gradient_norm = std::max(m_result.gradient_norm,
                                        Symmetric_form(v->metric_tensor()).length(x, y));
    }
  }

  const Mesh& m_mesh;
  const Measure m_measure;
  std::vector<Face_handle> m_faces; // of the domain
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
/// \tparam ConcurrencyTag as for `acvt_optimize_mesh_2()`; the result is the same to the bit.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param measure the measure of the energy.
template <class ConcurrencyTag = Parallel_if_available_tag, class Mesh>
Anisotropic_mesh_2::Mesh_statistics
anisotropic_mesh_statistics_2(const Mesh& mesh,
                              Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN)
{
  return Anisotropic_mesh_2::internal::Statistics_collector<Mesh, ConcurrencyTag>(mesh, measure)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_STATISTICS_2_H
#define CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

#include <CGAL/Anisotropic_mesh_2/internal/statistics/Energy_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Shape_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/free_vertices.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/faces_in_domain.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Mesh_statistics.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

template <class Mesh, class ConcurrencyTag>
class Statistics_collector
{
  typedef typename Mesh::Point       Point;
  typedef typename Mesh::Face_handle Face_handle;

public:
  Statistics_collector(const Mesh& mesh, Measure measure) : m_mesh(mesh), m_measure(measure) {}

  Mesh_statistics operator()()
  {
    faces_in_domain(m_mesh, m_faces);
    count();
    if(m_result.triangles == 0)
      return m_result;
    measure_shapes();
    measure_energy();
    return m_result;
  }

private:
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

  void measure_shapes()
  {
    sum_of_chunks<ConcurrencyTag, Shape_summary>(m_faces.size(), [&](std::size_t k, Shape_summary& sum) {
      measure_edges(m_faces[k], sum.edges);
      measure_qualities(m_faces[k], sum);
    }).write_to(m_result);
  }

  void measure_edges(Face_handle f, Edge_summary& sum) const
  {
    const auto length = m_mesh.geom_traits().compute_riemannian_length_2_object();
    for(int i = 0; i < 3; ++i)
      if(is_own_edge(f, i))
        sum.add(length(f->vertex(Mesh::ccw(i))->point(), f->vertex(Mesh::cw(i))->point()));
  }

  void measure_qualities(Face_handle f, Shape_summary& sum) const
  {
    const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    sum.qualities.add(quality_at_barycentre(a, b, c, m_mesh.geom_traits().construct_metric_tensor_2_object()));
    double least = 1;
    for(int i = 0; i < 3; ++i)
      least = (std::min)(least, metric_quality(a, b, c, Symmetric_form(f->vertex(i)->metric_tensor())));
    sum.qualities_min3.add(least);
  }

  void measure_energy()
  {
    Energy_summary<Mesh, ConcurrencyTag> summary(m_measure);
    summary.add(m_mesh, m_faces, {}, free_vertices(m_mesh));
    summary.write_to(m_result);
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
/// measures a mesh in its metric, as section 5.1 of \cgalCite{dw-acvt-05} does.
///
/// The field is evaluated about 100 times per vertex, and 2000 to 3000 times where it varies by a factor
/// within an element.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`; the result is the same to the bit.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param measure the measure of the energy.
/// \return the statistics.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class ConcurrencyTag = Sequential_tag, class Mesh>
Anisotropic_mesh_2::Mesh_statistics
anisotropic_mesh_statistics_2(const Mesh& mesh,
                              Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN)
{
  return Anisotropic_mesh_2::internal::Statistics_collector<Mesh, ConcurrencyTag>(mesh, measure)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/is_own_edge.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// How near a mesh is to a unit mesh: the share of edges of unit length, the mean
// quality and a tenth of the least one, which is that of a single face.
template <class ConcurrencyTag, class Mesh, class Metric>
class Unit_mesh_merit
{
  typedef typename Mesh::Face_handle   Face_handle;
  typedef typename Mesh::Vertex_handle Vertex_handle;

public:
  Unit_mesh_merit(const Mesh& mesh, const Metric& metric) : m_mesh(mesh), m_metric(metric) {}

  double operator()() const
  {
    const std::vector<Face_handle> faces = m_mesh.faces_in_domain();
    const Sums s = sum_of_chunks<ConcurrencyTag, Sums>(faces.size(), [&](std::size_t k, Sums& sums) {
      const Face_handle f = faces[k];
      sums.qualities.add(metric_quality(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                                        m_metric.tensor(barycentre(triangle_of_doubles(f)), f->vertex(0))));
      for(int i = 0; i < 3; ++i)
        if(is_own_edge(f, i))
          sums.edges.add(length(f->vertex(Mesh::ccw(i)), f->vertex(Mesh::cw(i))));
    });
    return faces.empty() ? 0 : s.edges.unit_share() + s.qualities.mean() + s.qualities.least / 10;
  }

private:
  struct Sums
  {
    Summary      qualities;
    Edge_summary edges;

    Sums& operator+=(const Sums& s)
    {
      qualities += s.qualities;
      edges += s.edges;
      return *this;
    }
  };

  double length(Vertex_handle u, Vertex_handle v) const
  {
    const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
    return length_by_simpson(Symmetric_form(u->metric_tensor()), m_metric.tensor(middle(p, q), u),
                             Symmetric_form(v->metric_tensor()), q.x - p.x, q.y - p.y);
  }

  const Mesh&   m_mesh;
  const Metric& m_metric;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// How near a mesh is to a unit mesh.
class Unit_mesh_merit
{
public:
  template <class ConcurrencyTag, class Mesh, class Metric>
  Unit_mesh_merit(ConcurrencyTag, const Mesh& mesh, const Metric& metric)
  {
    const auto faces = mesh.faces_in_domain();
    m_sums = sum_of_chunks<ConcurrencyTag, Sums>(faces.size(), [&](std::size_t k, Sums& s) {
      s.add_quality(quality(faces[k], metric));
      for(int i = 0; i < 3; ++i) {
        const auto u = faces[k]->vertex(Mesh::ccw(i)), v = faces[k]->vertex(Mesh::cw(i));
        if(u->index() < v->index() || !faces[k]->neighbor(i)->is_in_domain())
          s.add_length(length(u, v, metric));
      }
    });
  }

  // The share of edges of unit length, the mean quality and a tenth of the least one, which is that of a single face.
  double value() const
  {
    return m_sums.faces == 0 ? 0 : m_sums.unit_edges / m_sums.edges + m_sums.quality / m_sums.faces
                                    + m_sums.least / 10;
  }

private:
  struct Sums
  {
    double faces = 0, quality = 0, least = 1, edges = 0, unit_edges = 0;

    void add_quality(double q)
    {
      ++faces;
      quality += q;
      least = (std::min)(least, q);
    }

    void add_length(double l)
    {
      ++edges;
      unit_edges += l*l >= 0.5 && l*l <= 2;
    }

    Sums& operator+=(const Sums& s)
    {
      faces += s.faces;
      quality += s.quality;
      least = (std::min)(least, s.least);
      edges += s.edges;
      unit_edges += s.unit_edges;
      return *this;
    }
  };

  template <class Face_handle, class Metric>
  static double quality(Face_handle f, const Metric& metric)
  {
    const Vector_of_doubles a = to_doubles(f->vertex(0)->point()), b = to_doubles(f->vertex(1)->point());
    const Vector_of_doubles c = to_doubles(f->vertex(2)->point());
    return metric_quality(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
                          metric.tensor({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, f->vertex(0)));
  }

  // by Simpson's rule
  template <class Vertex_handle, class Metric>
  static double length(Vertex_handle u, Vertex_handle v, const Metric& metric)
  {
    const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
    const double x = q.x - p.x, y = q.y - p.y;
    return (Symmetric_form(u->metric_tensor()).length(x, y) + Symmetric_form(v->metric_tensor()).length(x, y)
            + 4 * metric.tensor({(p.x + q.x) / 2, (p.y + q.y) / 2}, u).length(x, y)) / 6;
  }

  Sums m_sums;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_UNIT_MESH_MERIT_H

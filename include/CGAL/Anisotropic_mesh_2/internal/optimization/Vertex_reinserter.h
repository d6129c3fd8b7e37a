// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_REINSERTER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_REINSERTER_H

#include <CGAL/Anisotropic_mesh_2/internal/mesh/assign_data.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Free_vertices.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/restore_connectivity.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/spatial_order.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>

#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Moves the free vertices of a mesh by inserting them again into the stored
// empty mesh, as in section 4 of the paper. Vertices keep what they store,
// handles do not stay valid.
template <class Mesh, class Metric = Field_metric<Mesh>, class ConcurrencyTag = Sequential_tag>
class Vertex_reinserter
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef std::vector<double>            Array; // of coordinates, as `Free_vertices` has them

public:
  // The metric is that of the field, which insertion evaluates.
  Vertex_reinserter(Mesh& mesh, Metric&)
    : m_mesh(mesh), m_empty(mesh.empty_mesh()), m_given(mesh), m_kept(m_empty), m_free(mesh)
  {}

  const Free_vertices<Mesh>& free_vertices() const { return m_free; }

  // A vertex whose target lies outside of the domain or is taken goes only a
  // part of its way. Should even its old place be taken, all move in place.
  void move_to(const Array& target)
  {
    const Array start = m_free.positions();
    Mesh next = m_empty;
    Face_handle hint;
    std::vector<Point> points;
    for(std::size_t i = 0; i < m_free.size(); ++i)
      points.push_back(m_free.point(target, i));
    for(std::size_t i : spatial_order(points)) {
      const Vertex_handle v = insert_on_the_way(next, start, target, i, hint);
      if(v == Vertex_handle()) {
        Field_metric<Mesh> field(m_mesh);
        Vertex_mover<Mesh>(m_mesh, field).move_to(target);
        return;
      }
      assign_data(*v, *m_free[i]);
      hint = v->face();
    }
    next.set_vertex_index_bound(m_mesh.vertex_index_bound());
    restore_connectivity(next);
    m_mesh.swap(next);
    m_free.find_in(m_mesh);
  }

  void finish() {} // the tensors are those of the field

  // as those of `Vertex_mover`, except for the handles
  void keep() { m_kept = m_mesh; }
  void restore_given() { restore(m_given); }
  void restore_kept() { restore(m_kept); }

private:
  static constexpr int halvings = 6;

  void restore(Mesh& mesh)
  {
    m_mesh.swap(mesh);
    m_free.find_in(m_mesh);
  }

  Vertex_handle insert_on_the_way(Mesh& mesh, const Array& start, const Array& target, std::size_t vertex,
                                  Face_handle hint) const
  {
    double t = 1;
    for(int i = 0; i <= halvings; ++i, t = i < halvings ? t / 2 : 0) {
      const Point p = m_free.point_between(start, target, t, vertex);
      typename Mesh::Locate_type lt;
      int li;
      const Face_handle f = mesh.locate(p, lt, li, hint);
      if(!mesh.is_field_point(lt, f, li))
        continue;
      return mesh.insert(p, lt, f, li);
    }
    return Vertex_handle();
  }

  Mesh&   m_mesh;
  Mesh    m_empty, m_given, m_kept;
  Free_vertices<Mesh> m_free;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_VERTEX_REINSERTER_H

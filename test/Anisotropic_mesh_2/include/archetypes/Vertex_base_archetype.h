// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_VERTEX_BASE_ARCHETYPE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_VERTEX_BASE_ARCHETYPE_H

#include <CGAL/Triangulation_ds_vertex_base_2.h>

#include <limits>

// The concept `AnisotropicMeshVertexBase_2`, on top of what the data structure needs.
template <class Gt, class Vb = CGAL::Triangulation_ds_vertex_base_2<> >
class Vertex_base_archetype
  : public Vb
{
public:
  typedef typename Gt::Point_2             Point;
  typedef typename Gt::Metric_tensor_2     Tensor;
  typedef typename Vb::Face_handle         Face_handle;

  template <class TDS2>
  struct Rebind_TDS
  {
    typedef Vertex_base_archetype<Gt, typename Vb::template Rebind_TDS<TDS2>::Other> Other;
  };

  Vertex_base_archetype() {}
  explicit Vertex_base_archetype(const Point& p) : m_point(p) {}
  explicit Vertex_base_archetype(const Point& p, Face_handle f) : Vb(f), m_point(p) {}

  const Point& point() const { return m_point; }
  void set_point(const Point& p) { m_point = p; }

  const Tensor& metric_tensor() const { return m_tensor; }
  void set_metric_tensor(const Tensor& m) { m_tensor = m; }

  int index() const { return m_index; }
  void set_index(int i) { m_index = i; }

  bool is_required() const { return m_is_required; }
  void set_required(bool b) { m_is_required = b; }

private:
  Point  m_point;
  Tensor m_tensor;
  int    m_index = (std::numeric_limits<int>::max)(); // must not be used
  bool   m_is_required = false;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_VERTEX_BASE_ARCHETYPE_H

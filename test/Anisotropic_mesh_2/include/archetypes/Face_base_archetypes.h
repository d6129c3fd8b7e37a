// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FACE_BASE_ARCHETYPES_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FACE_BASE_ARCHETYPES_H

#include <CGAL/Triangulation_ds_face_base_2.h>

#include <array>

// The concept `ConstrainedTriangulationFaceBase_2` of CGAL, on top of what the
// data structure needs.
template <class Fb = CGAL::Triangulation_ds_face_base_2<> >
class Constrained_face_base_archetype
  : public Fb
{
public:
  typedef typename Fb::Vertex_handle   Vertex_handle;
  typedef typename Fb::Face_handle     Face_handle;

  template <class TDS2>
  struct Rebind_TDS
  {
    typedef Constrained_face_base_archetype<typename Fb::template Rebind_TDS<TDS2>::Other> Other;
  };

  Constrained_face_base_archetype() {}
  explicit Constrained_face_base_archetype(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2)
    : Fb(v0, v1, v2)
  {}
  explicit Constrained_face_base_archetype(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2,
                                           Face_handle n0, Face_handle n1, Face_handle n2)
    : Fb(v0, v1, v2, n0, n1, n2)
  {}

  bool is_constrained(int i) const { return m_constrained[i]; }
  void set_constraint(int i, bool b) { m_constrained[i] = b; }
  void set_constraints(bool c0, bool c1, bool c2) { m_constrained = {{c0, c1, c2}}; }

  void reorient()
  {
    Fb::reorient();
    set_constraints(m_constrained[1], m_constrained[0], m_constrained[2]);
  }
  void ccw_permute()
  {
    Fb::ccw_permute();
    set_constraints(m_constrained[2], m_constrained[0], m_constrained[1]);
  }
  void cw_permute()
  {
    Fb::cw_permute();
    set_constraints(m_constrained[1], m_constrained[2], m_constrained[0]);
  }

private:
  std::array<bool, 3> m_constrained = {{false, false, false}};
};

// The concept `AnisotropicMeshFaceBase_2`.
template <class Fb = Constrained_face_base_archetype<> >
class Mesh_face_base_archetype
  : public Fb
{
public:
  template <class TDS2>
  struct Rebind_TDS
  {
    typedef Mesh_face_base_archetype<typename Fb::template Rebind_TDS<TDS2>::Other> Other;
  };

  using Fb::Fb;
  Mesh_face_base_archetype() {}

  bool is_in_domain() const { return m_is_in_domain; }
  void set_in_domain(bool b) { m_is_in_domain = b; }

  int subdomain_index() const { return m_subdomain_index; }
  void set_subdomain_index(int i) { m_subdomain_index = i; }

  int edge_reference(int i) const { return m_edge_references[i]; }
  void set_edge_reference(int i, int reference) { m_edge_references[i] = reference; }

  bool is_boundary(int i) const { return m_is_boundary[i]; }
  void set_boundary(int i, bool b) { m_is_boundary[i] = b; }

  void reorient()
  {
    Fb::reorient();
    m_edge_references = {{m_edge_references[1], m_edge_references[0], m_edge_references[2]}};
    m_is_boundary = {{m_is_boundary[1], m_is_boundary[0], m_is_boundary[2]}};
  }
  void ccw_permute()
  {
    Fb::ccw_permute();
    m_edge_references = {{m_edge_references[2], m_edge_references[0], m_edge_references[1]}};
    m_is_boundary = {{m_is_boundary[2], m_is_boundary[0], m_is_boundary[1]}};
  }
  void cw_permute()
  {
    Fb::cw_permute();
    m_edge_references = {{m_edge_references[1], m_edge_references[2], m_edge_references[0]}};
    m_is_boundary = {{m_is_boundary[1], m_is_boundary[2], m_is_boundary[0]}};
  }

private:
  bool m_is_in_domain = false;
  int  m_subdomain_index = -12345; // not used before it is set
  std::array<int, 3> m_edge_references = {{0, 0, 0}};
  std::array<bool, 3> m_is_boundary = {{false, false, false}};
};

// What writers need of faces.
template <class Fb = Constrained_face_base_archetype<> >
class Marked_face_base_archetype
  : public Fb
{
public:
  template <class TDS2>
  struct Rebind_TDS
  {
    typedef Marked_face_base_archetype<typename Fb::template Rebind_TDS<TDS2>::Other> Other;
  };

  using Fb::Fb;
  Marked_face_base_archetype() {}

  bool is_in_domain() const { return m_is_in_domain; }

  bool m_is_in_domain = false;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FACE_BASE_ARCHETYPES_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_FACE_BASE_2_H
#define CGAL_ANISOTROPIC_MESH_FACE_BASE_2_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Constrained_triangulation_face_base_2.h>

#include <array>
#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// The face base of anisotropic meshes: it stores whether the face belongs to
/// the domain, to which subdomain, the references of its edges, and which of them bound the domain.
///
/// \tparam Gt a model of `RiemannianMetricTraits_2`.
/// \tparam Fb a model of `ConstrainedTriangulationFaceBase_2`.
///
/// \cgalModels{AnisotropicMeshFaceBase_2}
template <class Gt, class Fb = Constrained_triangulation_face_base_2<Gt> >
class Anisotropic_mesh_face_base_2
  : public Fb
{
public:
  typedef typename Fb::Vertex_handle   Vertex_handle; ///< a vertex
  typedef typename Fb::Face_handle     Face_handle;   ///< a face

  /// \cond SKIP_IN_MANUAL
  template <class TDS2>
  struct Rebind_TDS
  {
    typedef typename Fb::template Rebind_TDS<TDS2>::Other  Fb2;
    typedef Anisotropic_mesh_face_base_2<Gt, Fb2>          Other;
  };
  /// \endcond

  /// \name Creation
  /// Edges have no reference until it is set.
  /// @{

  /// a face outside of the domain, without vertices.
  Anisotropic_mesh_face_base_2() : Fb() {}

  /// a face outside of the domain with the given vertices.
  Anisotropic_mesh_face_base_2(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2) : Fb(v0, v1, v2) {}

  /// a face outside of the domain with the given vertices and neighbors.
  Anisotropic_mesh_face_base_2(Vertex_handle v0, Vertex_handle v1, Vertex_handle v2,
                               Face_handle n0, Face_handle n1, Face_handle n2)
    : Fb(v0, v1, v2, n0, n1, n2)
  {}
  /// @}

  /// \name Access
  /// @{

  /// whether the face belongs to the domain.
  bool is_in_domain() const { return m_is_in_domain; }

  /// sets whether the face belongs to the domain.
  void set_in_domain(bool b) { m_is_in_domain = b; }

  /// the reference of the subdomain, any number, meaningful for faces in the domain; 0 if none is given.
  int subdomain_index() const { return m_subdomain_index; }

  /// sets the reference of the subdomain.
  void set_subdomain_index(int i) { m_subdomain_index = i; }

  /// the reference of the curve that the `i`-th edge comes from; 0 if there is none.
  int edge_reference(int i) const { return m_edge_references[i]; }

  /// sets the reference of the `i`-th edge.
  void set_edge_reference(int i, int reference) { m_edge_references[i] = reference; }

  /// whether inside and outside of the domain change at the `i`-th edge.
  bool is_boundary(int i) const { return m_is_boundary[i]; }

  /// sets whether inside and outside of the domain change at the `i`-th edge.
  void set_boundary(int i, bool b) { m_is_boundary[i] = b; }

  /// exchanges the vertices 0 and 1.
  void reorient()
  {
    Fb::reorient();
    std::swap(m_edge_references[0], m_edge_references[1]);
    std::swap(m_is_boundary[0], m_is_boundary[1]);
  }

  /// turns the face: vertex 0 becomes vertex 1.
  void ccw_permute()
  {
    Fb::ccw_permute();
    m_edge_references = {{m_edge_references[2], m_edge_references[0], m_edge_references[1]}};
    m_is_boundary = {{m_is_boundary[2], m_is_boundary[0], m_is_boundary[1]}};
  }

  /// turns the face: vertex 0 becomes vertex 2.
  void cw_permute()
  {
    Fb::cw_permute();
    m_edge_references = {{m_edge_references[1], m_edge_references[2], m_edge_references[0]}};
    m_is_boundary = {{m_is_boundary[1], m_is_boundary[2], m_is_boundary[0]}};
  }
  /// @}

private:
  bool m_is_in_domain = false;
  std::array<bool, 3> m_is_boundary = {{false, false, false}};
  int m_subdomain_index = 0;
  std::array<int, 3> m_edge_references = {{0, 0, 0}};
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_FACE_BASE_2_H

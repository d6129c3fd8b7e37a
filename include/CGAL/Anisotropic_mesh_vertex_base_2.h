// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_VERTEX_BASE_2_H
#define CGAL_ANISOTROPIC_MESH_VERTEX_BASE_2_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Triangulation_vertex_base_2.h>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// The vertex base of anisotropic triangulations: it keeps the metric tensor of
/// the vertex's position, so that the field is evaluated once per vertex, and
/// its index, which stays the same while the vertex moves and when an optimizer
/// rebuilds the triangulation, and whether it is required to stay.
///
/// \tparam Gt a model of `RiemannianMetricTraits_2`.
/// \tparam Vb a model of `TriangulationVertexBase_2`.
///
/// \cgalModels{AnisotropicMeshVertexBase_2}
template <class Gt, class Vb = Triangulation_vertex_base_2<Gt> >
class Anisotropic_mesh_vertex_base_2
  : public Vb
{
public:
  typedef typename Gt::Metric_tensor_2   Metric_tensor_2; ///< a tensor of the field
  typedef typename Vb::Point             Point;           ///< the position
  typedef typename Vb::Face_handle       Face_handle;     ///< a face

  /// \cond SKIP_IN_MANUAL
  template <class TDS2>
  struct Rebind_TDS
  {
    typedef typename Vb::template Rebind_TDS<TDS2>::Other  Vb2;
    typedef Anisotropic_mesh_vertex_base_2<Gt, Vb2>        Other;
  };
  /// \endcond

  /// \name Creation
  /// The tensor is the identity and the index -1 until they are set. The vertex is not required.
  /// @{

  /// a vertex without position.
  Anisotropic_mesh_vertex_base_2() : Vb() {}

  /// a vertex at `p`.
  explicit Anisotropic_mesh_vertex_base_2(const Point& p) : Vb(p) {}

  /// a vertex at `p` with the incident face `f`.
  Anisotropic_mesh_vertex_base_2(const Point& p, Face_handle f) : Vb(p, f) {}

  /// a vertex with the incident face `f`.
  explicit Anisotropic_mesh_vertex_base_2(Face_handle f) : Vb(f) {}
  /// @}

  /// \name Access
  /// @{

  /// the tensor of the field at the position of the vertex.
  const Metric_tensor_2& metric_tensor() const { return m_tensor; }

  /// \cgalAdvancedBegin
  /// sets the tensor; the triangulation does so when it inserts or moves the vertex.
  /// \cgalAdvancedEnd
  void set_metric_tensor(const Metric_tensor_2& m) { m_tensor = m; }

  /// the number of the vertex: its rank in the order of insertion, unless quality moves have given it that of a
  /// removed one.
  int index() const { return m_index; }

  /// \cgalAdvancedBegin
  /// sets the index; the triangulation does so when it inserts the vertex.
  /// \cgalAdvancedEnd
  void set_index(int i) { m_index = i; }

  /// whether algorithms must neither move nor remove the vertex.
  bool is_required() const { return m_is_required; }

  /// sets whether the vertex is required.
  void set_required(bool b) { m_is_required = b; }
  /// @}

private:
  Metric_tensor_2 m_tensor;
  int m_index = -1;
  bool m_is_required = false;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_VERTEX_BASE_2_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_RESTORE_CONNECTIVITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_RESTORE_CONNECTIVITY_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Decides which edges of a mesh are to be flipped, the vertices being where
// they are.
//
// Where the tensors of the four vertices around an edge are much the same, the
// criterion of the triangulation decides. Where they are not, that criterion
// says little about the faces in between; there the flip must raise the lower
// quality of the two faces in the metric at their barycentres.
//
// Flips by quality come to an end, flips by the criterion might follow each
// other in a circle, above all where both rules meet. Therefore, after a number
// of flips, quality decides everywhere; and since rounding errors may make even
// qualities rise in a circle, after many more no flip is wanted. But as long as
// all tensors are multiples of one, the criterion decides alone: it does not
// depend on the sizes then, and its flips come to an end.
template <class Mesh>
class Flip_rule
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Edge            Edge;
  typedef typename Mesh::Vertex_handle   Vertex_handle;

public:
  explicit Flip_rule(const Mesh& mesh)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_maximum_of_flips(4 * mesh.number_of_faces() + 16),
      m_maximum_of_rough_flips(mesh.number_of_faces() / 16 + 16)
  {}

  bool operator()(const Edge& e)
  {
    if(!m_mesh.is_flippable(e.first, e.second))
      return false;
    const Edge m = m_mesh.mirror_edge(e);
    const Vertex_handle p = e.first->vertex(e.second), q = m.first->vertex(m.second);
    const Vertex_handle a = e.first->vertex(Mesh::ccw(e.second)), b = e.first->vertex(Mesh::cw(e.second));
    m_is_uniform = m_is_uniform && m_mesh.has_multiples_of(m_mesh.finite_vertices_begin()->metric_tensor(), e);
    if(!m_is_uniform && m_flips > 8 * m_maximum_of_flips)
      return false;
    const bool by_quality = !m_is_uniform && (is_exhausted() || is_rough(p, q, a, b));
    const bool is_wanted = by_quality ? raises_quality(p, q, a, b)
                                      : !m_mesh.is_locally_Delaunay(e.first, e.second);
    m_flips += is_wanted;
    m_rough_flips += is_wanted && by_quality;
    return is_wanted;
  }

private:
  static constexpr double roughness = 0.8;

  bool is_exhausted() const
  {
    return m_flips > m_maximum_of_flips || m_rough_flips > m_maximum_of_rough_flips;
  }

  static bool is_rough(Vertex_handle p, Vertex_handle q, Vertex_handle a, Vertex_handle b)
  {
    const Weighted_tensor m(Symmetric_form(p->metric_tensor()), false);
    for(Vertex_handle v : {q, a, b})
      if(m.distance_to(Weighted_tensor(Symmetric_form(v->metric_tensor()), false)) > roughness)
        return true;
    return false;
  }

  // Strictly and by more than usual rounding errors, so that such flips come to an end.
  bool raises_quality(Vertex_handle p, Vertex_handle q, Vertex_handle a, Vertex_handle b) const
  {
    const double before = std::min(quality(p, a, b), quality(q, b, a));
    const double after = std::min(quality(p, a, q), quality(q, b, p));
    return after > before + 1e-9 * std::abs(before);
  }

  double quality(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    const Point &a = u->point(), &b = v->point(), &c = w->point();
    const Point barycentre((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
    return metric_quality(a, b, c, Symmetric_form(m_tensor(barycentre)));
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const std::size_t m_maximum_of_flips, m_maximum_of_rough_flips;
  std::size_t m_flips = 0, m_rough_flips = 0;
  bool m_is_uniform = true;
};

// Flips edges of the domain until no flip is wanted any more.
template <class Mesh>
void restore_connectivity(Mesh& mesh)
{
  Flip_rule<Mesh> rule(mesh);
  mesh.flip_edges(mesh.edges_in_domain(), [&](const typename Mesh::Edge& e) { return rule(e); });
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_RESTORE_CONNECTIVITY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Weighted_tensor.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

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
  typedef typename Mesh::Edge            Edge;
  typedef typename Mesh::Vertex_handle   Vertex_handle;

public:
  explicit Flip_rule(const Mesh& mesh)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_maximum_of_flips(4 * mesh.number_of_faces() + 16),
      m_maximum_of_rough_flips(mesh.number_of_faces() / 16 + 16),
      m_is_uniform(has_multiples_of_one_tensor(mesh))
  {}

  // whether an edge of the domain is to be flipped, as long as there are not too many flips
  bool is_wanted(const Edge& e) const { return is_flippable(e) && is_better_flipped(e, is_rough(e)); }

  // the same with a view to the flips already granted
  bool operator()(const Edge& e)
  {
    if(!is_flippable(e) || (!m_is_uniform && m_flips > 8 * m_maximum_of_flips))
      return false;
    const bool by_quality = is_rough(e) || (!m_is_uniform && is_exhausted());
    const bool is_granted = is_better_flipped(e, by_quality);
    m_flips += is_granted;
    m_rough_flips += is_granted && by_quality;
    return is_granted;
  }

private:
  static constexpr double squared_roughness = 0.64;

  static bool has_multiples_of_one_tensor(const Mesh& mesh)
  {
    const auto first = mesh.finite_vertices_begin();
    for(auto v = first; v != mesh.finite_vertices_end(); ++v)
      if(!is_multiple_of(v->metric_tensor(), first->metric_tensor()))
        return false;
    return true;
  }

  // but for the place of its ends
  bool is_flippable(const Edge& e) const
  {
    return !e.first->is_constrained(e.second) && e.first->is_in_domain();
  }

  bool is_exhausted() const
  {
    return m_flips > m_maximum_of_flips || m_rough_flips > m_maximum_of_rough_flips;
  }

  bool is_rough(const Edge& e) const
  {
    if(m_is_uniform)
      return false;
    const Weighted_tensor m(Symmetric_form(e.first->vertex(e.second)->metric_tensor()), false);
    for(Vertex_handle v : {opposite(e), e.first->vertex(Mesh::ccw(e.second)), e.first->vertex(Mesh::cw(e.second))})
      if(m.squared_distance_to(Weighted_tensor(Symmetric_form(v->metric_tensor()), false)) > squared_roughness)
        return true;
    return false;
  }

  Vertex_handle opposite(const Edge& e) const
  {
    const auto g = e.first->neighbor(e.second);
    return g->vertex(Mesh::ccw(g->index(e.first->vertex(Mesh::ccw(e.second)))));
  }

  bool is_better_flipped(const Edge& e, bool by_quality) const
  {
    return by_quality ? m_mesh.is_flippable(e.first, e.second) && raises_quality(e)
                      : !m_mesh.is_locally_Delaunay(e.first, e.second);
  }

  // Strictly and by more than usual rounding errors, so that such flips come to an end.
  bool raises_quality(const Edge& e) const
  {
    const Vertex_handle p = e.first->vertex(e.second), q = opposite(e);
    const Vertex_handle a = e.first->vertex(Mesh::ccw(e.second)), b = e.first->vertex(Mesh::cw(e.second));
    const double before = (std::min)(quality(p, a, b), quality(q, b, a));
    const double after = (std::min)(quality(p, a, q), quality(q, b, p));
    return after > before + 1e-9 * std::abs(before);
  }

  double quality(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    return quality_at_barycentre(u->point(), v->point(), w->point(), m_tensor);
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const std::size_t m_maximum_of_flips, m_maximum_of_rough_flips;
  const bool m_is_uniform;
  std::size_t m_flips = 0, m_rough_flips = 0;
};

// Flips edges of the domain, whose faces are given, until no flip is wanted any
// more. Most edges need none: these are found first, by all threads.
template <class ConcurrencyTag, class Mesh>
void restore_connectivity(Mesh& mesh, const std::vector<typename Mesh::Face_handle>& faces)
{
  typedef typename Mesh::Edge Edge;
  Flip_rule<Mesh> rule(mesh);
  mesh.flip_edges(selected_of_chunks<ConcurrencyTag, Edge>(faces.size(), [&](std::size_t k, auto& wanted) {
    for(int i = 0; i < 3; ++i)
      if(faces[k]->vertex(Mesh::ccw(i))->index() < faces[k]->vertex(Mesh::cw(i))->index()
         && rule.is_wanted(Edge(faces[k], i)))
        wanted.push_back(Edge(faces[k], i));
  }), [&](const Edge& e) { return rule(e); });
}

template <class Mesh>
void restore_connectivity(Mesh& mesh)
{
  restore_connectivity<Sequential_tag>(mesh, mesh.faces_in_domain());
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_RESTORE_CONNECTIVITY_H

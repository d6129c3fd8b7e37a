// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FLIP_POLICY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FLIP_POLICY_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/have_multiples_of.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// Measures faces in the mean of the tensors of their vertices, without the field. No edge is rough.
struct Quality_in_mean_tensor
{
  template <class Vertex_handle>
  double operator()(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    return metric_quality(u->point(), v->point(), w->point(),
                          Symmetric_form(u->metric_tensor()) + Symmetric_form(v->metric_tensor())
                          + Symmetric_form(w->metric_tensor()));
  }

  template <class Quadrilateral>
  bool is_rough(const Quadrilateral&) const { return false; }
};

// Decides which edges are to be flipped, the vertices being where they are.
//
// The criterion of the triangulation decides, unless the measure calls the four
// vertices around the edge rough: then that criterion says little about the
// faces in between, and the flip must raise the lower quality of the two faces.
//
// Flips by quality come to an end, flips by the criterion might follow each
// other in a circle, above all where both rules meet. Therefore, after a number
// of flips, quality decides everywhere; and since rounding errors may make even
// qualities rise in a circle, after many more no flip is wanted. But as long as
// all tensors are multiples of one, the criterion decides alone: it does not
// depend on the sizes then, and its flips come to an end if it is decided exactly.
template <class Triangulation, class Measure>
class Flip_policy
{
  typedef typename Triangulation::Edge            Edge;
  typedef typename Triangulation::Vertex_handle   Vertex_handle;

public:
  // around an edge, counterclockwise; the edge leads from [1] to [3]
  typedef std::array<Vertex_handle, 4>            Quadrilateral;

  // The budget of flips is proportional to `size`, the number of edges or faces in question. Unless `is_uniform`,
  // tensors are known not to be multiples of one.
  Flip_policy(const Triangulation& t, const Measure& measure, std::size_t size, bool is_uniform = true)
    : m_t(t), m_measure(measure), m_maximum_of_flips(4 * size + 16), m_maximum_by_quality(size / 16 + 16),
      m_is_uniform(is_uniform)
  {}

  // whether an edge is to be flipped, as long as there are not too many flips
  bool is_wanted(const Edge& e) const { return is_free(e) && is_better_flipped(e, is_rough(e)); }

  // the same with a view to the flips already granted
  bool operator()(const Edge& e)
  {
    const bool is_finite = m_is_uniform && Triangulation::Geom_traits::has_exact_predicates;
    if(!is_free(e) || (!is_finite && m_flips > 8 * m_maximum_of_flips))
      return false;
    const bool by_quality = is_rough(e) || (!m_is_uniform && is_exhausted());
    if(!is_better_flipped(e, by_quality))
      return false;
    ++m_flips;
    m_flips_by_quality += by_quality;
    if(m_first == Vertex_handle())
      m_first = e.first->vertex(0);
    m_is_uniform = m_is_uniform && have_multiples_of(around(e), m_first->metric_tensor());
    return true;
  }

private:
  static bool is_free(const Edge& e) { return !e.first->is_constrained(e.second); }

  Quadrilateral around(const Edge& e) const
  {
    const Edge m = m_t.mirror_edge(e);
    return {{e.first->vertex(e.second), e.first->vertex(Triangulation::ccw(e.second)), m.first->vertex(m.second),
             e.first->vertex(Triangulation::cw(e.second))}};
  }

  bool is_rough(const Edge& e) const { return !m_is_uniform && m_measure.is_rough(around(e)); }

  bool is_exhausted() const { return m_flips > m_maximum_of_flips || m_flips_by_quality > m_maximum_by_quality; }

  bool is_better_flipped(const Edge& e, bool by_quality) const
  {
    return by_quality ? m_t.is_flippable(e.first, e.second) && raises_quality(around(e))
                      : !m_t.is_locally_Delaunay(e.first, e.second);
  }

  // Strictly and by more than usual rounding errors, so that such flips come to an end.
  bool raises_quality(const Quadrilateral& v) const
  {
    const double before = (std::min)(m_measure(v[0], v[1], v[3]), m_measure(v[2], v[3], v[1]));
    const double after = (std::min)(m_measure(v[0], v[1], v[2]), m_measure(v[2], v[3], v[0]));
    return after > before + 1e-9 * std::abs(before);
  }

  const Triangulation& m_t;
  const Measure        m_measure;
  const std::size_t    m_maximum_of_flips, m_maximum_by_quality;
  bool                 m_is_uniform;
  Vertex_handle        m_first; // of an edge that has been flipped
  std::size_t          m_flips = 0, m_flips_by_quality = 0;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_FLIP_POLICY_H

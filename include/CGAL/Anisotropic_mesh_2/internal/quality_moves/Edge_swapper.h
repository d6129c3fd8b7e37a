// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_EDGE_SWAPPER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_EDGE_SWAPPER_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// The operation "swap": flips edges of a patch until none is wanted.
//
// Where the tensors of the four vertices around an edge are multiples of one,
// the criterion of the triangulation does not depend on the order of insertion
// and decides; elsewhere the lower quality of the two faces does, and no edge
// comes that is out of the unit band, unless for another such edge.
template <class Patch>
class Edge_swapper
{
  typedef typename Patch::Geom_traits      Gt;
  typedef typename Patch::Vertex_handle    Vertex_handle;
  typedef typename Patch::Edge             Edge;
  typedef std::array<Vertex_handle, 4>     Quadrilateral;

public:
  // Returns whether there was a flip.
  bool operator()(Patch& patch) const
  {
    std::size_t flips = 0, before;
    do {
      before = flips;
      patch.for_each_edge([&](const Edge& e) {
        if(is_wanted(patch, e)) {
          patch.flip(e);
          ++flips;
        }
      });
    } while(flips > before && flips < budget(patch));
    return flips > 0;
  }

  bool is_wanted(const Patch& patch, const Edge& e) const
  {
    if(!patch.is_in_convex_quadrilateral(e))
      return false;
    const Quadrilateral v = patch.quadrilateral(e);
    if(has_multiples(v))
      return is_in_conflict(patch.geom_traits(), v);
    const Face_shape &s = e.first->info(), &t = e.first->neighbor(e.second)->info();
    const double least = (std::min)(s.quality, t.quality) + least_rise;
    const Symmetric_form between = 0.5 * (s.metric + t.metric);
    if(!looks_better(v, between, least))
      return false;
    const Face_shape right = patch.shape(v[0], v[1], v[2]), left = patch.shape(v[2], v[3], v[0]);
    return (std::min)(right.quality, left.quality) > least
        && (Unit_band<Patch>::permits(*v[0], *v[2], 0.5 * (right.metric + left.metric))
            || !Unit_band<Patch>::permits(*v[1], *v[3], between));
  }

  // whether the criterion asks for no flip of an edge on the border, where the mesh is not changed
  bool keeps_border(const Patch& patch) const
  {
    bool keeps = true;
    patch.for_each_open_border_edge([&](const Edge& e) {
      const Quadrilateral v = patch.quadrilateral(e);
      keeps = keeps && !(has_multiples(v) && is_in_conflict(patch.geom_traits(), v)
                         && patch.is_in_convex_quadrilateral(e));
    });
    return keeps;
  }

private:
  static constexpr double least_rise = 1e-6; // of a quality, so that flips come to an end
  static constexpr double doubt = 0.8;       // about a quality in the tensor of other faces

  // rounding errors might let flips go on
  static std::size_t budget(const Patch& patch) { return 2 * patch.tds().number_of_faces(); }

  // whether a flip might lead to a quality of `least`, by the tensors of the two faces as they are
  static bool looks_better(const Quadrilateral& v, const Symmetric_form& m, double least)
  {
    return (std::min)(metric_quality(v[0]->point(), v[1]->point(), v[2]->point(), m),
                      metric_quality(v[2]->point(), v[3]->point(), v[0]->point(), m)) > doubt * least;
  }

  // up to rounding, since tensors are interpolated
  static bool has_multiples(const Quadrilateral& v)
  {
    const Symmetric_form m = unimodular(v[0]->metric_tensor());
    return std::all_of(v.begin() + 1, v.end(), [&](Vertex_handle w) {
      return (unimodular(w->metric_tensor()) + (-1.) * m).norm() <= 1e-9 * m.norm();
    });
  }

  static Symmetric_form unimodular(const typename Patch::Metric_tensor_2& m)
  {
    const Symmetric_form form(m);
    return (1 / std::sqrt(form.determinant())) * form;
  }

  // whether the last but one vertex is in conflict with the face of the others
  static bool is_in_conflict(const Gt& gt, const Quadrilateral& v)
  {
    return gt.side_of_metric_circle_2_object()
             (v[0]->point(), v[1]->point(), v[3]->point(), v[2]->point(), v[0]->metric_tensor(),
              v[1]->metric_tensor(), v[3]->metric_tensor(), v[2]->metric_tensor()) == ON_POSITIVE_SIDE;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_EDGE_SWAPPER_H

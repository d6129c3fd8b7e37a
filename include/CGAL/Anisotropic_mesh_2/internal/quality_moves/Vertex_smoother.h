// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_VERTEX_SMOOTHER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_VERTEX_SMOOTHER_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Unit_frame.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The operation "move": lowers the penalty of a patch by a step of Newton's
// method for its free vertices in turn, none of which takes an edge out of the
// unit band.
template <class Patch>
class Vertex_smoother
{
  typedef typename Patch::Face_handle     Face_handle;
  typedef typename Patch::Vertex          Vertex;
  typedef typename Patch::Vertex_handle   Vertex_handle;

  // the derivatives of the penalty by the place of a vertex, in its frame
  struct Derivatives
  {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    double determinant() const { return xx*yy - xy*xy; }
    bool is_convex() const { return determinant() > 0 && xx > 0; }
  };

public:
  // Moves vertices that have a face of less quality than `threshold`, and that
  // have moved lately or have a neighbor that has; returns which did, by number.
  std::vector<bool> operator()(Patch& patch, double threshold, const std::vector<bool>& moved) const
  {
    std::vector<bool> result(moved.size(), false);
    for(auto v = patch.tds().vertices_begin(); v != patch.tds().vertices_end(); ++v) {
      if(!patch.is_free(v))
        continue;
      bool is_near_move = moved[v->index()];
      double least = 1;
      patch.for_each_face_at(v, [&](Face_handle f, int i) {
        least = (std::min)(least, f->info().quality);
        is_near_move = is_near_move || moved[f->vertex(Patch::Tds::ccw(i))->index()];
      });
      result[v->index()] = is_near_move && least < threshold && move(patch, v);
    }
    return result;
  }

private:
  static constexpr double longest_step = 0.2;
  static constexpr double least_step = 0.001; // shorter ones do not pay for their evaluations
  static constexpr int    maximum_of_attempts = 3;

  // The step is shortened if the penalty does not fall; returns whether there was one.
  bool move(Patch& patch, Vertex_handle v) const
  {
    const Unit_frame frame(v->point(), Symmetric_form(v->metric_tensor()));
    double start = 0;
    patch.for_each_face_at(v, [&](Face_handle f, int) { start += quality_penalty(f->info().quality); });
    Vector_of_doubles step = newton_step(derivatives(patch, v, frame));
    for(int i = 0; i < maximum_of_attempts && std::hypot(step.x, step.y) > least_step; ++i) {
      if(try_move(patch, v, frame.template point<typename Patch::Point>(step), start))
        return true;
      step = {step.x / 4, step.y / 4};
    }
    return false;
  }

  bool try_move(Patch& patch, Vertex_handle v, const typename Patch::Point& p, double penalty_permitted) const
  {
    const auto shapes = patch.shapes_around(v, p);
    double sum = 0;
    for(const auto& s : shapes)
      sum += quality_penalty(s.quality);
    if(!(sum < penalty_permitted))
      return false;
    Vertex to(p);
    to.set_metric_tensor(patch.metric_tensor(p, *v));
    if(!keeps_band(patch, v, to, shapes))
      return false;
    patch.move(v, p, to.metric_tensor(), shapes);
    return true;
  }

  // Those of q^-6, where q is a multiple of A/S, of the area of a triangle v, u, w and the sum of its squared edges.
  // As if each face kept its tensor: that needs no evaluation of the field, and where the step leads is checked.
  static Derivatives derivatives(const Patch& patch, Vertex_handle v, const Unit_frame& frame)
  {
    Derivatives d;
    patch.for_each_face_at(v, [&](Face_handle f, int i) {
      const Vector_of_doubles u = frame.in_frame(f->vertex(Patch::Tds::ccw(i))->point());
      const Vector_of_doubles w = frame.in_frame(f->vertex(Patch::Tds::cw(i))->point());
      const Symmetric_form m = frame.in_frame(f->info().metric);
      const double a = u.x*w.y - u.y*w.x, s = m(u.x, u.y) + m(w.x, w.y) + m(u.x - w.x, u.y - w.y);
      const double ax = (u.y - w.y) / a, ay = (w.x - u.x) / a; // derivatives of log A and log S
      const double sx = -2 * m(u.x + w.x, u.y + w.y, 1, 0) / s, sy = -2 * m(u.x + w.x, u.y + w.y, 0, 1) / s;
      const double x = sx - ax, y = sy - ay, scale = 6 * (quality_penalty(f->info().quality) + 1);
      d.x += scale * x;
      d.y += scale * y;
      d.xx += scale * (6*x*x + 4*m.a/s - sx*sx + ax*ax);
      d.xy += scale * (6*x*y + 4*m.b/s - sx*sy + ax*ay);
      d.yy += scale * (6*y*y + 4*m.c/s - sy*sy + ay*ay);
    });
    return d;
  }

  // Downhill where the penalty is not convex, and none at all where it has no derivatives.
  static Vector_of_doubles newton_step(const Derivatives& d)
  {
    Vector_of_doubles s{-d.x, -d.y};
    if(d.is_convex())
      s = {(d.xy*d.y - d.yy*d.x) / d.determinant(), (d.xy*d.x - d.xx*d.y) / d.determinant()};
    const double length = std::hypot(s.x, s.y);
    if(!std::isfinite(length) || length == 0)
      return {};
    if(length > longest_step || !d.is_convex())
      s = {s.x * longest_step / length, s.y * longest_step / length};
    return s;
  }

  // whether no edge of v leaves the unit band; the shapes are those of the faces afterwards
  static bool keeps_band(const Patch& patch, Vertex_handle v, const Vertex& to,
                         const typename Patch::Face_shapes& shapes)
  {
    bool keeps = true;
    std::size_t k = 0;
    patch.for_each_face_at(v, [&](Face_handle f, int i) {
      const Vertex& w = *f->vertex(Patch::Tds::ccw(i));
      const Face_shape& s = f->neighbor(Patch::Tds::cw(i))->info(); // of the face before
      const Symmetric_form& before = shapes[(k + shapes.size() - 1) % shapes.size()].metric;
      keeps = keeps && (Unit_band<Patch>::permits(to, w, 0.5 * (before + shapes[k].metric))
                        || !Unit_band<Patch>::permits(*v, w, 0.5 * (s.metric + f->info().metric)));
      ++k;
    });
    return keeps;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_VERTEX_SMOOTHER_H

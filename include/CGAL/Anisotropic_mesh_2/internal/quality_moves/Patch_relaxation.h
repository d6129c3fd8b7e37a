// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_RELAXATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_RELAXATION_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_flipper.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Unit_band.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Unit_frame.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Lowers the penalty of a patch, the sum of q^-6 - 1 over the qualities of its
// faces, by moves of its free vertices and by flips.
//
// Of good faces it is a multiple of what their qualities lack of 1, of bad ones
// much more: so neither the mean nor the least quality is bought too dearly
// with the other.
template <class Mesh>
class Patch_relaxation
{
  typedef Mesh_patch<Mesh>         Patch;
  typedef typename Patch::Point    Point;
  typedef typename Patch::Vertex   Vertex;

  // the derivatives of the penalty by the place of a vertex, in its frame
  struct Derivatives
  {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    bool is_finite() const { return std::isfinite(x + y + xx + xy + yy); }
    double determinant() const { return xx*yy - xy*xy; }
    bool is_convex() const { return determinant() > 0 && xx > 0; }
  };

public:
  explicit Patch_relaxation(const Mesh& mesh)
    : m_gt(mesh.geom_traits()), m_flip(mesh), m_band(mesh)
  {}

  // Moves those vertices in turn that have a face of less quality than
  // `threshold`, and flips. Gives up, and returns false, as soon as it does not
  // look as if a penalty of `goal` was within reach: each sweep brings less than
  // the one before.
  bool operator()(Patch& patch, double threshold, double goal) const
  {
    m_flip(patch);
    std::vector<bool> moved(patch.number_of_vertices(), true);
    double before = penalty(patch);
    for(int i = 0; i < maximum_of_sweeps; ++i) {
      moved = sweep(patch, threshold, moved);
      if(m_flip(patch))
        moved.assign(moved.size(), true);
      else if(std::find(moved.begin(), moved.end(), true) == moved.end())
        break;
      const double after = penalty(patch);
      if(after - goal > before - after)
        return false;
      before = after;
    }
    return true;
  }

  static double penalty(const Patch& patch)
  {
    double sum = 0;
    for(const auto& f : patch.faces())
      if(f.is_used)
        sum += penalty_of_quality(f.shape.quality);
    return sum;
  }

private:
  static constexpr int    maximum_of_sweeps = 5;
  static constexpr double longest_step = 0.2;
  static constexpr double least_step = 0.001;    // shorter ones do not pay for their evaluations
  static constexpr int    maximum_of_attempts = 3;

  static double penalty_of_quality(double q)
  {
    return q > 0 ? 1 / ((q*q*q) * (q*q*q)) - 1 : std::numeric_limits<double>::infinity();
  }

  // Moves vertices that have moved lately, or whose neighbors have; returns which did.
  std::vector<bool> sweep(Patch& patch, double threshold, const std::vector<bool>& moved) const
  {
    std::vector<bool> result(moved.size(), false);
    for(int v = 0; v < patch.number_of_vertices(); ++v) {
      if(!patch.is_free(v))
        continue;
      bool is_near_move = moved[v];
      double least = 1;
      patch.for_each_face_at(v, [&](int f, int i) {
        const auto& face = patch.faces()[f];
        least = (std::min)(least, face.shape.quality);
        is_near_move = is_near_move || moved[face.vertex[Patch::ccw(i)]];
      });
      result[v] = is_near_move && least < threshold && move(patch, v);
    }
    return result;
  }

  // A step of Newton's method, shortened if the penalty does not fall; returns whether there was one.
  bool move(Patch& patch, int v) const
  {
    const Unit_frame frame(patch.vertices()[v].point, Symmetric_form(patch.vertices()[v].tensor));
    const double start = penalty_around(patch, v);
    Vector_of_doubles step = newton_step(derivatives(patch, v, frame));
    for(int i = 0; i < maximum_of_attempts && std::hypot(step.x, step.y) > least_step; ++i) {
      if(try_move(patch, v, frame.template point<Point>(step), start))
        return true;
      step = {step.x / 4, step.y / 4};
    }
    return false;
  }

  bool try_move(Patch& patch, int v, const Point& p, double demerit_permitted) const
  {
    const typename Patch::Shapes shapes = patch.shapes_around(v, p);
    double sum = 0;
    for(const auto& s : shapes)
      sum += penalty_of_quality(s.quality);
    if(!(sum < demerit_permitted))
      return false;
    const Vertex to(p, m_gt.construct_metric_tensor_2_object()(p));
    if(!keeps_band(patch, v, to))
      return false;
    patch.move(v, to, shapes);
    return true;
  }

  static double penalty_around(const Patch& patch, int v)
  {
    double sum = 0;
    patch.for_each_face_at(v, [&](int f, int) { sum += penalty_of_quality(patch.faces()[f].shape.quality); });
    return sum;
  }

  // As if each face kept its tensor: that needs no evaluation of the field, and where the step leads is checked.
  static Derivatives derivatives(const Patch& patch, int v, const Unit_frame& frame)
  {
    Derivatives sum;
    patch.for_each_face_at(v, [&](int f, int i) {
      const auto& face = patch.faces()[f];
      add_derivatives(sum, face.shape.quality, frame.in_frame(face.shape.metric),
                      frame.in_frame(patch.vertices()[face.vertex[Patch::ccw(i)]].point),
                      frame.in_frame(patch.vertices()[face.vertex[Patch::cw(i)]].point));
    });
    return sum;
  }

  // Those of q^-6, where q is a multiple of A/S, of the area of a triangle 0, u, v and the sum of its squared edges.
  static void add_derivatives(Derivatives& d, double q, const Symmetric_form& m,
                              const Vector_of_doubles& u, const Vector_of_doubles& v)
  {
    const double f = 6 * (penalty_of_quality(q) + 1);
    const double a = u.x*v.y - u.y*v.x, s = m(u.x, u.y) + m(v.x, v.y) + m(u.x - v.x, u.y - v.y);
    const double ax = (u.y - v.y) / a, ay = (v.x - u.x) / a; // derivatives of log A and log S
    const double sx = -2 * m(u.x + v.x, u.y + v.y, 1, 0) / s, sy = -2 * m(u.x + v.x, u.y + v.y, 0, 1) / s;
    const double x = sx - ax, y = sy - ay;
    d.x += f * x;
    d.y += f * y;
    d.xx += f * (6*x*x + 4*m.a/s - sx*sx + ax*ax);
    d.xy += f * (6*x*y + 4*m.b/s - sx*sy + ax*ay);
    d.yy += f * (6*y*y + 4*m.c/s - sy*sy + ay*ay);
  }

  // Downhill where the penalty is not convex, and none at all where it has no derivatives.
  static Vector_of_doubles newton_step(const Derivatives& d)
  {
    Vector_of_doubles s{-d.x, -d.y};
    if(d.is_convex())
      s = {(d.xy*d.y - d.yy*d.x) / d.determinant(), (d.xy*d.x - d.xx*d.y) / d.determinant()};
    const double length = std::hypot(s.x, s.y);
    if(!d.is_finite() || !std::isfinite(length) || length == 0)
      return {};
    if(length > longest_step || !d.is_convex())
      s = {s.x * longest_step / length, s.y * longest_step / length};
    return s;
  }

  // whether no edge of v leaves the unit band
  bool keeps_band(const Patch& patch, int v, const Vertex& to) const
  {
    const Vertex& from = patch.vertices()[v];
    bool keeps = true;
    patch.for_each_face_at(v, [&](int f, int i) {
      const Vertex& w = patch.vertices()[patch.faces()[f].vertex[Patch::ccw(i)]];
      keeps = keeps && (m_band.permits(to, w) || !m_band.permits(from, w));
    });
    return keeps;
  }

  const typename Mesh::Geom_traits& m_gt;
  const Patch_flipper<Mesh> m_flip;
  const Unit_band<Mesh>     m_band;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_PATCH_RELAXATION_H

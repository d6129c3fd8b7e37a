// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_PATCH_RELAXATION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_PATCH_RELAXATION_H

#include <CGAL/Anisotropic_mesh_2/internal/Mesh_patch.h>
#include <CGAL/Anisotropic_mesh_2/internal/Patch_flipper.h>
#include <CGAL/Anisotropic_mesh_2/internal/Star_model.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/Unit_band.h>
#include <CGAL/Anisotropic_mesh_2/internal/Unit_frame.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/demerit.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// Lowers the demerit of a patch, the sum of q^-6 - 1 over the qualities of its
// faces, by moves of its free vertices and by flips.
//
// Where to move is decided by a model; the field is only evaluated where a
// vertex then comes to lie.
template <class Mesh>
class Patch_relaxation
{
  typedef Mesh_patch<Mesh>         Patch;
  typedef typename Patch::Point    Point;
  typedef typename Patch::Vertex   Vertex;

  // the derivatives of the demerit at a vertex, in its frame
  struct Derivatives
  {
    double x, y, xx, xy, yy;

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
  // look as if a demerit of `goal` was within reach: each sweep brings less than
  // the one before.
  bool operator()(Patch& patch, double threshold, double goal) const
  {
    m_flip(patch);
    std::vector<bool> moved(patch.number_of_vertices(), true);
    double before = demerit(patch);
    if(before > hopeless_at_first * goal)
      return false;
    for(int i = 0; i < maximum_of_sweeps; ++i) {
      moved = sweep(patch, threshold, moved);
      if(m_flip(patch))
        moved.assign(moved.size(), true);
      else if(std::find(moved.begin(), moved.end(), true) == moved.end())
        break;
      const double after = demerit(patch);
      if(after > hopeless * goal || after - goal > before - after)
        return false;
      before = after;
    }
    return true;
  }

  static double demerit(const Patch& patch)
  {
    double sum = 0;
    for(const auto& f : patch.faces())
      if(f.is_used)
        sum += demerit_of_quality(f.shape.quality);
    return sum;
  }

private:
  static constexpr int    maximum_of_sweeps = 5;
  static constexpr double hopeless_at_first = 6; // times the goal
  static constexpr double hopeless = 1.5;        // after a sweep
  static constexpr double difference = 0.02;   // between the places that are compared, in the metric
  static constexpr double longest_step = 0.2;
  static constexpr double least_step = 0.003;  // less does not count as a move
  static constexpr int    maximum_of_halvings = 3;

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
        least = std::min(least, face.shape.quality);
        is_near_move = is_near_move || moved[face.vertex[Patch::ccw(i)]];
      });
      result[v] = is_near_move && least < threshold && move(patch, v) > least_step;
    }
    return result;
  }

  // A step of Newton's method, shortened until the demerit falls; returns its metric length.
  double move(Patch& patch, int v) const
  {
    const Vertex& old = patch.vertices()[v];
    const Unit_frame frame(old.point, Symmetric_form(old.tensor));
    const double start = demerit_around(patch, v);
    Vector_of_doubles step = newton_step(Star_model(patch, v, frame));
    for(int i = 0; i <= maximum_of_halvings; ++i, step = {step.x / 2, step.y / 2}) {
      const double length = std::hypot(step.x, step.y);
      if(length <= least_step)
        break;
      if(try_move(patch, v, frame.template point<Point>(step), start))
        return length;
    }
    return 0;
  }

  bool try_move(Patch& patch, int v, const Point& p, double demerit_permitted) const
  {
    const typename Patch::Shapes shapes = patch.shapes_around(v, p);
    double sum = 0;
    for(const auto& s : shapes)
      sum += demerit_of_quality(s.quality);
    if(!(sum < demerit_permitted))
      return false;
    const Vertex to(p, m_gt.construct_metric_tensor_2_object()(p));
    if(!keeps_band(patch, v, to))
      return false;
    patch.move(v, to, shapes);
    return true;
  }

  static double demerit_around(const Patch& patch, int v)
  {
    double sum = 0;
    patch.for_each_face_at(v, [&](int f, int) { sum += demerit_of_quality(patch.faces()[f].shape.quality); });
    return sum;
  }

  static Vector_of_doubles newton_step(const Star_model& star)
  {
    const Derivatives d = derivatives(star, difference);
    return newton_step(d.is_finite() ? d : derivatives(star, difference / 20)); // next to an almost flat face
  }

  static Derivatives derivatives(const Star_model& star, double h)
  {
    const double middle = star.demerit(0, 0), right = star.demerit(h, 0), left = star.demerit(-h, 0);
    const double up = star.demerit(0, h), down = star.demerit(0, -h), diagonal = star.demerit(h, h);
    return {(right - left) / (2*h), (up - down) / (2*h), (right - 2*middle + left) / (h*h),
            (diagonal - right - up + middle) / (h*h), (up - 2*middle + down) / (h*h)};
  }

  // Downhill where the demerit is not convex, and none at all where it has no derivatives.
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

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_PATCH_RELAXATION_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STAR_MODEL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STAR_MODEL_H

#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/Unit_frame.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/demerit.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_quality.h>

#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The demerit of the faces around a free vertex as a function of its place,
// without evaluations of the field: the tensor at the barycentre of a face
// changes as it does between the three vertices.
class Star_model
{
  // with the vertex of the star at the origin; all in its frame
  struct Corner
  {
    Vector_of_doubles u, v;              // the other two vertices
    Symmetric_form    metric, by_x, by_y; // at the barycentre, and its derivatives by the place of the vertex
  };

public:
  template <class Patch>
  Star_model(const Patch& patch, int v, const Unit_frame& frame)
  {
    const Symmetric_form here = frame.in_frame(Symmetric_form(patch.vertices()[v].tensor));
    patch.for_each_face_at(v, [&](int f, int i) {
      const auto& face = patch.faces()[f];
      const auto& a = patch.vertices()[face.vertex[Patch::ccw(i)]];
      const auto& b = patch.vertices()[face.vertex[Patch::cw(i)]];
      add(frame.in_frame(a.point), frame.in_frame(b.point), frame.in_frame(face.shape.metric), here,
          frame.in_frame(Symmetric_form(a.tensor)), frame.in_frame(Symmetric_form(b.tensor)));
    });
  }

  double demerit(double x, double y) const
  {
    double sum = 0;
    for(const Corner& c : m_corners) {
      const Symmetric_form m = c.metric + x * c.by_x + y * c.by_y;
      const double ux = c.u.x - x, uy = c.u.y - y, vx = c.v.x - x, vy = c.v.y - y;
      sum += demerit_of_quality(quality_of_edges(ux, uy, vx, vy, m));
    }
    return sum;
  }

private:
  void add(const Vector_of_doubles& u, const Vector_of_doubles& v, const Symmetric_form& metric,
           const Symmetric_form& here, const Symmetric_form& at_u, const Symmetric_form& at_v)
  {
    const double thrice = 3 * (u.x*v.y - u.y*v.x); // as the barycentre goes a third of the way
    const Symmetric_form to_u = at_u + (-1) * here, to_v = at_v + (-1) * here;
    m_corners.push_back({u, v, metric, (v.y / thrice) * to_u + (-u.y / thrice) * to_v,
                         (-v.x / thrice) * to_u + (u.x / thrice) * to_v});
  }

  std::vector<Corner> m_corners;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STAR_MODEL_H

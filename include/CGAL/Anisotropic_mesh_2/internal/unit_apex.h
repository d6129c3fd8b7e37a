// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_UNIT_APEX_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_UNIT_APEX_H

#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The point to the left of the edge uv that completes it to a triangle with
// two sides of unit length, in the metric halfway to that point. Returns false
// where the edge is so long that there is none.
template <class Vertex_handle, class Construct_tensor, class Point_2>
bool unit_apex(Vertex_handle u, Vertex_handle v, const Construct_tensor& tensor, Point_2& apex)
{
  const double ux = CGAL::to_double(u->point().x()), uy = CGAL::to_double(u->point().y());
  const double dx = CGAL::to_double(v->point().x()) - ux, dy = CGAL::to_double(v->point().y()) - uy;
  double ax = 0, ay = 0; // from the midpoint of the edge to the apex
  for(int correction = 0; correction < 2; ++correction) {
    const Symmetric_form m(tensor(Point_2(ux + dx/2 + ax/2, uy + dy/2 + ay/2)));
    const double height_squared = 1 - m(dx, dy) / 4;
    if(!(height_squared > 0.1))
      return false;
    // normal to the edge in m, of the length sqrt(edge^T m edge / det m) in it
    const double nx = -(m.c*dy + m.b*dx), ny = m.a*dx + m.b*dy;
    const double scale = std::sqrt(height_squared / m(nx, ny));
    ax = scale*nx;
    ay = scale*ny;
  }
  apex = Point_2(ux + dx/2 + ax, uy + dy/2 + ay);
  return true;
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_UNIT_APEX_H

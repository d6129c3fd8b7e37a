// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_GRADIENT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_GRADIENT_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_parts.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Metric_sample.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// The energy of a face and its exact derivatives by the corners: by the chain rule, from those by the corners of
// parts, by tensors, which move with the face, and by the area.
struct Face_gradient
{
  double              energy = 0;
  Triangle_of_doubles by_corner = {};

  void add(const Face_part& part, const Triangle_of_doubles& by_corner_of_part)
  {
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k) {
        by_corner[i].x += part.corner[k][i] * by_corner_of_part[k].x;
        by_corner[i].y += part.corner[k][i] * by_corner_of_part[k].y;
      }
  }

  // An energy in the tensor of `s`, sampled at l, and its derivative by the entries of the tensor with a fixed
  // density, which here is the root of the determinant if it `moves`.
  void add(const Barycentric& l, const Metric_sample& s, double energy, Symmetric_form by_tensor,
           bool density_moves)
  {
    this->energy += energy;
    if(density_moves)
      by_tensor += energy / (2 * s.root_of_determinant * s.root_of_determinant)
                 * s.tensor.adjugate();
    const double x = contracted(by_tensor, s.by_x), y = contracted(by_tensor, s.by_y);
    for(int i = 0; i < 3; ++i) {
      by_corner[i].x += l[i] * x;
      by_corner[i].y += l[i] * y;
    }
  }

  // the derivative by the doubled area of the face
  void add(const Triangle_of_doubles& z, double by_doubled_area)
  {
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = z[(i + 1) % 3], &q = z[(i + 2) % 3];
      by_corner[i].x += by_doubled_area * (p.y - q.y);
      by_corner[i].y += by_doubled_area * (q.x - p.x);
    }
  }

private:
  static double contracted(const Symmetric_form& m, const Symmetric_form& n)
  {
    return m.a*n.a + 2*m.b*n.b + m.c*n.c;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_GRADIENT_H

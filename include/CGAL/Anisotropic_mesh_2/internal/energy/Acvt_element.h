// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACVT_ELEMENT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACVT_ELEMENT_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Weighted_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// A triangle, or a part of one, over which the metric is taken as known: the
// weighted tensor is interpolated between the corners and the middles of the edges.
struct Acvt_element
{
  std::array<Vector_of_doubles, 3> corner;
  std::array<Weighted_tensor, 3>   tensor;
  Weighted_tensor                  middle;
  // weighted, at the middle of the edge opposite to the corner: less the mean of the two ends
  std::array<Symmetric_form, 3>    bend;
  bool                             is_linear = false; // no bends

  Vector_of_doubles barycentre() const
  {
    return {(corner[0].x + corner[1].x + corner[2].x) / 3, (corner[0].y + corner[1].y + corner[2].y) / 3};
  }

  double area() const
  {
    return ((corner[1].x - corner[0].x) * (corner[2].y - corner[0].y)
          - (corner[1].y - corner[0].y) * (corner[2].x - corner[0].x)) / 2;
  }

  // how much the metric varies, as the largest squared distance of a corner's tensor from the middle one
  double squared_variation() const
  {
    const double inverse = 1 / middle.determinant;
    double largest = 0;
    for(const Weighted_tensor& t : tensor)
      largest = (std::max)(largest, middle.squared_distance_to(t, inverse));
    return largest;
  }

  // Leaves the tensor linear.
  void forget_bends()
  {
    bend.fill(Symmetric_form());
    is_linear = true;
  }

  // Guesses the tensors at the middles of the edges from the difference, at the
  // barycentre, to the mean of the corners. It is laid on the edges by the
  // squares of the differences along them, as it should be where sizes vary
  // linearly.
  void guess_bends()
  {
    Symmetric_form lack = middle.weighted;
    std::array<double, 3> share;
    for(int i = 0; i < 3; ++i) {
      share[i] = squared_difference(tensor[(i + 1) % 3], tensor[(i + 2) % 3]);
      lack += (-1./3) * tensor[i].weighted;
    }
    const double sum = share[0] + share[1] + share[2];
    const double scale = sum > 0 ? 9./4 / sum : 0;
    for(int i = 0; i < 3; ++i)
      bend[i] = scale * share[i] * lack;
  }

  // Takes them from the field.
  template <class Tensor_at>
  void sample_bends(const Tensor_at& tensor_at)
  {
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      bend[i] = tensor_at(Vector_of_doubles{(corner[j].x + corner[k].x) / 2,
                                            (corner[j].y + corner[k].y) / 2}).weighted;
      bend[i] += (-0.5) * (tensor[j].weighted + tensor[k].weighted);
    }
  }

  // quadratic
  Symmetric_form weighted_tensor(double l0, double l1, double l2) const
  {
    const double k12 = 4*l1*l2, k20 = 4*l2*l0, k01 = 4*l0*l1;
    const Symmetric_form &s0 = tensor[0].weighted, &s1 = tensor[1].weighted, &s2 = tensor[2].weighted;
    return Symmetric_form(
      l0*s0.a + l1*s1.a + l2*s2.a + k12*bend[0].a + k20*bend[1].a + k01*bend[2].a,
      l0*s0.b + l1*s1.b + l2*s2.b + k12*bend[0].b + k20*bend[1].b + k01*bend[2].b,
      l0*s0.c + l1*s1.c + l2*s2.c + k12*bend[0].c + k20*bend[1].c + k01*bend[2].c);
  }

  // Halfway between two points with the weighted tensors s and t, whose
  // barycentric coordinates differ by d.
  Symmetric_form halfway(const Symmetric_form& s, const Symmetric_form& t, double d0, double d1, double d2) const
  {
    const double k12 = d1*d2, k20 = d2*d0, k01 = d0*d1;
    return Symmetric_form((s.a + t.a)/2 - k12*bend[0].a - k20*bend[1].a - k01*bend[2].a,
                          (s.b + t.b)/2 - k12*bend[0].b - k20*bend[1].b - k01*bend[2].b,
                          (s.c + t.c)/2 - k12*bend[0].c - k20*bend[1].c - k01*bend[2].c);
  }

  Vector_of_doubles at(double l0, double l1, double l2) const
  {
    return {l0*corner[0].x + l1*corner[1].x + l2*corner[2].x,
            l0*corner[0].y + l1*corner[1].y + l2*corner[2].y};
  }

private:
  // of two tensors as the middle one sees them, up to a common factor
  double squared_difference(const Weighted_tensor& p, const Weighted_tensor& q) const
  {
    const double a = p.m.a - q.m.a, b = p.m.b - q.m.b, c = p.m.c - q.m.c;
    const double xx = middle.m.c*a - middle.m.b*b, xy = middle.m.c*b - middle.m.b*c;
    const double yx = middle.m.a*b - middle.m.b*a, yy = middle.m.a*c - middle.m.b*b;
    return (std::max)(0., xx*xx + 2*xy*yx + yy*yy);
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACVT_ELEMENT_H

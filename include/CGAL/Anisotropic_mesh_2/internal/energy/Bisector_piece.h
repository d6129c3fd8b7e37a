// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_PIECE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_PIECE_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <algorithm>
#include <cmath>


namespace CGAL::Anisotropic_mesh_2::internal {

// A straight piece near the bisector of two generators z and y, at which their
// regions have been cut. Vectors to points of it start in the middle between the two.
struct Bisector_piece
{
  Vector_of_doubles e;             // from z to y
  Vector_of_doubles begin, along;  // its first end; the vector from there to the other end

  // How both regions respond to moves of their generators: what the piece adds
  // to the responses of z and y, and to the block of the Hessian with rows of z and
  // columns of y.
  struct Response
  {
    Symmetric_form        of_z, of_y;
    Face_couplings::Block mixed;
  };

  double swept_area() const { return std::abs(e.x * along.y - e.y * along.x); }

  // How far, in multiples of e, the bisector in the tensor s lies beyond the
  // point at `x`: there, x is equally far from both generators. One step of
  // Newton's method; far away it means nothing and is cut off.
  double shift(const Symmetric_form& s, const Vector_of_doubles& x) const
  {
    return (std::max)(-0.2, (std::min)(0.2, -s(x.x, x.y, e.x, e.y) / s(e.x, e.y)));
  }

  // The gradients lose and gain what the bisector sweeps: with the tensor s all
  // along, the integrals over the piece of p p^T / g, q q^T / g and p q^T / g,
  // where p = 2 s (x - z), q = 2 s (x - y) and g is the length of the gradient of
  // the difference of both squared distances.
  Response response(const Symmetric_form& s) const
  {
    const Vector_of_doubles p = times(s, {begin.x + e.x/2, begin.y + e.y/2});
    const Vector_of_doubles q = times(s, {begin.x - e.x/2, begin.y - e.y/2}), w = times(s, along);
    const double c = 2 * swept_area() / s(e.x, e.y);
    const double xx = w.x*w.x/3, xy = w.x*w.y/3, yy = w.y*w.y/3;
    return {Symmetric_form(c * (p.x*(p.x + w.x) + xx), c * (p.x*p.y + (p.x*w.y + w.x*p.y)/2 + xy),
                           c * (p.y*(p.y + w.y) + yy)),
            Symmetric_form(c * (q.x*(q.x + w.x) + xx), c * (q.x*q.y + (q.x*w.y + w.x*q.y)/2 + xy),
                           c * (q.y*(q.y + w.y) + yy)),
            {c * (p.x*q.x + (p.x + q.x)*w.x/2 + xx), c * (p.x*q.y + (p.x*w.y + w.x*q.y)/2 + xy),
             c * (p.y*q.x + (p.y*w.x + w.y*q.x)/2 + xy), c * (p.y*q.y + (p.y + q.y)*w.y/2 + yy)}};
  }

private:
  static Vector_of_doubles times(const Symmetric_form& s, const Vector_of_doubles& v)
  {
    return {s.a*v.x + s.b*v.y, s.b*v.x + s.c*v.y};
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_PIECE_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// What the bisectors in a face, with a constant tensor, add to the responses of
// its corners and to the blocks of the Hessian between them.
class Face_response
{
public:
  Face_response(const Triangle_of_doubles& z, const Symmetric_form& tensor, double density)
    : m_corner(z), m_weighted(density * tensor)
  {
    std::array<double, 3> square, cosine;
    for(int k = 0; k < 3; ++k)
      square[k] = tensor(z[(k + 2) % 3].x - z[(k + 1) % 3].x, z[(k + 2) % 3].y - z[(k + 1) % 3].y);
    for(int k = 0; k < 3; ++k)
      cosine[k] = (square[(k + 1) % 3] + square[(k + 2) % 3] - square[k]) / 2;
    for(int r = 0; r < 3; ++r)
      if(cosine[r] <= 0) { // its bisectors end on the opposite edge
        for(int u : {(r + 1) % 3, (r + 2) % 3}) {
          const int v = 3 - r - u;
          const double t = square[v] / (2 * cosine[u]);
          add_piece(r, u, {z[u].x + t * (z[v].x - z[u].x), z[u].y + t * (z[v].y - z[u].y)});
        }
        return;
      }
    const double sum = square[0]*cosine[0] + square[1]*cosine[1] + square[2]*cosine[2];
    Vector_of_doubles centre; // of the circumcircle
    for(int k = 0; k < 3; ++k) {
      centre.x += square[k] * cosine[k] / sum * z[k].x;
      centre.y += square[k] * cosine[k] / sum * z[k].y;
    }
    for(int k = 0; k < 3; ++k)
      add_piece((k + 1) % 3, (k + 2) % 3, centre);
  }

  const Symmetric_form& of_corner(int k) const { return m_response[k]; }
  const Face_couplings& couplings() const { return m_couplings; }

private:
  // The gradients lose and gain what the bisector of the corners i and j sweeps, here from the middle between them to
  // `end`: the integrals over that piece of p p^T / g, q q^T / g and p q^T / g, where p = 2 s (x - z_i),
  // q = 2 s (x - z_j), s is the weighted tensor, and g is the length of the gradient of the difference of both
  // squared distances. From the middle on, p grows from v to v + w, and q from -v to w - v.
  void add_piece(int i, int j, const Vector_of_doubles& end)
  {
    const Vector_of_doubles &zi = m_corner[i], &zj = m_corner[j], e = {zj.x - zi.x, zj.y - zi.y};
    const Vector_of_doubles along = {end.x - (zi.x + zj.x) / 2, end.y - (zi.y + zj.y) / 2};
    const Vector_of_doubles v = m_weighted.times({e.x/2, e.y/2}), w = m_weighted.times(along);
    const double c = 2 * std::abs(e.x * along.y - e.y * along.x) / m_weighted(e.x, e.y);
    const Symmetric_form vv = product(v, v), vw = product(v, w), ww = product(w, w);
    m_response[i] += c * (vv + vw + (1./3) * ww);
    m_response[j] += c * (vv + -1. * vw + (1./3) * ww);
    const Symmetric_form m = c * ((1./3) * ww + -1. * vv);
    const double turn = c * (v.x*w.y - v.y*w.x) / 2;
    m_couplings.add(i, 3 - i - j, {m.a, m.b + turn, m.b - turn, m.c});
  }

  // the symmetric part of u v^T
  static Symmetric_form product(const Vector_of_doubles& u, const Vector_of_doubles& v)
  {
    return Symmetric_form(u.x*v.x, (u.x*v.y + u.y*v.x) / 2, u.y*v.y);
  }

  const Triangle_of_doubles     m_corner;
  const Symmetric_form          m_weighted;
  std::array<Symmetric_form, 3> m_response;
  Face_couplings                m_couplings;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H

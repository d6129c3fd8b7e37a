// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Metric_triangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <array>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// What the bisectors in a face, with a constant tensor, add to the responses of
// its corners and to the blocks of the Hessian between them.
class Face_response
{
public:
  Face_response(const Metric_triangle& t, const Symmetric_form& weighted_tensor)
    : m_corner(t.corner), m_weighted(weighted_tensor)
  {
    for(int r = 0; r < 3; ++r)
      if(t.cosine[r] <= 0) { // its bisectors end on the opposite edge
        add_piece_to_edge(t, r, (r + 1) % 3, (r + 2) % 3);
        add_piece_to_edge(t, r, (r + 2) % 3, (r + 1) % 3);
        return;
      }
    const Vector_of_doubles centre = point_of(m_corner, t.circumcentre());
    for(int k = 0; k < 3; ++k)
      add_piece((k + 1) % 3, (k + 2) % 3, centre);
  }

  const Symmetric_form& of_corner(int k) const { return m_response[k]; }
  const Face_couplings& couplings() const { return m_couplings; }

private:
  // the bisector of the obtuse corner r and the corner u, which ends on the way from u to v
  void add_piece_to_edge(const Metric_triangle& t, int r, int u, int v)
  {
    const double share = t.square[v] / (2 * t.cosine[u]);
    Barycentric end = {{0, 0, 0}};
    end[u] = 1 - share;
    end[v] = share;
    add_piece(r, u, point_of(m_corner, end));
  }

  // The gradients lose and gain what the bisector of the corners i and j sweeps, here from the middle between them to
  // `end`: the integrals over that piece of p p^T / g, q q^T / g and p q^T / g, where p = 2 s (x - z_i),
  // q = 2 s (x - z_j), s is the weighted tensor, and g is the length of the gradient of the difference of both
  // squared distances. From the middle on, p grows from v to v + w, and q from -v to w - v.
  void add_piece(int i, int j, const Vector_of_doubles& end)
  {
    const Vector_of_doubles &zi = m_corner[i], &zj = m_corner[j], e = {zj.x - zi.x, zj.y - zi.y};
    const Vector_of_doubles begin = middle(zi, zj), along = {end.x - begin.x, end.y - begin.y};
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

  const Triangle_of_doubles&    m_corner;
  const Symmetric_form          m_weighted;
  std::array<Symmetric_form, 3> m_response;
  Face_couplings                m_couplings;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_RESPONSE_H

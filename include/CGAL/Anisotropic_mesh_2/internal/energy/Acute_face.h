// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_gradient.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// A face with a constant tensor, divided among its corners by the bisectors, which
// meet in the circumcentre. If it is acute, energy and derivatives have a closed
// form in the squared lengths of the edges and the area, see the page "Derivations" of the manual.
class Acute_face
{
public:
  Acute_face(const Triangle_of_doubles& z, const Control_space::Sample& s, double density)
    : m_sample(s), m_density(density), m_area(2 * area(z) * s.root_of_determinant)
  {
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = z[(k + 1) % 3], &q = z[(k + 2) % 3];
      m_edge[k] = {q.x - p.x, q.y - p.y};
      m_square[k] = s.tensor(m_edge[k].x, m_edge[k].y);
    }
    for(int k = 0; k < 3; ++k)
      m_cosine[k] = (m_square[(k + 1) % 3] + m_square[(k + 2) % 3] - m_square[k]) / 2;
  }

  // whether it is acute indeed
  bool is_acute() const { return m_cosine[0] > 0 && m_cosine[1] > 0 && m_cosine[2] > 0; }

  // Adds the energy, its gradient, and the matrices of the parts of the regions.
  void add_to(Face_gradient& g, bool is_riemannian, const std::array<Region_contribution*, 3>& regions) const
  {
    const double root = m_sample.root_of_determinant, scale = m_density / root;
    const Closed_form e(m_square, m_cosine, m_area);
    Symmetric_form by_tensor; // with the density fixed
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles d = m_edge[k], p = m_sample.tensor.times(d);
      const double s = 2 * scale * e.by_square[k], t = scale * e.by_area * root;
      add_multiple(g.by_corner[(k + 2) % 3], s, p);
      add_multiple(g.by_corner[(k + 1) % 3], -s, p);
      add_multiple(g.by_corner[k], t, {-d.y, d.x});
      by_tensor += scale * e.by_square[k] * Symmetric_form(d.x*d.x, d.x*d.y, d.y*d.y);
    }
    // the area grows with the root of the determinant, by which the energy is divided
    by_tensor += scale * (e.by_area * m_area - e.value) / (2 * root * root)
               * Symmetric_form(m_sample.tensor.c, -m_sample.tensor.b, m_sample.tensor.a);
    g.add({{1./3, 1./3, 1./3}}, m_sample, scale * e.value, by_tensor, is_riemannian);
    const double sum = m_square[0]*m_cosine[0] + m_square[1]*m_cosine[1] + m_square[2]*m_cosine[2];
    for(int k = 0; k < 3; ++k) // what the two kites along the opposite edge leave
      regions[k]->moments.a += (1 - m_square[k]*m_cosine[k] / sum) * scale * m_area / 4 * m_sample.tensor;
  }

private:
  // The integral of the squared distance to the nearest corner, and its derivatives by the squared lengths of the
  // edges and by the doubled area, as if these were independent.
  struct Closed_form
  {
    double value = 0, by_area = 0;
    std::array<double, 3> by_square = {{0, 0, 0}};

    Closed_form(const std::array<double, 3>& square, const std::array<double, 3>& cosine, double area)
    {
      for(int k = 0; k < 3; ++k) {
        const double l = square[k] / 96, cotangent = cosine[k] / area, squared_cotangent = cotangent * cotangent;
        const double by_cosine = 3 * l * square[k] * (1 + squared_cotangent) / area;
        const double along_edge = l * cotangent * (3 + squared_cotangent);
        value += square[k] * along_edge;
        by_area -= by_cosine * cotangent;
        by_square[k] += 2 * along_edge - by_cosine / 2;
        by_square[(k + 1) % 3] += by_cosine / 2;
        by_square[(k + 2) % 3] += by_cosine / 2;
      }
    }
  };

  static void add_multiple(Vector_of_doubles& v, double t, const Vector_of_doubles& w)
  {
    v.x += t * w.x;
    v.y += t * w.y;
  }

  Control_space::Sample m_sample;
  double                m_density, m_area; // the latter doubled, in the tensor
  std::array<Vector_of_doubles, 3> m_edge; // by the opposite corner
  std::array<double, 3> m_square, m_cosine; // scalar products: the latter of the edges at a corner
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H

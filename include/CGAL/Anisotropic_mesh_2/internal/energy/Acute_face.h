// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Face_gradient.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Metric_triangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// An acute face with a constant tensor, divided among its corners by the bisectors, which
// meet in the circumcentre: energy and derivatives have a closed form in the squared
// lengths of the edges and the area, see the page "Derivations" of the manual.
class Acute_face
{
public:
  Acute_face(const Metric_triangle& t, const Metric_sample& s, double density)
    : m_triangle(t), m_sample(s), m_scale(density / s.root_of_determinant),
      m_area(2 * area(t.corner) * s.root_of_determinant)
  {}

  // Adds the energy, its gradient, and the matrices of the parts of the regions.
  void add_to(Face_gradient& g, bool is_riemannian, const std::array<Region_contribution*, 3>& regions) const
  {
    const double root = m_sample.root_of_determinant;
    const Closed_form e(m_triangle, m_area);
    Symmetric_form by_tensor; // with the density fixed
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles d = m_triangle.edge[k], p = m_sample.tensor.times(d);
      const double s = 2 * m_scale * e.by_square[k];
      add_multiple(g.by_corner[(k + 2) % 3], s, p);
      add_multiple(g.by_corner[(k + 1) % 3], -s, p);
      by_tensor += m_scale * e.by_square[k] * Symmetric_form(d.x*d.x, d.x*d.y, d.y*d.y);
    }
    g.add(m_triangle.corner, m_scale * e.by_area * root);
    // the area grows with the root of the determinant, by which the energy is divided
    by_tensor += m_scale * (e.by_area * m_area - e.value) / (2 * root * root) * m_sample.tensor.adjugate();
    g.add({{1./3, 1./3, 1./3}}, m_sample, m_scale * e.value, by_tensor, is_riemannian);
    const Barycentric centre = m_triangle.circumcentre();
    for(int k = 0; k < 3; ++k) // what the two kites along the opposite edge leave
      regions[k]->moments.a += (1 - centre[k]) * m_scale * m_area / 4 * m_sample.tensor;
  }

  // Adds the moments of the parts of the regions; returns the energy.
  double add_to(const std::array<Region_moments*, 3>& regions) const
  {
    const Barycentric l = m_triangle.circumcentre();
    const Vector_of_doubles centre = point_of(m_triangle.corner, l);
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles& z = m_triangle.corner[k];
      const Vector_of_doubles c = {centre.x - z.x, centre.y - z.y};
      Vector_of_doubles first = {0, 0}; // of the two triangles from the corner to the circumcentre
      for(int i : {(k + 1) % 3, (k + 2) % 3}) {
        const Vector_of_doubles& w = m_triangle.corner[i];
        const double share = l[3 - i - k] / 12; // a third of its area, which is half of that up to the other corner
        first.x += share * (c.x + (w.x - z.x) / 2);
        first.y += share * (c.y + (w.y - z.y) / 2);
      }
      const Symmetric_form weighted = m_scale * m_area * m_sample.tensor;
      const Vector_of_doubles g = weighted.times(first);
      regions[k]->a += (1 - l[k]) / 4 * weighted;
      regions[k]->gx += g.x;
      regions[k]->gy += g.y;
    }
    return m_scale * Closed_form(m_triangle, m_area).value;
  }

private:
  // The integral of the squared distance to the nearest corner, and its derivatives by the squared lengths of the
  // edges and by the doubled area, as if these were independent.
  struct Closed_form
  {
    double value = 0, by_area = 0;
    std::array<double, 3> by_square = {{0, 0, 0}};

    Closed_form(const Metric_triangle& t, double area)
    {
      for(int k = 0; k < 3; ++k) {
        const double l = t.square[k] / 96, cotangent = t.cosine[k] / area, squared_cotangent = cotangent * cotangent;
        const double by_cosine = 3 * l * t.square[k] * (1 + squared_cotangent) / area;
        const double along_edge = l * cotangent * (3 + squared_cotangent);
        value += t.square[k] * along_edge;
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

  const Metric_triangle& m_triangle;
  const Metric_sample&   m_sample;
  double                 m_scale, m_area; // density over mapped density; doubled area in the tensor
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_FACE_H

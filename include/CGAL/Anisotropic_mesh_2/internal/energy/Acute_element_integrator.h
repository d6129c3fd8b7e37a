// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_ELEMENT_INTEGRATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_ELEMENT_INTEGRATOR_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_piece.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>

#include <array>

namespace CGAL::Anisotropic_mesh_2::internal {

// Splits an element that has the generators as its corners, and is acute, by
// straight bisectors from the middles of the edges to the circumcentre. There the
// tensor is that of the circumcentre itself, so that both ends are right to
// second order in the variation of the metric. In between, the true bisector is
// bent; the area between it and the chord goes over to the other region. Without
// that, gradients would be wrong in first order, all with the same sign.
//
// Each of the six triangles between a corner, the middle of an edge and the
// circumcentre is integrated exactly for a tensor that is quadratic on it. The page
// "Derivations" of the manual derives the coefficients.
class Acute_element_integrator
{
public:
  // whether the element is acute; prepares the integration if so
  bool prepare(const Acvt_element& e)
  {
    return find_centre(e, e.middle.m)
        && find_centre(e, m_at_centre = e.weighted_tensor(m_centre[0], m_centre[1], m_centre[2]));
  }

  // Adds to the sums of the corners, and to the couplings unless that is null; returns the energy.
  double operator()(const Acvt_element& e, const std::array<Region_contribution*, 3>& sums,
                    Face_couplings* couplings) const
  {
    const Vector_of_doubles centre = e.at(m_centre[0], m_centre[1], m_centre[2]);
    std::array<Symmetric_form, 3> at_radius;
    for(int k = 0; k < 3 && !e.is_linear; ++k)
      at_radius[k] = halfway_to_centre(e, e.tensor[k].weighted, unit(k));
    const double area = e.area();
    double energy = 0;
    std::array<Region_contribution, 3> local; // not written through pointers, which slows down
    for(int k = 0; k < 3; ++k) {
      // the two triangles at the bisector of the corners i and j
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Symmetric_form mean = 0.5 * (e.tensor[i].weighted + e.tensor[j].weighted), at_edge = mean + e.bend[k];
      const Symmetric_form at_bisector
        = halfway_to_centre(e, at_edge, {k == 0 ? 0 : 0.5, k == 1 ? 0 : 0.5, k == 2 ? 0 : 0.5});
      const Vector_of_doubles middle = {(e.corner[i].x + e.corner[j].x) / 2, (e.corner[i].y + e.corner[j].y) / 2};
      const double part = area * m_centre[k] / 2;
      for(int c : {i, j}) {
        const Vector_of_doubles& z = e.corner[c];
        const Symmetric_form& s = e.tensor[c].weighted;
        const Vector_of_doubles u = {middle.x - z.x, middle.y - z.y}, v = {centre.x - z.x, centre.y - z.y};
        energy += e.is_linear
          ? add_triangle(u, v, part, s, at_edge, m_at_centre, local[c].moments)
          : add_triangle(u, v, part, s, at_edge, m_at_centre,
                         0.5 * (s + at_edge) + 0.25 * e.bend[k], at_bisector, at_radius[c], local[c].moments);
      }
      const Bisector_piece piece = {{e.corner[j].x - e.corner[i].x, e.corner[j].y - e.corner[i].y}, {0, 0},
                                    {centre.x - middle.x, centre.y - middle.y}};
      energy += correct(piece, at_bisector, local[i].moments, local[j].moments);
      if(couplings) {
        const Bisector_piece::Response response = piece.response(at_bisector);
        local[i].response += response.of_z;
        local[j].response += response.of_y;
        couplings->block[k] = response.mixed;
      }
    }
    for(int k = 0; k < 3; ++k)
      *sums[k] += local[k];
    return energy;
  }

private:
  typedef std::array<double, 3> Coordinates;

  bool find_centre(const Acvt_element& e, const Symmetric_form& m)
  {
    std::array<double, 3> square;
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = e.corner[(i + 1) % 3], &q = e.corner[(i + 2) % 3];
      square[i] = m(q.x - p.x, q.y - p.y);
    }
    double sum = 0;
    for(int i = 0; i < 3; ++i) {
      const double cosine = square[(i + 1) % 3] + square[(i + 2) % 3] - square[i];
      if(!(cosine > 0))
        return false;
      m_centre[i] = square[i] * cosine;
      sum += m_centre[i];
    }
    for(double& l : m_centre)
      l /= sum;
    return true;
  }

  static Coordinates unit(int k) { return {double(k == 0), double(k == 1), double(k == 2)}; }

  // from a point with the tensor s and the coordinates l
  Symmetric_form halfway_to_centre(const Acvt_element& e, const Symmetric_form& s, const Coordinates& l) const
  {
    return e.halfway(s, m_at_centre, l[0] - m_centre[0], l[1] - m_centre[1], l[2] - m_centre[2]);
  }

  // Over a triangle with one corner at the generator and the others at u and v
  // from there. The tensor is given at the corners and at the middles of the
  // edges; it is quadratic, and multiplied by the barycentric coordinates l, m of
  // u and v, by their squares and their product, it is integrated exactly.
  static double add_triangle(const Vector_of_doubles& u, const Vector_of_doubles& v, double area,
                             const Symmetric_form& s0, const Symmetric_form& su, const Symmetric_form& sv,
                             const Symmetric_form& s0u, const Symmetric_form& suv, const Symmetric_form& s0v,
                             Region_moments& moments)
  {
    const Symmetric_form at_u = s0u + suv, at_v = s0v + suv, edges = at_u + s0v, corners = s0 + su + sv;
    const Symmetric_form odd = (1./15) * edges + (-1./60) * corners, even = (1./45) * edges + (-1./90) * corners;
    const Symmetric_form l = odd + (1./20) * su + (1./15) * at_u, ll = even + (2./45) * (su + at_u);
    const Symmetric_form m = odd + (1./20) * sv + (1./15) * at_v, mm = even + (2./45) * (sv + at_v);
    const Symmetric_form lm = (1./45) * (edges + suv) + (-1./180) * s0;
    moments.a += (area / 3) * edges;
    moments.gx += area * (l.a*u.x + l.b*u.y + m.a*v.x + m.b*v.y);
    moments.gy += area * (l.b*u.x + l.c*u.y + m.b*v.x + m.c*v.y);
    return area * (ll(u.x, u.y) + 2 * lm(u.x, u.y, v.x, v.y) + mm(v.x, v.y));
  }

  // the same for a linear tensor, given at the corners
  static double add_triangle(const Vector_of_doubles& u, const Vector_of_doubles& v, double area,
                             const Symmetric_form& s0, const Symmetric_form& su, const Symmetric_form& sv,
                             Region_moments& moments)
  {
    const Symmetric_form sum = s0 + su + sv, l = sum + su, m = sum + sv;
    moments.a += (area / 3) * sum;
    moments.gx += (area / 12) * (l.a*u.x + l.b*u.y + m.a*v.x + m.b*v.y);
    moments.gy += (area / 12) * (l.b*u.x + l.c*u.y + m.b*v.x + m.c*v.y);
    return (area / 30) * ((l + su)(u.x, u.y) + (l + sv)(u.x, u.y, v.x, v.y) + (m + sv)(v.x, v.y));
  }

  // The distance of the true bisector from the chord is a parabola with zeros at both ends: see "The Strip
  // Between Chord and Bisector" on the page "Derivations" of the manual.
  static double correct(const Bisector_piece& piece, const Symmetric_form& s, Region_moments& mi, Region_moments& mj)
  {
    const Vector_of_doubles half = {piece.along.x / 2, piece.along.y / 2};
    const double shift = piece.shift(s, half), strip = 2./3 * shift * piece.swept_area();
    return mi.add(strip * s, half.x + piece.e.x / 2, half.y + piece.e.y / 2)
         + mj.add(-strip * s, half.x - piece.e.x / 2, half.y - piece.e.y / 2)
         + 1.2 * strip * shift * s(piece.e.x, piece.e.y); // the jump falls to zero across the strip
  }

  Coordinates    m_centre;    // barycentric coordinates of the circumcentre
  Symmetric_form m_at_centre; // weighted
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_ACUTE_ELEMENT_INTEGRATOR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_PART_INTEGRATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_PART_INTEGRATOR_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// A generator, and where the moments of its region are summed up.
struct Part_generator
{
  Vector_of_doubles position;
  Region_moments*   moments;
};
typedef boost::container::static_vector<Part_generator, 6> Part_generators;

// Integrates over a part of a face, in which the tensor is constant: divides the
// part exactly among the generators, and sums up the energy, its derivatives by the corners of
// the part and by the entries of the tensor, and the moments of the regions, which are minus half the derivatives by
// the generators. All are exact for this tensor.
class Part_integrator
{
public:
  typedef Triangle_of_doubles Corners;

  // `density` is that of the measure
  Part_integrator(const Corners& corners, const Symmetric_form& tensor, double density)
    : m_corner(corners), m_e1{corners[1].x - corners[0].x, corners[1].y - corners[0].y},
      m_e2{corners[2].x - corners[0].x, corners[2].y - corners[0].y},
      m_mass((m_e1.x*m_e2.y - m_e1.y*m_e2.x) * density), m_tensor(tensor), m_weighted(m_mass * tensor)
  {}

  void operator()(const Part_generators& generators)
  {
    const std::size_t n = generators.size();
    std::array<Distances, 6> distances;
    for(std::size_t i = 0; i < n; ++i)
      for(int k = 0; k < 3; ++k)
        distances[i][k] = m_tensor(m_corner[k].x - generators[i].position.x, m_corner[k].y - generators[i].position.y);
    const std::size_t nearest = nearest_everywhere(distances, n);
    if(nearest < n)
      return add_region(whole(), generators[nearest]);
    const Ranks ranks = relevant(distances, n);
    for(std::size_t i : ranks)
      add_region(moments(clipped(i, ranks, distances)), generators[i]);
  }

  double energy() const { return m_energy; }

  // by the corners, with the generators, the tensor and the area fixed
  const Corners& gradient() const { return m_gradient; }

  // by the entries of the tensor, the density being fixed: the integral of the density times (x - z)(x - z)^T
  Symmetric_form by_tensor() const { return m_mass * m_second; }

private:
  struct Corner { double u, v; }; // barycentric, the first being 1 - u - v
  typedef boost::container::static_vector<Corner, 16> Polygon;

  struct Moments { double one, u, v, uu, uv, vv; };

  typedef std::array<double, 3> Distances; // squared, to the corners of the part
  typedef boost::container::static_vector<unsigned char, 6> Ranks;

  // The differences of squared distances are linear, so that a generator which
  // is farther than another one at all corners is farther everywhere.
  static Ranks relevant(const std::array<Distances, 6>& distances, std::size_t n)
  {
    Ranks kept;
    for(std::size_t i = 0; i < n; ++i) {
      bool is_beaten = false;
      for(std::size_t j = 0; j < n && !is_beaten; ++j)
        is_beaten = j != i && beats(distances[j], distances[i]) && !(i < j && beats(distances[i], distances[j]));
      if(!is_beaten)
        kept.push_back(static_cast<unsigned char>(i));
    }
    return kept;
  }

  // The generator that is nearest at all corners, or n. At the middle of two generators both are.
  static std::size_t nearest_everywhere(const std::array<Distances, 6>& distances, std::size_t n)
  {
    static constexpr double rounding = 1 + 1e-12;
    Distances least = distances[0];
    for(std::size_t i = 1; i < n; ++i)
      for(int k = 0; k < 3; ++k)
        least[k] = (std::min)(least[k], distances[i][k]);
    std::size_t i = 0;
    while(i < n && !(distances[i][0] <= rounding * least[0] && distances[i][1] <= rounding * least[1]
                     && distances[i][2] <= rounding * least[2]))
      ++i;
    return i;
  }

  static bool beats(const Distances& g, const Distances& h) { return g[0] <= h[0] && g[1] <= h[1] && g[2] <= h[2]; }

  static Polygon clipped(std::size_t g, const Ranks& ranks, const std::array<Distances, 6>& distances)
  {
    Polygon polygon = {{0, 0}, {1, 0}, {0, 1}};
    for(std::size_t h : ranks)
      if(h != g) {
        Distances excess;
        for(int k = 0; k < 3; ++k)
          excess[k] = distances[g][k] - distances[h][k];
        polygon = clip(polygon, excess);
      }
    return polygon;
  }

  static double at(const std::array<double, 3>& linear, const Corner& c)
  {
    return linear[0] + c.u * (linear[1] - linear[0]) + c.v * (linear[2] - linear[0]);
  }

  // the part of the polygon where the linear function is not positive
  static Polygon clip(const Polygon& polygon, const std::array<double, 3>& linear)
  {
    Polygon result;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double vp = at(linear, p), vq = at(linear, q);
      if(vp <= 0)
        result.push_back(p);
      if((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
        const double t = vp / (vp - vq);
        result.push_back({p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)});
      }
    }
    return result;
  }

  static Moments whole() { return {1./2, 1./6, 1./6, 1./12, 1./24, 1./12}; }

  static Moments moments(const Polygon& polygon)
  {
    Moments sum = {0, 0, 0, 0, 0, 0};
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      const Corner &p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
      const double area = ((q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u)) / 2;
      const double u = p.u + q.u + r.u, v = p.v + q.v + r.v;
      sum.one += area;
      sum.u += area * u / 3;
      sum.v += area * v / 3;
      sum.uu += area * (u*u + p.u*p.u + q.u*q.u + r.u*r.u) / 12;
      sum.uv += area * (u*v + p.u*p.v + q.u*q.v + r.u*r.v) / 12;
      sum.vv += area * (v*v + p.v*p.v + q.v*q.v + r.v*r.v) / 12;
    }
    return sum;
  }

  // the vector a d + b e1 + c e2
  Vector_of_doubles combined(double a, const Vector_of_doubles& d, double b, double c) const
  {
    return {a*d.x + b*m_e1.x + c*m_e2.x, a*d.y + b*m_e1.y + c*m_e2.y};
  }

  void add_region(const Moments& m, const Part_generator& g)
  {
    const Vector_of_doubles d = {m_corner[0].x - g.position.x, m_corner[0].y - g.position.y};
    // the integrals of x - z, and of that times the second and third coordinate
    const Vector_of_doubles first = combined(m.one, d, m.u, m.v);
    const Vector_of_doubles u = combined(m.u, d, m.uu, m.uv), v = combined(m.v, d, m.uv, m.vv);
    const Symmetric_form second(d.x*first.x + m_e1.x*u.x + m_e2.x*v.x, d.x*first.y + m_e1.x*u.y + m_e2.x*v.y,
                                d.y*first.y + m_e1.y*u.y + m_e2.y*v.y);
    m_energy += m_weighted.a*second.a + 2*m_weighted.b*second.b + m_weighted.c*second.c;
    m_second += second;
    add_product(1, first, g.moments->gx, g.moments->gy);
    g.moments->a += m.one * m_weighted;
    add_product(2, {first.x - u.x - v.x, first.y - u.y - v.y}, m_gradient[0].x, m_gradient[0].y);
    add_product(2, u, m_gradient[1].x, m_gradient[1].y);
    add_product(2, v, m_gradient[2].x, m_gradient[2].y);
  }

  void add_product(double factor, const Vector_of_doubles& d, double& x, double& y) const
  {
    x += factor * (m_weighted.a*d.x + m_weighted.b*d.y);
    y += factor * (m_weighted.b*d.x + m_weighted.c*d.y);
  }

  Corners           m_corner;
  Vector_of_doubles m_e1, m_e2;
  double            m_mass; // density times doubled area
  Symmetric_form    m_tensor, m_weighted;
  double            m_energy = 0;
  Corners           m_gradient = {};
  Symmetric_form    m_second;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_PART_INTEGRATOR_H

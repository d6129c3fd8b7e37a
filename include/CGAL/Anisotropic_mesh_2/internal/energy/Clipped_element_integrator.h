// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_CLIPPED_ELEMENT_INTEGRATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_CLIPPED_ELEMENT_INTEGRATOR_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Bisector_piece.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Anisotropic_mesh_2::internal {

// Splits an element among any generators by clipping it with their bisectors in
// its middle tensor; the areas between these and the true bisectors are then
// added to the regions, so that gradients are right to second order.
class Clipped_element_integrator
{
public:
  struct Generator
  {
    Vector_of_doubles position;
    Region_contribution*      sums;
    int               corner;               // of the current face, or -1
    std::array<double, 3> squared_distance; // to the corners of the element
  };
  typedef boost::container::static_vector<Generator, 12> Generators;

  // Adds to the sums of the generators, and to the couplings of the corners of
  // the face unless that is null; returns the energy.
  double operator()(const Acvt_element& e, const Generators& all, Face_couplings* couplings) const
  {
    const Generators generators = relevant(e, all);
    double energy = 0;
    for(const Generator& g : generators) {
      const Polygon polygon = clipped(g, generators);
      energy += integrate(e, polygon, g);
      for(std::size_t i = 0; i < polygon.size(); ++i)
        if(polygon[i].beyond)
          energy += correct(e, polygon[i], polygon[(i + 1) % polygon.size()], g, couplings);
    }
    return energy;
  }

private:
  struct Corner
  {
    double l1, l2;           // barycentric, the first being 1 - l1 - l2
    const Generator* beyond; // the edge that begins here, if it is a bisector
  };
  typedef boost::container::static_vector<Corner, 16> Polygon;

  static double at(const std::array<double, 3>& linear, const Corner& c)
  {
    return linear[0] + c.l1 * (linear[1] - linear[0]) + c.l2 * (linear[2] - linear[0]);
  }

  // The differences of squared distances are linear, so that a generator which
  // is farther than another one at all corners is farther everywhere.
  static Generators relevant(const Acvt_element& e, Generators all)
  {
    for(Generator& g : all)
      for(int k = 0; k < 3; ++k)
        g.squared_distance[k] = e.middle.m(e.corner[k].x - g.position.x, e.corner[k].y - g.position.y);
    const std::size_t nearest = nearest_to_corner(all, 0);
    if(nearest_to_corner(all, 1) == nearest && nearest_to_corner(all, 2) == nearest)
      return Generators(1, all[nearest]);
    Generators kept;
    for(std::size_t i = 0; i < all.size(); ++i) {
      bool is_beaten = false;
      for(std::size_t j = 0; j < all.size() && !is_beaten; ++j)
        is_beaten = j != i && beats(all[j], all[i]) && !(i < j && beats(all[i], all[j]));
      if(!is_beaten)
        kept.push_back(all[i]);
    }
    return kept;
  }

  static std::size_t nearest_to_corner(const Generators& all, int k)
  {
    std::size_t nearest = 0;
    for(std::size_t i = 1; i < all.size(); ++i)
      if(all[i].squared_distance[k] < all[nearest].squared_distance[k])
        nearest = i;
    return nearest;
  }

  static bool beats(const Generator& g, const Generator& h)
  {
    return g.squared_distance[0] <= h.squared_distance[0] && g.squared_distance[1] <= h.squared_distance[1]
        && g.squared_distance[2] <= h.squared_distance[2];
  }

  static Polygon clipped(const Generator& g, const Generators& generators)
  {
    Polygon polygon = {{0, 0, nullptr}, {1, 0, nullptr}, {0, 1, nullptr}};
    for(const Generator& h : generators) {
      if(&h == &g)
        continue;
      std::array<double, 3> excess;
      for(int k = 0; k < 3; ++k)
        excess[k] = g.squared_distance[k] - h.squared_distance[k];
      polygon = clip(polygon, excess, h);
    }
    return polygon;
  }

  // the part of the polygon where the linear function is not positive
  static Polygon clip(const Polygon& polygon, const std::array<double, 3>& linear, const Generator& beyond)
  {
    Polygon result;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double vp = at(linear, p), vq = at(linear, q);
      const bool leaves = vp <= 0 && vq > 0, enters = vp > 0 && vq < 0;
      if(vp <= 0 && !(leaves && vp == 0))
        result.push_back(p);
      if(leaves || enters) {
        const double t = vp / (vp - vq);
        result.push_back({p.l1 + t * (q.l1 - p.l1), p.l2 + t * (q.l2 - p.l2), leaves ? &beyond : p.beyond});
      }
    }
    return result;
  }

  // on a fan of triangles, by the rule of six points that is exact up to degree four
  static double integrate(const Acvt_element& e, const Polygon& polygon, const Generator& g)
  {
    double energy = 0;
    const double area = e.area();
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      const Corner &p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
      const double part = area * ((q.l1 - p.l1) * (r.l2 - p.l2) - (q.l2 - p.l2) * (r.l1 - p.l1));
      for(const auto& rule : {std::array<double, 2>{0.223381589678011, 0.445948490915965},
                              std::array<double, 2>{0.109951743655322, 0.091576213509771}})
        energy += add(e, p, q, r, rule[1], part * rule[0], g) + add(e, q, r, p, rule[1], part * rule[0], g)
                + add(e, r, p, q, rule[1], part * rule[0], g);
    }
    return energy;
  }

  // at the point whose barycentric coordinates for p and q are t
  static double add(const Acvt_element& e, const Corner& p, const Corner& q, const Corner& r, double t, double weight,
                    const Generator& g)
  {
    const double l1 = t * (p.l1 + q.l1) + (1 - 2*t) * r.l1, l2 = t * (p.l2 + q.l2) + (1 - 2*t) * r.l2, l0 = 1 - l1 - l2;
    const Vector_of_doubles x = e.at(l0, l1, l2);
    return g.sums->moments.add(weight * e.weighted_tensor(l0, l1, l2), x.x - g.position.x, x.y - g.position.y);
  }

  // What the region of g gains or loses where its edge pq is not on the bisector,
  // by Simpson's rule along the edge; the generator beyond does the same with
  // the other sign.
  static double correct(const Acvt_element& e, const Corner& p, const Corner& q, const Generator& g,
                        Face_couplings* couplings)
  {
    const Vector_of_doubles &z = g.position, &y = p.beyond->position;
    const Vector_of_doubles middle = {(z.x + y.x) / 2, (z.y + y.y) / 2};
    const Vector_of_doubles xp = e.at(1 - p.l1 - p.l2, p.l1, p.l2), xq = e.at(1 - q.l1 - q.l2, q.l1, q.l2);
    const Bisector_piece piece = {{y.x - z.x, y.y - z.y}, {xp.x - middle.x, xp.y - middle.y},
                                  {xq.x - xp.x, xq.y - xp.y}};
    double energy = 0;
    for(int i = 0; i < 3; ++i) {
      const double l1 = p.l1 + i * (q.l1 - p.l1) / 2, l2 = p.l2 + i * (q.l2 - p.l2) / 2;
      const Vector_of_doubles x = e.at(1 - l1 - l2, l1, l2);
      const Symmetric_form s = e.weighted_tensor(1 - l1 - l2, l1, l2);
      const double shift = piece.shift(s, {x.x - middle.x, x.y - middle.y});
      const double strip = (i == 1 ? 4./6 : 1./6) * piece.swept_area() * shift;
      energy += g.sums->moments.add(strip * s, x.x - z.x, x.y - z.y) + strip * shift * s(piece.e.x, piece.e.y) / 2;
      if(couplings && i == 1)
        respond(piece, s, g, *p.beyond, *couplings);
    }
    return energy;
  }

  static void respond(const Bisector_piece& piece, const Symmetric_form& s, const Generator& g, const Generator& h,
                      Face_couplings& couplings)
  {
    const Bisector_piece::Response response = piece.response(s);
    g.sums->response += response.of_z;
    if(g.corner >= 0 && h.corner > g.corner)
      couplings.add(g.corner, 3 - g.corner - h.corner, response.mixed);
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_CLIPPED_ELEMENT_INTEGRATOR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_INTEGRATOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_INTEGRATOR_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The integrals over the region V of a generator z, w being the density of the
// measure: those of w, of w M and w M (x - z), and of w |x - z|^2 in M.
struct Region_integrals
{
  double         mass = 0;
  Region_moments moments;
  double         energy = 0;

  Region_integrals& operator+=(const Region_integrals& s)
  {
    mass += s.mass;
    moments += s.moments;
    energy += s.energy;
    return *this;
  }
};

// Integrates over a region that is made up of triangles, by Radon's rule, whose
// error is bounded by the difference to a rule of degree two; the triangle
// of the largest error is quartered until the sum of the errors of the mass
// centre is small.
//
// `Density` returns at a point the tensor of the distance and the density of the measure.
template <class Density>
class Region_integrator
{
public:
  typedef Triangle_of_doubles Triangle;

  // `tolerance` of the mass centre, relative to the root of the mean squared distance
  Region_integrator(const Density& density, double tolerance) : m_density(density), m_tolerance(tolerance) {}

  // Sets `error` to a bound of the error of the mass centre, as a length in the mean tensor.
  Region_integrals operator()(const std::vector<Triangle>& triangles, const Vector_of_doubles& generator,
                              double& error) const
  {
    std::vector<Part> heap;
    for(const Triangle& t : triangles)
      heap.push_back(integrate(t, generator));
    const Region_integrals scale = total(heap);
    error = 0;
    for(Part& p : heap)
      error += (p.error = length(p, scale));
    std::make_heap(heap.begin(), heap.end());
    const std::size_t limit = maximum_growth * triangles.size();
    const double goal = m_tolerance * std::sqrt((std::max)(0., scale.energy / scale.mass));
    while(error > goal && heap.size() < limit)
      quarter_worst(heap, generator, scale, error);
    return total(heap);
  }

private:
  static constexpr std::size_t maximum_growth = 100;

  struct Part
  {
    Triangle          triangle;
    Region_integrals  sum;
    Vector_of_doubles difference; // of the integrals of w M (x - z) by the two rules
    double            error = 0;

    bool operator<(const Part& p) const { return error < p.error; }
  };

  static Region_integrals total(const std::vector<Part>& parts)
  {
    Region_integrals sum;
    for(const Part& p : parts)
      sum += p.sum;
    return sum;
  }

  // how far the difference moves the mass centre
  static double length(const Part& p, const Region_integrals& scale)
  {
    const Vector_of_doubles d = scale.moments.solve(p.difference.x, p.difference.y);
    return std::sqrt((std::max)(0., (d.x * p.difference.x + d.y * p.difference.y) / scale.mass));
  }

  void quarter_worst(std::vector<Part>& heap, const Vector_of_doubles& generator, const Region_integrals& scale,
                     double& error) const
  {
    std::pop_heap(heap.begin(), heap.end());
    const Triangle t = heap.back().triangle;
    error -= heap.back().error;
    heap.pop_back();
    for(const Triangle& quarter : quarters(t)) {
      Part p = integrate(quarter, generator);
      error += (p.error = length(p, scale));
      heap.push_back(p);
      std::push_heap(heap.begin(), heap.end());
    }
  }

  Part integrate(const Triangle& t, const Vector_of_doubles& generator) const
  {
    Part p;
    p.triangle = t;
    const double whole = area(t);
    for_each_node_of_radon(t, [&](const Vector_of_doubles& x, double weight, double other) {
      add(p, x, generator, whole * weight, whole * other);
    });
    return p;
  }

  // a sample with its weights in both rules
  void add(Part& p, const Vector_of_doubles& x, const Vector_of_doubles& generator, double weight, double other) const
  {
    Symmetric_form m;
    double density;
    m_density(x, m, density);
    p.sum.mass += weight * density;
    const double dx = x.x - generator.x, dy = x.y - generator.y;
    p.sum.energy += p.sum.moments.add((weight * density) * m, dx, dy);
    p.difference.x += (weight - other) * density * (m.a*dx + m.b*dy);
    p.difference.y += (weight - other) * density * (m.b*dx + m.c*dy);
  }

  const Density& m_density;
  const double   m_tolerance;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_INTEGRATOR_H

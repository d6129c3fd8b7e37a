// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_BRUTE_FORCE_ACVT_H
#define ANISOTROPIC_MESH_2_TEST_BRUTE_FORCE_ACVT_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// The energy of a tessellation and the moments of its regions from the
// definition: dense samples of the domain, each given to the nearest of all
// generators under the tensor at the sample.
template <class Field, class Point>
class Brute_force_acvt
{
public:
  struct Moments
  {
    double a = 0, b = 0, c = 0, gx = 0, gy = 0; // integrals of w M and of w M (x - z)

    void pull(double& x, double& y) const
    {
      const double det = a*c - b*b;
      x = (c*gx - b*gy) / det;
      y = (a*gy - b*gx) / det;
    }
  };

  Brute_force_acvt(const Field& field, bool riemannian) : m_field(field), m_riemannian(riemannian) {}

  // Samples the triangle with k*k samples.
  void add_triangle(const Point& p, const Point& q, const Point& r, int k)
  {
    const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = r.x() - p.x(), vy = r.y() - p.y();
    const double weight = (ux*vy - uy*vx) / 2 / (k*k);
    for(int i = 0; i < k; ++i)
      for(int j = 0; j < k - i; ++j)
        for(int upper = 0; upper < (i + j < k - 1 ? 2 : 1); ++upper) {
          const double s = (i + (1 + upper) / 3.) / k, t = (j + (1 + upper) / 3.) / k;
          m_samples.push_back(Sample(*this, Point(p.x() + s*ux + t*vx, p.y() + s*uy + t*vy), weight));
        }
  }

  // by the index of the generator
  double operator()(const std::vector<Point>& generators, std::vector<Moments>& moments) const
  {
    moments.assign(generators.size(), Moments());
    double energy = 0;
    for(const Sample& s : m_samples) {
      std::size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for(std::size_t i = 0; i < generators.size(); ++i) {
        const double d = s.squared_distance(generators[i]);
        if(d < least) {
          least = d;
          nearest = i;
        }
      }
      energy += least;
      s.add_to(moments[nearest], generators[nearest]);
    }
    return energy;
  }

private:
  struct Sample
  {
    double x, y, a, b, c; // the tensor times the weight

    Sample(const Brute_force_acvt& acvt, const Point& p, double weight) : x(p.x()), y(p.y())
    {
      const auto m = acvt.m_field(p);
      const double w = acvt.m_riemannian ? weight * std::sqrt(m.m11()*m.m22() - m.m12()*m.m12()) : weight;
      a = w * m.m11();
      b = w * m.m12();
      c = w * m.m22();
    }

    double squared_distance(const Point& z) const
    {
      const double dx = x - z.x(), dy = y - z.y();
      return a*dx*dx + 2*b*dx*dy + c*dy*dy;
    }

    void add_to(Moments& m, const Point& z) const
    {
      const double dx = x - z.x(), dy = y - z.y();
      m.a += a; m.b += b; m.c += c;
      m.gx += a*dx + b*dy;
      m.gy += b*dx + c*dy;
    }
  };

  Field m_field;
  bool m_riemannian;
  std::vector<Sample> m_samples;
};

#endif // ANISOTROPIC_MESH_2_TEST_BRUTE_FORCE_ACVT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Metrics for tests of the kernel: those of which a flat picture is known, which
// makes triangulations comparable with CGAL's, and those that vary.

#ifndef ANISOTROPIC_MESH_2_TEST_METRICS_H
#define ANISOTROPIC_MESH_2_TEST_METRICS_H

#include "Random_numbers.h"

#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel     Epeck;
typedef CGAL::Simple_cartesian<CGAL::Exact_rational>          Rational_kernel;
typedef CGAL::Simple_cartesian<double>                        Double_kernel;

const double pi = 3.14159265358979323846;

template <class K>
using Field = std::function<CGAL::Metric_tensor_2<K>(const typename K::Point_2&)>;

template <class K>
using Traits = CGAL::Riemannian_metric_traits_2<K, Field<K> >;

template <class K>
using Triangulation = CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits<K> >;

template <class K>
using Reference_triangulation
  = CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Default,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

typedef std::pair<double, double>    XY;
typedef std::pair<int, int>          Index_pair;

// points, and segments between them that are constraints
struct Input
{
  std::string             name;
  std::vector<XY>         points;
  std::vector<Index_pair> segments;
};

template <class K>
typename K::Point_2 point(const XY& p) { return typename K::Point_2(p.first, p.second); }

template <class K>
std::vector<typename K::Point_2> points_of(const std::vector<XY>& input)
{
  std::vector<typename K::Point_2> result;
  for(const XY& p : input)
    result.push_back(point<K>(p));
  return result;
}

// ---------------------------------------------------------------- metrics with a known flat picture

// The plane is mapped by (a b; c d), and the metric is the one of the image.
struct Flat_metric
{
  const char* name;
  int a, b, c, d;
  bool is_wild; // multiplied by a wild function, which changes no alpha

  template <class K>
  typename K::Point_2 operator()(const typename K::Point_2& p) const
  {
    return typename K::Point_2(a*p.x() + b*p.y(), c*p.x() + d*p.y());
  }

  template <class K>
  Field<K> field() const
  {
    return [m = *this](const typename K::Point_2& p)
    {
      const double rho = m.is_wild ? wild(CGAL::to_double(p.x()), CGAL::to_double(p.y())) : 1;
      return CGAL::Metric_tensor_2<K>::from_entries(rho * (m.a*m.a + m.c*m.c), rho * (m.a*m.b + m.c*m.d),
                                                    rho * (m.b*m.b + m.d*m.d));
    };
  }

  // a power of four between 1e-9 and 1e9 that jumps from point to point
  static double wild(double x, double y)
  {
    std::uint64_t u, v;
    std::memcpy(&u, &x, sizeof u);
    std::memcpy(&v, &y, sizeof v);
    const std::uint64_t hash = (u ^ (v * 0x9e3779b97f4a7c15u)) * 0xbf58476d1ce4e5b9u;
    return std::ldexp(1., 2 * int((hash >> 40) % 31) - 30);
  }
};

const Flat_metric euclidean = {"Euclidean", 1, 0, 0, 1, false};
const Flat_metric stretched = {"stretched", 2, 0, 0, 1, false};
const Flat_metric sheared   = {"sheared", 1, 3, 0, 1, false};
const Flat_metric oblique   = {"oblique", 2, 1, 1, -3, false};
const Flat_metric isotropic = {"isotropic, wild", 1, 0, 0, 1, true};
const Flat_metric wild_and_stretched = {"stretched, wild", 2, 0, 0, 1, true};

// ---------------------------------------------------------------- what is unique about a Delaunay triangulation

template <class K>
using Edge_picture = std::tuple<typename K::Point_2, typename K::Point_2, bool>;

template <class T>
bool is_on_hull(const T& t, const typename T::Edge& e)
{
  return t.dimension() < 2 || t.is_infinite(e.first) || t.is_infinite(e.first->neighbor(e.second));
}

// the in-circle test of the two faces of the edge, in the flat picture
template <class K, class T>
CGAL::Oriented_side side(const T& t, const typename T::Edge& e, const Flat_metric& map)
{
  const typename T::Edge m = t.mirror_edge(e);
  const auto p = map.operator()<K>(e.first->vertex(0)->point());
  const auto q = map.operator()<K>(e.first->vertex(1)->point());
  const auto r = map.operator()<K>(e.first->vertex(2)->point());
  const auto s = map.operator()<K>(m.first->vertex(m.second)->point());
  return CGAL::orientation(p, q, r) == CGAL::LEFT_TURN ? CGAL::side_of_oriented_circle(p, q, r, s)
                                                       : CGAL::side_of_oriented_circle(p, r, q, s);
}

// The edges that every constrained Delaunay triangulation has: those of the
// hull, the constraints, and those that are strictly Delaunay.
template <class K>
struct Picture
{
  std::vector<Edge_picture<K> > edges;
  long violations = 0, ambiguous = 0;
};

template <class K, class T>
Picture<K> picture(const T& t, const Flat_metric& map)
{
  Picture<K> result;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    const bool constrained = t.is_constrained(*e);
    const CGAL::Oriented_side s = constrained || is_on_hull(t, *e) ? CGAL::ON_NEGATIVE_SIDE : side<K>(t, *e, map);
    result.violations += s == CGAL::ON_POSITIVE_SIDE;
    result.ambiguous += s == CGAL::ON_ORIENTED_BOUNDARY;
    if(s != CGAL::ON_NEGATIVE_SIDE)
      continue;
    auto p = map.operator()<K>(e->first->vertex(t.ccw(e->second))->point());
    auto q = map.operator()<K>(e->first->vertex(t.cw(e->second))->point());
    if(q < p)
      std::swap(p, q);
    result.edges.emplace_back(p, q, constrained);
  }
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

template <class T>
std::vector<Edge_picture<typename T::Geom_traits::Kernel> > all_edges(const T& t)
{
  std::vector<Edge_picture<typename T::Geom_traits::Kernel> > result;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    auto p = e->first->vertex(t.ccw(e->second))->point(), q = e->first->vertex(t.cw(e->second))->point();
    if(q < p)
      std::swap(p, q);
    result.emplace_back(p, q, t.is_constrained(*e));
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class T>
bool refuses_constraint(T& t, const typename T::Point& p, const typename T::Point& q)
{
  try {
    t.insert_constraint(p, q);
  }
  catch(const typename T::Intersection_of_constraints_exception&) {
    return true;
  }
  return false;
}

// ---------------------------------------------------------------- varying metrics

typedef CGAL::Metric_tensor_2<Epick> Tensor;

// fields with double tensors, for all kernels
typedef std::function<Tensor(double, double)> Plain_field;

template <class K>
Field<K> field_of(const Plain_field& plain)
{
  return [plain](const typename K::Point_2& p)
  {
    const Tensor m = plain(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    return CGAL::Metric_tensor_2<K>(m, [](double x) { return typename K::FT(x); });
  };
}

inline Tensor rotating(double x, double y)      { return Tensor::from_sizes(0.1, 1, 7*x + 11*y*y); }
inline Tensor rotating_fast(double x, double y) { return Tensor::from_sizes(1e-4, 1, 300*x + 700*y); }
inline Tensor layer(double x, double y)         { return Tensor::from_sizes(1e-4 + std::abs(x + y - 1), 1, 0.8); }
inline Tensor graded(double x, double y)        { return Tensor::from_size(1e-3 + std::hypot(x - 0.5, y - 0.5)); }

inline Tensor discontinuous(double x, double y)
{
  const int cell = int(std::floor(5*x)) + 3 * int(std::floor(5*y));
  return Tensor::from_sizes(std::pow(10., -std::abs(cell) % 5), 1, cell);
}

// a different tensor at every point, of any size and direction, up to 10^8 : 1
inline Tensor chaotic(double x, double y)
{
  Random_numbers random(unsigned(std::int64_t(x * 1e9) * 31 + std::int64_t(y * 1e9)));
  const double h = random.power_of_ten(-3, 3), ratio = random.power_of_ten(0, 8);
  return Tensor::from_sizes(h, h * ratio, random.real(0, pi));
}

const std::vector<std::pair<const char*, Plain_field> > varying_fields
  = {{"rotating", rotating}, {"rotating fast", rotating_fast}, {"layer", layer}, {"graded", graded},
     {"discontinuous", discontinuous}, {"chaotic", chaotic}};

#endif // ANISOTROPIC_MESH_2_TEST_METRICS_H

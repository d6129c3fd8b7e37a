// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_MESHES_H
#define ANISOTROPIC_MESH_2_TEST_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel        K;
typedef K::Point_2                                                 Point;
typedef CGAL::Metric_tensor_2<K>                                   Tensor;
typedef std::function<Tensor(const Point&)>                        Field;
typedef CGAL::Anisotropic_Delaunay_mesh_2<CGAL::Riemannian_metric_traits_2<K, Field> > Mesh;

inline const auto lloyd_method
  = CGAL::Anisotropic_mesh_2::parameters::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD);

// A domain with a metric, of which the tests know the area.
struct Case
{
  std::string                        name;
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  Field                              field;
  double                             area; // of the polygon; of the disc for a disc
};

inline CGAL::Anisotropic_mesh_domain_2<K> box(double lower, double upper)
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{Point(lower, lower), Point(upper, lower),
                                        Point(upper, upper), Point(lower, upper)});
  return domain;
}

// The planar cases of the paper (figures 4.2, 5.1 and 5.3).
inline std::vector<Case> paper_cases()
{
  std::vector<Case> cases;
  CGAL::Anisotropic_mesh_domain_2<K> disc, parallelogram;
  disc.add_circle(Point(0, 0), 10);
  parallelogram.add_polygon(std::vector<Point>{Point(0, 0), Point(30, 0), Point(40, 14), Point(10, 14)});
  cases.push_back({"disc", disc, [](const Point&) { return Tensor::from_sizes(1.5, 0.3, std::acos(-1.) / 4); },
                   100 * std::acos(-1.)});
  cases.push_back({"square4", box(0, 4), [](const Point& p)
                   { return Tensor::from_sizes(0.031 + p.x() / 4, 0.031 + p.y() / 4); }, 16});
  cases.push_back({"layer10", box(0, 10), [](const Point& p) {
                     const double d = std::abs(p.y() - 5), h = d/5 + 0.04;
                     return Tensor::from_sizes(std::abs(5 - 4*d/5) * h, h);
                   }, 100});
  cases.push_back({"square10", box(0, 10), [](const Point& p) {
                     const double d = std::abs(p.y() - 5), h = d/5 + 0.04;
                     return Tensor::from_sizes(h, std::abs(5 - 4*d/5) * h);
                   }, 100});
  cases.push_back({"parallelogram", parallelogram, [](const Point&) { return Tensor::from_sizes(2, 0.5); }, 420});
  return cases;
}

// Fields of an acceptance suite for metric meshers, on the unit square.
inline std::vector<Case> unit_square_cases()
{
  std::vector<Case> cases;
  cases.push_back({"side", box(0, 1), [](const Point& p)
                   { return Tensor::from_sizes(0.1, 0.01 + 0.09*p.y()); }, 1});
  cases.push_back({"linear-01", box(0, 1), [](const Point& p)
                   { return Tensor::from_sizes(0.1, 0.01 + 0.18*std::abs(p.y() - 0.5)); }, 1});
  cases.push_back({"polar-2", box(0, 1), [](const Point& p) {
                     const double r = std::hypot(p.x(), p.y()), d = (std::min)(10*std::abs(r - 0.5), 1.);
                     return Tensor::from_sizes(0.001 + 0.198*std::abs(r - 0.5), 0.1*d + 0.025*(1 - d),
                                               std::atan2(p.y(), p.x()));
                   }, 1});
  return cases;
}

// A square with a slit of some width, around whose tip the sizes grow.
inline Case notched_square()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{-1, -1}, {1, -1}, {1, -0.02}, {0, 0}, {1, 0.02}, {1, 1}, {-1, 1}});
  return {"notch", domain, [](const Point& p)
          { return Tensor::from_sizes(0.02 + 0.2 * std::hypot(p.x(), p.y()), 0.05 + 0.2 * std::abs(p.y() + 0.1)); }, 3.98};
}

// Metrics that no mesh of their size resolves.
inline std::vector<Case> rough_cases()
{
  const auto cell = [](double x, double y) {
    const unsigned h = (unsigned(40 * x) * 7919u + unsigned(40 * y) * 104729u) * 2654435761u;
    return std::array<double, 2>{{(h >> 8) % 1000 / 1000., (h >> 18) % 1000 / 1000.}};
  };
  return {
    {"step", box(0, 1), [](const Point& p)
     { return Tensor::from_size(std::hypot(p.x() - 0.51, p.y() - 0.23) < 0.3 ? 0.02 : 0.25); }, 1},
    {"checkerboard", box(0, 1), [](const Point& p)
     { return Tensor::from_size((int(4 * p.x()) + int(4 * p.y())) % 2 == 0 ? 0.03 : 0.09); }, 1},
    {"cells", box(0, 1), [cell](const Point& p) {
       const auto c = cell(p.x(), p.y());
       return Tensor::from_sizes(0.04 * std::exp(c[0] - 0.5), 0.04 * std::exp(c[1] - 0.5), 3 * c[0] * c[1]); }, 1},
    {"turns", box(0, 1), [](const Point& p) { return Tensor::from_sizes(0.01, 0.2, 9 * p.x()); }, 1},
    {"jump by 1000", box(0, 1), [](const Point& p) { return Tensor::from_sizes(p.x() < 0.5 ? 0.05 : 50, 0.05); }, 1}};
}

template <class Mesh>
double area_of(const Mesh& mesh)
{
  double area = 0;
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      area += CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  return area;
}

#endif // ANISOTROPIC_MESH_2_TEST_MESHES_H

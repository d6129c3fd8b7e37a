// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of parametric surfaces: topology, quality, seams and poles, and
// developable surfaces against the plane.

#include "include/any_surface.h"
#include "include/check.h"

#include <CGAL/Anisotropic_mesh_2/Callable_surface_3.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_ellipsoid_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_torus_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Anisotropic_mesh_2/Quadratic_graph_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/optimize_anisotropic_surface_mesh_3.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/anisotropic_surface_Voronoi_regions_3.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef K::Point_2                                          Point_2;
typedef K::Point_3                                          Point_3;
typedef CGAL::Anisotropic_mesh_2::Parameter_rectangle       Rectangle;
typedef CGAL::Anisotropic_mesh_2::Surface_mesh_statistics   Statistics;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

namespace {

Rectangle square(double side)
{
  Rectangle r;
  r.u_min = r.v_min = -side / 2;
  r.u_max = r.v_max = side / 2;
  return r;
}

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

template <class Mesh>
CGAL::Surface_mesh<Point_3> in_space(const Mesh& mesh)
{
  CGAL::Surface_mesh<Point_3> result;
  mesh.add_to(result);
  CHECK(result.is_valid(false) && result.number_of_faces() == mesh.number_of_faces());
  return result;
}

int euler_characteristic(const CGAL::Surface_mesh<Point_3>& m)
{
  return int(m.number_of_vertices()) - int(m.number_of_edges()) + int(m.number_of_faces());
}

// the mean quality of the faces for which `is_chosen(face)` holds
template <class Mesh, class Is_chosen>
double mean_quality(const Mesh& mesh, const Is_chosen& is_chosen)
{
  double sum = 0;
  int n = 0;
  for(const auto& f : mesh.faces())
    if(is_chosen(f)) {
      sum += CGAL::Anisotropic_mesh_2::internal::surface_quality
        (std::array<Point_3, 3>{mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2])}, CGAL::Metric_tensor_3<K>());
      ++n;
    }
  CHECK(n >= 5);
  return sum / n;
}

// ------------------------------------------------------------- closed surfaces

template <class Mesh>
void check_closed(const Mesh& mesh, int characteristic, const std::string& name)
{
  const CGAL::Surface_mesh<Point_3> m = in_space(mesh);
  CHECK_MSG(CGAL::is_closed(m) && CGAL::is_triangle_mesh(m), name);
  CHECK_MSG(euler_characteristic(m) == characteristic, name);
  CHECK_MSG(PMP::is_outward_oriented(m), name);
  CHECK_MSG(!PMP::does_self_intersect(m), name);
}

void check_quality(const Statistics& s, double mean, double least, const std::string& name,
                   double energy_ratio = 1.02)
{
  CHECK_MSG(s.quality_mean >= mean && s.quality_min >= least,
            name + ": " + std::to_string(s.quality_mean) + ", " + std::to_string(s.quality_min));
  CHECK_MSG(s.edge_length_unit_share > 0.98, name + ": " + std::to_string(s.edge_length_unit_share));
  CHECK_MSG(s.energy_ratio > 0.99 && s.energy_ratio < energy_ratio, name + ": " + std::to_string(s.energy_ratio));
}

// The faces that touch the seams of both parameters are as good as the others.
void test_torus()
{
  const auto field = surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.7), [](const Point_3& p) {
    return 0.1 + 0.2 * std::hypot(std::hypot(p.x(), p.y()) - 2.7, p.z()); // refined at the outer circle
  });
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(field);
  check_closed(mesh, 0, "torus");
  check_quality(CGAL::anisotropic_surface_mesh_statistics_3(mesh), 0.978, 0.6, "torus");
  const auto crosses_seam = [&](const auto& f) {
    for(int i = 0; i < 3; ++i) {
      const Point_2 &p = mesh.parameters(f[i]), &q = mesh.parameters(f[(i + 1) % 3]);
      if(std::abs(p.x() - q.x()) > CGAL_PI || std::abs(p.y() - q.y()) > CGAL_PI)
        return true;
    }
    return false;
  };
  const double at_seam = mean_quality(mesh, crosses_seam);
  const double elsewhere = mean_quality(mesh, [&](const auto& f) { return !crosses_seam(f); });
  CHECK_MSG(std::abs(at_seam - elsewhere) < 0.01, std::to_string(at_seam) + ", " + std::to_string(elsewhere));
}

// The same at the poles, one of which is refined.
void test_ellipsoid()
{
  const Point_3 pole(0, 0, 0.8);
  const auto field = surface_field(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(2, 1.2, 0.8), [=](const Point_3& p) {
    return 0.03 + 0.1 * distance(p, pole);
  });
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(field);
  check_closed(mesh, 2, "ellipsoid");
  check_quality(CGAL::anisotropic_surface_mesh_statistics_3(mesh), 0.984, 0.6, "ellipsoid");
  for(double z : {0.8, -0.8}) {
    const Point_3 p(0, 0, z);
    const double reach = 4 * (0.03 + 0.1 * distance(p, pole)); // four edges around
    const auto is_near = [&](const auto& f) { return distance(mesh.point(f[0]), p) < reach; };
    const double near = mean_quality(mesh, is_near), far = mean_quality(mesh, [&](const auto& f) { return !is_near(f); });
    CHECK_MSG(std::abs(near - far) < 0.01, std::to_string(near) + " at a pole, " + std::to_string(far));
  }
}

// Ellipsoids with places of a radius of curvature far below the size, where faces that one chart makes are upside
// down in another.
void test_sharp_ellipsoids()
{
  const auto check = [](double a, double b, double c, double size, const std::string& name) {
    const auto mesh = CGAL::make_anisotropic_surface_mesh_3
      (surface_field(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(a, b, c), [=](const Point_3&) { return size; }));
    check_closed(mesh, 2, name);
    const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
    CHECK_MSG(s.quality_mean > 0.975 && s.quality_min > 0.55,
              name + ": " + std::to_string(s.quality_mean) + ", " + std::to_string(s.quality_min));
    CHECK_MSG(s.energy_ratio > 0.97 && s.energy_ratio < 1.05, name + ": " + std::to_string(s.energy_ratio));
  };
  check(6, 1, 1, 0.3, "needle along x");
  check(1, 1, 6, 0.3, "needle along the poles");
  check(0.1, 1, 1, 0.1, "disc through the poles");
}

// Meshes of a few faces, which are large in every chart.
void test_figures_of_coarse_meshes()
{
  const auto check = [](const auto& surface, double size, int characteristic, double distance, const std::string& name) {
    const auto mesh = CGAL::make_anisotropic_surface_mesh_3(surface_field(surface, [=](const Point_3&) { return size; }));
    check_closed(mesh, characteristic, name);
    const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
    CHECK_MSG(s.distance_max < distance, name + ": " + std::to_string(s.distance_max));
    CHECK_MSG(s.energy_ratio > 0.97 && s.energy_ratio < 1.3, name + ": " + std::to_string(s.energy_ratio));
  };
  check(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(1, 1, 1), 5, 2, 1, "coarse sphere"); // the centre is as far as can be
  check(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.5), 0.8, 0, 0.5, "coarse torus");
}

// Sizes beyond the radius of curvature cannot be had; the figures say so, and are numbers.
void test_sizes_beyond_curvature()
{
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3
    (surface_field(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(1, 1, 1), [](const Point_3&) {
      return CGAL::Metric_tensor_3<K>::from_sizes(1, 1, 0.04);
    }));
  CHECK(CGAL::is_closed(in_space(mesh)) && euler_characteristic(in_space(mesh)) == 2);
  const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  s.for_each([](const char* name, double value) { CHECK_MSG(std::isfinite(value), name); });
  CHECK(s.edge_length_unit_share < 0.95 && s.normal_deviation_max > CGAL_PI / 2);
}

// A mesh that is folded in its chart has no tessellation there, but other figures.
void test_folded_mesh()
{
  const auto field = surface_field(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(1, 1, square(4)), [](const Point_3&) { return 1; });
  CGAL::Anisotropic_surface_mesh_3<std::decay_t<decltype(field)> > mesh(field);
  for(const Point_2& p : {Point_2(0, 0), Point_2(1, 0), Point_2(0, 1), Point_2(0.1, -0.5), Point_2(0.5, 1), Point_2(-0.5, 1)})
    mesh.add_vertex(p);
  mesh.add_face({0, 1, 2});
  mesh.add_face({3, 4, 5});
  mesh.add_face({0, 0, 0});
  const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  CHECK(s.triangles == 3 && s.quality_mean > 0.1 && s.quality_min == 0);
  s.for_each([](const char* name, double value) { CHECK_MSG(std::isfinite(value), name); });
}

void test_curvature_of_ellipsoid()
{
  typedef CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K> Ellipsoid;
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3
    (surface_field(Ellipsoid(2, 1.2, 0.8), CGAL::Anisotropic_mesh_2::Curvature_metric_3<Ellipsoid>(0.01, 0.01, 1)));
  check_closed(mesh, 2, "ellipsoid, curvature");
  const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  check_quality(s, 0.97, 0.6, "ellipsoid, curvature");
  CHECK(s.distance_max < 2 * 0.01 * 4 / 0.8); // twice the chord error of the largest radius of curvature
}

// The optimizer brings all vertices close to their mass centres, those at the
// seams and poles as well.
template <class Surface>
void check_gradient(const Surface& surface, const std::string& name)
{
  const auto field = surface_field(surface, [](const Point_3& p) { return 0.15 + 0.1 * std::abs(p.z()); });
  const auto gradient = [&](int iterations) {
    return CGAL::anisotropic_surface_mesh_statistics_3(CGAL::make_anisotropic_surface_mesh_3
      (field, np::quality_moves(false).number_of_iterations(iterations))).gradient_norm;
  };
  const double before = gradient(0), after = gradient(300);
  // what remains is the difference between the energy of the optimizer and the finer one of the statistics
  CHECK_MSG(std::isfinite(before) && after > 0 && after < 0.2 * before,
            name + ": " + std::to_string(before) + ", " + std::to_string(after));
}

void test_gradient()
{
  check_gradient(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.7), "torus");
  check_gradient(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(2, 1.2, 0.8), "ellipsoid");
  check_gradient(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(1, 1, square(2)), "paraboloid");
}

// On a sphere the area of the regions is known, and each place is like any other.
void test_tessellation_of_sphere()
{
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3
    (surface_field(CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(1, 1, 1), [](const Point_3&) { return 0.25; }));
  check_closed(mesh, 2, "sphere");
  const auto regions = CGAL::anisotropic_surface_Voronoi_regions_3(mesh);
  CHECK(regions.size() == mesh.number_of_vertices());
  double sum = 0, mean = 4 * CGAL_PI / double(regions.size());
  for(std::size_t v = 0; v < regions.size(); ++v) {
    double area = 0;
    for(const auto& t : regions[v].tiles)
      area += std::sqrt(CGAL::squared_area(t[0], t[1], t[2]));
    sum += area;
    CHECK_MSG(regions[v].vertex == v && area > 0.6 * mean && area < 1.4 * mean, std::to_string(area / mean));
    CHECK(regions[v].boundaries.size() == 1);
    for(const Point_3& p : regions[v].boundaries[0])
      CHECK(std::abs(distance(p, Point_3(0, 0, 0)) - 1) < 1e-12);
  }
  CHECK_MSG(std::abs(sum / (4 * CGAL_PI) - 1) < 0.01, std::to_string(sum)); // tiles are flat
}

// ------------------------------------------------------------- open surfaces

void test_paper_surfaces()
{
  typedef CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K> Graph;
  const auto check = [](const auto& mesh, double mean, double least, const std::string& name, double energy_ratio = 1.02) {
    const CGAL::Surface_mesh<Point_3> m = in_space(mesh);
    CHECK_MSG(euler_characteristic(m) == 1 && !PMP::does_self_intersect(m), name);
    check_quality(CGAL::anisotropic_surface_mesh_statistics_3(mesh), mean, least, name, energy_ratio);
  };
  check(CGAL::make_anisotropic_surface_mesh_3(surface_field
    (Graph(1, 1, square(2)), [](const Point_3& p) { return 0.06 + 0.15 * std::abs(p.y()); })), 0.979, 0.6, "paraboloid");
  check(CGAL::make_anisotropic_surface_mesh_3(surface_field
    (Graph(2, -4, square(1)), [](const Point_3&) { return CGAL::Metric_tensor_3<K>::from_sizes(0.04, 0.4, 0.04); })),
        0.971, 0.55, "saddle, sizes", 1.04); // along the ridge, quality moves pay for shapes with energy
  check(CGAL::make_anisotropic_surface_mesh_3(surface_field
    (Graph(2, -4, square(2)), CGAL::Anisotropic_mesh_2::Curvature_metric_3<Graph>(0.001, 0.005, 1))), 0.968, 0.55, "saddle, curvature");
}

// A cylinder and a cone, unrolled, are parts of the plane: with an isotropic
// metric their meshes have the statistics of the planar ones.
template <class Surface, class Map>
void check_developable(const Surface& surface, const Map& unroll, const std::string& name)
{
  const double size = 0.06;
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(surface_field(surface, [=](const Point_3&) {
    return size;
  }));
  const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  check_quality(s, 0.985, 0.8, name);
  double sum = 0, least = 1, longest = 0, shortest = 10;
  for(const auto& f : mesh.faces()) {
    const Point_2 p = unroll(mesh.parameters(f[0])), q = unroll(mesh.parameters(f[1])), r = unroll(mesh.parameters(f[2]));
    const auto m = CGAL::Anisotropic_mesh_2::internal::Symmetric_form(1 / (size*size), 0, 1 / (size*size));
    const double quality = CGAL::Anisotropic_mesh_2::internal::metric_quality(p, q, r, m);
    sum += quality;
    least = (std::min)(least, quality);
    for(const auto& e : {q - p, r - q, p - r}) {
      longest = (std::max)(longest, std::sqrt(e.squared_length()) / size);
      shortest = (std::min)(shortest, std::sqrt(e.squared_length()) / size);
    }
  }
  CHECK_MSG(std::abs(sum / double(mesh.number_of_faces()) - s.quality_mean) < 2e-3, name);
  CHECK_MSG(std::abs(least - s.quality_min) < 0.01, name);
  CHECK_MSG(std::abs(longest - s.edge_length_max) < 5e-3 && std::abs(shortest - s.edge_length_min) < 5e-3, name);
}

void test_developable_surfaces()
{
  Rectangle r;
  r.u_max = 1.5;
  check_developable(CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& p) { return Point_3(p.x(), p.y(), 3); }, r),
                    [](const Point_2& p) { return p; }, "plane");
  check_developable(CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& p) {
    return Point_3(std::cos(p.x()), std::sin(p.x()), p.y());
  }, r), [](const Point_2& p) { return p; }, "cylinder");
  r.v_min = 1;
  r.v_max = 2;
  check_developable(CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& p) { // of 60 degrees
    return Point_3(p.y() / 2 * std::cos(p.x()), p.y() / 2 * std::sin(p.x()), p.y() * std::sqrt(0.75));
  }, r), [](const Point_2& p) { return Point_2(p.y() * std::sin(p.x() / 2), p.y() * std::cos(p.x() / 2)); }, "cone");
}

// On the plane the mesh is that of the planar functions, vertex by vertex.
void test_plane()
{
  const Rectangle r;
  const auto size = [](double x, double y) { return 0.05 + 0.1 * x * y; };
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(surface_field
    (CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(0, 0, r), [&](const Point_3& p) { return size(p.x(), p.y()); }));
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point_2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto planar = CGAL::make_anisotropic_mesh_2
    (domain, CGAL::make_isotropic_metric_field_2<K>([&](const Point_2& p) { return size(p.x(), p.y()); }));
  CGAL::optimize_anisotropic_mesh_2(planar);
  CHECK(mesh.number_of_vertices() == planar.number_of_vertices());
  std::vector<Point_2> on_surface, in_plane(planar.points_begin(), planar.points_end());
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    on_surface.push_back(mesh.parameters(v));
  std::sort(on_surface.begin(), on_surface.end());
  std::sort(in_plane.begin(), in_plane.end());
  CHECK(on_surface == in_plane);
  const Statistics s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  const auto t = CGAL::anisotropic_mesh_statistics_2(planar);
  CHECK(std::abs(s.quality_mean - t.quality_mean) < 1e-12 && std::abs(s.quality_min3_min - t.quality_min3_min) < 1e-12);
  CHECK(std::abs(s.energy / t.energy - 1) < 1e-6 && std::abs(s.ideal_vertices / t.ideal_vertices - 1) < 1e-6);
  CHECK(std::abs(s.edge_length_mean - t.edge_length_mean) < 1e-4);
  CHECK_MSG(t.gradient_norm > 0 && std::abs(s.gradient_norm / t.gradient_norm - 1) < 1e-6,
            std::to_string(s.gradient_norm) + ", " + std::to_string(t.gradient_norm));
  CHECK(s.distance_max < 1e-15 && s.normal_deviation_max < 1e-15);
}

// A tube is closed in one direction, and keeps its ends.
void test_tube()
{
  Rectangle r;
  r.u_max = 2 * CGAL_PI;
  r.u_is_periodic = true;
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(surface_field
    (CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>([](const Point_2& p) { return Point_3(std::cos(p.x()), std::sin(p.x()), p.y()); }, r),
     [](const Point_3&) { return 0.15; }));
  const CGAL::Surface_mesh<Point_3> m = in_space(mesh);
  CHECK(euler_characteristic(m) == 0 && !PMP::does_self_intersect(m));
  int ends = 0;
  for(const auto h : m.halfedges())
    if(m.is_border(h)) {
      const double z = m.point(m.target(h)).z();
      CHECK(z == 0 || z == 1);
      ++ends;
    }
  CHECK(ends == 2 * 42); // the circumference is 41.9 sizes
  check_quality(CGAL::anisotropic_surface_mesh_statistics_3(mesh), 0.985, 0.8, "tube");
}

struct Obeying_visitor
{
  bool goes_on;
  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state&) const { return goes_on; }
};

// The optimizer alone, on a closed mesh and on one with a border: it lowers the energy
// and says why it stopped.
void test_optimizer()
{
  const auto optimize = [](auto& mesh, int iterations, double seconds = 0, bool goes_on = true) {
    return CGAL::optimize_anisotropic_surface_mesh_3(mesh, CGAL::parameters::number_of_iterations(iterations)
                                                    .maximum_running_time(seconds).visitor(Obeying_visitor{goes_on})).return_code;
  };
  const auto size = [](const Point_3& q) { return 0.15 + 0.05 * q.y(); };
  const auto check = [&](const Any_surface_field& field, const std::string& name) {
    const auto start = CGAL::make_anisotropic_surface_mesh_3
      (field, np::quality_moves(false).number_of_iterations(0));
    auto mesh = start;
    CHECK_MSG(optimize(mesh, 100, 1e-9) == CGAL::TIME_LIMIT_REACHED, name);
    CHECK_MSG(optimize(mesh, 100, 0, false) == CGAL::BOUND_REACHED, name);
    const auto after_two = optimize(mesh, 2); // the first steps may be too wild for the mesh to be better
    CHECK_MSG(after_two == CGAL::MAX_ITERATION_NUMBER_REACHED || after_two == CGAL::CANT_IMPROVE_ANYMORE, name);
    const auto code = optimize(mesh, 100);
    CHECK_MSG(code == CGAL::CANT_IMPROVE_ANYMORE || code == CGAL::CONVERGENCE_REACHED, name + std::to_string(code));
    const Statistics before = CGAL::anisotropic_surface_mesh_statistics_3(start), after = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
    CHECK_MSG(after.energy < 0.99 * before.energy, name + std::to_string(after.energy / before.energy));
    check_quality(after, 0.98, 0.8, name);
  };
  check(surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(1, 0.5), size), "torus, optimized");
  check(surface_field(CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>(0.5, 0.5, square(3)), size), "graph, optimized");
}

// However large the sizes, the mesh is closed or refused: no edge may lead around
// the tube to the vertex where it began.
void test_coarse_meshes()
{
  int closed = 0, refused = 0;
  for(double size : {0.5, 0.7, 0.9, 1.2, 1.6, 2.2, 3., 10.})
    try {
      check_closed(CGAL::make_anisotropic_surface_mesh_3
                     (surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.9), [=](const Point_3&) {
                       return size;
                     })), 0, "torus of size " + std::to_string(size));
      ++closed;
    }
    catch(const CGAL::Anisotropic_mesh_2::Invalid_domain_exception& e) {
      CHECK(std::string(e.what()).find("the sizes are too large") != std::string::npos);
      ++refused;
    }
  CHECK_MSG(closed >= 2 && refused >= 2, std::to_string(closed) + " closed");
}

// Where a domain goes once around, the mesh is not glued, nor by the optimizer, and each vertex but those at the
// seam has its region.
void test_part_on_both_sides_of_seam()
{
  const auto field = surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.7), [](const Point_3&) { return 0.3; });
  for(const std::array<double, 2>& part : {std::array<double, 2>{0, 1}, {0, 2 * CGAL_PI}, {1.1, 1}}) {
    const double u = part[0], height = part[1];
    CGAL::Anisotropic_mesh_domain_2<K> domain;
    domain.add_polygon(std::vector<Point_2>{Point_2(u, 0), Point_2(u + 2 * CGAL_PI, 0),
                                            Point_2(u + 2 * CGAL_PI, height), Point_2(u, height)});
    auto mesh = CGAL::make_anisotropic_surface_mesh_3(domain, field);
    const std::size_t vertices = mesh.number_of_vertices(), faces = mesh.number_of_faces();
    CGAL::optimize_anisotropic_surface_mesh_3(mesh, np::quality_moves(false));
    CHECK(mesh.number_of_vertices() == vertices && mesh.number_of_faces() == faces);
    CHECK(euler_characteristic(in_space(mesh)) == 1);
    check_quality(CGAL::anisotropic_surface_mesh_statistics_3(mesh), 0.96, 0.6, "part of a torus");
    if(height == 1)
      for(const auto& r : CGAL::anisotropic_surface_Voronoi_regions_3(mesh))
        CHECK(std::abs(mesh.parameters(r.vertex).x() - u) < 0.2 || !r.tiles.empty()); // an edge of length 0.3 there
  }
}

// Nothing calls a surface outside of its rectangle.
void test_strict_surface()
{
  std::atomic<int> outside(0);
  const auto strict = [&](const Point_2& p) {
    if(!(p.x() >= 0 && p.x() <= 1 && p.y() >= 0 && p.y() <= 1))
      ++outside;
    return Point_3(p.x(), p.y(), -p.x() * p.x() - p.y() * p.y());
  };
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3
    (surface_field(CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>(strict, Rectangle()), [](const Point_3&) { return 0.2; }));
  CHECK(CGAL::anisotropic_surface_mesh_statistics_3(mesh).distance_max < 0.02);
  CHECK(CGAL::anisotropic_surface_Voronoi_regions_3(mesh).size() == mesh.number_of_vertices());
  CHECK_MSG(outside == 0, std::to_string(outside) + " calls");
}

void test_no_iterations()
{
  const auto field = surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.7), [](const Point_3&) { return 0.3; });
  auto mesh = CGAL::make_anisotropic_surface_mesh_3(field, np::number_of_iterations(0));
  const auto faces = mesh.faces();
  const auto none = CGAL::optimize_anisotropic_surface_mesh_3(mesh, np::number_of_iterations(0));
  CHECK(none.return_code == CGAL::MAX_ITERATION_NUMBER_REACHED && none.iterations == 0 && none.largest_move > 0);
  CHECK(mesh.faces() == faces);
  CHECK(CGAL::optimize_anisotropic_surface_mesh_3(mesh, np::number_of_iterations(0).convergence(10.)).return_code
        == CGAL::CONVERGENCE_REACHED);
  CHECK(mesh.faces() == faces);
}

void test_refusals_of_rectangles()
{
  const auto refuses = [](const Rectangle& r, const char* text) {
    const Any_surface plane = {r, [](const Point_2& p) { return Point_3(p.x(), p.y(), 0); }, [](const Point_2&) {
      return std::array<K::Vector_3, 2>{K::Vector_3(1, 0, 0), K::Vector_3(0, 1, 0)};
    }};
    const Any_surface_field field(plane, [](const Any_surface&, const Point_2&) { return CGAL::Metric_tensor_3<K>(); });
    CHECK_THROWS(CGAL::make_anisotropic_surface_mesh_3(field), CGAL::Anisotropic_mesh_2::Invalid_domain_exception, text);
  };
  refuses({1, -1, 0, 1}, "the rectangle [1, -1] x [0, 1] of the parameters of the surface is not valid");
  refuses({0, 1, 0, std::nan("")}, "the rectangle [0, 1] x [0, nan]");
  Rectangle pole;
  pole.v_min_is_pole = true;
  refuses(pole, "poles only where u is periodic");
}

void test_refusals()
{
  const auto unit = [](const Point_3&) { return 0.2; };
  const auto folded = [](const Point_2& p) { return Point_3(p.x() * p.x(), p.y(), 0); };
  CHECK_THROWS(CGAL::make_anisotropic_surface_mesh_3(surface_field
                 (CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>(folded, Rectangle()), unit)),
               CGAL::Anisotropic_mesh_2::Degenerate_parametrization_exception, "the derivative of the surface by u is zero at the point (0, ");
  Rectangle r;
  r.u_is_periodic = r.v_is_periodic = true;
  const auto broken = [](const Point_2& p) { return Point_3(std::log(p.x() - 0.5), p.y(), 0); };
  CHECK_THROWS(CGAL::make_anisotropic_surface_mesh_3(surface_field
                 (CGAL::Anisotropic_mesh_2::make_callable_surface_3<K>(broken, r), unit)),
               CGAL::Anisotropic_mesh_2::Degenerate_parametrization_exception, "of the parameters (u, v)");
  const auto tiny = surface_field(CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 1), [](const Point_3&) { return 1e-5; });
  CHECK_THROWS(CGAL::make_anisotropic_surface_mesh_3(tiny, np::maximum_number_of_vertices(1000)),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "1000");
}

} // namespace

int main()
{
  test_torus();
  test_ellipsoid();
  test_sharp_ellipsoids();
  test_curvature_of_ellipsoid();
  test_gradient();
  test_tessellation_of_sphere();
  test_paper_surfaces();
  test_developable_surfaces();
  test_plane();
  test_tube();
  test_optimizer();
  test_coarse_meshes();
  test_figures_of_coarse_meshes();
  test_sizes_beyond_curvature();
  test_folded_mesh();
  test_part_on_both_sides_of_seam();
  test_strict_surface();
  test_no_iterations();
  test_refusals();
  test_refusals_of_rectangles();
  return finish();
}

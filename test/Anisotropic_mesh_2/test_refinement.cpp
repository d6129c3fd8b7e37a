// Where field points come from, which of them are taken, and what bounds their number, against brute force and closed
// forms.

#include "check.h"
#include "meshes.h"
#include "Random_numbers.h"

#include <CGAL/Anisotropic_mesh_2/internal/meshing/unit_apex.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Point_placement;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

typedef CGAL::Riemannian_metric_traits_2<K, Field> Traits;

// ---------------------------------------------------------------- edges

// Sizes that grow linearly along the edge: as many parts as its length is near to, all of the same length.
void test_parts_of_edges()
{
  for(double slope : {0.02, 0.5, 1.})
    for(double l : {0.9, 1.38, 1.45, 2.4, 2.6, 7.7}) {
      const Field field = [=](const Point& p) { return Tensor::from_sizes(0.1 + slope * p.x(), 7); };
      const auto length = [=](const Point& p) { return std::log1p(10 * slope * p.x()) / slope; };
      const Point p(0, 0), q(std::expm1(l * slope) / (10 * slope), 0);
      const double n = l <= std::sqrt(2.) ? 1 : (std::max)(2., std::round(l));
      Edge_subdivision<Point> subdivision;
      for(bool is_forward : {true, false}) {
        std::vector<Point> points = is_forward ? subdivision(p, field(p), q, field(q), field)
                                               : subdivision(q, field(q), p, field(p), field);
        if(!is_forward)
          std::reverse(points.begin(), points.end());
        CHECK_MSG(double(points.size()) == n - 1, std::to_string(points.size()) + " points in " + std::to_string(l));
        for(std::size_t k = 0; k < points.size(); ++k)
          CHECK_MSG(std::abs(length(points[k]) - double(k + 1) * l / n) < 0.03 && points[k].y() == 0,
                    std::to_string(length(points[k])) + " of " + std::to_string(l));
      }
    }
}

// to the left of the edge, at unit distance from both ends
void test_apex()
{
  Random_numbers random(5);
  int found = 0;
  for(int i = 0; i < 200; ++i) {
    const double h1 = random.power_of_ten(-1.5, 1.5), h2 = random.power_of_ten(-1.5, 1.5);
    const Tensor m = Tensor::from_sizes(h1, h2, random.real(0, 3));
    const double x = random.real(-1, 1), y = random.real(-1, 1), length = std::sqrt(m.squared_length(x, y));
    const double wanted = random.real(0.1, 2.2);
    const Point u(random.real(-1, 1), 3), v(u.x() + x * wanted / length, 3 + y * wanted / length);
    Point apex;
    if(!unit_apex(u, v, Symmetric_form(m), apex)) {
      CHECK(wanted > 1.89); // the apex is near to the edge, or there is none
      continue;
    }
    ++found;
    CHECK(wanted < 1.9 && CGAL::orientation(u, v, apex) == CGAL::LEFT_TURN);
    for(const Point& end : {u, v})
      CHECK(std::abs(m.squared_length(apex - end) - 1) < 1e-6);
  }
  CHECK(found > 100);
}

// ---------------------------------------------------------------- samples

std::vector<std::pair<double, double> > samples_in(const Domain_samples& lattice, const Triangle_of_doubles& t)
{
  std::vector<std::pair<double, double> > result;
  lattice.for_each_in(t, [&](const Vector_of_doubles& x) {
    result.emplace_back(x.x, x.y);
    if(result.size() > 1000000)
      throw std::length_error("samples without end");
  });
  std::sort(result.begin(), result.end());
  return result;
}

// Samples lie in their triangle, one in each cell, and no disc of more than 0.62 times the root of a cell's area is
// without one; those of the parts of a triangle are those of the triangle.
void test_lattice()
{
  Random_numbers random(3);
  const double cell = 0.003, radius = 0.6205 * std::sqrt(cell);
  const Domain_samples lattice(cell);
  for(int i = 0; i < 20; ++i) {
    Triangle_of_doubles t;
    for(Vector_of_doubles& p : t) {
      p.x = random.real(-1, 1);
      p.y = random.real(-1, 1);
    }
    if(area(t) < 0)
      std::swap(t[0], t[1]);
    const auto distance_to_side = [&](double x, double y, int k) { // negative outside
      const Vector_of_doubles &p = t[k], &q = t[(k + 1) % 3];
      return ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) / std::hypot(q.x - p.x, q.y - p.y);
    };
    const auto depth = [&](double x, double y) {
      return (std::min)({distance_to_side(x, y, 0), distance_to_side(x, y, 1), distance_to_side(x, y, 2)});
    };
    const auto samples = samples_in(lattice, t);
    double perimeter = 0;
    for(int k = 0; k < 3; ++k)
      perimeter += std::hypot(t[k].x - t[(k + 1) % 3].x, t[k].y - t[(k + 1) % 3].y);
    CHECK(std::abs(double(samples.size()) * cell - area(t)) <= radius * perimeter);
    for(const auto& s : samples)
      CHECK(depth(s.first, s.second) > -1e-12);
    for(int k = 0; k < 100; ++k) {
      const double x = random.real(-1, 1), y = random.real(-1, 1);
      if(depth(x, y) > radius)
        CHECK(std::any_of(samples.begin(), samples.end(),
                          [&](const auto& s) { return std::hypot(s.first - x, s.second - y) <= radius; }));
    }
    std::vector<std::pair<double, double> > of_parts;
    for(const Triangle_of_doubles& part : quarters(t)) {
      const auto more = samples_in(lattice, part);
      of_parts.insert(of_parts.end(), more.begin(), more.end());
    }
    CHECK(of_parts.size() == samples.size());
  }
}

// Where rows are so far from the origin that doubles do not tell one from the next, there is an end all the same.
void test_far_samples()
{
  const Domain_samples lattice(1);
  const double direction = 0.4 + CGAL_PI / 3; // of the lattice
  for(double far : {1e15, 1e17, 1e19}) {
    const double x = far * std::cos(direction), y = far * std::sin(direction), size = 1e-14 * far;
    try {
      CHECK(samples_in(lattice, {{{x, y}, {x + size, y}, {x, y + size}}}).size() < 100000);
    }
    catch(const std::length_error& e) {
      CHECK_MSG(false, e.what());
    }
  }
}

// ---------------------------------------------------------------- places

Mesh empty_square(const Field& field, double side = 1)
{
  Mesh mesh{Traits(field)};
  Mesh::Boundary_graph boundary;
  boundary.points = {Point(0, 0), Point(side, 0), Point(side, side), Point(0, side)};
  for(std::size_t k = 0; k < 4; ++k)
    boundary.segments.push_back({k, (k + 1) % 4, 1, true});
  mesh.insert_boundary(boundary);
  return mesh;
}

std::vector<Point> uncovered_places(const Field& field)
{
  const Mesh mesh = empty_square(field);
  return Uncovered_area<Mesh>(mesh).places();
}

// Faces have too much area from 2.5 times that of a unit triangle on; a disc of a hundredth of the domain's extent
// that is fine is found wherever it is.
void test_places()
{
  const double size = std::sqrt(0.5 / (2.5 * std::sqrt(3.) / 4)); // of which the two faces have 2.5 times the area
  CHECK(uncovered_places([=](const Point&) { return Tensor::from_size(1.02 * size); }).empty());
  CHECK(uncovered_places([=](const Point&) { return Tensor::from_size(0.98 * size); }).size() == 2);
  Random_numbers random(8);
  for(int i = 0; i < 40; ++i) {
    const double radius = 0.0125, x = random.real(radius, 1 - radius), y = random.real(radius, 1 - radius);
    const auto is_inside = [=](const Point& p) { return std::hypot(p.x() - x, p.y() - y) < radius; };
    const std::vector<Point> places = uncovered_places([=](const Point& p)
                                                       { return Tensor::from_size(is_inside(p) ? 0.002 : 2); });
    CHECK(!places.empty() && places.size() <= 2 && std::all_of(places.begin(), places.end(), is_inside));
  }
}

// ---------------------------------------------------------------- points

// whether the filter takes p, and how near the corners of its cavity are
bool is_taken(const Mesh& mesh, const Point& p, double& nearest)
{
  Mesh::Locate_type lt;
  int li;
  const Mesh::Face_handle f = mesh.locate(p, lt, li);
  const Tensor m = mesh.geom_traits().metric_field()(p);
  Mesh::Cavity cavity;
  mesh.find_cavity(p, m, lt, f, li, cavity);
  nearest = HUGE_VAL;
  for(const Mesh::Edge& e : cavity.boundary) {
    const auto v = e.first->vertex(Mesh::ccw(e.second));
    const CGAL::Vector_2<K> d = v->point() - p;
    const double distance = (std::sqrt(m.squared_length(d)) + std::sqrt(v->metric_tensor().squared_length(d))) / 2;
    nearest = (std::min)(nearest, distance);
  }
  return Field_point_filter<Mesh>(mesh)(p, m, cavity);
}

// Where sizes vary little, a point is taken if its neighbors are not nearer than the root of 1/2.
void test_distances()
{
  const auto field = [](const Point& p) { return Tensor::from_sizes(0.8 + 0.1*p.x(), 0.6 + 0.1*p.y(), p.x()); };
  Mesh mesh = empty_square(field, 3);
  Random_numbers random(4);
  int taken = 0, refused = 0;
  for(int i = 0; i < 400; ++i) {
    const double x = random.real(0.01, 2.99), y = random.real(0.01, 2.99);
    double nearest;
    const bool is = is_taken(mesh, Point(x, y), nearest);
    CHECK_MSG(is == (nearest >= std::sqrt(0.5)), std::to_string(nearest));
    ++(is ? taken : refused);
    if(is && i % 2 == 0)
      mesh.insert(Point(x, y));
  }
  CHECK_MSG(taken > 10 && refused > 10, std::to_string(taken) + " taken");
}

// Fine places count if they fill half of the unit disc of their tensor, which bands thinner than that do not.
void test_fine_bands()
{
  const double size = 0.05, middle = 0.6;
  for(double angle : {0., 0.5, 1.4, 2.3, 3.})
    for(double width : {0.1, 2.}) { // to half of the size
      const auto across = [=](const Point& p)
                          { return std::cos(angle) * (p.x() - middle) + std::sin(angle) * (p.y() - middle); };
      const auto band = [=](const Point& p)
                        { return Tensor::from_size(2 * std::abs(across(p)) < width * size ? size : 1); };
      const auto half = [=](const Point& p) { return Tensor::from_size(across(p) < 0.02 * size ? size : 1); };
      double nearest;
      CHECK(is_taken(empty_square(band), Point(middle, middle), nearest) == (width > 1) && nearest > 1);
      CHECK(is_taken(empty_square(half), Point(middle, middle), nearest));
    }
}

// ---------------------------------------------------------------- limits

void test_limits()
{
  const Field field = [](const Point&) { return Tensor::from_size(0.1); };
  CGAL::Anisotropic_mesh_2::Refinement_result result;
  const auto tell = np::refinement_result(std::ref(result));
  const auto refined = [&](const auto& parameters) {
    Mesh mesh = empty_square(field);
    CHECK(CGAL::refine_anisotropic_mesh_2(mesh, parameters) == result.number_of_insertions);
    CHECK(mesh.is_valid(true) && mesh.number_of_vertices() == 4 + result.number_of_insertions);
    return mesh;
  };
  for(Point_placement placement : {Point_placement::ADVANCING_FRONT, Point_placement::EDGE_SUBDIVISION}) {
    const std::size_t n = refined(tell.point_placement(placement)).number_of_vertices();
    CHECK(n > 80 && !result.time_limit_reached && !result.vertex_limit_reached);
    CHECK(refined(tell.point_placement(placement).maximum_number_of_vertices(n)).number_of_vertices() == n);
    Mesh full = empty_square(field);
    const auto too_few = np::point_placement(placement).maximum_number_of_vertices(n - 1);
    CHECK_THROWS(CGAL::refine_anisotropic_mesh_2(full, too_few),
                 CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, std::to_string(n - 1));
    CHECK(full.is_valid(true) && full.number_of_vertices() == n - 1);
    CHECK(refined(tell.point_placement(placement).maximum_running_time(1e-9)).number_of_vertices() < n / 2);
    CHECK(result.time_limit_reached && !result.vertex_limit_reached);
  }
}

int main()
{
  test_parts_of_edges();
  test_apex();
  test_lattice();
  test_far_samples();
  test_places();
  test_distances();
  test_fine_bands();
  test_limits();
  return finish();
}

// Unit meshing and its optimization: what the meshes of known cases must hold.

#include "check.h"
#include "meshes.h"

#include <CGAL/Discrete_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Random.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using CGAL::Anisotropic_mesh_2::Mesh_statistics;
using CGAL::Anisotropic_mesh_2::Point_placement;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

// The smallest metric distance between vertices joined by an interior edge that
// ends at a free vertex, by the rule of the filter.
double smallest_distance(const Mesh& mesh)
{
  double least = std::numeric_limits<double>::infinity();
  for(const Mesh::Edge& e : mesh.edges_in_domain()) {
    const auto u = e.first->vertex(Mesh::ccw(e.second)), v = e.first->vertex(Mesh::cw(e.second));
    if(mesh.is_fixed(u) && mesh.is_fixed(v))
      continue;
    const CGAL::Vector_2<K> d = v->point() - u->point();
    least = (std::min)(least, (std::sqrt(u->metric_tensor().squared_length(d))
                             + std::sqrt(v->metric_tensor().squared_length(d))) / 2);
  }
  return least;
}

void test_unit_mesh(const Case& c, Point_placement placement)
{
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::point_placement(placement));
  CHECK_MSG(mesh.is_valid(true), c.name);
  const double tolerance = c.name == "disc" ? 2e-3 : 1e-12;
  CHECK_MSG(std::abs(area_of(mesh) / c.area - 1) < tolerance, c.name);
  CHECK_MSG(smallest_distance(mesh) > 0.7, c.name + ": " + std::to_string(smallest_distance(mesh)));
  const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh);
  CHECK_MSG(s.edge_length_unit_share > 0.93, c.name + ": " + std::to_string(s.edge_length_unit_share));
  CHECK_MSG(s.triangles > 0.9 * 2 * s.ideal_vertices && s.triangles < 1.25 * 2 * s.ideal_vertices, c.name);
}

// What optimized meshes reach with the default settings.
void test_optimized(const Case& c, double unit_share, double quality_mean, double energy_ratio, bool by_lloyd)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const double area = area_of(mesh);
  if(by_lloyd)
    CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method);
  else
    CGAL::optimize_anisotropic_mesh_2(mesh);
  const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh);
  std::ostringstream figures;
  figures << c.name << (by_lloyd ? " by Lloyd:\n" : ":\n") << s;
  CHECK(mesh.is_valid(true));
  CHECK(std::abs(area_of(mesh) / area - 1) < 1e-12);
  CHECK_MSG(s.edge_length_unit_share >= unit_share, figures.str());
  CHECK_MSG(s.quality_mean >= quality_mean, figures.str());
  CHECK_MSG(s.energy_ratio <= energy_ratio, figures.str());
}

// The gates of the acceptance suite: shortest and longest edge; BAMG's share of unit edges.
void test_gates(const Case& c, double shortest, double longest, double unit_share, double least_quality)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh);
  std::ostringstream figures;
  figures << c.name << ":\n" << s;
  CHECK_MSG(s.edge_length_min >= shortest && s.edge_length_max <= longest, figures.str());
  CHECK_MSG(s.edge_length_unit_share >= unit_share, figures.str());
  CHECK_MSG(s.quality_min >= least_quality, figures.str());
}

// An L-shape with a circular hole and an inner arc, in two subdomains.
void test_domain_with_everything()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{Point(0, 0), Point(4, 0), Point(4, 2), Point(2, 2), Point(2, 4), Point(0, 4)}, 7);
  domain.add_circle(Point(1, 1), 0.5, 8);
  domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::segment(Point(2, 2), Point(2, 0), 9));
  domain.add_region(Point(3, 1), 30);
  domain.add_region(Point(1, 3), 10);
  const Field field = [](const Point& p) { return Tensor::from_sizes(0.1 + 0.1*p.x(), 0.2, p.y()); };
  Mesh mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(20));
  CHECK(mesh.is_valid(true));
  CHECK(std::abs(area_of(mesh) / (12 - std::acos(-1.) / 4) - 1) < 0.02);

  std::multiset<int> references;
  double inner_length = 0;
  for(const Mesh::Edge& e : mesh.edges_in_domain()) {
    if(!mesh.is_constrained(e)) {
      CHECK(mesh.edge_reference(e) == 0);
      continue;
    }
    const int reference = mesh.edge_reference(e);
    references.insert(reference);
    CHECK(mesh.is_on_boundary(e) == (reference != 9));
    if(reference == 9)
      inner_length += std::sqrt(CGAL::squared_distance(e.first->vertex(Mesh::ccw(e.second))->point(),
                                                       e.first->vertex(Mesh::cw(e.second))->point()));
  }
  CHECK(references.count(7) > 20 && references.count(8) >= 8 && references.count(9) > 2);
  CHECK(references.count(7) + references.count(8) + references.count(9) == references.size());
  CHECK(std::abs(inner_length - 2) < 1e-12);
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain()) {
      const Point b = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
      CHECK(f->subdomain_index() == (b.x() > 2 ? 30 : 10));
    }

  const Mesh empty = mesh.empty_mesh();
  CHECK(empty.is_valid(true));
  CHECK(std::abs(area_of(empty) / area_of(mesh) - 1) < 1e-12);
  std::size_t fixed = 0;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    fixed += mesh.is_fixed(v);
  CHECK(empty.number_of_vertices() == fixed);

  double regions = 0;
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh> diagram(mesh);
  for(const auto& region : diagram.regions())
    regions += region.area;
  CHECK_MSG(std::abs(regions / area_of(mesh) - 1) < 1e-10, std::to_string(regions));
}

// The paper's start for the parallelogram: half of the points clustered at the centre.
void test_clustered_start()
{
  const Case c = paper_cases()[4];
  const Mesh unit = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Mesh mesh = unit.empty_mesh();
  CGAL::Random random(3);
  const std::size_t wanted = unit.number_of_vertices();
  while(mesh.number_of_vertices() < wanted) {
    const double scale = mesh.number_of_vertices() % 2 == 0 ? 0.1 : 1;
    const double s = 0.5 + scale * random.get_double(-0.499, 0.499), t = 0.5 + scale * random.get_double(-0.499, 0.499);
    mesh.insert(Point(30*s + 10*t, 14*t));
  }
  mesh.mark_domain();
  const Mesh_statistics start = CGAL::anisotropic_mesh_statistics_2(mesh);
  CHECK(start.quality_mean < 0.7);
  Mesh lloyd = mesh;
  CGAL::optimize_anisotropic_mesh_2(lloyd, lloyd_method.number_of_iterations(200));
  const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(lloyd);
  CHECK_MSG(lloyd.is_valid(true) && s.quality_mean > 0.95, std::to_string(s.quality_mean));
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(200));
  const Mesh_statistics q = CGAL::anisotropic_mesh_statistics_2(mesh);
  CHECK_MSG(mesh.is_valid(true) && q.quality_mean > 0.97, std::to_string(q.quality_mean));
}

void test_refusals()
{
  const CGAL::Anisotropic_mesh_domain_2<K> domain = box(0, 1);
  CHECK_THROWS(CGAL::make_anisotropic_mesh_2(domain, Field([](const Point&) { return Tensor::from_size(1e-6); })),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "1.1547e+12");
  CHECK_THROWS(CGAL::make_anisotropic_mesh_2(domain, Field([](const Point&) { return Tensor::from_size(0.01); }),
                                             np::maximum_number_of_vertices(500)),
               CGAL::Anisotropic_mesh_2::Too_many_vertices_exception, "500");
  CHECK_THROWS(CGAL::make_anisotropic_mesh_2(domain, Field([](const Point&) { return Tensor::from_size(0); })),
               CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "at the point (");
  CHECK_THROWS(CGAL::make_anisotropic_mesh_2(domain, Field([](const Point& p)
                 { return Tensor::from_entries(p.x() > 0.7 ? -1 : 100, 0, 100); })),
               CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "m11 = -1");
  // the field names the point itself, and the traits do not name it once more
  try {
    CGAL::make_anisotropic_mesh_2(domain, CGAL::make_isotropic_metric_field_2<K>([](const Point&) { return -1.; }));
    CHECK(false);
  }
  catch(const CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception& e) {
    const std::string what = e.what(), words = "at the point (";
    CHECK_MSG(what.find(words) != std::string::npos && what.find(words) == what.rfind(words), what);
  }
}

// The field is asked for nothing beyond the domain.
void test_field_defined_on_the_domain_only()
{
  const Field field = [](const Point& p) {
    const bool is_inside = p.x() >= 0 && p.x() <= 1 && p.y() >= 0 && p.y() <= 1
                        && !(p.x() > 0.5 && p.y() > 0.5);
    return is_inside ? Tensor::from_sizes(0.02 + 0.1*p.y(), 0.1, 0.7) : Tensor::from_size(-1);
  };
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{Point(0, 0), Point(1, 0), Point(1, 0.5), Point(0.5, 0.5), Point(0.5, 1), Point(0, 1)});
  Mesh mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.number_of_iterations(5));
  CHECK(mesh.is_valid(true));
  CHECK(CGAL::anisotropic_mesh_statistics_2(mesh).quality_mean > 0.95);
}

// s^2 M on a domain scaled by 1/s gives the same mesh, scaled: to the last bit
// for a power of two.
void test_scaling()
{
  const Field unit = [](const Point& p) { return Tensor::from_sizes(0.05 + 0.1*p.x(), 0.1 + 0.1*p.y()); };
  Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), unit);
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(10));
  for(double s : {std::ldexp(1., -100), std::ldexp(1., 100)}) {
    const Field field = [s, unit](const Point& p) { return unit(Point(p.x() / s, p.y() / s)).scaled(s); };
    Mesh scaled = CGAL::make_anisotropic_mesh_2(box(0, s), field);
    CGAL::optimize_anisotropic_mesh_2(scaled, CGAL::parameters::number_of_iterations(10));
    CHECK(scaled.is_valid(true));
    if(!CHECK(scaled.number_of_vertices() == mesh.number_of_vertices()))
      continue;
    double error = 0;
    for(auto v = mesh.finite_vertices_begin(), w = scaled.finite_vertices_begin();
        v != mesh.finite_vertices_end(); ++v, ++w)
      error = (std::max)(error, std::hypot(w->point().x() / s - v->point().x(), w->point().y() / s - v->point().y()));
    CHECK_MSG(error == 0, std::to_string(error));
    const double move = CGAL::anisotropic_mesh_statistics_2(mesh).gradient_norm;
    CHECK(std::abs(CGAL::anisotropic_mesh_statistics_2(scaled).gradient_norm - move) <= 1e-9 * move);
  }
}

// Fine places inside of coarse faces, whose edges do not show them. The bound follows from the area of the place.
void test_fine_place(const std::string& name, const Field& field, double area_of_place, double size)
{
  const double ideal = 2 / std::sqrt(3.) * area_of_place / (size*size);
  for(Point_placement placement : {Point_placement::ADVANCING_FRONT, Point_placement::EDGE_SUBDIVISION}) {
    const Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), field, np::point_placement(placement));
    CHECK_MSG(mesh.is_valid(), name);
    CHECK_MSG(double(mesh.number_of_vertices()) > 0.8 * ideal, name + ": " + std::to_string(mesh.number_of_vertices())
              + " vertices instead of " + std::to_string(ideal));
  }
}

void test_fine_places()
{
  const auto disc = [](const Point& c, double radius, double size, double coarse) -> Field {
    return [=](const Point& p)
           { return Tensor::from_size(std::hypot(p.x() - c.x(), p.y() - c.y()) < radius ? size : coarse); };
  };
  const double pi = std::acos(-1.);
  for(double coarse : {1., 0.1})
    for(double radius : {0.1, 0.02})
      for(const Point& c : {Point(0.51, 0.23), Point(0.97, 0.96)}) {
        const double inside = c.x() + radius < 1 ? 1 : 0.5; // at least; a part of the disc may be outside
        test_fine_place("disc of radius " + std::to_string(radius), disc(c, radius, radius/20, coarse),
                        inside * pi*radius*radius, radius/20);
      }
  const Field band = [](const Point& p) { return Tensor::from_size(std::abs(p.y() - 0.523) < 0.002 ? 0.001 : 0.5); };
  test_fine_place("band", band, 0.004, 0.001);
  const Field ring = [](const Point& p)
    { return Tensor::from_size(std::abs(std::hypot(p.x() - 0.5, p.y() - 0.5) - 0.3) < 0.01 ? 0.003 : 0.4); };
  test_fine_place("ring", ring, 2*pi*0.3*0.02, 0.003);
}

// One wild tensor among 625 of size 0.1 is thinner than any element: the mesh is about that without it.
void test_wild_tensor()
{
  const int n = 24;
  CGAL::Discrete_metric_field_2<K>::Background background;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      background.points.push_back(Point(double(i) / n, double(j) / n));
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j*(n + 1) + i, b = a + n + 1;
      background.triangles.push_back({a, a + 1, b + 1});
      background.triangles.push_back({a, b + 1, b});
    }
  for(const Tensor& wild : {Tensor::from_sizes(1e-3, 0.1), Tensor::from_sizes(1e-6, 0.1), Tensor::from_sizes(1e-4, 10),
                            Tensor::from_sizes(1e-6, 10)}) {
    std::vector<Tensor> tensors(background.points.size(), Tensor::from_size(0.1));
    tensors[13*(n + 1) + 11] = wild;
    const Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(box(0, 1), Mesh::Geom_traits(
      Field(CGAL::Discrete_metric_field_2<K>(background, tensors))));
    CHECK(mesh.is_valid());
    const double ideal = 2 / std::sqrt(3.) * 100; // without the wild one
    CHECK_MSG(mesh.number_of_vertices() > ideal && mesh.number_of_vertices() < 1.3 * ideal + 20 /* on the boundary */,
              std::to_string(mesh.number_of_vertices()));
  }
}

int main()
{
  for(const Case& c : paper_cases()) {
    test_unit_mesh(c, Point_placement::ADVANCING_FRONT);
    test_unit_mesh(c, Point_placement::EDGE_SUBDIVISION);
    if(c.name != "square10") { // where the metric doubles within an element
      test_optimized(c, 0.99, 0.97, 1.03, false);
      test_optimized(c, 0.99, 0.97, 1.03, true);
    }
  }
  const std::vector<Case> gated = unit_square_cases();
  test_gates(gated[0], 0.50, 1.6, 0.999, 0.717);
  test_gates(gated[1], 0.50, 1.6, 0.996, 0.759);
  test_gates(gated[2], 0.20, 3.0, 0.996, 0.577);
  test_fine_places();
  test_wild_tensor();
  test_domain_with_everything();
  test_clustered_start();
  test_refusals();
  test_field_defined_on_the_domain_only();
  test_scaling();
  return finish();
}

// The statistics of meshes against plain evaluations of their definitions, and the warning.

#include "check.h"
#include "brute_force_acvt.h"
#include "meshes.h"

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

using CGAL::Anisotropic_mesh_2::Measure;
using CGAL::Anisotropic_mesh_2::Mesh_statistics;
namespace internal = CGAL::Anisotropic_mesh_2::internal;

// The integral of f over a triangle, by n * n parts of the same size.
template <class Function>
double integral(const Function& f, const Point& a, const Point& b, const Point& c, int n)
{
  double sum = 0;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < 2 * (n - i) - 1; ++j) {
      const double u = (i + (j % 2 == 0 ? 1 : 2) / 3.) / n, v = (j / 2 + (j % 2 == 0 ? 1 : 2) / 3.) / n;
      sum += f(a + u * (b - a) + v * (c - a));
    }
  return sum * CGAL::area(a, b, c) / (n * n);
}

double length_of_segment(const Field& field, const Point& p, const Point& q, int n)
{
  double sum = 0;
  for(int i = 0; i < n; ++i)
    sum += std::sqrt(field(p + (i + 0.5) / n * (q - p)).squared_length(q - p)) / n;
  return sum;
}

double quality_in(const Tensor& m, const Point& a, const Point& b, const Point& c)
{
  return 4 * std::sqrt(3 * m.determinant()) * CGAL::area(a, b, c)
       / (m.squared_length(b - a) + m.squared_length(c - b) + m.squared_length(a - c));
}

// All statistics that have a definition are what a plain evaluation of it gives; outer faces do not count.
void test_statistics()
{
  const Field field = [](const Point& p) { return Tensor::from_sizes(0.3 + p.x()/8, 0.2 + p.y()/16, p.x()/2); };
  Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 4), field);
  mesh.insert(Point(9, 2));
  std::vector<double> lengths, qualities, worst;
  double area = 0, root_area = 0;
  for(Mesh::Face_handle f : mesh.faces_in_domain()) {
    const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    qualities.push_back(quality_in(field(CGAL::centroid(a, b, c)), a, b, c));
    worst.push_back((std::min)({quality_in(field(a), a, b, c), quality_in(field(b), a, b, c),
                                quality_in(field(c), a, b, c)}));
    area += integral([&](const Point& p) { return std::sqrt(field(p).determinant()); }, a, b, c, 8);
    root_area += integral([&](const Point& p) { return std::pow(field(p).determinant(), 0.25); }, a, b, c, 8);
  }
  for(const Mesh::Edge& e : mesh.edges_in_domain())
    lengths.push_back(length_of_segment(field, mesh.segment(e).source(), mesh.segment(e).target(), 100));
  const auto mean = [](const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.) / double(v.size());
  };
  const auto least = [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); };
  const auto is_unit = [](double l) { return l >= std::sqrt(0.5) && l <= std::sqrt(2.); };
  for(const Measure measure : {Measure::RIEMANNIAN, Measure::LEBESGUE}) {
    const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh, measure);
    const auto check = [&](double value, double expected, double tolerance, const char* what) {
      CHECK_MSG(std::abs(value - expected) <= tolerance * expected,
                what + (": " + std::to_string(value)) + " instead of " + std::to_string(expected));
    };
    CHECK(s.vertices == mesh.number_of_vertices() - 1 && s.triangles == qualities.size());
    check(s.edge_length_mean, mean(lengths), 1e-4, "mean length");
    check(s.edge_length_min, least(lengths), 1e-4, "least length");
    check(s.edge_length_max, *std::max_element(lengths.begin(), lengths.end()), 1e-4, "greatest length");
    check(s.edge_length_unit_share,
          double(std::count_if(lengths.begin(), lengths.end(), is_unit)) / double(lengths.size()), 1e-12, "unit share");
    check(s.quality_mean, mean(qualities), 1e-12, "mean quality");
    check(s.quality_min, least(qualities), 1e-12, "least quality");
    check(s.quality_min3_mean, mean(worst), 1e-12, "mean of the least qualities");
    check(s.quality_min3_min, least(worst), 1e-12, "least of the least qualities");
    check(s.ideal_vertices, 2 / std::sqrt(3.) * area, 1e-3, "ideal vertices");
    const double of_density = measure == Measure::LEBESGUE ? root_area : area;
    check(s.energy / s.energy_ratio, 5 / (18 * std::sqrt(3.)) * of_density * of_density * 2 / double(qualities.size()),
          2e-3, "bound of the energy");
  }
}

// The energy and the largest way to a mass centre are those of dense samples, each given to the nearest generator.
void test_energy_and_moves(Measure measure)
{
  const Field field = [](const Point&) { return Tensor::from_sizes(0.5, 0.3, 0.4); };
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 2), field);
  Brute_force_acvt<Field, Point> brute_force(field, measure == Measure::RIEMANNIAN);
  for(const auto f : mesh.faces_in_domain())
    brute_force.add_triangle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), 40);
  std::vector<Point> generators(mesh.number_of_vertices());
  for(const auto v : mesh.finite_vertex_handles())
    generators[v->index()] = v->point();
  std::vector<Brute_force_acvt<Field, Point>::Moments> moments;
  const double energy = brute_force(generators, moments);
  double largest = 0;
  for(const auto v : mesh.finite_vertex_handles()) {
    double x, y;
    moments[v->index()].pull(x, y);
    if(!mesh.is_fixed(v))
      largest = (std::max)(largest, std::sqrt(v->metric_tensor().squared_length(x, y)));
  }
  const Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh, measure);
  CHECK_MSG(std::abs(s.energy / energy - 1) < 1e-3, std::to_string(s.energy) + " instead of " + std::to_string(energy));
  CHECK_MSG(std::abs(s.gradient_norm - largest) < 3e-3, std::to_string(s.gradient_norm) + " instead of "
            + std::to_string(largest));
}

// What is summed up by parts is the same as all at once.
void test_parts()
{
  const std::vector<double> values = {0.7, 1.5, 0.2, 1.1, 1.4, 0.9};
  internal::Edge_summary all;
  for(double v : values)
    all.add(v);
  for(std::size_t n = 0; n <= values.size(); ++n) {
    internal::Edge_summary first, second;
    for(std::size_t i = 0; i < values.size(); ++i)
      (i < n ? first : second).add(values[i]);
    first += second;
    CHECK(first.lengths.least == 0.2 && first.lengths.largest == 1.5 && first.lengths.number == 6);
    CHECK(std::abs(first.lengths.mean() - all.lengths.mean()) < 1e-12 && first.unit_share() == 0.5);
  }
}

// An object of names and numbers, as JSON has it.
void test_json()
{
  Mesh_statistics s;
  s.vertices = 3;
  s.quality_min = 0.125;
  s.gradient_norm = 1e-5;
  std::ostringstream os;
  s.write_json(os);
  std::istringstream is(os.str());
  std::vector<std::string> words;
  for(std::string word; is >> word;)
    words.push_back(word);
  if(!CHECK(words.size() == 2 * 14 + 2 && words.front() == "{" && words.back() == "}"))
    return;
  std::size_t k = 1;
  s.for_each([&](const char* name, const auto& value) {
    const std::string& number = words[k + 1];
    char* end;
    CHECK(words[k] == "\"" + std::string(name) + "\":" && std::strtod(number.c_str(), &end) == double(value));
    CHECK(std::string(end) == (k + 2 < words.size() - 1 ? "," : ""));
    k += 2;
  });
}

// Complained of are a mean quality below 1/2 and twice as many inner vertices as are ideal; the worst face is named.
void test_warning()
{
  const Field fine = [](const Point&) { return Tensor::from_sizes(0.2, 0.1); };
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), fine);
  CHECK(CGAL::anisotropic_mesh_warning_2(mesh).empty());
  CHECK(CGAL::anisotropic_mesh_statistics_2(mesh).warning.empty());

  const Mesh boundary_only = mesh.empty_mesh();
  double least = 2;
  std::string place;
  for(const auto f : boundary_only.faces_in_domain()) {
    const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    const double q = quality_in(fine(a), a, b, c);
    if(q < least) {
      least = q;
      place = internal::describe((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
    }
  }
  const std::string warning = CGAL::anisotropic_mesh_warning_2(boundary_only);
  CHECK_MSG(warning.find("0 inner vertices") != std::string::npos, warning);
  CHECK_MSG(warning.find("worst at " + place) != std::string::npos, warning + " instead of " + place);
  CHECK(CGAL::anisotropic_mesh_statistics_2(boundary_only).warning == warning);

  // good shapes, but nine times as many vertices as there should be
  const Field coarse = [](const Point&) { return Tensor::from_sizes(0.6, 0.3); };
  Mesh crowded = CGAL::make_anisotropic_mesh_2(box(0, 1), coarse);
  for(const auto v : mesh.finite_vertex_handles())
    if(!mesh.is_fixed(v))
      crowded.insert(v->point());
  CHECK(!CGAL::anisotropic_mesh_warning_2(crowded).empty());
}

int main()
{
  test_statistics();
  test_energy_and_moves(Measure::RIEMANNIAN);
  test_energy_and_moves(Measure::LEBESGUE);
  test_parts();
  test_json();
  test_warning();
  return finish();
}

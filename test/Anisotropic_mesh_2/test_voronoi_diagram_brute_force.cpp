// Voronoi diagrams against their definition: the nearest of all generators at
// dense samples, and differences of energies.

#include "voronoi_diagrams.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// ---------------------------------------------------------------- the nearest generator

// the first of the least distances to all generators
template <class Diagram>
std::size_t nearest_of_all(const Diagram& diagram, const Point& x)
{
  std::size_t nearest = 0;
  for(std::size_t i = 1; i < diagram.number_of_regions(); ++i)
    if(diagram.squared_distance(x, i) < diagram.squared_distance(x, nearest))
      nearest = i;
  return nearest;
}

template <class Diagram>
void check_nearest(const Diagram& diagram, int samples, const std::string& name)
{
  for(const Point& x : random_points(samples, 21))
    CHECK_MSG(diagram.nearest_generator(x) == nearest_of_all(diagram, x), name);
  for(std::size_t i = 0; i < diagram.number_of_regions(); i += 7)
    CHECK_MSG(diagram.nearest_generator(diagram.region(i).generator) == i, name);
}

const Weight weight = [](Mesh::Vertex_handle v) { return 1 + 0.5 * std::sin(30 * v->point().x() + v->point().y()); };

// A coarse tolerance, since the regions are not asked for.
void test_nearest_generator(const Named_field& f, int n)
{
  const Mesh mesh = mesh_of(square(), random_points(n, 22), f.field);
  check_nearest(CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Weighted>(mesh, Weighted(weight), 0.1), 200, f.name);
  check_nearest(CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Labelle_Shewchuk>(mesh, Labelle_Shewchuk(), 0.1), 200, f.name);
  check_nearest(Diagram(mesh, Directional(), 0.1), 200, f.name);
}

// Generators at the points of a grid: in the middle of its cells four are equally near.
void test_ties()
{
  std::vector<Point> grid;
  for(int i = 1; i < 32; ++i)
    for(int j = 1; j < 32; ++j)
      grid.push_back(Point(i/16. - 1, j/16. - 1));
  const Mesh mesh = mesh_of(square(), grid, constant_field(1, 0, 1));
  const Diagram diagram(mesh);
  check_areas(diagram, mesh, "grid");
  for(int i = 1; i < 63; ++i)
    for(int j = 1; j < 63; j += 5) {
      const Point x(i/32. - 1, j/32. - 1);
      CHECK(diagram.nearest_generator(x) == nearest_of_all(diagram, x));
    }
}

// ---------------------------------------------------------------- regions

template <class Diagram>
bool is_in_region(const Diagram& diagram, std::size_t i, const Point& x)
{
  for(const auto& piece : diagram.region(i).pieces)
    if(contains(piece.boundaries, x))
      return true;
  return false;
}

// whether the region reaches to within a few tolerances of x
template <class Diagram>
bool is_near_region(const Diagram& diagram, const Tensor& m, const Point& x, std::size_t i, double tolerance)
{
  const double distance = std::sqrt(diagram.squared_distance(x, diagram.nearest_generator(x)));
  const auto sizes = m.sizes();
  for(int k = 0; k < 48; ++k) { // on three ellipses
    const double angle = k * CGAL_PI / 8, r = tolerance * distance * (1 + k / 16);
    const double u = r * sizes.h1 * std::cos(angle), v = r * sizes.h2 * std::sin(angle);
    const double c = std::cos(sizes.angle), s = std::sin(sizes.angle);
    if(diagram.nearest_generator(Point(x.x() + c*u - s*v, x.y() + s*u + c*v)) == i)
      return true;
  }
  return false;
}

// Each sample is in the region of its nearest generator and in no other one,
// unless a bisector is nearer to it than a few tolerances.
template <class Diagram>
void check_regions(const Diagram& diagram, const Field& tensor, double tolerance, const std::string& name)
{
  int wrong = 0, exceptions = 0;
  for(const Point& x : random_points(1500, 23)) {
    std::vector<std::size_t> found;
    for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
      if(is_in_region(diagram, i, x))
        found.push_back(i);
    if(found.size() == 1 && found[0] == nearest_of_all(diagram, x))
      continue;
    ++exceptions;
    wrong += found.size() != 1 || !is_near_region(diagram, tensor(x), x, found[0], tolerance);
  }
  CHECK_MSG(wrong == 0, name + ": " + std::to_string(wrong) + " wrong");
  CHECK_MSG(exceptions < 60, name + ": " + std::to_string(exceptions) + " next to bisectors");
}

void test_regions(const Named_field& f, int n, double tolerance)
{
  const Mesh mesh = mesh_of(square(), random_points(n, 24), f.field);
  const Diagram diagram(mesh, Directional(), tolerance);
  check_areas(diagram, mesh, f.name);
  check_regions(diagram, f.field, tolerance, f.name + ", directional");
}

void test_regions_of_distances_at_generators(const Named_field& f, int n, double tolerance)
{
  const Mesh mesh = mesh_of(square(), random_points(n, 24), f.field);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Labelle_Shewchuk> conics(mesh, Labelle_Shewchuk(), tolerance);
  check_areas(conics, mesh, f.name);
  check_regions(conics, f.field, tolerance, f.name + ", Labelle and Shewchuk");
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Weighted> circles(mesh, Weighted(weight), tolerance);
  check_areas(circles, mesh, f.name);
  check_regions(circles, constant_field(1, 0, 1), tolerance, f.name + ", weighted");
}

// A generator whose region is a needle that goes on beyond another generator, in a face that is divided elsewhere. Its area is that of the cells of a fine grid that are nearest to it.
void test_needle()
{
  const Point thin(0.25, -0.3);
  const Field field = [&](const Point& p) { return p == thin ? Tensor::from_sizes(0.05, 5) : Tensor::from_size(1); };
  const Polygon boundary = {Point(0, -1), Point(1, 0), Point(0, 1.2), Point(-1, 0)};
  const Mesh mesh = mesh_of(boundary, {thin, Point(0.25, 0)}, field);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Labelle_Shewchuk> diagram(mesh, Labelle_Shewchuk(), 1e-3);
  const std::size_t needle = index_of(diagram, thin);
  const int n = 500;
  double area = 0;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const Point x((2*i + 1.) / n - 1, 1.1 * ((2*j + 1.) / n - 1) + 0.1);
      area += 4.4 / (n*n) * (contains({boundary}, x) && nearest_of_all(diagram, x) == needle);
    }
  CHECK_MSG(area > 0.05 && std::abs(diagram.region(needle).area - area) < 0.02 * area,
            std::to_string(diagram.region(needle).area) + " instead of " + std::to_string(area));
}

// ---------------------------------------------------------------- pieces

// The connected parts of regions on a grid of n x n cells: their generators, with the numbers of cells.
std::vector<std::pair<std::size_t, int> > parts_of_grid(const Diagram& diagram, int n)
{
  std::vector<std::size_t> label;
  for(int k = 0; k < n*n; ++k)
    label.push_back(nearest_of_all(diagram, Point((2*(k % n) + 1.) / n - 1, (2*(k / n) + 1.) / n - 1)));
  std::vector<bool> is_seen(label.size(), false);
  std::vector<std::pair<std::size_t, int> > parts;
  for(int start = 0; start < n*n; ++start) {
    if(is_seen[start])
      continue;
    parts.emplace_back(label[start], 0);
    std::vector<int> stack(1, start);
    is_seen[start] = true;
    while(!stack.empty()) {
      const int k = stack.back(), x = k % n, y = k / n;
      stack.pop_back();
      ++parts.back().second;
      for(int l : {x > 0 ? k - 1 : k, x < n - 1 ? k + 1 : k, y > 0 ? k - n : k, y < n - 1 ? k + n : k})
        if(!is_seen[l] && label[l] == label[start]) {
          is_seen[l] = true;
          stack.push_back(l);
        }
    }
  }
  return parts;
}

// Pieces larger than a few cells are those of the grid, with their areas.
void test_pieces(const Named_field& f, const std::vector<Point>& inner)
{
  const int n = 400;
  const double of_cell = 4. / (n*n), least = 40 * of_cell;
  const Mesh mesh = mesh_of(square(), inner, f.field);
  const Diagram diagram(mesh);
  const auto parts = parts_of_grid(diagram, n);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    std::vector<double> areas, expected;
    for(const auto& piece : diagram.region(i).pieces)
      if(piece.area > least)
        areas.push_back(piece.area);
    for(const auto& part : parts)
      if(part.first == i && part.second * of_cell > least)
        expected.push_back(part.second * of_cell);
    std::sort(areas.begin(), areas.end());
    std::sort(expected.begin(), expected.end());
    CHECK_MSG(areas.size() == expected.size(), f.name + ": " + std::to_string(areas.size()) + " pieces, not "
              + std::to_string(expected.size()));
    for(std::size_t k = 0; k < (std::min)(areas.size(), expected.size()); ++k)
      CHECK_MSG(std::abs(areas[k] - expected[k]) < 0.005 * std::sqrt(expected[k]), f.name);
  }
}

// ---------------------------------------------------------------- integrals

double energy_of(const std::vector<Point>& inner, const Field& field, Measure measure)
{
  const Mesh mesh = mesh_of(square(), inner, field);
  const Diagram diagram(mesh, Directional(), 1e-6);
  double sum = 0;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
    sum += diagram.integrals(i, measure, 1e-6).energy;
  return sum;
}

// The sums of all regions against dense samples.
void test_energy(const Named_field& f, Measure measure)
{
  const int n = 300;
  const std::vector<Point> inner = random_points(8, 25);
  const Mesh mesh = mesh_of(square(), inner, f.field);
  const Diagram diagram(mesh);
  double energy = 0, mass = 0, sum = 0, area = 0;
  for(int k = 0; k < n*n; ++k) {
    const Point x((2*(k % n) + 1.) / n - 1, (2*(k / n) + 1.) / n - 1);
    const Tensor m = f.field(x);
    const double w = measure == Measure::RIEMANNIAN ? std::sqrt(m.m11()*m.m22() - m.m12()*m.m12()) : 1;
    energy += 4. / (n*n) * w * diagram.squared_distance(x, nearest_of_all(diagram, x));
    mass += 4. / (n*n) * w;
  }
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const Diagram::Integrals integrals = diagram.integrals(i, measure);
    sum += integrals.energy;
    area += integrals.area;
  }
  CHECK_MSG(std::abs(sum / energy - 1) < 1e-3, f.name + ": " + std::to_string(sum / energy));
  CHECK_MSG(std::abs(area / mass - 1) < 1e-3, f.name + ": " + std::to_string(area / mass));
}

// The gradient of the energy is twice A (z - mass centre): regions are best as they are.
void test_gradient(const Named_field& f, Measure measure)
{
  std::vector<Point> inner = random_points(6, 26);
  const Mesh mesh = mesh_of(square(), inner, f.field);
  const Diagram diagram(mesh, Directional(), 1e-6);
  const double step = 1e-3;
  Point& moved = inner[0];
  const Point z = moved;
  const auto gradient = diagram.integrals(index_of(diagram, z), measure, 1e-7).energy_gradient;
  for(int axis = 0; axis < 2; ++axis) {
    const CGAL::Vector_2<K> d(axis == 0 ? step : 0, axis == 0 ? 0 : step);
    moved = z + d;
    const double up = energy_of(inner, f.field, measure);
    moved = z - d;
    const double difference = (up - energy_of(inner, f.field, measure)) / (2 * step);
    const double error = (difference - gradient[axis]) / std::hypot(gradient[0], gradient[1]);
    CHECK_MSG(std::abs(error) < 1e-4, f.name + ": " + std::to_string(error));
  }
}

// The bound of the error holds, as a length in the mean tensor.
void test_error_bound(const Named_field& f)
{
  const Mesh mesh = mesh_of(square(), random_points(4, 27), f.field);
  const Diagram diagram(mesh, Directional(), 1e-2);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const Diagram::Integrals exact = diagram.integrals(i, Measure::RIEMANNIAN, 1e-8);
    for(double tolerance : {0.1, 1e-3, 1e-5}) {
      const Diagram::Integrals r = diagram.integrals(i, Measure::RIEMANNIAN, tolerance);
      const CGAL::Vector_2<K> d = r.mass_centre - exact.mass_centre;
      const double square = exact.matrix[0]*d.x()*d.x() + 2*exact.matrix[1]*d.x()*d.y() + exact.matrix[2]*d.y()*d.y();
      const double length = std::sqrt(square / exact.area);
      CHECK_MSG(length <= r.mass_centre_error + 1e-8, f.name + ": " + std::to_string(length / r.mass_centre_error));
      CHECK(r.mass_centre_error <= tolerance * std::sqrt(r.energy / r.area) * 1.01);
    }
  }
}

int main()
{
  const Named_field turns = {"turning", turning}, thin = {"figure 2.2", thin_in_the_middle}, layer = {"layer", layer_field};
  test_ties();
  test_needle();
  for(int n : {5, 60}) {
    test_nearest_generator(turns, n);
    test_nearest_generator(layer, n);
  }
  test_nearest_generator({"constant needles", constant_field(1e8, 9.9999e3, 1)}, 200);
  for(const Named_field& f : {turns, thin, layer}) {
    test_regions(f, 10, 1e-4);
    test_regions_of_distances_at_generators(f, 10, 1e-4);
    test_energy(f, Measure::RIEMANNIAN);
    test_energy(f, Measure::LEBESGUE);
  }
  for(const Named_field& f : {turns, thin}) {
    test_gradient(f, Measure::RIEMANNIAN);
    test_gradient(f, Measure::LEBESGUE);
  }
  test_regions({"broken", broken}, 8, 1e-2);
  test_pieces(thin, {Point(0, 0)});
  test_pieces(turns, random_points(6, 28));
  test_pieces({"thin at the border", thin_at_the_border}, {Point(0, 0)});
  test_error_bound(turns);
  return finish();
}

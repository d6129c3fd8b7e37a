// What Voronoi diagrams are made of: nearest generators and all that are near, against trials of all of them, and
// integrals over regions against closed forms.

#include "check.h"
#include "Random_numbers.h"

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_integrator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;

Symmetric_form random_tensor(Random_numbers& random)
{
  const double angle = random.real(0, 3), c = std::cos(angle), s = std::sin(angle);
  const double a = random.power_of_ten(-2, 2), b = random.power_of_ten(-2, 2);
  return Symmetric_form(a*c*c + b*s*s, (a - b)*c*s, a*s*s + b*c*c);
}

Vector_of_doubles random_place(Random_numbers& random)
{
  const double x = random.real(-1, 1);
  return {x, random.real(-1, 1)};
}

// Half of the generators at random, half of them on a grid, where ties occur; some are the same.
Generator_set random_generators(bool with_tensors, Random_numbers& random)
{
  Vectors positions;
  std::vector<Symmetric_form> tensors;
  for(int i = 0; i < 200; ++i) {
    Vector_of_doubles p = random_place(random);
    if(i % 2 == 0)
      p = {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4};
    positions.push_back(p);
    if(with_tensors)
      tensors.push_back(i % 2 == 0 ? Symmetric_form(1, 0, 1) : random_tensor(random));
  }
  return Generator_set(positions, tensors);
}

// Also between two generators, and in the middle of the cells of the grid.
void test_nearest(bool with_tensors)
{
  Random_numbers random(11);
  const Generator_set generators = random_generators(with_tensors, random);
  for(int trial = 0; trial < 500; ++trial) {
    Metric_point p{random_place(random), random_tensor(random)};
    if(trial % 2 == 0)
      p = {{(std::floor(4 * p.at.x) + 0.5) / 4, std::round(4 * p.at.y) / 4}, Symmetric_form(1, 0, 1)};
    std::size_t nearest = 0;
    for(std::size_t i = 1; i < generators.size(); ++i)
      if(generators.squared_distance(p, i) < generators.squared_distance(p, nearest))
        nearest = i;
    CHECK(generators.nearest(p, std::size_t(random.integer(200))) == nearest);
    const std::size_t other = std::size_t(random.integer(200));
    const double d = generators.squared_distance(p, other), e = generators.squared_distance(p, nearest);
    CHECK(std::abs(generators.difference(p, other, nearest) - (d - e)) <= 1e-12 * (d + e) + 1e-14);
  }
}

// Wherever one goes within reach of a point, what is within the radius there has been found; and nothing is far away if
// one tensor measures all.
void test_within(bool with_tensors)
{
  Random_numbers random(12);
  const Generator_set generators = random_generators(with_tensors, random);
  int found = 0;
  for(int trial = 0; trial < 300; ++trial) {
    const Metric_point p{random_place(random), random_tensor(random)};
    const Symmetric_form m = with_tensors ? Symmetric_form(1, 0, 1) : p.m;
    const double reach = random.real(0.01, 0.3), radius = random.real(0.01, 0.3);
    std::vector<std::size_t> near;
    generators.within(p, reach, radius, near);
    std::sort(near.begin(), near.end());
    for(int k = 0; k < 60; ++k) {
      const double angle = k * 0.105;
      Metric_point x = p;
      const double length = m.length(std::cos(angle), std::sin(angle));
      x.at = {p.at.x + reach * std::cos(angle) / length, p.at.y + reach * std::sin(angle) / length};
      for(std::size_t i = 0; i < generators.size(); ++i)
        if(generators.squared_distance(x, i) <= radius * radius) {
          ++found;
          CHECK(std::binary_search(near.begin(), near.end(), i));
        }
    }
    for(std::size_t i : near)
      CHECK(with_tensors || generators.squared_distance(p, i) <= (reach + radius) * (reach + radius) * (1 + 1e-12));
  }
  CHECK(found > 100);
}

// A square with a generator at (z, z), the identity as tensor and the density exp(kx): all integrals in closed form.
void test_integrals(double k, double tolerance)
{
  int calls = 0;
  const auto density = [&](const Vector_of_doubles& x, Symmetric_form& m, double& w) {
    ++calls;
    m = Symmetric_form(1, 0, 1);
    w = std::exp(k * x.x);
  };
  const double z = 0.3, mass = std::expm1(k) / k, mean = 1 / -std::expm1(-k) - 1/k;
  const double mean_square = 1 / -std::expm1(-k) - 2/k * mean, variance = mean_square - mean * mean;
  const double energy = mass * (variance + (mean - z) * (mean - z) + 1./12 + 0.04);
  double error = 0;
  const Region_integrals r = Region_integrator<decltype(density)>(density, tolerance)
    ({{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}}, {z, z}, error);
  const Vector_of_doubles move = r.moments.lloyd_move();
  const double scale = std::sqrt(energy / mass), wrong = std::hypot(move.x - (mean - z), move.y - (0.5 - z));
  // two triangles with seven evaluations each are divided into at most two hundred, four for one at a time
  const bool is_limit_reached = calls >= 7 * (2 + 4*66);
  CHECK(calls <= 7 * (2 + 4*66));
  CHECK_MSG((error <= tolerance * scale || is_limit_reached) && wrong <= error + 1e-15,
            std::to_string(wrong) + " wrong, bound " + std::to_string(error));
  CHECK(std::abs(r.mass / mass - 1) < tolerance && std::abs(r.energy / energy - 1) < tolerance);
}

int main()
{
  for(bool with_tensors : {false, true}) {
    test_nearest(with_tensors);
    test_within(with_tensors);
  }
  for(double k : {1., 5., 20.})
    for(double tolerance : {1e-2, 1e-3, 1e-4})
      test_integrals(k, tolerance);
  return finish();
}

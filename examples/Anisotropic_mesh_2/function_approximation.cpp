// Approximating functions (section 2.6 of Du and Wang): generators and vertices
// that a metric of the function has placed, against as many uniform ones. The
// values at the generators are taken all over their Voronoi regions, with the
// metric of the gradient; those at the vertices are interpolated linearly, with
// the metric of the Hessian. Both metrics are made for the least L2 error.
//
//   function_approximation [NUMBER_OF_VERTICES]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Gradient_metric_field_2.h>
#include <CGAL/Hessian_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>
#include <CGAL/approximation_error_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using K     = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;

// ------------------------------------------------- functions with their derivatives

struct Jet { double value, x, y, xx, xy, yy; };

// g of u, where g and its derivatives are taken at the value of u
Jet compose(double g, double g1, double g2, const Jet& u)
{
  return {g, g1*u.x, g1*u.y, g1*u.xx + g2*u.x*u.x, g1*u.xy + g2*u.x*u.y, g1*u.yy + g2*u.y*u.y};
}

const double pi = std::acos(-1.);

// from -1 to 1 across a curved line
Jet layer(const Point& p)
{
  const double w = 0.02, s = 0.2 * std::sin(2*pi * p.x()), c = 0.4*pi * std::cos(2*pi * p.x());
  const double t = std::tanh((p.y() - 0.5 - s) / w);
  return compose(t, 1 - t*t, -2*t*(1 - t*t), {0, -c/w, 1/w, 4*pi*pi * s/w, 0, 0});
}

// rings that become denser away from the origin
Jet rings(const Point& p)
{
  const double u = 20 * (p.x()*p.x() + p.y()*p.y());
  return compose(std::sin(u), std::cos(u), -std::sin(u), {u, 40*p.x(), 40*p.y(), 40, 0, 40});
}

// a flat hill
Jet hill(const Point& p)
{
  const double x = p.x() - 0.4, y = p.y() - 0.3, e = std::exp(-2*x*x - 4*y*y);
  return compose(e, e, e, {0, -4*x, -8*y, -4, 0, -8});
}

using Function = Jet (*)(const Point&);

double value(Function f, const Point& p) { return f(p).value; }

// With the norm 2 the default measure of the optimizer makes the energy the
// bound (2.4) of the paper, that is, the energy of the gradient's metric with
// the Lebesgue measure.
auto gradient_field(Function f, double error)
{
  const auto gradient = [f](const Point& p) { const Jet j = f(p); return std::array<double, 2>{j.x, j.y}; };
  return CGAL::make_gradient_metric_field_2<K>(gradient, 0.1, error, 2);
}

auto hessian_field(Function f, double error)
{
  const auto hessian = [f](const Point& p) { const Jet j = f(p); return std::array<double, 3>{j.xx, j.xy, j.yy}; };
  return CGAL::make_hessian_metric_field_2<K>(hessian, error, 1e-4, 0.5, 2);
}

// ------------------------------------------------- generators

template <class Field>
auto unit_mesh(const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  return CGAL::make_anisotropic_mesh_2(square, field);
}

// Where values are those of generators, these stay at their mass centres; the
// shape of faces does not matter.
enum class Purpose { GENERATORS, VERTICES };

// The optimized mesh of about n vertices under `field(scale)`, whose sizes are
// proportional to the scale. Were there no boundary, so were their squares to
// 1/n, and the second step would arrive.
template <class Field_of_scale>
auto mesh_of_size(std::size_t n, double tolerance, Purpose purpose, const Field_of_scale& field)
{
  double scale = 4 / std::sqrt(double(n)); // rather too coarse, since coarse meshes are cheap
  auto mesh = unit_mesh(field(scale));
  for(int i = 0; i < 20 && std::abs(double(mesh.number_of_vertices()) / double(n) - 1) > tolerance; ++i) {
    scale *= std::sqrt(double(mesh.number_of_vertices()) / double(n));
    mesh = unit_mesh(field(scale));
  }
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::Anisotropic_mesh_2::parameters::quality_moves(purpose == Purpose::VERTICES)
                                     .number_of_iterations(30));
  return mesh;
}

// A small change of an anisotropic metric changes the number of vertices by some
// percent; uniform meshes are the ones that can be had in any size.
auto uniform_mesh(std::size_t n, Purpose purpose)
{
  return mesh_of_size(n, 0.01, purpose, [](double scale) {
    return CGAL::make_isotropic_metric_field_2<K>([scale](const Point&) { return scale; });
  });
}

template <class Mesh>
double constant_error(const std::string& picture, const Mesh& mesh, Function f)
{
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh> diagram(mesh, {}, 0.05);
  CGAL::IO::write_SVG(picture, diagram);
  return CGAL::piecewise_constant_approximation_error_2(diagram, [f](const Point& p) { return value(f, p); }).l2;
}

template <class Mesh>
double linear_error(const Mesh& mesh, Function f)
{
  return CGAL::piecewise_linear_approximation_error_2(mesh, [f](const Point& p) { return value(f, p); }).l2;
}

void print(std::size_t uniform, std::size_t adapted, double uniform_error, double adapted_error)
{
  std::printf(" %7zu | %7zu | %.2e | %.2e | %5.1f |", uniform, adapted, uniform_error, adapted_error,
              uniform_error / adapted_error);
}

void compare(const std::string& name, Function f, std::size_t n)
{
  std::printf("| %-8s |", name.c_str());

  const auto generators = mesh_of_size(n, 0.05, Purpose::GENERATORS,
                                       [f](double scale) { return gradient_field(f, scale); });
  const auto uniform_generators = uniform_mesh(generators.number_of_vertices(), Purpose::GENERATORS);
  print(uniform_generators.number_of_vertices(), generators.number_of_vertices(),
        constant_error(name + "_uniform_tessellation.svg", uniform_generators, f),
        constant_error(name + "_gradient_tessellation.svg", generators, f));
  CGAL::IO::write_SVG(name + "_gradient.svg", generators);

  const auto vertices = mesh_of_size(n, 0.05, Purpose::VERTICES,
                                     [f](double scale) { return hessian_field(f, scale*scale); });
  const auto uniform_vertices = uniform_mesh(vertices.number_of_vertices(), Purpose::VERTICES);
  print(uniform_vertices.number_of_vertices(), vertices.number_of_vertices(),
        linear_error(uniform_vertices, f), linear_error(vertices, f));
  CGAL::IO::write_SVG(name + "_hessian.svg", vertices);
  std::printf("\n");
}

int main(int argc, char* argv[])
{
  const std::size_t n = argc > 1 ? std::size_t(std::atoi(argv[1])) : 500;
  const char* columns = " uniform | adapted | L2 unif. | L2 adap. | ratio |";
  const char* rule    = " ------- | ------- | -------- | -------- | ----- |";
  std::printf("| function |%s%s\n| -------- |%s%s\n", columns, columns, rule, rule);
  compare("layer", layer, n);
  compare("rings", rings, n);
  compare("hill", hill, n);
  std::printf("\nfirst of piecewise constant, then of piecewise linear approximation: the numbers of uniform and of\n"
              "adapted generators or vertices, the L2 errors with them, and the first error over the second\n");
  return 0;
}

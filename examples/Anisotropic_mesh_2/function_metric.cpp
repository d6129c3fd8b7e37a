// A metric from the derivatives of a function that is to be represented: that of the Hessian for linear
// interpolation on the triangles, that of the gradient for one value per Voronoi region. Both are compared
// with a uniform mesh of no fewer vertices.

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
#include <iostream>
#include <vector>

using K     = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;

// a layer along a quarter of a circle, in which the function rises from -1 to 1
double layer(const Point& p) { return std::tanh(20 * (p.x()*p.x() + p.y()*p.y() - 0.5)); }

std::array<double, 2> gradient(const Point& p)
{
  const double t = layer(p), slope = 40 * (1 - t*t);
  return {slope * p.x(), slope * p.y()};
}

std::array<double, 3> hessian(const Point& p)
{
  const double t = layer(p), slope = 40 * (1 - t*t), bend = -80 * t * slope;
  return {slope + bend * p.x() * p.x(), bend * p.x() * p.y(), slope + bend * p.y() * p.y()};
}

template <class Field>
auto mesh_under(const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto mesh = CGAL::make_anisotropic_mesh_2(square, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  return mesh;
}

auto uniform_mesh(std::size_t n)
{
  const double size = std::sqrt(2 / std::sqrt(3.) / double(n)); // of n triangular cells in the unit square
  return mesh_under(CGAL::make_isotropic_metric_field_2<K>([size](const Point&) { return size; }));
}

template <class Mesh>
double linear_error(const Mesh& mesh)
{
  const double error = CGAL::piecewise_linear_approximation_error_2(mesh, layer).l2;
  std::cout << mesh.number_of_vertices() << " vertices, linear on triangles: error " << error << '\n';
  return error;
}

template <class Mesh>
double constant_error(const Mesh& mesh)
{
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh> regions(mesh);
  const double error = CGAL::piecewise_constant_approximation_error_2(regions, layer).l2;
  std::cout << mesh.number_of_vertices() << " vertices, constant on regions: error " << error << '\n';
  return error;
}

int main()
{
  // Both for the least L2 error. Where the function is flat, something else bounds the sizes: 0.3 does for
  // the Hessian, and for the gradient a squared slope of 4 that counts everywhere, beside 28^2 in the layer.
  const auto by_hessian  = mesh_under(CGAL::make_hessian_metric_field_2<K>(hessian, 0.01, 1e-3, 0.3, 2));
  const auto by_gradient = mesh_under(CGAL::make_gradient_metric_field_2<K>(gradient, 4, 0.1, 2));
  CGAL::IO::write_SVG("function_metric_hessian.svg", by_hessian);
  CGAL::IO::write_SVG("function_metric_gradient.svg", by_gradient);

  const auto uniform = uniform_mesh(by_hessian.number_of_vertices());
  const double linear_gain = linear_error(uniform) / linear_error(by_hessian);
  const auto uniform_too = uniform_mesh(by_gradient.number_of_vertices());
  const double constant_gain = constant_error(uniform_too) / constant_error(by_gradient);
  std::cout << "gains: " << linear_gain << " and " << constant_gain << std::endl;
  return linear_gain > 10 && constant_gain > 3 ? 0 : 1;
}

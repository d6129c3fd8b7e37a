// Figure 5.3 of Du and Wang: a square refined towards the line y = 5. The sizes
// as printed change by a factor of two within a triangle; exchanged, small
// across the line and long along it, they give the quality that the paper reports.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

template <class Field>
void mesh_square(const std::string& name, const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  auto mesh = CGAL::make_anisotropic_mesh_2(square, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  std::cout << name << '\n' << CGAL::anisotropic_mesh_statistics_2(mesh) << std::endl;
  CGAL::IO::write_SVG(name + ".svg", mesh);
}

int main()
{
  const auto first = [](const Point& p) { return std::abs(p.y() - 5) / 5 + 0.04; };
  const auto second = [first](const Point& p) { return std::abs(5 - 4 * std::abs(p.y() - 5) / 5) * first(p); };
  mesh_square("square10", [=](const Point& p) { return Tensor::from_sizes(first(p), second(p)); });
  mesh_square("layer10", [=](const Point& p) { return Tensor::from_sizes(second(p), first(p)); });
  return 0;
}

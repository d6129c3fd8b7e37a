#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <iostream>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tensor = CGAL::Metric_tensor_2<K>;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

int main()
{
  const std::vector<K::Point_2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  auto field = [](const K::Point_2& p) { return Tensor::from_sizes(0.1 + p.x()/4, 0.1 + p.y()/4); };

  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(square);

  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)
                                          .number_of_iterations(20));

  std::cout << CGAL::anisotropic_mesh_statistics_2(mesh);
  CGAL::IO::write_SVG("mesh.svg", mesh);
  return mesh.number_of_vertices() > 100 ? 0 : 1;
}

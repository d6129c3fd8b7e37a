// The tessellations of figure 4.2 of Du and Wang: a disc under a constant
// metric, and a square whose sizes grow with x and with y.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

template <class Field>
void tessellate(const std::string& name, const CGAL::Anisotropic_mesh_domain_2<K>& domain, const Field& field)
{
  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)
                                          .number_of_iterations(60));
  std::cout << name << '\n' << CGAL::anisotropic_mesh_statistics_2(mesh) << std::endl;
  CGAL::IO::write_SVG(name + ".svg", mesh);
  CGAL::IO::write_SVG(name + "_tessellation.svg", CGAL::Anisotropic_Voronoi_diagram_2<decltype(mesh)>(mesh));
}

int main()
{
  const double pi = std::acos(-1.);

  CGAL::Anisotropic_mesh_domain_2<K> disc;
  disc.add_circle(Point(0, 0), 10);
  tessellate("disc", disc, CGAL::Constant_metric_field_2<K>(Tensor::from_sizes(1.5, 0.3, pi / 4)));

  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  tessellate("square4", square, [](const Point& p)
             { return Tensor::from_sizes(0.031 + p.x() / 4, 0.031 + p.y() / 4); });
  return 0;
}

// Figures 5.1 and 5.2 of Du and Wang: a parallelogram under a constant metric,
// where Lloyd's iteration starts from points half of which are clustered at the
// centre. The table shows how the triangles evolve.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Random.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;
using Mesh   = CGAL::Anisotropic_Delaunay_mesh_2<CGAL::Riemannian_metric_traits_2<K> >;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

void report(const Mesh& mesh, int iterations)
{
  const auto s = CGAL::anisotropic_mesh_statistics_2(mesh);
  std::cout << iterations << '\t' << s.quality_mean << '\t' << s.quality_min << '\t' << s.edge_length_mean << '\n';
  const std::string name = "parallelogram_" + std::to_string(iterations);
  CGAL::IO::write_SVG(name + ".svg", mesh);
  CGAL::IO::write_SVG(name + "_tessellation.svg", CGAL::Anisotropic_Voronoi_diagram_2<Mesh>(mesh));
}

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {30, 0}, {40, 14}, {10, 14}});
  const CGAL::Constant_metric_field_2<K> field(Tensor::from_sizes(2, 0.5));
  const Mesh unit_mesh = CGAL::make_anisotropic_mesh_2(domain, field);

  // as many vertices as in the unit mesh, every other one in a small parallelogram at the centre
  Mesh mesh = unit_mesh.empty_mesh();
  CGAL::Random random(0);
  for(std::size_t n = mesh.number_of_vertices(); n < unit_mesh.number_of_vertices(); ++n) {
    const double extent = n % 2 == 0 ? 0.05 : 0.49;
    const double s = 0.5 + random.get_double(-extent, extent), t = 0.5 + random.get_double(-extent, extent);
    mesh.insert(Point(30*s + 10*t, 14*t));
  }
  mesh.mark_domain();

  std::cout << "iterations\tmean quality\tleast quality\tmean length of edges\n";
  report(mesh, 0);
  int done = 0;
  for(int iterations : {5, 30, 100}) {
    CGAL::optimize_anisotropic_mesh_2(mesh, np::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)
                                            .number_of_iterations(iterations - done));
    report(mesh, done = iterations);
  }
  return mesh.is_valid() ? 0 : 1;
}

// One tensor everywhere: an L-shaped plate that conducts heat a hundred times better along its fibres, so
// that edges may be ten times as long there. The mesh is the constrained Delaunay triangulation of the
// points, stretched by the metric.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <iostream>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});

  // the fibres run in the direction of 0.5 radians
  const CGAL::Constant_metric_field_2<K> field(Tensor::from_sizes(0.3, 0.03, 0.5));

  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);

  const auto statistics = CGAL::anisotropic_mesh_statistics_2(mesh);
  std::cout << statistics;
  CGAL::IO::write_SVG("constant_metric.svg", mesh);

  // Level 2 tests every edge exactly, by the criterion of Delaunay for the stretched points.
  return mesh.is_valid(true, 2) && statistics.quality_mean > 0.9 ? 0 : 1;
}

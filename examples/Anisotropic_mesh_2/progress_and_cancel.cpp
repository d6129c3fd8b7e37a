// A visitor follows the optimizer and stops it when it is good enough.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

struct Progress
{
  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& state)
  {
    std::cout << state.iteration << ": energy " << state.energy << ", largest move " << state.largest_move << '\n';
    return state.largest_move > 0.02; // a fiftieth of an edge
  }
};

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto field = [](const Point& p) { return Tensor::from_sizes(0.02, 0.08, std::sin(3 * p.x())); };

  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  const auto result = CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(1e-4).visitor(Progress()));
  std::cout << result << std::endl; // "interrupted" by the visitor, or another reason
  return mesh.is_valid() ? 0 : 1;
}

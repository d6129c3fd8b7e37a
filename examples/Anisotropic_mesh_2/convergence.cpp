// The energy and the greatest move of Lloyd's iteration and of the quasi-Newton
// method, from the same unit meshes, for three cases of Du and Wang. Vertices stay
// at their mass centres: quality moves would raise the energy at the end.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

// prints a line per iteration
struct Table
{
  std::string name; // case and method

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& s) const
  {
    std::cout << name << '\t' << s.iteration << '\t' << s.evaluations << '\t'
              << s.energy << '\t' << s.largest_move << '\n';
    return true;
  }
};

// all criteria to stop are off but the number of iterations
auto parameters(const std::string& name)
{
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  return np::convergence(0.).energy_reduction(0.).quality_moves(false)
    .number_of_iterations(100).visitor(Table{name});
}

template <class Field>
void compare(const std::string& name, const std::vector<Point>& polygon, const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(polygon);
  const auto unit_mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  auto mesh = unit_mesh;
  CGAL::optimize_anisotropic_mesh_2(mesh, parameters(name + "\tLloyd")
                                          .method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD));
  mesh = unit_mesh;
  CGAL::optimize_anisotropic_mesh_2(mesh, parameters(name + "\tquasi-Newton"));
}

int main()
{
  std::cout.precision(12); // the energy falls little at the end
  std::cout << "case\tmethod\titeration\tevaluations\tenergy\tgreatest move\n";

  // smaller than in the paper: 10 000 vertices
  compare("square4-10k", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, [](const Point& p)
          { return Tensor::from_sizes(0.031 + p.x() / 4, 0.031 + p.y() / 4).scaled(0.15); });

  compare("layer10", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, [](const Point& p) {
    const double distance = std::abs(p.y() - 5) / 5, across = distance + 0.04;
    return Tensor::from_sizes((5 - 4*distance) * across, across);
  });

  compare("parallelogram", {{0, 0}, {30, 0}, {40, 14}, {10, 14}}, [](const Point&)
          { return Tensor::from_sizes(2, 0.5); });
  return 0;
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <iostream>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tensor = CGAL::Metric_tensor_2<K>;
using Traits = CGAL::Riemannian_metric_traits_2<K>;

int main()
{
  CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits> triangulation{
    Traits([](const K::Point_2& p) { return Tensor::from_sizes(0.1 + p.x()/4, 0.1 + p.y()/4); })};
  for(int i = 0; i < 25; ++i)
    triangulation.insert(K::Point_2(i % 5, i / 5));
  std::cout << triangulation.number_of_faces() << " triangles" << std::endl;
  return triangulation.is_valid() && triangulation.number_of_faces() == 32 ? 0 : 1;
}

// Any kernel serves. With exact constructions points and tensors are what they are meant to be: the cells
// of a turned grid are squares in the metric, their corners cocircular, and new vertices on a border lie
// on it exactly. With coordinates in double decisions are exact as well, but about rounded points.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <iostream>

using Exact   = CGAL::Exact_predicates_exact_constructions_kernel;
using Rounded = CGAL::Exact_predicates_inexact_constructions_kernel;

// a point of the grid whose cells have the sides 1/10 and 1/7000, turned by the angle of the cosine 4/5
template <class K>
typename K::Point_2 grid_point(int i, int j)
{
  const typename K::FT u = typename K::FT(i) / 10, v = typename K::FT(j) / 7000;
  return {(4*u - 3*v) / 5, (3*u + 4*v) / 5};
}

// the metric of the grid, by its entries, since an angle in radians would be rounded
template <class K>
CGAL::Constant_metric_field_2<K> field_of_grid()
{
  const typename K::FT a = 100, b = 49000000;
  using Tensor = CGAL::Metric_tensor_2<K>;
  return CGAL::Constant_metric_field_2<K>(
    Tensor::from_entries((16*a + 9*b) / 25, 12*(a - b) / 25, (9*a + 16*b) / 25));
}

template <class K>
int number_of_cocircular_cells()
{
  const CGAL::Riemannian_metric_traits_2<K, CGAL::Constant_metric_field_2<K> > traits(field_of_grid<K>());
  const auto side = traits.side_of_metric_circle_2_object();
  int result = 0;
  for(int k = 0; k < 100; ++k) {
    const int i = k % 10, j = k / 10;
    const auto p = grid_point<K>(i, j);
    const auto m = traits.metric_field()(p); // the same at all corners
    result += side(p, grid_point<K>(i + 1, j), grid_point<K>(i + 1, j + 1), grid_point<K>(i, j + 1),
                   m, m, m, m) == CGAL::ON_ORIENTED_BOUNDARY;
  }
  return result;
}

int main()
{
  const int exact = number_of_cocircular_cells<Exact>(), rounded = number_of_cocircular_cells<Rounded>();
  std::cout << "cocircular cells of 100: " << exact << ", with rounded coordinates " << rounded << '\n';

  CGAL::Polygon_2<Exact> border;
  for(int k : {0, 1, 3, 2})
    border.push_back(grid_point<Exact>(10 * (k % 2), 10 * (k / 2)));
  CGAL::Anisotropic_mesh_domain_2<Exact> domain;
  domain.add_polygon(border);
  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field_of_grid<Exact>());
  CGAL::optimize_anisotropic_mesh_2(mesh);

  int on_border = 0, fixed = 0;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v) {
    on_border += border.has_on_boundary(v->point());
    fixed += mesh.is_fixed(v);
  }
  std::cout << mesh.number_of_vertices() << " vertices, " << on_border << " exactly on the border\n";
  return exact == 100 && rounded < 100 && on_border == fixed && mesh.is_valid(true, 2) ? 0 : 1;
}

// A triangulation that is there already, here from the Delaunay mesher of CGAL, becomes an anisotropic mesh:
// its points and constrained edges are taken over, refined where the metric wants more, and optimized.
// Vertices do not become fewer: the given triangulation must be coarse enough.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <vector>

using K        = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point    = K::Point_2;
using Tensor   = CGAL::Metric_tensor_2<K>;
using Tds      = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>,
                                                      CGAL::Delaunay_mesh_face_base_2<K> >;
using Cdt      = CGAL::Constrained_Delaunay_triangulation_2<K, Tds>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;

// inside of a square and outside of another one
Cdt square_with_hole()
{
  Cdt cdt;
  for(double r : {1., 0.3}) {
    const std::vector<Point> square = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    cdt.insert_constraint(square.begin(), square.end(), true);
  }
  const std::vector<Point> holes = {{0, 0}};
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(0.125, 0.2));
  mesher.set_seeds(holes.begin(), holes.end());
  mesher.refine_mesh();
  return cdt;
}

int main()
{
  const Cdt cdt = square_with_hole();

  // layers along a circle around the hole
  const auto field = [](const Point& p) {
    const double r = std::hypot(p.x(), p.y());
    return Tensor::from_sizes(0.04 + 0.2 * std::abs(r - 0.7), 0.15, std::atan2(p.y(), p.x()));
  };
  using Traits = CGAL::Riemannian_metric_traits_2<K, decltype(field)>;
  CGAL::Anisotropic_Delaunay_mesh_2<Traits> mesh{Traits(field)};
  mesh.insert_triangulation(cdt);
  const auto before = CGAL::anisotropic_mesh_statistics_2(mesh);

  CGAL::refine_anisotropic_mesh_2(mesh);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  const auto after = CGAL::anisotropic_mesh_statistics_2(mesh);

  std::cout << "vertices: " << before.vertices << ", then " << after.vertices
            << "\nmean quality: " << before.quality_mean << ", then " << after.quality_mean
            << "\nedges of unit length: " << 100 * before.edge_length_unit_share << " %, then "
            << 100 * after.edge_length_unit_share << " %" << std::endl;
  CGAL::IO::write_SVG("optimize_existing_before.svg", cdt);
  CGAL::IO::write_SVG("optimize_existing.svg", mesh);
  return after.quality_mean > 0.9 && mesh.is_valid(true, 1) ? 0 : 1;
}

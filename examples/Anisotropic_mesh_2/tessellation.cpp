// The anisotropic Voronoi tessellation of an optimized mesh: what regions and bisectors offer, and how near
// to a centroidal tessellation it is.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const auto field = [](const Point& p) { return Tensor::from_sizes(0.04 + 0.1*p.x(), 0.12, 2*p.y()); };
  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  // Topological moves take vertices out of their mass centres in favour of well shaped triangles.
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::Anisotropic_mesh_2::parameters::quality_moves(false));

  const CGAL::Anisotropic_Voronoi_diagram_2<decltype(mesh)> diagram(mesh);
  double area = 0, energy = 0, farthest = 0;
  std::size_t orphans = 0, neighbors = 0, free_regions = 0;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& region = diagram.region(i);
    const auto integrals = diagram.integrals(i); // by quadrature, so better kept than asked for twice
    area += region.area;
    energy += integrals.energy;
    orphans += region.number_of_orphans();
    if(region.is_fixed) // on the border, where generators stay although their mass centres lie inside
      continue;
    ++free_regions;
    neighbors += diagram.neighbors(i).size();
    const K::Vector_2 offset = integrals.mass_centre - region.generator;
    farthest = (std::max)(farthest, std::sqrt(region.vertex->metric_tensor().squared_length(offset)));
  }
  std::cout << diagram.number_of_regions() << " regions: area " << area << ", energy " << energy << ", "
            << orphans << " orphans\nneighbors of a free one: " << double(neighbors) / double(free_regions)
            << "\nfarthest from its mass centre, in lengths of an edge: " << farthest
            << "\nedges dual to a bisector: " << 100 * diagram.duality().share_of_dual_edges() << " %\n";

  CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
  drawing.mass_centres = drawing.dual_edges = true;
  CGAL::IO::write_SVG("tessellation.svg", diagram, "Regions, dual edges and mass centres", drawing);
  return std::abs(area - 1) < 1e-9 && farthest < 0.1 ? 0 : 1;
}

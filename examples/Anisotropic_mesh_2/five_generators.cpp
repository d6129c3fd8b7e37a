// Figure 2.2 of Du and Wang: the regions of five generators in a square under
// three metrics. Under the last one the region of the centre has two orphans.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>

using K       = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point   = K::Point_2;
using Tensor  = CGAL::Metric_tensor_2<K>;
using Field   = std::function<Tensor(const Point&)>;
using Traits  = CGAL::Riemannian_metric_traits_2<K, Field>;
using Mesh    = CGAL::Anisotropic_Delaunay_mesh_2<Traits>;
using Diagram = CGAL::Anisotropic_Voronoi_diagram_2<Mesh>;

// the corners of the square [-1,1]^2, which are generators as well, and its centre
Mesh five_generators(const Field& field)
{
  Mesh::Boundary_graph square;
  square.points = {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)};
  for(std::size_t i = 0; i < 4; ++i)
    square.segments.push_back({i, (i + 1) % 4, 1, true});
  Mesh mesh{Traits(field)};
  mesh.insert_boundary(square);
  mesh.insert(Point(0, 0));
  return mesh;
}

void tessellate(const std::string& name, const std::string& title, const Field& field)
{
  const Mesh mesh = five_generators(field);
  const Diagram diagram(mesh);
  CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
  drawing.mass_centres = true;
  CGAL::IO::write_SVG("five_generators_" + name + ".svg", diagram, title, drawing);

  std::cout << title << '\n';
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& region = diagram.region(i);
    std::cout << "  (" << region.generator << "): area " << region.area
              << ", mass centre (" << diagram.integrals(i).mass_centre << ')';
    for(const auto& piece : region.pieces)
      if(!piece.is_main)
        std::cout << ", an orphan of area " << piece.area;
    std::cout << '\n';
  }
}

int main()
{
  tessellate("isotropic", "M = I", [](const Point&) { return Tensor(); });
  tessellate("constant", "M = diag(4, 1)", [](const Point&) { return Tensor::from_entries(4, 0, 1); });
  tessellate("varying", "M = diag(7 - 6.3 |x|, 1)", [](const Point& p)
             { return Tensor::from_entries(7 - 6.3 * std::abs(p.x()), 0, 1); });
  return 0;
}

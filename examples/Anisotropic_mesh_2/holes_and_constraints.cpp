// An L-shaped plate with a round hole, and a line inside that edges must
// follow and that parts the plate into two subdomains.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <map>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;
using Curve  = CGAL::Anisotropic_mesh_2::Curve_piece_2<K>;

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 1);
  domain.add_circle(Point(1, 1), 0.5, 2);
  domain.add_constraint(Curve::segment(Point(2, 2), Point(2, 0), 3));
  domain.add_region(Point(1, 3), 10);
  domain.add_region(Point(3, 1), 20);

  // layers around the hole: thin across, long along
  auto field = [](const Point& p) {
    const double x = p.x() - 1, y = p.y() - 1, distance = std::abs(std::hypot(x, y) - 0.5);
    return Tensor::from_sizes(0.02 + 0.2*distance, 0.1 + 0.1*distance, std::atan2(y, x));
  };

  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);

  std::map<int, int> edges, faces;
  for(const auto& e : mesh.edges_in_domain())
    if(mesh.is_constrained(e))
      ++edges[mesh.edge_reference(e)];
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      ++faces[f->subdomain_index()];
  for(const auto& r : edges)
    std::cout << r.second << " edges of curve " << r.first << '\n';
  for(const auto& r : faces)
    std::cout << r.second << " faces of subdomain " << r.first << '\n';

  CGAL::IO::write_MEDIT("holes_and_constraints.mesh", mesh);
  CGAL::IO::write_SVG("holes_and_constraints.svg", mesh);
  return edges.size() == 3 && faces.size() == 2 ? 0 : 1;
}

// A graph z = f(x, y), meshed by its curvature: to a file, to a picture, and
// to a class that the algorithms of CGAL work on.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/Callable_surface_3.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>

#include <cmath>
#include <iostream>
#include <type_traits>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  const auto height = [](const K::Point_2& p) { return std::sin(p.x()) * std::cos(p.y()); };
  const auto surface = CGAL::Anisotropic_mesh_2::make_graph_surface_3<K>(height, {0, 3, 0, 3}); // x and y from 0 to 3

  // edges come as close to the surface as 0.002 radii of curvature; sizes from 0.02 to 0.5
  const CGAL::Anisotropic_mesh_2::Curvature_metric_3<std::decay_t<decltype(surface)> > metric(0.002, 0.02, 0.5);
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(CGAL::make_surface_metric_field_2(surface, metric));

  std::cout << CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  CGAL::IO::write_OFF("graph_surface.off", mesh);
  CGAL::IO::write_SVG("graph_surface.svg", mesh, "sin(x) cos(y)",
                      CGAL::Anisotropic_mesh_2::View_direction_3{2.2, 0.7}); // from behind, and from above

  CGAL::Surface_mesh<K::Point_3> faces;
  mesh.add_to(faces);
  return CGAL::is_triangle_mesh(faces) ? 0 : 1;
}

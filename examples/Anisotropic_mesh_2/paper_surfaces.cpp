// Figures 5.4 to 5.8 of Du and Wang: an ellipsoid refined at a point, a
// paraboloid refined along a line, a torus refined along a circle, and a saddle,
// under three sizes along the axes and under the metric of its curvature.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_ellipsoid_3.h>
#include <CGAL/Anisotropic_mesh_2/Parametric_torus_3.h>
#include <CGAL/Anisotropic_mesh_2/Quadratic_graph_surface_3.h>
#include <CGAL/Surface_metric_field_2.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>

#include <cmath>
#include <iostream>
#include <string>

using K         = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3   = K::Point_3;
using Tensor_3  = CGAL::Metric_tensor_3<K>;
using Saddle    = CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>;
using Rectangle = CGAL::Anisotropic_mesh_2::Parameter_rectangle;

// meshes a surface, draws it, and returns whether it is as good as the paper's
template <class Surface, class Metric>
bool mesh_surface(const std::string& name, const Surface& surface, const Metric& metric, double mean_of_paper)
{
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(CGAL::make_surface_metric_field_2(surface, metric));
  const auto s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  std::cout << name << '\t' << s.vertices << '\t' << s.quality_mean << '\t' << s.quality_min << '\t'
            << s.energy_ratio << '\n';
  CGAL::IO::write_SVG("surface_" + name + ".svg", mesh);
  return s.quality_mean > mean_of_paper;
}

Rectangle centred_square(double side)
{
  Rectangle r;
  r.u_min = r.v_min = -side / 2;
  r.u_max = r.v_max = side / 2;
  return r;
}

int main()
{
  std::cout << "surface\tvertices\tmean quality\tleast quality\tenergy ratio\n";
  bool good = true;
  good &= mesh_surface("ellipsoid", CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>(2, 1.2, 0.8), [](const Point_3& p)
                       { return 0.03 + 0.1 * std::hypot(p.x(), p.y(), p.z() - 0.8); }, 0.984);
  good &= mesh_surface("paraboloid", Saddle(1, 1, centred_square(2)), [](const Point_3& p)
                       { return 0.04 + 0.15 * std::abs(p.y()); }, 0.979);
  good &= mesh_surface("torus", CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>(2, 0.7), [](const Point_3& p)
                       { return 0.08 + 0.2 * std::hypot(std::hypot(p.x(), p.y()) - 2.7, p.z()); }, 0.978);
  good &= mesh_surface("saddle_sizes", Saddle(2, -4, centred_square(1)), [](const Point_3&)
                       { return Tensor_3::from_sizes(0.04, 0.4, 0.04); }, 0.971);
  good &= mesh_surface("saddle_curvature", Saddle(2, -4, centred_square(2)),
                       CGAL::Anisotropic_mesh_2::Curvature_metric_3<Saddle>(0.001, 0.005, 1), 0.968);
  return good ? 0 : 1;
}

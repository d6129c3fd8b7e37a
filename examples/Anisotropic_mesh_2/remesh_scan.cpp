// A scanned surface, of many points without order, is remeshed by its curvature: the parametrization that this
// needs, and the curvature, are computed from the triangles. New vertices lie on them, and the border stays.
//
//   remesh_scan [FILE]    a disc of triangles in any format of CGAL; by default a mask that is made here

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Anisotropic_mesh_2/Triangulated_surface_3.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>

using K       = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;
using Scan    = CGAL::Surface_mesh<Point_3>;
using Surface = CGAL::Anisotropic_mesh_2::Triangulated_surface_3<K>;
using Metric  = CGAL::Anisotropic_mesh_2::Curvature_metric_3<Surface>;

double bump(double x, double y) { return std::exp(-x*x - y*y); }

// a face, as far as ten bumps can be one
Point_3 mask(double x, double y)
{
  const double side = std::abs(x);
  const double nose = 0.22 * bump(x / 0.13, (y + 0.08) / 0.22) + 0.10 * bump(x / 0.10, (y - 0.2) / 0.3);
  const double eyes = 0.06 * bump((side - 0.32) / 0.09, (y - 0.21) / 0.07)
                    - 0.14 * bump((side - 0.32) / 0.17, (y - 0.22) / 0.11);
  const double brows = 0.05 * bump((side - 0.3) / 0.25, (y - 0.42) / 0.07);
  const double lips = 0.05 * bump(x / 0.22, (y + 0.46) / 0.05) + 0.05 * bump(x / 0.2, (y + 0.58) / 0.05);
  return Point_3(0.8 * x, y, 0.9 * std::sqrt(1.25 - x*x - y*y) + nose + eyes + brows + lips);
}

// random points of it, with the noise of a scanner
Scan scanned_mask()
{
  CGAL::Delaunay_triangulation_2<K> plane;
  CGAL::Random random(0);
  for(int i = 0; i < 250; ++i)
    plane.insert(Point_2(std::cos(i * CGAL_PI / 125), std::sin(i * CGAL_PI / 125)));
  while(plane.number_of_vertices() < 12000) {
    const double x = random.get_double(-1, 1), y = random.get_double(-1, 1);
    if(x*x + y*y < 0.98)
      plane.insert(Point_2(x, y));
  }
  Scan scan;
  std::map<CGAL::Delaunay_triangulation_2<K>::Vertex_handle, Scan::Vertex_index> index;
  for(auto v = plane.finite_vertices_begin(); v != plane.finite_vertices_end(); ++v) {
    const double noise = random.get_double(-1e-4, 1e-4);
    index[v] = scan.add_vertex(mask(v->point().x(), v->point().y()) + K::Vector_3(0, 0, noise));
  }
  for(auto f = plane.finite_faces_begin(); f != plane.finite_faces_end(); ++f)
    scan.add_face(index[f->vertex(0)], index[f->vertex(1)], index[f->vertex(2)]);
  return scan;
}

double diagonal(const Scan& scan)
{
  const CGAL::Bbox_3 b = CGAL::Polygon_mesh_processing::bbox(scan);
  return std::hypot(b.x_span(), b.y_span(), b.z_span());
}

// prints how close the new mesh comes, and writes it; returns whether it is good
bool remesh(const Scan& scan)
{
  const Surface surface(scan);
  const double d = diagonal(scan);
  const Metric metric(0.005, d / 200, d / 25, 4); // relative chord error, bounds of the sizes and of their ratio
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(surface.domain(),
                                                        CGAL::make_surface_metric_field_2(surface, metric));
  const auto s = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  std::cout << scan.number_of_vertices() << " vertices became " << s.vertices
            << "\nmean quality in the metric: " << s.quality_mean << ", least: " << s.quality_min
            << "\nmean distance to the scan: " << 100 * s.distance_mean / d << " % of the diagonal" << std::endl;
  CGAL::IO::write_OFF("remesh_scan.off", mesh);
  CGAL::IO::write_SVG("surface_scan.svg", mesh, "",
                      CGAL::Anisotropic_mesh_2::View_direction_3{-1.3, 1.2}); // from the front
  return s.quality_mean > 0.9;
}

int main(int argc, char* argv[])
{
  try {
    Scan scan;
    if(argc == 1)
      scan = scanned_mask();
    else if(!CGAL::IO::read_polygon_mesh(argv[1], scan))
      throw std::runtime_error("no polygon mesh can be read");
    return remesh(scan) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e) { // for example, the surface may be no disc
    std::cerr << (argc == 1 ? "the mask" : argv[1]) << ": " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}

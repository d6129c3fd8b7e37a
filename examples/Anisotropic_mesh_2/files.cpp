// From files to files: a domain, a metric at the vertices of a background mesh, the new mesh in four formats,
// and back again. A solver that adapts its mesh does this in each round.
//
//   files [DOMAIN.poly]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/IO/VTU.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Discrete_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;
using Domain = CGAL::Anisotropic_mesh_domain_2<K>;

// what a solver would write: a mesh to begin with, and the tensors that it wants at the vertices
void write_background(const Domain& domain)
{
  const CGAL::Constant_metric_field_2<K> uniform(Tensor::from_size(0.2));
  CGAL::IO::write_MEDIT("background.mesh", CGAL::make_anisotropic_mesh_2(domain, uniform));

  std::vector<Tensor> tensors; // in the order of the vertices in the file
  for(const Point& p : CGAL::IO::read_MEDIT<K>("background.mesh").points) {
    const double distance = std::hypot(p.x(), p.y()) - 0.5; // to the hole of the plate
    tensors.push_back(Tensor::from_sizes(0.03 + 0.2 * std::abs(distance), 0.2, std::atan2(p.y(), p.x())));
  }
  CGAL::IO::write_MEDIT_metric("background.sol", tensors);
}

int main(int argc, char* argv[])
{
  try {
    const Domain domain(CGAL::IO::read_POLY<K>(argc > 1 ? argv[1] : "data/plate.poly"));
    write_background(domain);

    const CGAL::Discrete_metric_field_2<K> field(CGAL::IO::read_MEDIT<K>("background.mesh"),
                                                 CGAL::IO::read_MEDIT_metric<K>("background.sol"));
    auto mesh = CGAL::make_anisotropic_mesh_2(domain, field);
    CGAL::optimize_anisotropic_mesh_2(mesh);

    CGAL::IO::write_MEDIT("files.mesh", mesh); // with references of edges and subdomains
    CGAL::IO::write_MEDIT_metric("files.sol", mesh);
    CGAL::IO::write_VTU("files.vtu", mesh);
    CGAL::IO::write_OFF("files.off", mesh);
    CGAL::IO::write_SVG("files.svg", mesh, "The mesh that was written");

    // The mesh is the background of the next round, and its border bounds the domain.
    const auto background = CGAL::IO::read_MEDIT<K>("files.mesh");
    const CGAL::Discrete_metric_field_2<K> next_field(background,
                                                      CGAL::IO::read_MEDIT_metric<K>("files.sol"));
    const auto next = CGAL::make_anisotropic_mesh_2(Domain(background), next_field);
    std::cout << mesh.number_of_vertices() << " vertices, and " << next.number_of_vertices()
              << " in the next round" << std::endl;
    return background.points.size() == mesh.number_of_vertices() && next.is_valid(true, 1) ? 0 : 1;
  }
  catch(const CGAL::Mesh_io_exception& e) {
    std::cerr << e.what() << std::endl; // the file, the line, and what is wrong there
    return 1;
  }
}

// A vertex base of one's own: buoys that float on a pond are vertices of its mesh and know their names. What
// vertices hold stays with them when the mesh is edited and optimized.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <iostream>
#include <string>
#include <vector>

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;

struct Field
{
  Tensor operator()(const Point& p) const
  {
    return Tensor::from_sizes(0.1, 0.1 - 0.24 * p.x() * (1 - p.x()));
  }
};

// The bases of the package add to any base of CGAL what they need.
using Traits      = CGAL::Riemannian_metric_traits_2<K, Field>;
using Named       = CGAL::Triangulation_vertex_base_with_info_2<std::string, Traits>;
using Vertex_base = CGAL::Anisotropic_mesh_vertex_base_2<Traits, Named>;
using Face_base   = CGAL::Anisotropic_mesh_face_base_2<Traits>;
using Tds         = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Mesh        = CGAL::Anisotropic_Delaunay_mesh_2<Traits, Tds>;

int main()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Mesh pond = CGAL::make_anisotropic_mesh_2<Mesh>(domain, Traits(Field()));
  const Mesh::Vertex_handle red = pond.insert(Point(0.3, 0.7)), green = pond.insert(Point(0.6, 0.2)),
                            white = pond.insert(Point(0.8, 0.6));
  red->info() = "red";
  green->info() = "green";
  white->info() = "white";

  pond.remove(white);
  pond.move(green, Point(0.2, 0.15)); // across many faces
  // Buoys may drift, but not vanish, as vertices off constrained edges might by quality moves.
  CGAL::optimize_anisotropic_mesh_2(pond, CGAL::Anisotropic_mesh_2::parameters::quality_moves(false));

  int buoys = 0;
  for(auto v = pond.finite_vertices_begin(); v != pond.finite_vertices_end(); ++v)
    if(!v->info().empty()) { // the other vertices have no name
      std::cout << v->info() << " at " << v->point() << '\n';
      ++buoys;
    }
  std::cout << pond.number_of_vertices() << " vertices" << std::endl;
  return buoys == 2 && red->info() == "red" && green->info() == "green" && pond.is_valid(true, 1) ? 0 : 1;
}

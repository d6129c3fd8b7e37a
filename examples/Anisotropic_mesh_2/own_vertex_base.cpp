// A vertex base of one's own: buoys that float on a pond are vertices of its mesh and know their names. What
// vertices hold stays with them when the mesh is refined, edited and optimized.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/acvt_optimize_mesh_2.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <cstddef>
#include <iostream>
#include <string>

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

Mesh unit_square()
{
  Mesh::Boundary_mesh border;
  border.points = {Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)};
  for(std::size_t i = 0; i < 4; ++i)
    border.segments.push_back({i, (i + 1) % 4, 1, true});
  Mesh mesh{Traits(Field())};
  mesh.insert_boundary(border);
  for(int i = 1; i < 10; ++i) // refinement takes constrained edges as they are
    for(const Point& p : {Point(i / 10., 0), Point(1, i / 10.), Point(i / 10., 1), Point(0, i / 10.)})
      mesh.insert(p);
  return mesh;
}

int main()
{
  Mesh pond = unit_square();
  const Mesh::Vertex_handle red = pond.insert(Point(0.3, 0.7)), green = pond.insert(Point(0.6, 0.2)),
                            white = pond.insert(Point(0.8, 0.6));
  red->info() = "red";
  green->info() = "green";
  white->info() = "white";

  CGAL::refine_anisotropic_mesh_2(pond);
  pond.remove(white);
  pond.move(green, Point(0.2, 0.15)); // across many faces
  // Buoys may drift, but not vanish, as vertices off constrained edges might by topological moves.
  CGAL::acvt_optimize_mesh_2(pond, CGAL::Anisotropic_mesh_2::parameters::topological_moves(false));

  int buoys = 0;
  for(auto v = pond.finite_vertices_begin(); v != pond.finite_vertices_end(); ++v)
    if(!v->info().empty()) { // the other vertices have no name
      std::cout << v->info() << " at " << v->point() << '\n';
      ++buoys;
    }
  std::cout << pond.number_of_vertices() << " vertices" << std::endl;
  return buoys == 2 && red->info() == "red" && green->info() == "green" && pond.is_valid(true, 1) ? 0 : 1;
}

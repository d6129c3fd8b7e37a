// Meshes of the user's types and of the user's triangulations: what vertices store
// outlasts every operation, and a triangulation of CGAL is taken over as it is.

#include "check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using K       = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = K::Point_2;
using Tensor  = CGAL::Metric_tensor_2<K>;

struct Field
{
  Tensor operator()(const Point_2& p) const { return Tensor::from_sizes(0.1, 0.1 + 0.2 * std::abs(p.x())); }
};

using Traits   = CGAL::Riemannian_metric_traits_2<K, Field>;
using Own_base = CGAL::Anisotropic_mesh_vertex_base_2<Traits, CGAL::Triangulation_vertex_base_with_info_2<std::string, Traits> >;
using Tds      = CGAL::Triangulation_data_structure_2<Own_base, CGAL::Anisotropic_mesh_face_base_2<Traits> >;
using Mesh     = CGAL::Anisotropic_Delaunay_mesh_2<Traits, Tds>;

CGAL::Anisotropic_mesh_domain_2<K> square()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point_2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  return domain;
}

void check_names(const Mesh& mesh, const std::string& what)
{
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    CHECK_MSG(v->info() == "vertex " + std::to_string(v->index()), what + ": " + v->info());
  CHECK_MSG(mesh.is_valid(true), what);
}

void test_own_vertex_base()
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(square(), Traits(Field()));
  const auto by_default = CGAL::make_anisotropic_mesh_2(square(), Field());
  CHECK(std::vector<Point_2>(mesh.points_begin(), mesh.points_end())
        == std::vector<Point_2>(by_default.points_begin(), by_default.points_end()));

  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    v->info() = "vertex " + std::to_string(v->index());
  check_names(mesh.empty_mesh(), "empty mesh");
  CHECK(mesh.empty_mesh().number_of_vertices() < mesh.number_of_vertices());
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::Anisotropic_mesh_2::parameters::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)
                                          .number_of_iterations(3));
  check_names(mesh, "Lloyd");
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::Anisotropic_mesh_2::parameters::quality_moves(false));
  check_names(mesh, "quasi-Newton");
  CHECK(mesh.number_of_vertices() == by_default.number_of_vertices());
}

// A square with a square hole, of CGAL's mesher, and a constraint within.
void test_triangulation_of_cgal()
{
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2
    <K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>, CGAL::Delaunay_mesh_face_base_2<K> > >;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
  Cdt cdt;
  for(double r : {1., 0.5}) {
    const std::vector<Point_2> loop = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    cdt.insert_constraint(loop.begin(), loop.end(), true);
  }
  cdt.insert_constraint(Point_2(0.5, 0), Point_2(1, 0));
  const std::vector<Point_2> holes = {{0, 0}};
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(0.125, 0.2));
  mesher.set_seeds(holes.begin(), holes.end());
  mesher.refine_mesh();

  Mesh mesh{Traits(Field())};
  mesh.insert_triangulation(cdt);
  CHECK(mesh.is_valid(true));
  CHECK(mesh.number_of_faces_in_domain() > 50);
  CHECK(std::set<Point_2>(mesh.points_begin(), mesh.points_end()) == std::set<Point_2>(cdt.points_begin(), cdt.points_end()));
  const auto number_of_constraints = [](const auto& t) {
    std::size_t n = 0;
    for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
      n += t.is_constrained(*e);
    return n;
  };
  CHECK(number_of_constraints(mesh) == number_of_constraints(cdt));
  double area = 0;
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      area += CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  CHECK_MSG(std::abs(area - 3) < 1e-12, std::to_string(area));
  CGAL::optimize_anisotropic_mesh_2(mesh);
  CHECK(mesh.is_valid(true) && number_of_constraints(mesh) == number_of_constraints(cdt));
}

int main()
{
  test_own_vertex_base();
  test_triangulation_of_cgal();
  return finish();
}

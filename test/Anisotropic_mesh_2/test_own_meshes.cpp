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

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
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

using Method = CGAL::Anisotropic_mesh_2::Optimization_method;

// the vertices that a test requires, as a property map
struct Is_among
{
  typedef Mesh::Vertex_handle                    key_type;
  typedef bool                                   value_type, reference;
  typedef boost::readable_property_map_tag       category;

  const std::set<int>* indices;

  friend bool get(const Is_among& map, Mesh::Vertex_handle v) { return map.indices->count(v->index()) > 0; }
};

std::map<int, Point_2> positions(const Mesh& mesh)
{
  std::map<int, Point_2> result;
  for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
    result[v->index()] = v->point();
  return result;
}

void check_positions(const Mesh& mesh, const std::map<int, Point_2>& before, const std::set<int>& required,
                     const std::string& what)
{
  const std::map<int, Point_2> after = positions(mesh);
  for(int i : required)
    CHECK_MSG(after.count(i) == 1 && after.at(i) == before.at(i), what + ", vertex " + std::to_string(i));
  std::size_t moved = 0;
  for(const auto& p : before)
    moved += after.count(p.first) == 0 || after.at(p.first) != p.second;
  CHECK_MSG(moved > before.size() / 2, what);
  CHECK_MSG(mesh.is_valid(true), what);
}

// Vertices in pairs that are much closer to each other than the metric wants: optimizers
// would part them and quality moves unite them.
void test_required_vertices()
{
  Mesh start = CGAL::make_anisotropic_mesh_2<Mesh>(square(), Traits(Field()));
  std::set<int> required;
  for(const Point_2& p : {Point_2(0.3, 0.1), Point_2(0.31, 0.1), Point_2(-0.5, 0.52), Point_2(-0.49, 0.5)})
    required.insert(start.insert(p)->index());
  const std::map<int, Point_2> before = positions(start);

  for(bool by_map : {false, true})
    for(bool by_lloyd : {false, true}) {
      const std::string what = std::string(by_lloyd ? "Lloyd" : "quasi-Newton") + (by_map ? ", map" : ", marks");
      const auto optimize = [&](Mesh& mesh) {
        const auto np = CGAL::Anisotropic_mesh_2::parameters::number_of_iterations(20)
                          .method(by_lloyd ? Method::LLOYD : Method::QUASI_NEWTON);
        if(by_map)
          CGAL::optimize_anisotropic_mesh_2(mesh, np.vertex_is_constrained_map(Is_among{&required}));
        else
          CGAL::optimize_anisotropic_mesh_2(mesh, np);
      };
      Mesh mesh = start;
      for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
        v->set_required(!by_map && required.count(v->index()) > 0);
      optimize(mesh);
      check_positions(mesh, before, required, what);
      for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
        CHECK_MSG(v->is_required() == (!by_map && required.count(v->index()) > 0), what);
      for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
        v->set_required(false);
      CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(2));
      const std::map<int, Point_2> after = positions(mesh);
      for(int i : required)
        CHECK_MSG(after.at(i) != before.at(i), what); // nothing else had held them
    }

  Mesh::Vertex_handle v = start.insert(Point_2(0.3, 0.1));
  CHECK(!start.is_fixed(v));
  v->set_required(true);
  CHECK(start.is_fixed(v) && start.empty_mesh().insert(Point_2(0.3, 0.1))->index() == v->index());
}

// fails after some vertices that it requires
struct Failing_map
{
  typedef Mesh::Vertex_handle                    key_type;
  typedef bool                                   value_type, reference;
  typedef boost::readable_property_map_tag       category;

  int* calls;

  friend bool get(const Failing_map& map, Mesh::Vertex_handle)
  {
    if(++*map.calls > 5)
      throw std::runtime_error("no value here");
    return true;
  }
};

void test_failing_map()
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(square(), Traits(Field()));
  int calls = 0;
  const auto np = CGAL::parameters::vertex_is_constrained_map(Failing_map{&calls});
  CHECK_THROWS(CGAL::Anisotropic_mesh_2::internal::Required_for_now<Mesh>(mesh, np), std::runtime_error, "no value here");
  CHECK(calls == 6);
  for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
    CHECK(!v->is_required());
}

void test_ranges()
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(square(), Traits(Field()));
  const std::size_t vertices = mesh.number_of_vertices();
  CHECK(mesh.number_of_vertices_in_domain() == vertices && mesh.vertices_in_domain().size() == vertices);
  mesh.insert(Point_2(5, 5));
  CHECK(mesh.number_of_vertices() == vertices + 1 && mesh.number_of_vertices_in_domain() == vertices);
  const auto faces = mesh.faces_in_domain();
  CHECK(faces.size() == mesh.number_of_faces_in_domain() && faces.size() < mesh.number_of_faces());
  CHECK(vertices - mesh.edges_in_domain().size() + faces.size() == 1); // Euler
  std::size_t boundary = 0;
  for(const Mesh::Edge& e : mesh.constrained_edges())
    boundary += mesh.is_on_boundary(e);
  CHECK(3 * faces.size() + boundary == 2 * mesh.edges_in_domain().size());
}

int main()
{
  test_own_vertex_base();
  test_triangulation_of_cgal();
  test_required_vertices();
  test_failing_map();
  test_ranges();
  return finish();
}

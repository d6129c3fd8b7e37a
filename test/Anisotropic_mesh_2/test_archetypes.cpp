// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Everything compiles and works with models that have the least that the
// concepts promise, so that no algorithm needs more than the manual says.

#include "include/archetypes/Face_base_archetypes.h"
#include "include/archetypes/Functor_archetypes.h"
#include "include/archetypes/Metric_field_archetype.h"
#include "include/archetypes/Range_archetype.h"
#include "include/archetypes/Riemannian_metric_traits_archetype.h"
#include "include/archetypes/Vertex_base_archetype.h"
#include "include/check.h"
#include "include/concept_checks.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/IO/VTU.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Oriented_sizes_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_Delaunay_consistency_2.h>
#include <CGAL/anisotropic_mass_centre_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Anisotropic_mesh_2/Labelle_Shewchuk_distance_2.h>
#include <CGAL/anisotropic_visibility_region_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>
#include <CGAL/approximation_error_2.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel                            K;
typedef Riemannian_metric_traits_archetype<K>                                          Exact_traits;
typedef Riemannian_metric_traits_archetype<CGAL::Simple_cartesian<double> >            Inexact_traits;
typedef std::vector<Point_archetype>                                                   Points;

namespace p = CGAL::Anisotropic_mesh_2::parameters;
const auto lloyd_method = p::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD);

// the archetypes promise what the concepts promise
static_assert(models_metric_field<Metric_field_archetype<K>, K>(), "");
static_assert(models_riemannian_metric_traits<Exact_traits>(), "");
static_assert(models_riemannian_metric_traits<Inexact_traits>(), "");
static_assert(Exact_traits::has_exact_predicates && !Inexact_traits::has_exact_predicates, "");

// ---------------------------------------------------------------- the triangulation

template <class Gt>
using Plain_tds = CGAL::Triangulation_data_structure_2<Vertex_base_archetype<Gt>, Constrained_face_base_archetype<> >;

template <class T>
void test_insertion(T& t)
{
  Points points;
  for(int i = 0; i < 50; ++i)
    points.push_back(point_archetype((i * 17) % 50 / 16., (i * 29) % 50 / 16.)); // exact in double
  const auto range = Range_archetype<Point_archetype>::make(points);
  CHECK(t.insert(range.begin(), range.end()) == 50);
  const auto v = t.insert(point_archetype(3.875, 0.125)), w = t.push_back(point_archetype(3.875, 2));
  t.insert_constraint(v, w);
  t.insert_constraint(point_archetype(0.0625, 0.03125), point_archetype(0.5, 0.03125));
  const auto loop = Range_archetype<Point_archetype>::make(
    {point_archetype(0, 0), point_archetype(4, 0), point_archetype(4, 4)});
  t.insert_constraint(loop.begin(), loop.end(), true);
  CHECK(t.is_valid(true) && t.dimension() == 2);
}

template <class T>
void test_vertices(const T& t)
{
  const auto tensor = t.geom_traits().construct_metric_tensor_2_object();
  std::set<int> indices;
  for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
    CHECK(v->metric_tensor() == tensor(v->point()));
    CHECK(v->index() >= 0 && v->index() < t.vertex_index_bound());
    indices.insert(v->index());
  }
  CHECK(indices.size() == t.number_of_vertices());
}

template <class T>
void test_cavity(T& t, const Point_archetype& p)
{
  const auto m = t.geom_traits().construct_metric_tensor_2_object()(p);
  typename T::Locate_type lt;
  int li;
  const auto f = t.locate(p, lt, li);
  if(!CHECK(lt == T::FACE))
    return;
  typename T::Cavity cavity;
  t.find_cavity(p, m, lt, f, li, cavity);
  for(const auto& g : cavity.faces)
    CHECK(g == f || t.is_in_conflict(g, p, m));
  const auto v = t.insert_in_cavity(p, m, cavity);
  CHECK(t.degree(v) == cavity.boundary.size() && t.is_valid(true));
}

template <class T>
void test_flips(T& t)
{
  int flips = 0;
  for(auto f = t.finite_faces_begin(); f != t.finite_faces_end() && flips < 10; ++f)
    for(int i = 0; i < 3; ++i)
      if(t.is_flippable(f, i)) {
        t.flip(f, i);
        ++flips;
        break;
      }
  CHECK(flips == 10 && t.is_valid(true));
  std::vector<typename T::Edge> edges;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    edges.push_back(*e);
  CHECK(t.flip_edges(edges, Edge_predicate_archetype<T>::make(t)) > 0);
  t.restore_local_criterion(edges);
  CHECK(t.is_valid(true));
}

template <class T>
void test_removal_and_moves(T& t)
{
  const auto v = t.insert(point_archetype(2.25, 1.125));
  CHECK(t.move_if_no_collision(v, point_archetype(2.26, 1.13)) == v);
  CHECK(t.move(v, point_archetype(0.375, 3.5)) == v && t.is_valid(true, 2));
  CHECK(t.remove(v) && t.is_valid(true, 2));
  const auto a = t.insert(point_archetype(3.875, 0.125)), b = t.insert(point_archetype(3.875, 2));
  typename T::Face_handle f;
  int i;
  CHECK(t.is_edge(a, b, f, i));
  t.remove_constrained_edge(f, i);
  t.remove_incident_constraints(t.insert(point_archetype(4, 4)));
  CHECK(t.is_valid(true, 2));
  const auto consistency = CGAL::anisotropic_Delaunay_consistency_2(t);
  CHECK(consistency.stars == t.number_of_vertices() && consistency.edges > 100);
}

template <class T>
void test_triangulation()
{
  T t(T::Geom_traits::make());
  CHECK(t.is_valid());
  test_insertion(t);
  test_vertices(t);
  test_cavity(t, point_archetype(1.01, 1.23));
  test_flips(t);

  T copy;
  copy = t;
  CHECK(copy.is_valid(true) && copy.number_of_vertices() == t.number_of_vertices());
  copy.clear();
  copy.swap(t);
  CHECK(t.number_of_vertices() == 0 && copy.number_of_vertices() > 50);
  test_vertices(copy);
  test_cavity(copy, point_archetype(2.51, 1.73));
  test_removal_and_moves(copy);
}

// ---------------------------------------------------------------- meshes

template <class Gt>
using Mesh_tds = CGAL::Triangulation_data_structure_2<Vertex_base_archetype<Gt>, Mesh_face_base_archetype<> >;

static_assert(models_vertex_base<Mesh_tds<Exact_traits>::Vertex, Exact_traits>(), "");
static_assert(models_face_base<Mesh_tds<Exact_traits>::Face>(), "");

// the square [0, 4] x [0, 4] with a square hole, an inner segment and a region
template <class Mesh>
typename Mesh::Boundary_graph boundary_of_square()
{
  typename Mesh::Boundary_graph boundary;
  for(double low : {0., 1.5})
    for(int i = 0; i < 4; ++i)
      boundary.points.push_back(point_archetype(i == 1 || i == 2 ? 4 - low : low, i < 2 ? low : 4 - low));
  boundary.points.push_back(point_archetype(0.5, 0.5));
  for(std::size_t i = 0; i < 8; ++i)
    boundary.segments.push_back({i, i % 4 == 3 ? i - 3 : i + 1, i < 4 ? 1 : 2, true});
  boundary.segments.push_back({0, 8, 3, false});
  boundary.regions.push_back({point_archetype(3, 1), 5});
  return boundary;
}

template <class Mesh>
bool is_mesh_of_square(const Mesh& mesh)
{
  int holes = 0;
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f) {
    holes += !f->is_in_domain();
    CHECK(!f->is_in_domain() || f->subdomain_index() == 5);
  }
  return mesh.is_valid(true) && holes == 2;
}

template <class Mesh>
void test_statistics(const Mesh& mesh)
{
  namespace A = CGAL::Anisotropic_mesh_2;
  const A::Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh);
  CHECK(s.vertices == mesh.number_of_vertices() && s.triangles == mesh.number_of_faces_in_domain());
  CHECK(s.quality_mean > 0.6 && s.energy_ratio > 1 && s.edge_length_mean > 1);
  CHECK(CGAL::anisotropic_mesh_statistics_2(mesh, A::Measure::LEBESGUE).energy > 0);
  std::string names;
  s.for_each(Figure_visitor_archetype::make(names));
  CHECK(names.find("vertices") == 0 && names.find("energy_ratio") != std::string::npos);
}

template <class Mesh>
void test_voronoi_diagram(const Mesh& mesh)
{
  typedef CGAL::Anisotropic_Voronoi_diagram_2<Mesh> Diagram;
  const Diagram diagram(mesh);
  CHECK(diagram.number_of_regions() == mesh.number_of_vertices());
  double area = 0, energy = 0;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    area += diagram.region(i).area;
    energy += diagram.integrals(i).energy;
    CHECK(diagram.index(diagram.region(i).vertex) == i);
    CHECK(diagram.nearest_generator(diagram.region(i).generator) == i);
  }
  CHECK(std::abs(area - 15) < 1e-9);
  CHECK(energy > 0 && diagram.duality().share_of_dual_edges() > 0.5);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, CGAL::Anisotropic_mesh_2::Labelle_Shewchuk_distance_2> other(mesh);
  CHECK(other.number_of_regions() == diagram.number_of_regions());
  CGAL::Anisotropic_mesh_2::Voronoi_drawing all;
  all.mass_centres = all.dual_edges = true;
  std::ostringstream os;
  CGAL::IO::write_SVG(os, diagram);
  CGAL::IO::write_SVG(os, other, "regions", all);
  CHECK(os.str().find("regions") != std::string::npos);
}

template <class Mesh>
void test_visibility_regions(const Mesh& mesh)
{
  CGAL::Anisotropic_mesh_2::Visibility_sampling shrunk;
  shrunk.shrinks_testing_region = true;
  std::size_t corners = 0;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v) {
    for(const auto& polygon : CGAL::anisotropic_visibility_region_2(mesh, typename Mesh::Vertex_handle(v)))
      corners += polygon.size();
    CHECK(!CGAL::anisotropic_visibility_region_2(mesh, typename Mesh::Vertex_handle(v), shrunk).empty());
    const auto centre = CGAL::anisotropic_mass_centre_2(mesh, typename Mesh::Vertex_handle(v));
    const double x = CGAL::to_double(centre.x()), y = CGAL::to_double(centre.y());
    CHECK(x >= 0 && x <= 4 && y >= 0 && y <= 4);
  }
  CHECK(corners > 30 * mesh.number_of_faces_in_domain() - 1);
}

// the faces as regions that have their first vertices as generators
template <class Mesh>
struct Faces_as_regions
{
  struct Region { Point_archetype generator; std::vector<std::array<Point_archetype, 3> > tiles; };

  explicit Faces_as_regions(const Mesh& mesh)
  {
    for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
      if(f->is_in_domain())
        regions.push_back({f->vertex(0)->point(), {{f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()}}});
  }

  std::size_t number_of_regions() const { return regions.size(); }
  Region region(std::size_t i) const { return regions[i]; }

  std::vector<Region> regions;
};

template <class Mesh>
void test_approximation_errors(const Mesh& mesh)
{
  const auto f = [](const Point_archetype& p) { return p.x() * p.x(); };
  CHECK(CGAL::piecewise_linear_approximation_error_2(mesh, f).l2 > 0);
  CHECK(CGAL::piecewise_constant_approximation_error_2(Faces_as_regions<Mesh>(mesh), f).l2 > 0);
}

// a mesh, or any constrained triangulation of CGAL whose faces know whether they are in the domain
template <class Tr>
void test_writers(const Tr& tr)
{
  const auto reference = Edge_reference_archetype<Tr>::make();
  const auto quality = Quality_archetype<Tr>::make();
  std::ostringstream os;
  CGAL::IO::write_OFF(os, tr);
  CGAL::IO::write_VTU(os, tr);
  CGAL::IO::write_VTU(os, tr, CGAL::IO::ASCII);
  CGAL::IO::write_SVG(os, tr);
  CGAL::IO::write_SVG(os, tr, "title");
  CGAL::IO::write_SVG(os, tr, "title", quality);
  CGAL::IO::write_MEDIT(os, tr);
  CHECK(os.str().find(" 77\n") == std::string::npos);
  CGAL::IO::write_MEDIT(os, tr, reference);
  CHECK(os.str().find(" 77\n") != std::string::npos);

  const Scratch_directory scratch;
  CGAL::IO::write_OFF(scratch / "mesh.off", tr);
  CGAL::IO::write_VTU(scratch / "mesh.vtu", tr);
  CGAL::IO::write_SVG(scratch / "mesh.svg", tr, "title");
  CGAL::IO::write_SVG(scratch / "quality.svg", tr, "title", quality);
  CGAL::IO::write_MEDIT(scratch / "mesh.mesh", tr);
  CGAL::IO::write_MEDIT(scratch / "references.mesh", tr, reference);
  CHECK(scratch.number_of_files() == 6);
}

template <class Mesh>
void test_metric_writer(const Mesh& mesh)
{
  std::ostringstream os;
  CGAL::IO::write_MEDIT_metric(os, mesh);
  CHECK(os.str().find("SolAtVertices\n" + std::to_string(mesh.number_of_vertices()) + "\n") != std::string::npos);
}

template <class Mesh>
void test_optimizers(Mesh& mesh)
{
  int calls = 0;
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.convergence(0.).visitor(Visitor_archetype::make(calls))).return_code
        == CGAL::BOUND_REACHED && calls == 5);
  CHECK(mesh.is_valid(true));
  calls = 0;
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, p::convergence(0.).visitor(Visitor_archetype::make(calls))).return_code
        == CGAL::BOUND_REACHED && calls == 5);
  CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.measure(CGAL::Anisotropic_mesh_2::Measure::LEBESGUE)
                                                  .number_of_iterations(2));
  CGAL::optimize_anisotropic_mesh_2(mesh);
  const auto by_regions = p::region_evaluation(CGAL::Anisotropic_mesh_2::Region_evaluation::VISIBILITY_REGIONS)
                            .number_of_iterations(2);
  CGAL::optimize_anisotropic_mesh_2(mesh, by_regions.method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD));
  CGAL::optimize_anisotropic_mesh_2(mesh, by_regions);
  CHECK(mesh.is_valid(true));
}

template <class Mesh>
void test_mesh(CGAL::Anisotropic_mesh_2::Point_placement placement)
{
  Mesh mesh(Mesh::Geom_traits::make());
  mesh.insert_boundary(boundary_of_square<Mesh>());
  CHECK(mesh.empty_mesh().number_of_vertices() == 9);
  CHECK(CGAL::refine_anisotropic_mesh_2(mesh, p::point_placement(placement)) > 10);
  CHECK(is_mesh_of_square(mesh));
  test_optimizers(mesh);
  CHECK(is_mesh_of_square(mesh));
  test_statistics(mesh);
  test_voronoi_diagram(mesh);
  test_visibility_regions(mesh);
  test_approximation_errors(mesh);
  test_writers(mesh);
  test_metric_writer(mesh);
}

// ---------------------------------------------------------------- other triangulations in writers

void test_marked_triangulation()
{
  typedef CGAL::Triangulation_data_structure_2<Vertex_base_archetype<Exact_traits>, Marked_face_base_archetype<> > Tds;
  typedef CGAL::Constrained_triangulation_2<Exact_traits, Tds> Triangulation;
  Triangulation t(Exact_traits::make());
  for(double x : {0., 1., 3.})
    t.insert_constraint(point_archetype(x, 0), point_archetype(x, 2));
  for(auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    f->m_is_in_domain = CGAL::to_double(f->vertex(0)->point().x() + f->vertex(1)->point().x()
                                        + f->vertex(2)->point().x()) > 3;
  CHECK(t.tds().is_valid()); // t.is_valid() of some versions of CGAL writes points
  test_writers(t);
}

// ---------------------------------------------------------------- from domain and field

template <class Field>
void test_field(const CGAL::Anisotropic_mesh_domain_2<K>& domain, const Field& field)
{
  auto mesh = CGAL::make_anisotropic_mesh_2(domain, field, p::maximum_number_of_vertices(10000));
  CHECK(mesh.is_valid(true) && mesh.number_of_vertices() > 15);
  CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.number_of_iterations(2));
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(2));
  CHECK(mesh.is_valid(true));
  CHECK(CGAL::anisotropic_mesh_statistics_2(mesh).quality_mean > 0.7);
  CHECK(CGAL::Anisotropic_Voronoi_diagram_2<decltype(mesh)>(mesh).number_of_regions() > 0);
  CHECK(CGAL::Anisotropic_Voronoi_diagram_2<decltype(mesh)>(mesh).number_of_regions() > 0);
  test_visibility_regions(mesh);
  test_metric_writer(mesh);
}

void test_fields()
{
  typedef CGAL::Anisotropic_mesh_2::Curve_piece_2<K> Piece;
  const K::Point_2 a(0, 0), b(4, 0), c(4, 4), d(0, 4);
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(Range_archetype<K::Point_2>::make({a, b, c, d}));
  square.add_polyline(Range_archetype<K::Point_2>::make({a, K::Point_2(1, 1), K::Point_2(2, 1)}));
  test_field(square, Metric_field_archetype<K>::make());
  test_field(square, CGAL::make_isotropic_metric_field_2<K>(Size_archetype<K>::make()));
  test_field(square, CGAL::make_oriented_sizes_metric_field_2<K>(Sizes_archetype<K>::make()));

  // the chords of the curve lie below it, outside of the domain, but still within the square
  const Piece curve = Piece::parametrized(Curve_archetype<K>::make(), 0, 1);
  CGAL::Anisotropic_mesh_domain_2<K> curved;
  curved.add_loop(Range_archetype<Piece>::make(
    {curve, Piece::segment(b, c), Piece::segment(c, d), Piece::segment(d, a)}));
  test_field(curved, Metric_field_archetype<K>::make());
}

int main()
{
  test_triangulation<CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Exact_traits, Plain_tds<Exact_traits> > >();
  test_triangulation<CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Inexact_traits> >();
  test_mesh<CGAL::Anisotropic_Delaunay_mesh_2<Exact_traits, Mesh_tds<Exact_traits> > >
    (CGAL::Anisotropic_mesh_2::Point_placement::ADVANCING_FRONT);
  test_mesh<CGAL::Anisotropic_Delaunay_mesh_2<Inexact_traits> >
    (CGAL::Anisotropic_mesh_2::Point_placement::EDGE_SUBDIVISION);
  test_marked_triangulation();
  test_fields();
  return finish();
}

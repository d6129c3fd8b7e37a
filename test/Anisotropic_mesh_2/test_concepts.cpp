// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The models of the package have all that the concepts promise, and its bases
// may stand on others that hold the user's data.

#include "include/archetypes/Metric_field_archetype.h"
#include "include/check.h"
#include "include/concept_checks.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_face_base_2.h>
#include <CGAL/Anisotropic_mesh_vertex_base_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Oriented_sizes_metric_field_2.h>
#include <CGAL/Discrete_metric_field_2.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <istream>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Exact_predicates_exact_constructions_kernel     Exact;
typedef CGAL::Simple_cartesian<double>                        Inexact;
typedef K::Point_2                                            Point;
typedef CGAL::Metric_tensor_2<K>                              Tensor;

// the least of a field: it cannot be default constructed nor assigned
typedef Metric_field_archetype<K>                             Field;
typedef CGAL::Riemannian_metric_traits_2<K, Field>            Traits;

// ---------------------------------------------------------------- fields and traits

template <class K2>
constexpr bool fields_and_traits_are_models()
{
  typedef std::array<double, 3> (*Sizes)(const typename K2::Point_2&);
  typedef typename K2::FT (*Size)(const typename K2::Point_2&);
  typedef Tensor (*Function)(const Point&);
  static_assert(models_metric_field<CGAL::Constant_metric_field_2<K2>, K2>(), "");
  static_assert(models_metric_field<CGAL::Isotropic_metric_field_2<K2, Size>, K2>(), "");
  static_assert(models_metric_field<CGAL::Oriented_sizes_metric_field_2<K2, Sizes>, K2>(), "");
  static_assert(models_metric_field<CGAL::Discrete_metric_field_2<K2>, K2>(), "");
  static_assert(models_metric_field<Function, K>(), "");
  static_assert(models_riemannian_metric_traits<
                  CGAL::Riemannian_metric_traits_2<K2, CGAL::Constant_metric_field_2<K2> > >(), "");
  return true;
}

static_assert(fields_and_traits_are_models<K>(), "");
static_assert(fields_and_traits_are_models<Exact>(), "");
static_assert(fields_and_traits_are_models<Inexact>(), "");

static_assert(models_metric_field<Field, K>(), "");
static_assert(models_riemannian_metric_traits<Traits>(), "although the field can be neither made nor assigned");
static_assert(std::is_same<Traits::Metric_field, Field>::value, "");
static_assert(std::is_same<Traits::Kernel, K>::value, "");

static_assert(Traits::has_exact_predicates, "");
static_assert(CGAL::Riemannian_metric_traits_2<Exact, int>::has_exact_predicates, "");
static_assert(!CGAL::Riemannian_metric_traits_2<Inexact, int>::has_exact_predicates, "");

// ---------------------------------------------------------------- vertex and face bases

typedef CGAL::Triangulation_vertex_base_with_info_2<std::string, Traits>                   Vertex_with_info;
typedef CGAL::Triangulation_face_base_with_info_2<std::vector<int>, Traits>                Info_of_face;
typedef CGAL::Constrained_triangulation_face_base_2<Traits, Info_of_face>                  Face_with_info;
typedef CGAL::Anisotropic_mesh_vertex_base_2<Traits, Vertex_with_info>                     Rich_vertex;
typedef CGAL::Anisotropic_mesh_face_base_2<Traits, Face_with_info>                         Rich_face;
typedef CGAL::Triangulation_data_structure_2<Rich_vertex, Rich_face>                       Rich_tds;

typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits>                     Plain;
typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits, Rich_tds>           Rich;
typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits>                                          Mesh;

// with constructions for constraints that cross
typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits, CGAL::Default,
                                                               CGAL::Exact_predicates_tag> Crossing;

static_assert(models_vertex_base<Plain::Vertex, Traits>(), "");
static_assert(models_vertex_base<Rich::Vertex, Traits>(), "");
static_assert(models_vertex_base<Mesh::Vertex, Traits>() && models_face_base<Mesh::Face>(), "");
static_assert(models_face_base<Rich::Face>(), "");

static_assert(std::is_same<Plain::Metric_tensor_2, Tensor>::value, "");
static_assert(std::is_same<Rich::Geom_traits, Traits>::value, "");
static_assert(std::is_copy_constructible<Rich>::value && std::is_copy_assignable<Rich>::value, "");

// Members of the base class that would break what the triangulation promises cannot be called.
template <class T>
constexpr bool hides_what_breaks_it()
{
  typedef typename T::Face_handle Face;
  const auto inserts_in_face = [](auto& t, Face f) -> decltype((void)t.insert_in_face(Point(), f)) {};
  const auto inserts_outside = [](auto& t, Face f) -> decltype((void)t.insert_outside_convex_hull(Point(), f)) {};
  const auto removes = [](auto& t, Face f) -> decltype((void)t.remove_degree_3(f->vertex(0))) {};
  const auto frees = [](auto& t, Face f) -> decltype((void)t.remove_constraint(f, 0)) {};
  const auto reads = [](auto& t, Face) -> decltype((void)(std::declval<std::istream&>() >> t)) {};
  typedef typename T::Constrained_triangulation Base;
  static_assert(std::is_invocable<decltype(inserts_in_face), Base&, Face>::value, "");
  static_assert(std::is_invocable<decltype(inserts_outside), Base&, Face>::value, "");
  static_assert(std::is_invocable<decltype(removes), Base&, Face>::value, "");
  static_assert(std::is_invocable<decltype(frees), Base&, Face>::value, "");
  static_assert(std::is_invocable<decltype(reads), Base&, Face>::value, "");
  return !std::is_invocable<decltype(inserts_in_face), T&, Face>::value
      && !std::is_invocable<decltype(inserts_outside), T&, Face>::value
      && !std::is_invocable<decltype(removes), T&, Face>::value
      && !std::is_invocable<decltype(frees), T&, Face>::value && !std::is_invocable<decltype(reads), T&, Face>::value;
}

static_assert(hides_what_breaks_it<Plain>() && hides_what_breaks_it<Rich>(), "");
static_assert(hides_what_breaks_it<Mesh>(), "");

template <class T>
T filled()
{
  T t{Traits(Field::make())};
  CHECK(t.is_valid());
  std::vector<Point> points;
  for(int i = 0; i < 50; ++i)
    points.push_back(Point((i * 17) % 50 / 20., (i * 29) % 50 / 15.));
  t.insert(points.begin(), points.end());
  t.insert_constraint(points[3], points[30]);
  const std::vector<Point> loop = {Point(3.5, 0), Point(4, 0), Point(4, 4)};
  t.insert_constraint(loop.begin(), loop.end(), true);
  t.push_back(Point(3.9, 2));
  return t;
}

template <class T>
void test_triangulation()
{
  const T t = filled<T>();
  CHECK(t.is_valid(true) && t.dimension() == 2);
  const auto tensor = t.geom_traits().construct_metric_tensor_2_object();
  std::set<int> indices;
  for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
    CHECK(v->metric_tensor() == tensor(v->point()));
    indices.insert(v->index());
  }
  CHECK(indices.size() == t.number_of_vertices());
  T copy;
  copy = t;
  CHECK(copy.is_valid() && copy.number_of_vertices() == t.number_of_vertices());
}

void test_info()
{
  Rich t = filled<Rich>();
  int n = 0;
  for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v, ++n) {
    v->info() = "vertex " + std::to_string(n);
    v->set_index(n);
  }
  for(auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    f->info().push_back(f->vertex(0)->index());
    CHECK(!f->is_in_domain());
    f->set_in_domain(true);
    f->set_subdomain_index(f->vertex(1)->index());
  }
  const Rich copy(t);
  for(auto v = copy.finite_vertices_begin(); v != copy.finite_vertices_end(); ++v)
    CHECK(v->info() == "vertex " + std::to_string(v->index()));
  for(auto f = copy.finite_faces_begin(); f != copy.finite_faces_end(); ++f)
    CHECK(f->info() == std::vector<int>(1, f->vertex(0)->index()) && f->is_in_domain()
          && f->subdomain_index() == f->vertex(1)->index());
}

void test_crossing_constraints()
{
  Crossing t{Traits(Field::make())};
  t.insert_constraint(Point(0, 0), Point(4, 4));
  t.insert_constraint(Point(0, 4), Point(4, 0));
  CHECK(t.is_valid(true) && t.number_of_vertices() == 5);
  const auto v = t.insert(Point(2, 2));
  CHECK(t.number_of_vertices() == 5);
  CHECK(v->metric_tensor() == Field::make()(Point(2, 2)));
}

int main()
{
  test_triangulation<Plain>();
  test_triangulation<Rich>();
  test_info();
  test_crossing_constraints();
  return finish();
}

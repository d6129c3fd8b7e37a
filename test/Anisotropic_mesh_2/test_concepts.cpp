// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

// The kernel compiles and works with the poorest models of its concepts, and
// with bases that hold the user's data.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_face_base_2.h>
#include <CGAL/Anisotropic_mesh_vertex_base_2.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <set>
#include <string>
#include <type_traits>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef K::Point_2                                            Point;
typedef CGAL::Metric_tensor_2<K>                              Tensor;

// ---------------------------------------------------------------- concept MetricField_2

// can be copied and called, and nothing else
class Poorest_field
{
public:
  static Poorest_field make() { return Poorest_field(); }

  Poorest_field(const Poorest_field&) = default;
  Poorest_field& operator=(const Poorest_field&) = delete;

  Tensor operator()(const Point& p) const { return Tensor::from_sizes(1, 2 + p.x()*p.x(), p.y()); }

private:
  Poorest_field() {}
};

static_assert(!std::is_default_constructible<Poorest_field>::value, "");
static_assert(!std::is_copy_assignable<Poorest_field>::value, "");

typedef CGAL::Riemannian_metric_traits_2<K, Poorest_field>    Traits;

// ---------------------------------------------------------------- concept RiemannianMetricTraits_2

static_assert(std::is_same<Traits::Metric_tensor_2, Tensor>::value, "");
static_assert(std::is_same<Traits::Metric_field, Poorest_field>::value, "");
static_assert(std::is_same<Traits::Kernel, K>::value, "");
static_assert(std::is_same<Traits::FT, K::FT>::value, "");
static_assert(std::is_same<Traits::Point_2, Point>::value, "");
static_assert(std::is_default_constructible<Traits>::value, "");
static_assert(std::is_copy_constructible<Traits>::value, "");
static_assert(std::is_copy_assignable<Traits>::value, "although the field is not");
static_assert(Traits::has_exact_predicates, "");
static_assert(!CGAL::Riemannian_metric_traits_2<CGAL::Simple_cartesian<double>, int>::has_exact_predicates, "");

// the functors are types of the traits, and the traits hand them out
static_assert(std::is_same<decltype(Traits().construct_metric_tensor_2_object()),
                           Traits::Construct_metric_tensor_2>::value, "");
static_assert(std::is_same<decltype(Traits().side_of_metric_circle_2_object()),
                           Traits::Side_of_metric_circle_2>::value, "");
static_assert(std::is_same<decltype(Traits().compute_squared_directional_distance_2_object()),
                           Traits::Compute_squared_directional_distance_2>::value, "");
static_assert(std::is_same<decltype(Traits().compute_riemannian_length_2_object()),
                           Traits::Compute_riemannian_length_2>::value, "");

// ---------------------------------------------------------------- vertex and face bases

// AnisotropicMeshVertexBase_2 as far as the kernel needs it
template <class Gt, class Vb = CGAL::Triangulation_vertex_base_2<Gt> >
class Poorest_vertex_base
  : public Vb
{
public:
  template <class TDS2>
  struct Rebind_TDS
  {
    typedef Poorest_vertex_base<Gt, typename Vb::template Rebind_TDS<TDS2>::Other> Other;
  };

  using Vb::Vb;
  Poorest_vertex_base() {}

  const typename Gt::Metric_tensor_2& metric_tensor() const { return m_tensor; }
  void set_metric_tensor(const typename Gt::Metric_tensor_2& m) { m_tensor = m; }
  int index() const { return m_index; }
  void set_index(int i) { m_index = i; }

private:
  typename Gt::Metric_tensor_2 m_tensor;
  int m_index = 0;
};

typedef CGAL::Triangulation_vertex_base_with_info_2<std::string, Traits>                   Vertex_with_info;
typedef CGAL::Triangulation_face_base_with_info_2<std::vector<int>, Traits>                Info_of_face;
typedef CGAL::Constrained_triangulation_face_base_2<Traits, Info_of_face>                  Face_with_info;
typedef CGAL::Anisotropic_mesh_vertex_base_2<Traits, Vertex_with_info>                     Rich_vertex;
typedef CGAL::Anisotropic_mesh_face_base_2<Traits, Face_with_info>                         Rich_face;

template <class Vb, class Fb>
using Triangulation
  = CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<Vb, Fb> >;

typedef CGAL::Constrained_triangulation_face_base_2<Traits>                             Plain_face;
typedef Triangulation<Poorest_vertex_base<Traits>, Plain_face>                          Poorest;
typedef Triangulation<Poorest_vertex_base<Traits, Vertex_with_info>, Face_with_info>    Poor_with_info;
typedef Triangulation<Rich_vertex, Rich_face>                                           Rich;

// with constructions for constraints that cross
typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits, CGAL::Default,
                                                               CGAL::Exact_predicates_tag>                Crossing;

static_assert(std::is_same<Poorest::Metric_tensor_2, Tensor>::value, "");
static_assert(std::is_same<Rich::Geom_traits, Traits>::value, "");
static_assert(std::is_copy_constructible<Rich>::value && std::is_copy_assignable<Rich>::value, "");

template <class T>
T filled()
{
  T t{Traits(Poorest_field::make())};
  CHECK(t.is_valid());
  std::vector<Point> points;
  for(int i = 0; i < 50; ++i)
    points.push_back(Point((i * 17) % 50 / 7., (i * 29) % 50 / 11.));
  t.insert(points.begin(), points.end());
  t.insert_constraint(points[3], points[30]);
  const std::vector<Point> loop = {Point(-1, -1), Point(9, -1), Point(9, 9)};
  t.insert_constraint(loop.begin(), loop.end(), true);
  t.push_back(Point(8, 2));
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
  Crossing t{Traits(Poorest_field::make())};
  t.insert_constraint(Point(0, 0), Point(4, 4));
  t.insert_constraint(Point(0, 4), Point(4, 0));
  CHECK(t.is_valid(true) && t.number_of_vertices() == 5);
  const auto v = t.insert(Point(2, 2));
  CHECK(t.number_of_vertices() == 5);
  CHECK(v->metric_tensor() == Poorest_field::make()(Point(2, 2)));
}

int main()
{
  test_triangulation<Poorest>();
  test_triangulation<Poor_with_info>();
  test_triangulation<Rich>();
  test_info();
  test_crossing_constraints();
  return finish();
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices that go and move: random sequences of operations keep the strictest
// validity, and equality with CGAL's triangulation where the metric is flat.

#include "include/check.h"
#include "include/metrics.h"
#include "include/Random_numbers.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_reinserter.h>
#include <CGAL/anisotropic_Delaunay_consistency_2.h>

#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

typedef Epick::Point_2   Point;

// ---------------------------------------------------------------- random sequences

// Does the same to a triangulation of the package and to CGAL's, in which a
// vertex moves by removal and insertion.
template <class K>
class Twin_triangulations
{
  typedef Triangulation<K>                   T;
  typedef Reference_triangulation<K>         Reference;
  typedef typename K::Point_2                Point_2;
  typedef typename T::Vertex_handle          Vertex_handle;

public:
  Twin_triangulations(const Flat_metric& metric, bool on_grid, unsigned int seed)
    : m_metric(metric), m_on_grid(on_grid), m_random(seed), m_t(Traits<K>(metric.field<K>()))
  {}

  void step(int largest)
  {
    const int what = m_random.integer(20), n = int(m_t.number_of_vertices());
    if(n == 0 || (what < 8 && n < largest))
      insert(random_point());
    else if(what < 12)
      remove(random_vertex());
    else if(what < 18)
      move(random_vertex(), what < 15 ? random_point() : point_near(random_vertex()));
    else if(what == 18)
      insert_constraint(random_vertex(), random_vertex());
    else
      remove_incident_constraints(random_vertex());
    check();
  }

  long removals() const { return m_removals; }
  long moves() const { return m_moves; }
  long constraints() const { return m_constraints; }

private:
  Point_2 random_point()
  {
    const double x = m_random.real(0, 1), y = m_random.real(0, 1);
    return m_on_grid ? Point_2(std::floor(6*x), std::floor(6*y)) : Point_2(rounded(x), rounded(y));
  }

  Point_2 point_near(Vertex_handle v)
  {
    const double x = m_random.real(-1, 1), y = m_random.real(-1, 1);
    const double dx = m_on_grid ? std::round(x) : rounded(x / 30), dy = m_on_grid ? std::round(y) : rounded(y / 30);
    return Point_2(v->point().x() + dx, v->point().y() + dy);
  }

  // such that the maps of flat metrics are exact
  static double rounded(double x) { return std::ldexp(std::round(std::ldexp(x, 30)), -30); }

  Vertex_handle random_vertex()
  {
    auto v = m_t.finite_vertices_begin();
    for(int i = m_random.integer(int(m_t.number_of_vertices())); i > 0; --i)
      ++v;
    return v;
  }

  void insert(const Point_2& p)
  {
    m_t.insert(p);
    m_reference.insert(m_metric.operator()<K>(p));
  }

  void remove(Vertex_handle v)
  {
    if(m_t.are_there_incident_constraints(v))
      return;
    remove_from_reference(v->point());
    const auto before = m_t.number_of_vertices();
    CHECK(m_t.remove(v));
    CHECK(m_t.number_of_vertices() == before - 1);
    ++m_removals;
  }

  void move(Vertex_handle v, const Point_2& p)
  {
    if(m_t.are_there_incident_constraints(v))
      return;
    const Point_2 old = v->point();
    const int index = v->index(), bound = m_t.vertex_index_bound();
    const Vertex_handle w = m_t.move_if_no_collision(v, p);
    CHECK(w->point() == p && v->index() == index && m_t.vertex_index_bound() == bound);
    if(w != v) {
      CHECK(v->point() == old && p != old);
      return;
    }
    remove_from_reference(old);
    m_reference.insert(m_metric.operator()<K>(p));
    ++m_moves;
  }

  void insert_constraint(Vertex_handle v, Vertex_handle w)
  {
    const Point_2 p = v->point(), q = w->point();
    if(p == q)
      return;
    const bool is_refused = refuses_constraint(m_t, p, q);
    CHECK(is_refused == refuses_constraint(m_reference, m_metric.operator()<K>(p), m_metric.operator()<K>(q)));
    m_constraints += !is_refused;
  }

  void remove_incident_constraints(Vertex_handle v)
  {
    m_t.remove_incident_constraints(v);
    m_reference.remove_incident_constraints(m_reference.insert(m_metric.operator()<K>(v->point())));
  }

  void remove_from_reference(const Point_2& p)
  {
    m_reference.remove(m_reference.insert(m_metric.operator()<K>(p)));
  }

  void check() const
  {
    CHECK(m_t.is_valid(true, 2));
    CHECK(m_t.number_of_vertices() == m_reference.number_of_vertices());
    CHECK(m_t.dimension() == m_reference.dimension());
    if(m_t.dimension() < 2)
      return;
    const Picture<K> found = picture<K>(m_t, m_metric), expected = picture<K>(m_reference, euclidean);
    CHECK_MSG(found.violations == 0 && found.edges == expected.edges && found.ambiguous == expected.ambiguous,
              m_metric.name);
  }

  Flat_metric m_metric;
  bool m_on_grid;
  Random_numbers m_random;
  T m_t;
  Reference m_reference;
  long m_removals = 0, m_moves = 0, m_constraints = 0;
};

template <class K>
void test_against_reference(int steps)
{
  long removals = 0, moves = 0, constraints = 0;
  for(const Flat_metric& metric : {euclidean, stretched, oblique, isotropic, wild_and_stretched})
    for(bool on_grid : {false, true})
      for(int largest : {5, 12, 50}) {
        Twin_triangulations<K> twins(metric, on_grid, unsigned(largest));
        for(int i = 0; i < steps; ++i)
          twins.step(largest);
        removals += twins.removals();
        moves += twins.moves();
        constraints += twins.constraints();
      }
  std::cout << "flat metrics: " << removals << " removals, " << moves << " moves, " << constraints << " constraints"
            << std::endl;
  CHECK(removals > 2 * steps && moves > 2 * steps && constraints > steps / 4);
}

template <class K>
void test_varying_metrics(int steps, int largest)
{
  typedef Triangulation<K> T;
  long removals = 0, moves = 0;
  for(const auto& f : varying_fields) {
    T t{Traits<K>(field_of<K>(f.second))};
    Random_numbers random{unsigned(steps)};
    std::vector<typename T::Vertex_handle> vertices;
    const auto random_point = [&] {
      const double x = random.real(0, 1);
      return typename K::Point_2(x, random.real(0, 1));
    };
    for(int i = 0; i < steps; ++i) {
      const int what = random.integer(3), which = random.integer((std::max)(1, int(vertices.size())));
      if(vertices.empty() || (what == 0 && int(vertices.size()) < largest))
        vertices.push_back(t.insert(random_point()));
      else if(what == 1) {
        CHECK_MSG(t.remove(vertices[std::size_t(which)]) || !Traits<K>::has_exact_predicates, f.first);
        vertices.erase(vertices.begin() + which);
        ++removals;
      }
      else {
        const auto p = random_point();
        CHECK_MSG(t.move(vertices[std::size_t(which)], p)->point() == p || !Traits<K>::has_exact_predicates, f.first);
        ++moves;
      }
      CHECK_MSG(t.is_valid(true, 2), f.first);
      CHECK_MSG(t.number_of_vertices() == vertices.size() || !Traits<K>::has_exact_predicates, f.first);
    }
  }
  CHECK(removals > steps / 2 && moves > steps / 2);
}

// The hub of a wheel has a high degree; half of its spokes are flipped away one after the other.
void test_high_degree()
{
  Triangulation<Epick> t{Traits<Epick>(stretched.field<Epick>())};
  Reference_triangulation<Epick> reference;
  const int n = 3000;
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    const Point p(std::cos(angle) / 2, std::sin(angle));
    t.insert(p);
    reference.insert(stretched.operator()<Epick>(p));
  }
  const auto hub = t.insert(Point(0.0001, 0.0002));
  CHECK(t.degree(hub) > n / 2);
  CHECK(t.remove(hub) && t.is_valid(true, 2));
  CHECK(picture<Epick>(t, stretched).edges == picture<Epick>(reference, euclidean).edges);
}

// ---------------------------------------------------------------- single cases

template <class K>
Triangulation<K> triangulation_of(const std::vector<XY>& points)
{
  Triangulation<K> t{Traits<K>(field_of<K>(rotating))};
  for(const XY& p : points)
    t.insert(point<K>(p));
  return t;
}

template <class T>
typename T::Vertex_handle vertex_at(T& t, double x, double y)
{
  const auto n = t.number_of_vertices();
  const auto v = t.insert(typename T::Point(x, y));
  CHECK(t.number_of_vertices() == n);
  return v;
}

template <class T>
typename T::Edge edge_between(const T& t, typename T::Vertex_handle u, typename T::Vertex_handle v)
{
  typename T::Face_handle f;
  int i = 0;
  CHECK(t.is_edge(u, v, f, i));
  return typename T::Edge(f, i);
}

// the dimension falls, down to nothing, and a constraint on the line stays
template <class K>
void test_falling_dimension()
{
  Triangulation<K> t = triangulation_of<K>({{0, 0}, {2, 1}, {4, 2}, {1, 5}});
  t.insert_constraint(vertex_at(t, 0, 0), vertex_at(t, 2, 1));
  CHECK(t.remove(vertex_at(t, 1, 5)) && t.dimension() == 1 && t.is_valid(true, 1));
  auto e = t.finite_edges_begin();
  int constrained = 0;
  for(; e != t.finite_edges_end(); ++e)
    constrained += t.is_constrained(*e);
  CHECK(constrained == 1);
  t.insert(point<K>(XY{1, 5}));
  CHECK(t.is_valid(true, 1) && t.is_constrained(edge_between(t, vertex_at(t, 0, 0), vertex_at(t, 2, 1))));
  t.remove_incident_constraints(vertex_at(t, 0, 0));
  for(const XY& p : {XY(2, 1), XY(1, 5), XY(0, 0), XY(4, 2)}) {
    CHECK(t.remove(vertex_at(t, p.first, p.second)) && t.is_valid(true, 1));
  }
  CHECK(t.number_of_vertices() == 0 && t.dimension() == -1);
  t.insert(point<K>(XY{1, 1}));
  CHECK(t.is_valid(true, 1) && t.number_of_vertices() == 1);
}

// corners, points of the hull's edges, points beyond which the hull is flat or reflex
template <class K>
void test_hull()
{
  for(int which = 0; which < 9; ++which) {
    Triangulation<K> t = triangulation_of<K>({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {2, 2}});
    auto v = t.finite_vertices_begin();
    std::advance(v, which);
    CHECK(t.remove(v) && t.is_valid(true, 1) && t.number_of_vertices() == 8);
  }
  Triangulation<K> t = triangulation_of<K>({{0, 0}, {8, 0}, {4, 1}, {3, 2}, {5, 2}, {4, 9}});
  CHECK(t.remove(vertex_at(t, 4, 9)) && t.is_valid(true, 1) && t.number_of_vertices() == 5);
  CHECK(t.remove(vertex_at(t, 4, 1)) && t.is_valid(true, 1) && t.number_of_vertices() == 4);
}

void test_moves_of_constrained_vertices()
{
  Triangulation<Epick> t = triangulation_of<Epick>({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 4}, {6, 4}, {4, 2}, {4, 6}});
  const auto v = t.insert(Point(4, 4));
  t.insert_constraint(vertex_at(t, 2, 4), v);
  t.insert_constraint(v, vertex_at(t, 6, 4));
  CHECK(t.move_if_no_collision(v, Point(4.25, 4.5)) == v); // takes the constraints along
  CHECK(t.is_valid(true, 1) && v->point() == Point(4.25, 4.5));
  CHECK(t.is_constrained(edge_between(t, v, vertex_at(t, 2, 4))) && t.is_constrained(edge_between(t, v, vertex_at(t, 6, 4))));
  const auto edges = all_edges(t);
  CHECK_THROWS(t.move_if_no_collision(v, Point(4, 7)), CGAL::Precondition_exception, "is_fixed");
  CHECK_THROWS(t.remove(v), CGAL::Precondition_exception, "is_fixed");
  CHECK_THROWS(t.remove(t.infinite_vertex()), CGAL::Precondition_exception, "is_infinite");
  CHECK(all_edges(t) == edges);

  const auto w = vertex_at(t, 4, 2); // across a constraint, and onto one
  CHECK(t.move_if_no_collision(w, Point(4, 5)) == w && t.is_valid(true, 1));
  t.insert_constraint(vertex_at(t, 0, 0), vertex_at(t, 0, 8));
  CHECK(t.move_if_no_collision(w, Point(0, 3)) == w && t.is_valid(true, 1) && w->point() == Point(0, 3));
  CHECK(t.is_constrained(edge_between(t, w, vertex_at(t, 0, 0))) && t.is_constrained(edge_between(t, w, vertex_at(t, 0, 8))));

  const auto e = edge_between(t, v, vertex_at(t, 6, 4));
  t.remove_constrained_edge(e.first, e.second);
  CHECK(t.is_valid(true, 1) && t.are_there_incident_constraints(v));
  t.remove_incident_constraints(v);
  CHECK(t.is_valid(true, 1) && !t.are_there_incident_constraints(v));
}

void test_collisions()
{
  Triangulation<Epick> t = triangulation_of<Epick>({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 4}, {6, 4}});
  const auto v = vertex_at(t, 2, 4), w = vertex_at(t, 6, 4);
  const auto edges = all_edges(t);
  CHECK(t.move_if_no_collision(v, Point(6, 4)) == w && v->point() == Point(2, 4) && all_edges(t) == edges);
  CHECK(t.move_if_no_collision(v, Point(2, 4)) == v && all_edges(t) == edges);
  CHECK(t.move(v, Point(6, 4)) == w && t.number_of_vertices() == 5 && t.is_valid(true, 1));
  CHECK(t.move(w, Point(20, -3)) == w && t.number_of_vertices() == 5 && t.is_valid(true, 1));

  Triangulation<Epick> lonely = triangulation_of<Epick>({{1, 1}}); // and in low dimension
  const auto u = vertex_at(lonely, 1, 1);
  CHECK(lonely.move(u, Point(3, 2)) == u && lonely.is_valid(true, 1) && lonely.number_of_vertices() == 1);
  lonely.insert(Point(5, 2));
  CHECK(lonely.move(u, Point(9, 2)) == u && lonely.is_valid(true, 1) && lonely.dimension() == 1);
  lonely.insert(Point(7, 2));
  CHECK(lonely.move(u, Point(6, 3)) == u && lonely.is_valid(true, 1) && lonely.dimension() == 2);
  CHECK(lonely.move(u, Point(1, 2)) == u && lonely.is_valid(true, 1) && lonely.dimension() == 1);
}

// A field that refuses the new place leaves everything as it was.
void test_refused_moves()
{
  const Field<Epick> field = [](const Point& p) { return Tensor::from_entries(1, 0, 30 - p.x()); };
  Triangulation<Epick> t{Traits<Epick>(field)};
  for(int i = 0; i < 9; ++i)
    t.insert(Point(10 * (i % 3), 10 * (i / 3)));
  const auto edges = all_edges(t);
  const auto v = vertex_at(t, 10, 10);
  CHECK_THROWS(t.move_if_no_collision(v, Point(35, 3)), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "(35, 3)");
  CHECK(all_edges(t) == edges && t.is_valid(true, 2) && v->point() == Point(10, 10));
}

// ---------------------------------------------------------------- what users store stays

typedef CGAL::Triangulation_vertex_base_with_info_2<std::string, Traits<Epick> >          Vertex_with_info;
typedef CGAL::Anisotropic_mesh_vertex_base_2<Traits<Epick>, Vertex_with_info>             Vertex_base;
typedef CGAL::Anisotropic_mesh_face_base_2<Traits<Epick> >                                Face_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>                      Tds_with_info;

void test_info()
{
  typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits<Epick>, Tds_with_info> T;
  T t{Traits<Epick>(field_of<Epick>(layer))};
  Random_numbers random(5);
  std::vector<T::Vertex_handle> vertices;
  for(int i = 0; i < 200; ++i) {
    const double x = random.real(0, 1);
    vertices.push_back(t.insert(Point(x, random.real(0, 1))));
    vertices.back()->info() = std::to_string(i);
  }
  for(int i = 0; i < 1000; ++i) {
    const double x = random.real(0, 1);
    const auto v = vertices[std::size_t(random.integer(int(vertices.size())))];
    CHECK(t.move_if_no_collision(v, Point(x, random.real(0, 1))) == v);
  }
  for(int i = 0; i < 100; ++i) {
    CHECK(t.remove(vertices.back()));
    vertices.pop_back();
  }
  CHECK(t.is_valid(true, 2) && t.number_of_vertices() == vertices.size() && t.vertex_index_bound() == 200);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    CHECK(vertices[i]->info() == std::to_string(i) && vertices[i]->index() == int(i));
}

typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits<Epick> > Mesh;

// a square in two halves of different references, with edges of references of their own
Mesh two_halves()
{
  Mesh mesh{Traits<Epick>(field_of<Epick>(rotating))};
  Mesh::Boundary_graph boundary;
  boundary.points = {Point(0, 0), Point(4, 0), Point(8, 0), Point(8, 8), Point(4, 8), Point(0, 8)};
  for(std::size_t i = 0; i < 6; ++i)
    boundary.segments.push_back({i, (i + 1) % 6, 10 + int(i), true});
  boundary.segments.push_back({1, 4, 7, false});
  boundary.regions.push_back({Point(1, 1), 3});
  boundary.regions.push_back({Point(7, 1), 5});
  mesh.insert_boundary(boundary);
  return mesh;
}

// where a constraint has divided the right half, its parts need not have references
bool has_its_halves(const Mesh& mesh, bool right_is_divided = false)
{
  for(auto f = mesh.all_faces_begin(); f != mesh.all_faces_end(); ++f) {
    if(mesh.is_infinite(f)) {
      if(f->is_in_domain())
        return false;
      continue;
    }
    const Point c = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    const bool is_inside = c.x() > 0 && c.x() < 8 && c.y() > 0 && c.y() < 8;
    if(f->is_in_domain() != is_inside)
      return false;
    const bool may_be_without = right_is_divided && c.x() > 4 && f->subdomain_index() == 0;
    if(is_inside && f->subdomain_index() != (c.x() < 4 ? 3 : 5) && !may_be_without)
      return false;
  }
  return true;
}

std::multiset<int> references(const Mesh& mesh)
{
  std::multiset<int> result;
  for(auto e = mesh.finite_edges_begin(); e != mesh.finite_edges_end(); ++e)
    if(mesh.is_constrained(*e))
      result.insert(mesh.edge_reference(*e));
  return result;
}

double area_of_domain(const Mesh& mesh)
{
  double sum = 0;
  for(Mesh::Face_handle f : mesh.faces_in_domain())
    sum += CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  return sum;
}

void test_marks_of_meshes()
{
  Mesh mesh = two_halves();
  CHECK(has_its_halves(mesh) && references(mesh) == (std::multiset<int>{7, 10, 11, 12, 13, 14, 15}));
  mesh.insert(Point(4, 3)); // on the inner curve
  mesh.insert(Point(8, 5)); // on the boundary
  CHECK(has_its_halves(mesh) && mesh.is_valid(true, 1));
  CHECK(references(mesh) == (std::multiset<int>{7, 7, 10, 11, 12, 12, 13, 14, 15}));
  mesh.insert(Point(11, 4)); // outside
  mesh.insert(Point(-2, 13));
  CHECK(has_its_halves(mesh) && mesh.is_valid(true, 1));
  Random_numbers random(8);
  std::vector<Mesh::Vertex_handle> vertices;
  for(int i = 0; i < 400; ++i) {
    const Point p(random.real(0.1, 7.9), random.real(0.1, 7.9));
    const int what = random.integer(3), which = random.integer((std::max)(1, int(vertices.size())));
    if(what == 0 || vertices.size() < 10)
      vertices.push_back(mesh.insert(p));
    else if(what == 1) {
      CHECK(mesh.remove(vertices[std::size_t(which)]));
      vertices.erase(vertices.begin() + which);
    }
    else
      CHECK(mesh.move_if_no_collision(vertices[std::size_t(which)], p) == vertices[std::size_t(which)]);
    CHECK(has_its_halves(mesh) && mesh.is_valid(true, 1));
  }
  CHECK(references(mesh) == (std::multiset<int>{7, 7, 10, 11, 12, 12, 13, 14, 15}));
  const Mesh empty = mesh.empty_mesh();
  CHECK(has_its_halves(empty) && references(empty) == references(mesh));
}

// the edge between two vertices, which must be there
Mesh::Edge edge_between(const Mesh& mesh, Mesh::Vertex_handle u, Mesh::Vertex_handle v)
{
  Mesh::Edge e;
  CHECK(mesh.is_edge(u, v, e.first, e.second));
  return e;
}

void test_clear()
{
  Mesh mesh = two_halves();
  mesh.clear();
  CHECK(mesh.number_of_vertices() == 0 && mesh.number_of_faces_in_domain() == 0);
  Mesh::Boundary_graph triangle;
  triangle.points = {Point(0, 0), Point(4, 0), Point(0, 4)};
  for(std::size_t i = 0; i < 3; ++i)
    triangle.segments.push_back({i, (i + 1) % 3, 2, true});
  mesh.insert_boundary(triangle);
  CHECK(mesh.number_of_faces_in_domain() == 1 && references(mesh) == (std::multiset<int>{2, 2, 2}));
  mesh.mark_domain();
  for(Mesh::Face_handle f : mesh.finite_face_handles()) // the regions of before are forgotten, too
    CHECK(f->is_in_domain() && f->subdomain_index() == 0);
  mesh = two_halves();
  mesh.clear();
  mesh.insert_boundary(triangle);
  CHECK(mesh.number_of_faces_in_domain() == 1);
}

// A second boundary leaves the subdomains of the first one as they are.
void test_subdomains_of_two_boundaries()
{
  Mesh mesh = two_halves();
  Mesh::Boundary_graph hole;
  hole.points = {Point(5, 5), Point(7, 5), Point(6, 7)};
  for(std::size_t i = 0; i < 3; ++i)
    hole.segments.push_back({i, (i + 1) % 3, 20, true});
  mesh.insert_boundary(hole);
  for(Mesh::Face_handle f : mesh.faces_in_domain()) {
    const Point c = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    CHECK(f->subdomain_index() == (c.x() < 4 ? 3 : 5));
  }
  CHECK(mesh.locate(Point(6, 6))->is_in_domain() == false);
}

// Constraints on a line are edges of the mesh, too, and stay in the empty mesh.
void test_constraints_on_a_line()
{
  Mesh mesh{Traits<Epick>(field_of<Epick>(rotating))};
  mesh.insert_constraint(mesh.insert(Point(0, 0)), mesh.insert(Point(2, 0)));
  mesh.insert(Point(5, 0));
  CHECK(mesh.dimension() == 1 && mesh.constrained_edges().size() == 1);
  CHECK(mesh.empty_mesh().number_of_vertices() == 2);
}

// A free edge has no reference, and gets none from before when it is constrained again.
void test_references_of_freed_edges()
{
  Mesh mesh = two_halves();
  const auto u = mesh.insert(Point(4, 0)), v = mesh.insert(Point(4, 8));
  CHECK(mesh.edge_reference(edge_between(mesh, u, v)) == 7);
  const Mesh::Edge e = edge_between(mesh, u, v);
  mesh.remove_constrained_edge(e.first, e.second);
  CHECK(references(mesh) == (std::multiset<int>{10, 11, 12, 13, 14, 15}) && mesh.is_valid(true));
  for(const Mesh::Edge& free : mesh.edges_in_domain())
    CHECK(mesh.is_constrained(free) || mesh.edge_reference(free) == 0);
  mesh.insert_constraint(u, v);
  CHECK(references(mesh) == (std::multiset<int>{0, 10, 11, 12, 13, 14, 15}) && mesh.is_valid(true));
  CHECK(mesh.number_of_faces_in_domain() == 4);
  mesh.mark_domain();
  CHECK(has_its_halves(mesh));
  mesh.remove_incident_constraints(u);
  CHECK(references(mesh) == (std::multiset<int>{12, 13, 14, 15}) && mesh.is_valid(true));
}

// References and domain under what replaces faces: new constraints, whose holes have constrained edges around and
// within them, insertions in low dimension, and vertices that move onto an edge with a reference.
void test_references_under_changes()
{
  Mesh mesh = two_halves();
  mesh.insert(Point(4, 5));
  Random_numbers random(9);
  for(int i = 0; i < 100; ++i)
    mesh.insert(Point(random.real(0.1, 7.9), random.real(0.1, 7.9)));
  const std::multiset<int> old = references(mesh);
  mesh.insert_constraint(mesh.insert(Point(4, 5)), mesh.insert(Point(8, 4)));
  mesh.insert_constraint(mesh.insert(Point(7, 7)), mesh.insert(Point(6, 6))); // ends within the next hole
  mesh.insert_constraint(mesh.insert(Point(4, 0)), mesh.insert(Point(7.9, 3.9)));
  mesh.insert_constraint(mesh.insert(Point(4.5, 5.5)), mesh.insert(Point(7.8, 5.9)));
  std::multiset<int> all = references(mesh);
  all.erase(0);
  CHECK(has_its_halves(mesh) && mesh.is_valid(true, 1) && all.count(7) == old.count(7));
  all.erase(12); // which (8, 4) has divided
  CHECK(all.size() == old.size() - 1);
  mesh.mark_domain();
  CHECK(has_its_halves(mesh, true));
  mesh.move_if_no_collision(mesh.insert(Point(0.01, 0.02)), Point(4, 2));
  CHECK(has_its_halves(mesh, true) && mesh.is_valid(true, 1) && references(mesh).count(7) == old.count(7) + 1);

  Mesh flat{mesh.geom_traits()};
  Mesh::Boundary_graph line;
  line.points = {Point(0, 0), Point(4, 0), Point(8, 0)};
  line.segments = {{0, 1, 5, false}, {1, 2, 6, false}};
  flat.insert_boundary(line);
  CHECK(flat.dimension() == 1 && references(flat) == (std::multiset<int>{5, 6}));
  flat.insert(Point(2, 0));
  flat.insert(Point(9, 0));
  CHECK(flat.dimension() == 1 && references(flat) == (std::multiset<int>{5, 5, 6}));
  const auto apex = flat.insert(Point(3, 3));
  CHECK(flat.is_valid(true, 1) && flat.dimension() == 2 && references(flat) == (std::multiset<int>{5, 5, 6}));
  CHECK(flat.remove(apex) && flat.dimension() == 1 && references(flat) == (std::multiset<int>{5, 5, 6}));
  flat.insert(Point(3, -3));
  CHECK(flat.is_valid(true, 1) && references(flat) == (std::multiset<int>{5, 5, 6}));

  Mesh copy(mesh), other;
  other = copy;
  CHECK(references(copy) == references(mesh) && references(other) == references(mesh));
  other.clear();
  other.swap(copy);
  CHECK(references(other) == references(mesh) && has_its_halves(other, true) && references(copy).empty());
  other.mark_domain();
  CHECK(has_its_halves(other, true));
}

// Two boundaries, the second inserted into the mesh of the first: a hole in it, and the same again, which fills it.
void test_second_boundary()
{
  Mesh mesh = two_halves();
  Mesh::Boundary_graph hole;
  hole.points = {Point(1, 1), Point(3, 1), Point(3, 3), Point(1, 3)};
  for(std::size_t i = 0; i < 4; ++i)
    hole.segments.push_back({i, (i + 1) % 4, 2, true});
  mesh.insert_boundary(hole);
  CHECK(area_of_domain(mesh) == 60 && references(mesh).count(2) == 4);
  for(auto& s : hole.segments)
    s.reference = 9; // edges keep the one that they have
  mesh.insert_boundary(hole);
  CHECK(area_of_domain(mesh) == 64 && references(mesh).count(2) == 4 && references(mesh).count(9) == 0);
}

// A hole near the boundary of a square, of which an edge is freed, so that flips mix faces of both its sides, also
// those at other boundary edges: the hole is gone, and comes back with its edge.
void test_freed_edges_of_holes(const Field<Epick>& field)
{
  Mesh::Boundary_graph square, hole;
  square.points = {Point(0, 0), Point(8, 0), Point(8, 8), Point(0, 8)};
  hole.points = {Point(4, 0.5), Point(7.5, 4), Point(4, 7.5), Point(0.5, 4)};
  for(std::size_t i = 0; i < 4; ++i) {
    square.segments.push_back({i, (i + 1) % 4, 1, true});
    hole.segments.push_back({i, (i + 1) % 4, 2, true});
  }
  for(std::size_t i = 0; i < 4; ++i) {
    Mesh mesh{Traits<Epick>(field)};
    mesh.insert_boundary(square);
    mesh.insert_boundary(hole);
    CHECK(area_of_domain(mesh) == 64 - 24.5);
    const Mesh::Edge e = edge_between(mesh, mesh.insert(hole.points[i]), mesh.insert(hole.points[(i + 1) % 4]));
    mesh.remove_constrained_edge(e.first, e.second);
    Random_numbers random(unsigned(i) + 1);
    const auto v = mesh.insert(Point(4, 4));
    for(int k = 0; k < 20; ++k)
      mesh.move_if_no_collision(v, Point(random.real(0.1, 7.9), random.real(0.1, 7.9)));
    mesh.remove(v);
    mesh.mark_domain();
    CHECK(area_of_domain(mesh) == 64);
    hole.segments = {{i, (i + 1) % 4, 3, true}};
    mesh.insert_boundary(hole);
    CHECK(area_of_domain(mesh) == 64 - 24.5);
    CHECK(references(mesh) == (std::multiset<int>{1, 1, 1, 1, 2, 2, 2, 3}) && mesh.is_valid(true, 1));
    hole.segments = {{0, 1, 2, true}, {1, 2, 2, true}, {2, 3, 2, true}, {3, 0, 2, true}};
  }
}

// Where coordinates are finer than a double, vertices whose move is taken back stand where they have stood: after a
// move into inverted faces, after one at whose end the field fails, and after one there and back.
template <class K>
void test_moves_taken_back()
{
  typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits<K> > Fine_mesh;
  typedef typename K::Point_2                           Fine_point;
  bool fails = false;
  Fine_mesh mesh{Traits<K>([&](const Fine_point&) { return CGAL::Metric_tensor_2<K>::from_size(fails ? -1 : 1); })};
  typename Fine_mesh::Boundary_graph boundary;
  boundary.points = {Fine_point(0, 0), Fine_point(3, 0), Fine_point(3, 3), Fine_point(0, 3)};
  for(std::size_t i = 0; i < 4; ++i)
    boundary.segments.push_back({i, (i + 1) % 4, 1, true});
  mesh.insert_boundary(boundary);
  const typename K::FT third = typename K::FT(1) / 3, seventh = typename K::FT(1) / 7;
  const std::vector<Fine_point> old = {Fine_point(1 + third, 1 + seventh), Fine_point(2 - seventh, 1 + third),
                                       Fine_point(2 - third, 2 - seventh)};
  std::vector<typename Fine_mesh::Vertex_handle> vertices;
  for(const Fine_point& p : old)
    vertices.push_back(mesh.insert(p));
  const auto stand_as_before = [&] {
    for(std::size_t i = 0; i < old.size(); ++i)
      CHECK(vertices[i]->point() == old[i]);
    CHECK(mesh.is_valid(true));
  };
  CGAL::Anisotropic_mesh_2::internal::Field_metric<Fine_mesh> metric(mesh);
  CGAL::Anisotropic_mesh_2::internal::Vertex_mover<Fine_mesh> mover(mesh, metric);
  const std::vector<double> start = mover.free_vertices().positions();
  std::vector<double> target = start;
  for(double& x : target)
    x += 0.0625;
  fails = true;
  CHECK_THROWS(mover.move_to(target), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "size -1");
  stand_as_before();
  fails = false;
  mover.move_to({1e9, 1e9, 1e9, 1e9, 1e9, 1e9});
  stand_as_before();
  mover.move_to(target);
  CHECK(vertices[0]->point() == Fine_point(target[0], target[1]));
  mover.move_to(start);
  stand_as_before();
  CGAL::Anisotropic_mesh_2::internal::Vertex_reinserter<Fine_mesh> reinserter(mesh, metric);
  reinserter.move_to(target);
  reinserter.move_to(start);
  std::set<Fine_point> now;
  for(const auto v : mesh.finite_vertex_handles())
    now.insert(v->point());
  CHECK(std::count_if(old.begin(), old.end(), [&](const Fine_point& p) { return now.count(p) > 0; }) == 3);
}

// By how much a tensor exceeds another one at most.
double greatest_ratio(const Tensor& m, const Tensor& n)
{
  const double trace = (m.m11()*n.m22() + m.m22()*n.m11() - 2*m.m12()*n.m12()) / n.determinant();
  const double det = m.determinant() / n.determinant();
  return (trace + std::sqrt((std::max)(0., trace*trace - 4*det))) / 2;
}

// The flips that restore the connectivity of a mesh leave no edge, between vertices of very different tensors, whose
// flip would raise the lower quality of its two faces.
void test_rough_edges(const Plain_field& field)
{
  Mesh mesh{Traits<Epick>(field_of<Epick>(field))};
  Mesh::Boundary_graph square;
  square.points = {Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)};
  for(std::size_t i = 0; i < 4; ++i)
    square.segments.push_back({i, (i + 1) % 4, 1, true});
  mesh.insert_boundary(square);
  Random_numbers random(6);
  for(int i = 0; i < 300; ++i) {
    const double x = random.real(0.01, 0.99);
    mesh.insert(Point(x, random.real(0.01, 0.99)));
  }
  CGAL::Anisotropic_mesh_2::internal::restore_connectivity(mesh);
  CHECK(mesh.is_valid(true, 1));
  const auto quality = [&](const Point& a, const Point& b, const Point& c) {
    const Point g = CGAL::centroid(a, b, c);
    const Tensor m = field(g.x(), g.y());
    const double squares = m.squared_length(b - a) + m.squared_length(c - b) + m.squared_length(a - c);
    return 4 * std::sqrt(3 * m.determinant()) * CGAL::area(a, b, c) / squares;
  };
  int rough = 0;
  for(const Mesh::Edge& e : mesh.edges_in_domain()) {
    if(!mesh.is_flippable(e.first, e.second))
      continue;
    const Mesh::Edge mirror = mesh.mirror_edge(e);
    const auto v = e.first->vertex(e.second), w = mirror.first->vertex(mirror.second);
    if((std::max)(greatest_ratio(v->metric_tensor(), w->metric_tensor()),
                  greatest_ratio(w->metric_tensor(), v->metric_tensor())) < 100)
      continue;
    ++rough;
    const Point &p = v->point(), &q = w->point(), &r = e.first->vertex(Mesh::ccw(e.second))->point(),
                &s = e.first->vertex(Mesh::cw(e.second))->point();
    CHECK((std::min)(quality(p, r, q), quality(q, s, p)) < (std::min)(quality(p, r, s), quality(q, s, r)) + 1e-6);
  }
  CHECK_MSG(rough > 50, std::to_string(rough));
}

// Always asks for a flip, as rounding errors might, but not endlessly.
struct Flipping_traits
  : public Traits<Double_kernel>
{
  struct Side_of_metric_circle_2
  {
    int* calls;

    template <class... Arguments>
    CGAL::Oriented_side operator()(const Arguments&...) const
    {
      if(++*calls > 100000)
        throw std::runtime_error("flips without end");
      return CGAL::ON_POSITIVE_SIDE;
    }
  };

  explicit Flipping_traits(int* calls)
    : Traits<Double_kernel>([](const Double_kernel::Point_2&) {
        return CGAL::Metric_tensor_2<Double_kernel>::from_size(1);
      }), m_calls(calls)
  {}

  Side_of_metric_circle_2 side_of_metric_circle_2_object() const { return {m_calls}; }

private:
  int* m_calls;
};

// Even in a constant metric flips have a bound where the criterion is not decided exactly.
void test_endless_flips()
{
  typedef Double_kernel::Point_2 P;
  int calls = 0;
  CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Flipping_traits> t{Flipping_traits(&calls)};
  Random_numbers random(5);
  for(int i = 0; i < 30; ++i) {
    const double x = random.real(0, 1);
    t.insert(P(x, random.real(0, 1)));
  }
  calls = 0;
  const auto flips = t.restore_local_criterion({t.finite_edges_begin(), t.finite_edges_end()});
  CHECK_MSG(flips > 1000 && t.is_valid(true), std::to_string(flips));
}

// The vertices of an empty mesh are those of its edges, each edge from its source to its target, in the order in which
// the edges come, with every compiler.
void test_order_of_empty_meshes()
{
  Mesh mesh = two_halves();
  mesh.insert(Point(4, 3));
  const Mesh empty = mesh.empty_mesh();
  std::vector<int> expected, found;
  for(const Mesh::Edge& e : mesh.constrained_edges())
    for(int i : {Mesh::ccw(e.second), Mesh::cw(e.second)})
      if(std::find(expected.begin(), expected.end(), e.first->vertex(i)->index()) == expected.end())
        expected.push_back(e.first->vertex(i)->index());
  for(Mesh::Vertex_handle v : empty.finite_vertex_handles())
    found.push_back(v->index());
  CHECK(expected.size() == 7 && found == expected);
}

// A field of size 1, and an orientation that sees no triangle of some points, as if rounding errors hid it.
struct Blind_traits
  : public Traits<Double_kernel>
{
  typedef Double_kernel::Point_2 Point_2;

  struct Orientation_2
  {
    std::set<Point_2> hidden;

    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      return hidden.count(p) + hidden.count(q) + hidden.count(r) == 3 ? CGAL::COLLINEAR : CGAL::orientation(p, q, r);
    }
  };

  explicit Blind_traits(const std::set<Point_2>& hidden)
    : Traits<Double_kernel>([](const Point_2&) { return CGAL::Metric_tensor_2<Double_kernel>::from_size(1); }),
      m_hidden(hidden)
  {}

  Orientation_2 orientation_2_object() const { return {m_hidden}; }

private:
  std::set<Point_2> m_hidden;
};

// A vertex that is moved onto a constrained edge, but whose old place cannot be filled: it stays, and so does the edge.
void test_failing_move_onto_constraint()
{
  typedef Blind_traits::Point_2 P;
  const std::set<P> around = {P(0, 0), P(2, 0), P(2, 2), P(0, 2)};
  CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Blind_traits> t{Blind_traits(around)};
  const auto v = t.insert(P(1, 1));
  for(const P& p : around)
    t.insert(p);
  const auto source = t.insert(P(6, -2)), target = t.insert(P(6, 4));
  t.insert(P(10, 1));
  t.insert_constraint(source, target);
  CHECK(!t.remove(v));
  CHECK(t.move_if_no_collision(v, P(6, 1)) == v);
  CHECK(v->point() == P(1, 1) && t.is_valid(true, 1));
  double length = 0;
  for(const auto& e : t.constrained_edges())
    length += std::sqrt(t.segment(e).squared_length());
  CHECK(length == 6);
}

// ---------------------------------------------------------------- validity and consistency

Triangulation<Epick> random_triangulation(const Field<Epick>& field, int n)
{
  Triangulation<Epick> t{Traits<Epick>(field)};
  Random_numbers random(3);
  for(int i = 0; i < n; ++i) {
    const double x = random.real(0, 1);
    t.insert(Point(x, random.real(0, 1)));
  }
  return t;
}

// Each level says no to what the one below does not see.
void test_levels_of_validity()
{
  Triangulation<Epick> t = random_triangulation(sheared.field<Epick>(), 50);
  CHECK(t.is_valid(true, 2));
  const auto v = t.finite_vertices_begin();
  const Tensor m = v->metric_tensor();
  v->set_metric_tensor(Tensor::from_size(3));
  CHECK(t.is_valid(true, 0) && !t.is_valid(false, 1));
  v->set_metric_tensor(m);
  const int index = v->index();
  for(int wrong : {-1, t.vertex_index_bound(), std::next(v)->index()}) {
    v->set_index(wrong);
    CHECK(t.is_valid(true, 0) && !t.is_valid(false, 1));
  }
  v->set_index(index);
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    if(t.is_flippable(e->first, e->second)) {
      t.flip(e->first, e->second);
      break;
    }
  CHECK(t.is_valid(true, 1) && !t.is_valid(false, 2));
}

// the star of every vertex by brute force, for triangulations without constraints
bool is_consistent_by_brute_force(const Triangulation<Epick>& t, Triangulation<Epick>::Vertex_handle v)
{
  const auto side = t.geom_traits().side_of_metric_circle_2_object();
  const Tensor& m = v->metric_tensor();
  auto f = t.incident_faces(v), done = f;
  do {
    for(auto w = t.finite_vertices_begin(); w != t.finite_vertices_end(); ++w)
      if(!t.is_infinite(f) && !f->has_vertex(w)
         && side(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), w->point(), m, m, m, m)
            == CGAL::ON_POSITIVE_SIDE)
        return false;
  } while(++f != done);
  return true;
}

void test_consistency()
{
  for(const Flat_metric& metric : {euclidean, oblique, isotropic}) {
    const auto c = CGAL::anisotropic_Delaunay_consistency_2(random_triangulation(metric.field<Epick>(), 500));
    CHECK(c.stars == 500 && c.edges > 1300 && c.edge_share() == 1 && c.star_share() == 1);
  }
  for(const auto& f : varying_fields) {
    const Triangulation<Epick> t = random_triangulation(field_of<Epick>(f.second), 300);
    std::size_t consistent = 0;
    for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
      CHECK_MSG(CGAL::is_consistent_star(t, v) == is_consistent_by_brute_force(t, v), f.first);
      consistent += is_consistent_by_brute_force(t, v);
    }
    const auto c = CGAL::anisotropic_Delaunay_consistency_2(t);
    CHECK_MSG(c.stars == 300 && c.consistent_stars == consistent, f.first);
    std::cout << f.first << ": " << 100 * c.edge_share() << " % of the edges, " << 100 * c.star_share()
              << " % of the stars consistent" << std::endl;
  }
  Triangulation<Epick> t = random_triangulation(sheared.field<Epick>(), 100);
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    if(t.is_flippable(e->first, e->second)) {
      const auto f = e->first;
      t.flip(f, e->second);
      const auto c = CGAL::anisotropic_Delaunay_consistency_2(t);
      CHECK(c.edges - c.consistent_edges >= 1 && c.stars - c.consistent_stars >= 4);
      break;
    }
  const Triangulation<Epick> flat = triangulation_of<Epick>({{0, 0}, {1, 1}});
  CHECK(CGAL::anisotropic_Delaunay_consistency_2(flat).edge_share() == 1);
}

// what a constraint hides from a vertex does not count
void test_consistency_with_constraints()
{
  const Field<Epick> field = [](const Point&) { return Tensor(); };
  Triangulation<Epick> t{Traits<Epick>(field)};
  t.insert_constraint(Point(-9, 0), Point(9, 0));
  for(const Point& p : {Point(-9, 9), Point(9, 9), Point(0, 1), Point(-9, -9), Point(9, -9), Point(0, -1)})
    t.insert(p);
  const auto c = CGAL::anisotropic_Delaunay_consistency_2(t);
  CHECK(c.edge_share() == 1 && c.star_share() == 1);

  Mesh mesh = two_halves();
  const auto d = CGAL::anisotropic_Delaunay_consistency_2(mesh);
  mesh.insert(Point(40, 4));
  CHECK(CGAL::anisotropic_Delaunay_consistency_2(mesh).edges == d.edges && d.edges == 2 && d.stars == 6);
}

int main()
{
  test_against_reference<Epick>(1500);
  test_against_reference<Epeck>(25);
  test_against_reference<Rational_kernel>(25);
  test_varying_metrics<Epick>(1500, 60);
  test_varying_metrics<Epeck>(100, 15);
  test_varying_metrics<Double_kernel>(300, 60);
  test_high_degree();
  test_falling_dimension<Epick>();
  test_falling_dimension<Epeck>();
  test_hull<Epick>();
  test_hull<Rational_kernel>();
  test_moves_of_constrained_vertices();
  test_collisions();
  test_refused_moves();
  test_info();
  test_marks_of_meshes();
  test_clear();
  test_subdomains_of_two_boundaries();
  test_constraints_on_a_line();
  test_references_of_freed_edges();
  test_references_under_changes();
  test_second_boundary();
  test_moves_taken_back<Epeck>();
  test_moves_taken_back<Rational_kernel>();
  test_failing_move_onto_constraint();
  test_endless_flips();
  test_rough_edges(chaotic);
  test_rough_edges(rotating_fast);
  test_order_of_empty_meshes();
  test_freed_edges_of_holes(stretched.field<Epick>());
  test_freed_edges_of_holes(field_of<Epick>(rotating));
  test_levels_of_validity();
  test_consistency();
  test_consistency_with_constraints();
  return finish();
}

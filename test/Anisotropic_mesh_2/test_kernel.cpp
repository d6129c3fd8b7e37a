// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The generalized constrained Delaunay kernel: equal to CGAL's triangulations
// where the metric is constant or isotropic, valid with any metric.

#include "include/check.h"
#include "include/metrics.h"
#include "include/Random_numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// ---------------------------------------------------------------- points and constraints

typedef std::function<XY(Random_numbers&)> Point_generator;

Input make_input(const std::string& name, int n, const Point_generator& generator)
{
  Random_numbers random(7);
  Input input{name, {}, {}};
  for(int i = 0; i < n; ++i)
    input.points.push_back(generator(random));
  return input;
}

// rounded, so that all the linear maps above are exact
double rounded(double x) { return std::ldexp(std::round(std::ldexp(x, 30)), -30); }

Input grid(int n)
{
  Input input{"grid", {}, {}};
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      input.points.emplace_back(i, j);
  Random_numbers(3).shuffle(input.points);
  return input;
}

// the points with integer coordinates on a circle, and those that `stretched` maps there
Input cocircular()
{
  Input input{"cocircular", {{0, 0}, {1, 1}}, {}};
  const int radius = 1105;
  for(int x = -radius; x <= radius; ++x)
    for(int y = -radius; y <= radius; ++y)
      if(x*x + y*y == radius*radius) {
        input.points.emplace_back(x, y);
        input.points.emplace_back(x / 2., y);
      }
  Random_numbers(4).shuffle(input.points);
  return input;
}

std::vector<Input> all_inputs()
{
  std::vector<Input> inputs;
  inputs.push_back(make_input("random", 3000, [](Random_numbers& r)
  {
    const double x = r.real(0, 1);
    return XY(rounded(x), rounded(r.real(0, 1)));
  }));
  inputs.push_back(make_input("clustered", 2000, [](Random_numbers& r)
  {
    const double size = r.power_of_ten(-7, 0), angle = r.real(0, 2*pi);
    const int center = r.integer(4);
    return XY(rounded(center + size * std::cos(angle)), rounded(size * std::sin(angle)));
  }));
  inputs.push_back(make_input("nearly cocircular", 600, [](Random_numbers& r)
  {
    const double angle = r.real(0, 2*pi);
    return XY(rounded(std::cos(angle)), rounded(std::sin(angle)));
  }));
  inputs.push_back(make_input("nearly collinear", 600, [](Random_numbers& r)
  {
    const double x = r.real(0, 1);
    return XY(rounded(x), rounded(x / 3 + (r.integer(4) == 0 ? 1e-9 * r.integer(3) : 0)));
  }));
  inputs.push_back(make_input("on few columns", 800, [](Random_numbers& r)
  {
    const int column = r.integer(5);
    return XY(column, rounded(r.real(0, 1)));
  }));
  inputs.push_back(grid(30));
  inputs.push_back(cocircular());
  return inputs;
}

// segments that do not cross, but that may touch each other and pass through points
std::vector<Index_pair> random_segments(const std::vector<XY>& points, int n)
{
  typedef Reference_triangulation<Epick> CDT;
  Random_numbers random(11);
  CDT accepted;
  std::vector<Index_pair> segments;
  for(int i = 0; i < n; ++i) {
    const int a = random.integer(int(points.size())), b = random.integer(int(points.size()));
    if(points[std::size_t(a)] == points[std::size_t(b)])
      continue;
    CDT trial(accepted); // so that the ends of refused segments are not there for others to cross in
    if(refuses_constraint(trial, point<Epick>(points[std::size_t(a)]), point<Epick>(points[std::size_t(b)])))
      continue;
    accepted = trial;
    segments.emplace_back(a, b);
  }
  return segments;
}

template <class T, class Point>
void insert_segments(T& t, const std::vector<Point>& points, const std::vector<Index_pair>& segments)
{
  for(const Index_pair& s : segments)
    t.insert_constraint(points[std::size_t(s.first)], points[std::size_t(s.second)]);
}

// ---------------------------------------------------------------- oracles 1 and 2

enum Order { ONE_BY_ONE, RANGE, CONSTRAINTS_FIRST, BACKWARDS };

template <class K>
Triangulation<K> build(const Input& input, const Flat_metric& metric, Order order)
{
  Triangulation<K> t{Traits<K>(metric.field<K>())};
  std::vector<typename K::Point_2> points = points_of<K>(input.points);
  if(order == CONSTRAINTS_FIRST)
    insert_segments(t, points, input.segments);
  if(order == RANGE)
    t.insert(points.begin(), points.end());
  else if(order == BACKWARDS)
    for(auto p = points.rbegin(); p != points.rend(); ++p)
      t.insert(*p);
  else
    for(const auto& p : points)
      t.insert(p);
  insert_segments(t, points, input.segments);
  return t;
}

template <class K>
Picture<K> reference(const Input& input, const Flat_metric& metric)
{
  Reference_triangulation<K> t;
  std::vector<typename K::Point_2> points = points_of<K>(input.points);
  for(auto& p : points)
    p = metric.operator()<K>(p);
  t.insert(points.begin(), points.end());
  insert_segments(t, points, input.segments);
  return picture<K>(t, euclidean);
}

struct Totals { long triangulations = 0, vertices = 0, edges = 0, ambiguous = 0; };

template <class K>
void compare(const Input& input, const Flat_metric& metric, std::initializer_list<Order> orders, Totals& totals)
{
  const Picture<K> expected = reference<K>(input, metric);
  for(Order order : orders) {
    const std::string name = input.name + ", " + metric.name + ", order " + std::to_string(order);
    const Triangulation<K> t = build<K>(input, metric, order);
    const Picture<K> found = picture<K>(t, metric);
    CHECK_MSG(t.is_valid(true), name);
    CHECK_MSG(found.violations == 0, name);
    CHECK_MSG(found.edges == expected.edges, name);
    CHECK_MSG(found.ambiguous == expected.ambiguous, name);
    ++totals.triangulations;
    totals.vertices += long(t.number_of_vertices());
    totals.edges += long(found.edges.size());
    totals.ambiguous += found.ambiguous;
  }
}

void test_flat_metrics()
{
  Totals totals;
  for(Input input : all_inputs())
    for(int n : {0, 40, 400}) {
      input.segments = random_segments(input.points, n);
      for(const Flat_metric& metric : {stretched, sheared, oblique, isotropic, wild_and_stretched})
        compare<Epick>(input, metric, {ONE_BY_ONE, RANGE, CONSTRAINTS_FIRST, BACKWARDS}, totals);
    }
  std::cout << "flat metrics: " << totals.triangulations << " triangulations, " << totals.vertices << " vertices, "
            << totals.edges << " edges compared, " << totals.ambiguous << " ambiguous" << std::endl;
  CHECK(totals.ambiguous > 0);
}

template <class K>
void test_flat_metrics_small()
{
  Totals totals;
  for(Input input : all_inputs()) {
    input.points.resize((std::min<std::size_t>)(input.points.size(), 120));
    input.segments = random_segments(input.points, 15);
    compare<K>(input, sheared, {ONE_BY_ONE, RANGE, CONSTRAINTS_FIRST}, totals);
    compare<K>(input, isotropic, {ONE_BY_ONE, RANGE, CONSTRAINTS_FIRST}, totals);
  }
}

// coordinates with all their bits, for which multiplication by 2 is exact
void test_flat_metrics_full_precision()
{
  Input circle = make_input("circle, all bits", 1500, [](Random_numbers& r)
                            { const double a = r.real(0, 2*pi); return XY(std::cos(a), std::sin(a)); });
  Input ellipse = make_input("ellipse, all bits, far away", 1500, [](Random_numbers& r)
                             { const double a = r.real(0, 2*pi); return XY(1e3 + std::cos(a)/2, std::sin(a) - 1e4); });
  Totals totals;
  for(Input& input : std::vector<Input>{circle, ellipse})
    for(double scale : {1., 1e-30, 1e30}) {
      for(XY& p : input.points)
        p = XY(p.first * scale, p.second * scale);
      input.segments = random_segments(input.points, 20);
      for(const Flat_metric& metric : {stretched, isotropic, wild_and_stretched})
        compare<Epick>(input, metric, {ONE_BY_ONE, RANGE}, totals);
      for(XY& p : input.points)
        p = XY(p.first / scale, p.second / scale);
    }
}

// ---------------------------------------------------------------- varying metrics

// no edge opposite to v is in conflict with it
template <class T>
bool has_no_conflict(const T& t, typename T::Vertex_handle v)
{
  if(t.dimension() < 2)
    return true;
  auto f = t.incident_faces(v), done = f;
  do {
    const int i = f->index(v);
    const auto g = f->neighbor(i);
    if(!t.is_infinite(f) && !t.is_infinite(g) && !f->is_constrained(i)
       && t.is_in_conflict(g, v->point(), v->metric_tensor()))
      return false;
  } while(++f != done);
  return true;
}

template <class T>
bool has_its_tensors(const T& t)
{
  const auto tensor = t.geom_traits().construct_metric_tensor_2_object();
  for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
    if(v->metric_tensor() != tensor(v->point()))
      return false;
  return true;
}

// The boundary of a cavity is one closed chain that p sees from strictly inside,
// it holds all the vertices of the cavity's faces, and no face beyond it is in conflict.
template <class T>
bool is_good_cavity(const T& t, const typename T::Point& p, const typename T::Metric_tensor_2& m,
                    const typename T::Cavity& cavity)
{
  const auto& boundary = cavity.boundary;
  bool good = boundary.size() == cavity.faces.size() + 2;
  for(std::size_t i = 0; i < boundary.size(); ++i) {
    const auto &e = boundary[i], &next = boundary[(i + 1) % boundary.size()];
    const auto source = e.first->vertex(t.cw(e.second)), target = e.first->vertex(t.ccw(e.second));
    good = good && target == next.first->vertex(t.cw(next.second))
                && t.orientation(source->point(), target->point(), p) == CGAL::LEFT_TURN
                && std::find(cavity.faces.begin(), cavity.faces.end(), e.first) == cavity.faces.end()
                && (t.is_infinite(e.first) || e.first->is_constrained(e.second)
                    || !t.is_in_conflict(e.first, p, m));
  }
  for(std::size_t i = 2; i < cavity.faces.size(); ++i) // the first may be there for containing p
    good = good && t.is_in_conflict(cavity.faces[i], p, m);
  return good;
}

struct Cavity_counts { long cavities = 0, faces = 0, largest = 0; };

void report(const Cavity_counts& counts)
{
  std::cout << "varying metrics: " << counts.cavities << " cavities of " << counts.faces << " faces, the largest of "
            << counts.largest << std::endl;
}

template <class T>
void check_cavity(const T& t, const typename T::Point& p, Cavity_counts& counts)
{
  typename T::Locate_type lt;
  int li;
  const auto f = t.locate(p, lt, li);
  const bool on_inner_edge = lt == T::EDGE && t.dimension() == 2 && !f->is_constrained(li)
                             && !is_on_hull(t, typename T::Edge(f, li));
  if(t.dimension() < 2 || (lt != T::FACE && !on_inner_edge))
    return;
  const auto m = t.geom_traits().construct_metric_tensor_2_object()(p);
  typename T::Cavity cavity;
  t.find_cavity(p, m, lt, f, li, cavity);
  CHECK(is_good_cavity(t, p, m, cavity));
  ++counts.cavities;
  counts.faces += long(cavity.faces.size());
  counts.largest = (std::max)(counts.largest, long(cavity.faces.size()));
}

// The same triangulation, but with vertices that come by splitting a face or an
// edge and flipping what is in conflict.
template <class T>
struct Triangulation_by_flips : public T
{
  using T::T;

  void insert_by_flips(const typename T::Point& p)
  {
    const auto before = this->number_of_vertices();
    const auto v = T::Constrained_triangulation::insert(p);
    if(this->number_of_vertices() == before)
      return;
    v->set_metric_tensor(this->geom_traits().construct_metric_tensor_2_object()(p));
    bool flipped = this->dimension() == 2;
    while(flipped)
      flipped = flip_one(v);
  }

private:
  bool flip_one(typename T::Vertex_handle v)
  {
    auto f = this->incident_faces(v), done = f;
    do {
      const int i = f->index(v);
      const auto g = f->neighbor(i);
      if(!this->is_infinite(f) && !this->is_infinite(g) && !f->is_constrained(i)
         && this->is_in_conflict(g, v->point(), v->metric_tensor())) {
        CHECK(this->is_flippable(f, i));
        this->flip(f, i);
        return true;
      }
    } while(++f != done);
    return false;
  }
};

// Conflicts are decided by the tensors of the point and of the three vertices.
void test_conflicts()
{
  int in_conflict = 0, by_one_tensor_otherwise = 0;
  Random_numbers random(9);
  for(int i = 0; i < 500; ++i) {
    typedef Triangulation<Epick> T;
    const T::Geom_traits traits(field_of<Epick>(chaotic));
    const auto side = traits.side_of_metric_circle_2_object();
    const auto tensor = traits.construct_metric_tensor_2_object();
    T t(traits);
    std::vector<Epick::Point_2> p;
    for(int j = 0; j < 4; ++j)
      p.push_back(point<Epick>(XY{random.real(0, 1), random.real(0, 1)}));
    if(CGAL::orientation(p[0], p[1], p[2]) != CGAL::LEFT_TURN)
      continue;
    t.insert(p.begin(), p.begin() + 3);
    const auto m = tensor(p[3]);
    const bool expected
      = side(p[0], p[1], p[2], p[3], tensor(p[0]), tensor(p[1]), tensor(p[2]), m) == CGAL::ON_POSITIVE_SIDE;
    CHECK(t.is_in_conflict(t.finite_faces_begin(), p[3], m) == expected);
    in_conflict += expected;
    by_one_tensor_otherwise += expected != (side(p[0], p[1], p[2], p[3], m, m, m, m) == CGAL::ON_POSITIVE_SIDE);
  }
  CHECK(in_conflict > 50 && by_one_tensor_otherwise > 20);
}

// a sequence of points and constraints for varying metrics
Input small_input(int n, int segments, bool on_grid)
{
  Random_numbers random(unsigned(n + segments));
  Input input{"small", {}, {}};
  for(int i = 0; i < n; ++i) {
    const double x = random.real(0, 1), y = random.real(0, 1);
    input.points.push_back(on_grid ? XY(std::round(8*x) / 8, std::round(8*y) / 8) : XY(x, y));
  }
  // between points of the first half, for they come when these are there
  input.segments = random_segments({input.points.begin(), input.points.begin() + n/2}, segments);
  return input;
}

// whether constrained edges lead straight from one point to the other
template <class T>
bool has_constraint(const T& t, const typename T::Point& from, const typename T::Point& to)
{
  auto v = t.finite_vertices_begin();
  while(v != t.finite_vertices_end() && v->point() != from)
    ++v;
  typename T::Vertex_handle at = v;
  while(at->point() != to) {
    typename T::Vertex_handle next;
    auto e = t.incident_edges(at), done = e;
    do {
      if(t.is_infinite(*e) || !t.is_constrained(*e))
        continue;
      const auto w = e->first->vertex(e->first->vertex(t.cw(e->second)) == at ? t.ccw(e->second) : t.cw(e->second));
      if(w->point() == to || CGAL::are_strictly_ordered_along_line(at->point(), w->point(), to))
        next = w;
    } while(++e != done);
    if(next == typename T::Vertex_handle())
      return false;
    at = next;
  }
  return true;
}

template <class T, class Point>
void check_constraints(const T& t, const std::vector<Point>& points, const std::vector<Index_pair>& segments,
                       std::size_t n)
{
  for(std::size_t i = 0; i < n; ++i)
    CHECK(has_constraint(t, points[std::size_t(segments[i].first)], points[std::size_t(segments[i].second)]));
}

std::size_t number_of_different(std::vector<XY> points, std::size_t n)
{
  points.resize(n);
  std::sort(points.begin(), points.end());
  return std::size_t(std::unique(points.begin(), points.end()) - points.begin());
}

// Inserts half of the points, the segments, and then the other half, and checks
// everything after every step.
template <class K>
void run_varying(const char* name, const Plain_field& plain, const Input& input, Cavity_counts& counts)
{
  typedef Triangulation<K> T;
  T t{Traits<K>(field_of<K>(plain))};
  const auto points = points_of<K>(input.points);
  for(std::size_t i = 0; i < points.size(); ++i) {
    check_cavity(t, points[i], counts);
    const auto before = t.number_of_vertices();
    const auto v = t.insert(points[i]);
    CHECK_MSG(t.is_valid(true), name);
    CHECK_MSG(t.number_of_vertices() == before || has_no_conflict(t, v), name);
    CHECK_MSG(t.number_of_vertices() == number_of_different(input.points, i + 1), name);
    if(i != points.size() / 2)
      continue;
    for(std::size_t j = 0; j < input.segments.size(); ++j) {
      t.insert_constraint(points[std::size_t(input.segments[j].first)], points[std::size_t(input.segments[j].second)]);
      CHECK_MSG(t.is_valid(true), name);
    }
    check_constraints(t, points, input.segments, input.segments.size());
  }
  check_constraints(t, points, input.segments, input.segments.size());
  CHECK_MSG(has_its_tensors(t), name);
}

template <class K>
void run_against_flips(const char* name, const Plain_field& plain, const Input& input)
{
  typedef Triangulation<K> T;
  const Traits<K> traits(field_of<K>(plain));
  T t(traits);
  Triangulation_by_flips<T> u(traits);
  const auto points = points_of<K>(input.points);
  insert_segments(t, points, input.segments);
  insert_segments(u, points, input.segments);
  CHECK_MSG(all_edges(t) == all_edges(u), name);
  for(const auto& p : points) {
    t.insert(p);
    u.insert_by_flips(p);
  }
  CHECK_MSG(all_edges(t) == all_edges(u), name);
}

template <class K>
void test_varying_metrics(int n)
{
  Cavity_counts counts;
  for(const auto& f : varying_fields)
    for(bool on_grid : {false, true})
      for(int segments : {0, n/6, n}) {
        const Input input = small_input(n, segments, on_grid);
        run_varying<K>(f.first, f.second, input, counts);
        run_against_flips<K>(f.first, f.second, input);
      }
  report(counts);
  CHECK(counts.largest > 5);
}

// many points, all cavities checked, the triangulation at the end
void test_varying_metrics_large()
{
  Cavity_counts counts;
  const Input input = make_input("large", 20000, [](Random_numbers& r)
                                 { const double x = r.real(0, 1); return XY(x, r.real(0, 1)); });
  const auto points = points_of<Epick>(input.points);
  for(const auto& f : varying_fields) {
    Triangulation<Epick> t{Traits<Epick>(field_of<Epick>(f.second))};
    for(const auto& p : points) {
      check_cavity(t, p, counts);
      CHECK_MSG(has_no_conflict(t, t.insert(p)), f.first);
    }
    CHECK_MSG(t.is_valid(true) && has_its_tensors(t), f.first);
    CHECK_MSG(t.number_of_vertices() == points.size(), f.first);
  }
  report(counts);
  CHECK(counts.cavities > 100000 && counts.largest > 20);
}

// long constraints through many faces, in metrics where flips might go round in circles
void test_long_constraints()
{
  const Input input = make_input("long", 4000, [](Random_numbers& r)
                                 { const double x = r.real(0, 1); return XY(x, r.real(0, 1)); });
  const auto points = points_of<Epick>(input.points);
  for(const auto& f : varying_fields) {
    Triangulation<Epick> t{Traits<Epick>(field_of<Epick>(f.second))};
    t.insert(points.begin(), points.end());
    for(int i = 0; i < 10; ++i) {
      const Epick::Point_2 p(0, i / 10.), q(1, i / 10. + 0.05);
      t.insert_constraint(p, q);
      CHECK_MSG(has_constraint(t, p, q), f.first);
    }
    CHECK_MSG(t.is_valid(true), f.first);
    CHECK_MSG(t.number_of_vertices() == points.size() + 20, f.first);
  }
}

// ---------------------------------------------------------------- special positions

template <class K>
void test_low_dimensions()
{
  typedef typename K::Point_2 Point;
  Triangulation<K> t{Traits<K>(field_of<K>(rotating))};
  CHECK(t.is_valid() && t.dimension() == -1);
  const auto a = t.insert(Point(0, 0));
  CHECK(t.is_valid() && t.dimension() == 0);
  CHECK(t.insert(Point(0, 0)) == a && t.number_of_vertices() == 1);
  const auto b = t.insert(Point(4, 2));
  CHECK(t.is_valid() && t.dimension() == 1);
  for(const Point& p : {Point(2, 1), Point(-2, -1), Point(6, 3), Point(1, 0.5)}) // between and beyond
    CHECK(t.insert(p)->point() == p && t.is_valid() && t.dimension() == 1);
  CHECK(t.insert(Point(2, 1))->point() == Point(2, 1) && t.number_of_vertices() == 6);
  t.insert_constraint(a, b);
  CHECK(has_constraint(t, Point(0, 0), Point(4, 2)));
  t.insert(Point(3, 1.5)); // on the constraint
  CHECK(t.is_valid() && t.dimension() == 1 && has_constraint(t, Point(0, 0), Point(4, 2)));
  t.insert(Point(1, 3));
  CHECK(t.is_valid() && t.dimension() == 2 && has_constraint(t, Point(0, 0), Point(4, 2)));
  t.insert(Point(1, -3));
  CHECK(t.is_valid() && t.number_of_vertices() == 9 && has_constraint(t, Point(0, 0), Point(4, 2)));
  CHECK(has_its_tensors(t));
}

template <class T>
std::size_t number_of_constrained_edges(const T& t)
{
  std::size_t n = 0;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    n += t.is_constrained(*e);
  return n;
}

template <class K>
Triangulation<K> square(const Plain_field& plain, bool constrained)
{
  typedef typename K::Point_2 Point;
  Triangulation<K> t{Traits<K>(field_of<K>(plain))};
  const std::vector<Point> corners = {Point(0, 0), Point(8, 0), Point(8, 8), Point(0, 8)};
  if(constrained)
    t.insert_constraint(corners.begin(), corners.end(), true);
  else
    t.insert(corners.begin(), corners.end());
  CHECK(t.is_valid() && t.number_of_vertices() == 4 && number_of_constrained_edges(t) == (constrained ? 4 : 0));
  return t;
}

template <class K>
void test_points_on_edges()
{
  typedef typename K::Point_2 Point;
  for(bool constrained : {false, true}) {
    Triangulation<K> t = square<K>(rotating, constrained);
    t.insert(Point(4, 4)); // on the diagonal
    CHECK(t.is_valid() && t.number_of_vertices() == 5);
    t.insert(Point(2, 2));
    t.insert(Point(6, 2));
    CHECK(t.is_valid() && t.number_of_vertices() == 7);
    t.insert(Point(4, 0)); // on the hull
    t.insert(Point(8, 5));
    CHECK(t.is_valid() && t.number_of_vertices() == 9);
    CHECK(number_of_constrained_edges(t) == (constrained ? 6 : 0));
    for(const Point& p : {Point(9, 0), Point(20, 30), Point(-1, 8), Point(4, 8.125), Point(0, -5)}) // outside
      CHECK(has_no_conflict(t, t.insert(p)) && t.is_valid());
    CHECK(t.number_of_vertices() == 14);
    CHECK(number_of_constrained_edges(t) == (constrained ? 6 : 0));
    t.insert_constraint(Point(2, 2), Point(6, 2));
    t.insert(Point(3, 2));
    t.insert(Point(5, 2));
    CHECK(t.is_valid() && has_constraint(t, Point(2, 2), Point(6, 2)));
    CHECK(number_of_constrained_edges(t) == (constrained ? 9 : 3));
    CHECK(has_its_tensors(t));
  }
}

template <class K>
void test_constraints()
{
  typedef typename K::Point_2 Point;
  typedef Triangulation<K> T;
  T t = square<K>(rotating, true);
  for(const Point& p : {Point(1, 1), Point(3, 1), Point(2, 5), Point(5, 6), Point(7, 3), Point(4, 4), Point(6, 6)})
    t.insert(p);
  const std::vector<Point> hole = {Point(3, 3), Point(5, 3), Point(5, 5), Point(3, 5)};
  t.insert_constraint(hole.begin(), hole.end(), true);
  CHECK(t.is_valid() && number_of_constrained_edges(t) == 8);
  t.insert_constraint(Point(1, 1), Point(1, 7)); // dangling
  t.insert_constraint(Point(0, 0), Point(3, 3)); // through the vertex (1,1)
  CHECK(t.is_valid() && number_of_constrained_edges(t) == 11);
  t.insert_constraint(Point(3, 3), Point(5, 5)); // the hole's diagonal, through (4,4)
  t.insert_constraint(Point(4, 4), Point(8, 8)); // partly there already
  t.insert_constraint(Point(1, 7), Point(1, 1)); // there already
  CHECK(t.is_valid() && number_of_constrained_edges(t) == 15);
  CHECK(has_constraint(t, Point(0, 0), Point(8, 8)));
  const auto before = all_edges(t);
  CHECK(refuses_constraint(t, Point(2, 5), Point(0, 0))); // crosses (1,1)-(1,7)
  CHECK(refuses_constraint(t, Point(2, 5), Point(7, 3))); // crosses the hole
  CHECK(t.is_valid() && has_its_tensors(t));
  for(const auto& e : before)
    if(std::get<2>(e))
      CHECK(has_constraint(t, std::get<0>(e), std::get<1>(e)));
  CHECK(!refuses_constraint(t, Point(8, 0), Point(0, 8))); // crosses in vertices only
  CHECK(t.is_valid() && has_constraint(t, Point(8, 0), Point(0, 8)));
}

// crossing constraints are refused by both, with the same result
void test_crossing_constraints()
{
  typedef Reference_triangulation<Epick> CDT;
  const Input input = small_input(150, 0, true);
  const auto points = points_of<Epick>(input.points);
  Triangulation<Epick> t{Traits<Epick>(isotropic.field<Epick>())};
  CDT u;
  t.insert(points.begin(), points.end());
  u.insert(points.begin(), points.end());
  Random_numbers random(5);
  int refused = 0;
  for(int i = 0; i < 300; ++i) {
    const auto p = points[std::size_t(random.integer(150))], q = points[std::size_t(random.integer(150))];
    if(p == q)
      continue;
    const bool is_refused = refuses_constraint(t, p, q);
    CHECK(is_refused == refuses_constraint(u, p, q));
    CHECK(t.is_valid(true));
    CHECK(picture<Epick>(t, euclidean).edges == picture<Epick>(u, euclidean).edges);
    refused += is_refused;
  }
  CHECK(refused > 50);
}

// ---------------------------------------------------------------- copies, and fields with data

struct Field_with_data
{
  std::vector<double> sizes;

  CGAL::Metric_tensor_2<Epick> operator()(const Epick::Point_2& p) const
  {
    return Tensor::from_sizes(sizes.at(std::size_t(p.x()) % sizes.size()), 1, p.y());
  }
};

typedef CGAL::Riemannian_metric_traits_2<Epick, Field_with_data>            Traits_with_data;
typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits_with_data>  Triangulation_with_data;

void test_copies()
{
  typedef Triangulation_with_data T;
  std::unique_ptr<T> first(new T{Traits_with_data(Field_with_data{{1, 0.5, 0.25}})});
  for(int i = 0; i < 40; ++i)
    first->insert(Epick::Point_2(i % 7, (i * i) % 11));
  first->insert_constraint(Epick::Point_2(0, 0), Epick::Point_2(6, 3));
  const auto edges = all_edges(*first);

  T copy(*first), assigned{Traits_with_data(Field_with_data{{9}})}, empty;
  assigned.insert(Epick::Point_2(0, 0));
  assigned = copy;
  empty = assigned;
  first->insert(Epick::Point_2(2.5, 2.25));
  CHECK(all_edges(*first) != edges);
  first.reset(); // the field outlives the first of its users
  for(T* t : {&copy, &assigned, &empty}) {
    CHECK(all_edges(*t) == edges && t->is_valid() && has_its_tensors(*t));
    CHECK(t->geom_traits().metric_field().sizes.size() == 3);
    t->insert(Epick::Point_2(2.5, 2.25));
    CHECK(t->is_valid() && has_its_tensors(*t) && all_edges(*t) != edges);
  }
  CHECK(all_edges(copy) == all_edges(assigned) && all_edges(copy) == all_edges(empty));

  const T moved(std::move(copy));
  CHECK(all_edges(moved) == all_edges(assigned) && moved.is_valid() && has_its_tensors(moved));
  T other{Traits_with_data(Field_with_data{{9}})};
  other.swap(assigned);
  CHECK(all_edges(moved) == all_edges(other) && has_its_tensors(other) && assigned.number_of_vertices() == 0);
  assigned.insert(Epick::Point_2(1, 1));
  CHECK(has_its_tensors(assigned) && assigned.geom_traits().metric_field().sizes.size() == 1);
}

// A field that refuses a point leaves the triangulation as it was.
void test_refused_points()
{
  const Field<Epick> field = [](const Epick::Point_2& p) { return Tensor::from_entries(1, 0, 3 - p.x()); };
  Triangulation<Epick> t{Traits<Epick>(field)};
  typedef CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception Invalid;
  CHECK_THROWS(t.insert(Epick::Point_2(5, 7)), Invalid, "(5, 7)");
  CHECK(t.number_of_vertices() == 0 && t.is_valid());
  for(int i = 0; i < 9; ++i)
    t.insert(Epick::Point_2(i % 3, i / 3));
  const auto edges = all_edges(t);
  CHECK_THROWS(t.insert(Epick::Point_2(3, 0.5)), Invalid, "(3, 0.5)");
  CHECK_THROWS(t.insert_constraint(Epick::Point_2(0, 0), Epick::Point_2(3.5, 1)), Invalid, "(3.5, 1)");
  CHECK(all_edges(t) == edges && t.is_valid() && has_its_tensors(t));
}

// is_valid() must be able to say no
void test_invalid_triangulations()
{
  typedef Epick::Point_2 Point;
  const Triangulation<Epick> valid = [] {
    Triangulation<Epick> t = square<Epick>(rotating, false);
    t.insert(Point(8, 4));
    t.insert(Point(3, 3));
    return t;
  }();
  const auto moved = [&](const Point& from, const Point& to)
  {
    Triangulation<Epick> t(valid);
    t.insert(from)->set_point(to);
    return t.is_valid();
  };
  CHECK(moved(Point(3, 3), Point(3, 3.5)));
  CHECK(!moved(Point(3, 3), Point(9, 9)));   // faces turn over
  CHECK(!moved(Point(8, 4), Point(7.5, 4))); // the hull is not convex

  Triangulation<Epick> t(valid);
  const auto f = t.finite_faces_begin();
  f->set_constraint(0, true);
  CHECK(!t.is_valid());
  f->set_constraint(0, false);
  CHECK(t.is_valid());
}

// ---------------------------------------------------------------- a kernel with rounding errors

void test_doubles()
{
  for(const auto& f : {varying_fields[0], varying_fields[3]}) {
    Triangulation<Double_kernel> t{Traits<Double_kernel>(field_of<Double_kernel>(f.second))};
    const std::vector<Double_kernel::Point_2> corners = points_of<Double_kernel>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    t.insert_constraint(corners.begin(), corners.end(), true);
    Random_numbers random(1);
    for(int i = 0; i < 2000; ++i) {
      const double x = random.real(0.001, 0.999);
      t.insert(Double_kernel::Point_2(x, random.real(0.001, 0.999)));
    }
    CHECK_MSG(t.is_valid(true), f.first);
    CHECK_MSG(t.number_of_vertices() == 2004, f.first);
    CHECK_MSG(number_of_constrained_edges(t) == 4, f.first);
  }
}

template <class K>
void test_special_positions()
{
  test_low_dimensions<K>();
  test_points_on_edges<K>();
  test_constraints<K>();
}

int main()
{
  test_special_positions<Epick>();
  test_special_positions<Epeck>();
  test_special_positions<Rational_kernel>();
  test_flat_metrics();
  test_flat_metrics_full_precision();
  test_flat_metrics_small<Epeck>();
  test_flat_metrics_small<Rational_kernel>();
  test_conflicts();
  test_varying_metrics<Epick>(300);
  test_varying_metrics<Epeck>(40);
  test_varying_metrics<Rational_kernel>(40);
  test_varying_metrics_large();
  test_long_constraints();
  test_crossing_constraints();
  test_copies();
  test_refused_points();
  test_invalid_triangulations();
  test_doubles();
  return finish();
}

// Voronoi diagrams whose regions are known in closed form.

#include "voronoi_diagrams.h"

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Mesh_generators.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_subdivision.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

typedef Diagram::Duality::Pair Pair;

static_assert(std::is_constructible<Diagram, const Mesh&>::value && std::is_constructible<Diagram, Mesh&>::value
              && !std::is_constructible<Diagram, Mesh>::value && !std::is_constructible<Diagram, const Mesh>::value,
              "a temporary mesh does not outlive its diagram");

const Point centre(0, 0);

// Where three bisectors meet on an edge, areas are accurate to the square of the tolerance.
const double strict_tolerance = 1e-6;

// ---------------------------------------------------------------- figure 2.2 of the paper

// The region of the centre is where |y| <= (1 - m (2|x| - 1)) / 2 with the
// tensors diag(m, 1): the points as far from it as from a corner.
void test_figure_with_identity()
{
  const Mesh mesh = mesh_of(square(), {centre}, constant_field(1, 0, 1));
  const Diagram diagram(mesh, Directional(), strict_tolerance);
  check_areas(diagram, mesh, "identity");
  const Diagram::Region& r = diagram.region(index_of(diagram, centre));
  CHECK(r.pieces[0].is_main && std::abs(r.pieces[0].area - r.area) < 1e-12); // where corners of regions touch, rounding decides
  CHECK(!r.is_fixed && diagram.region(index_of(diagram, Point(1, 1))).is_fixed);
  CHECK(std::abs(r.area - 2) < 1e-12); // |x| + |y| <= 1
}

void test_figure_with_stretched_tensor()
{
  const Mesh mesh = mesh_of(square(), {centre}, constant_field(4, 0, 1));
  const Diagram diagram(mesh);
  check_areas(diagram, mesh, "diag(4, 1)");
  const Diagram::Region& r = diagram.region(index_of(diagram, centre));
  CHECK(r.pieces.size() == 1);
  CHECK(std::abs(r.area - 2) < 1e-12); // |x| <= (5 - 2|y|) / 8
  CHECK(std::abs(diagram.integrals(index_of(diagram, centre)).area - 4) < 1e-12);
}

// Here |y| <= f(|x|) with f(t) = 6.3 t^2 - 10.15 t + 4, which is positive
// between 0 and t1 and between t2 and 1: so there are two orphans.
void test_figure_with_orphans(double tolerance)
{
  const auto integral = [](double t) { return 2.1*t*t*t - 5.075*t*t + 4*t; };
  const auto moment = [](double t) { return 6.3/4*t*t*t*t - 10.15/3*t*t*t + 2*t*t; };
  const double root = std::sqrt(10.15*10.15 - 4*6.3*4);
  const double t1 = (10.15 - root) / 12.6, t2 = (10.15 + root) / 12.6;
  const double t0 = (10.15 - std::sqrt(10.15*10.15 - 4*6.3*3)) / 12.6; // f(t0) = 1
  const double orphan_area = 2 * (integral(1) - integral(t2)), orphan_x = 2 * (moment(1) - moment(t2)) / orphan_area;

  const Mesh mesh = mesh_of(square(), {centre}, thin_in_the_middle);
  const Diagram diagram(mesh, Directional(), tolerance);
  check_areas(diagram, mesh, "figure 2.2");
  const Diagram::Region& r = diagram.region(index_of(diagram, centre));
  CHECK_MSG(r.number_of_orphans() == 2 && r.pieces.size() == 3, std::to_string(r.pieces.size()));
  CHECK(std::abs(r.pieces[0].area - 4*t0 - 4 * (integral(t1) - integral(t0))) < 4 * tolerance);
  double side = 0;
  for(std::size_t k = 1; k < r.pieces.size(); ++k) {
    const Point c = centroid(r.pieces[k].boundaries);
    CHECK_MSG(std::abs(r.pieces[k].area - orphan_area) < tolerance, std::to_string(r.pieces[k].area));
    CHECK_MSG(std::abs(std::abs(c.x()) - orphan_x) < 10 * tolerance, std::to_string(c.x()));
    CHECK(std::abs(c.y()) < 10 * tolerance);
    side += c.x();
  }
  CHECK(std::abs(side) < 10 * tolerance); // one on either side
  for(const Diagram::Region& other : diagram.regions())
    CHECK(other.generator == centre || other.pieces.size() == 1);
}

// With tensors diag(m(x), 1) the region of the centre is where |y| <= (1 - m (2|x| - 1)) / 2. Where m dips
// there are orphans that reach no edge of the triangulation: the margins of the certificate must see them.
void test_hidden_orphans(double at, double width)
{
  const auto m = [=](double x) { const double t = (std::abs(x) - at) / width; return 7 - 6.5 * std::exp(-t*t); };
  const Mesh mesh = mesh_of(square(), {centre}, [=](const Point& p) { return Tensor::from_entries(m(p.x()), 0, 1); });
  const Diagram diagram(mesh);
  check_areas(diagram, mesh, "hidden orphans");
  const int n = 100000;
  double area = 0;
  std::size_t orphans = 0;
  bool is_in_region = true;
  for(int k = 0; k < n; ++k) {
    const double x = (k + 0.5) / n, y = (std::min)(1., (1 - m(x) * (2*x - 1)) / 2);
    area += 4 * (std::max)(0., y) / n;
    orphans += y > 0 && !is_in_region ? 2 : 0; // one on either side
    is_in_region = y > 0;
  }
  const Diagram::Region& r = diagram.region(index_of(diagram, centre));
  CHECK_MSG(std::abs(r.area - area) < 1e-3, std::to_string(r.area) + " instead of " + std::to_string(area));
  CHECK_MSG(r.number_of_orphans() == orphans && orphans == 2, std::to_string(r.number_of_orphans()));
}

// ---------------------------------------------------------------- Euclidean cells

// a linear map of the plane and what is Euclidean in its image
struct Linear_map
{
  double a, b, c, d;

  double determinant() const { return a*d - b*c; }
  Point operator()(const Point& p) const { return Point(a*p.x() + b*p.y(), c*p.x() + d*p.y()); }
  Point inverse(const Point& p) const
  {
    return Point((d*p.x() - b*p.y()) / determinant(), (a*p.y() - c*p.x()) / determinant());
  }
  Field field() const { return constant_field(a*a + c*c, a*b + c*d, b*b + d*d); }
};

// the part of a convex polygon that is nearer to p than to q
Polygon clip(const Polygon& polygon, const Point& p, const Point& q)
{
  const auto excess = [&](const Point& x) { return CGAL::squared_distance(x, p) - CGAL::squared_distance(x, q); };
  Polygon result;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &u = polygon[i], &v = polygon[(i + 1) % polygon.size()];
    const double at_u = excess(u), at_v = excess(v);
    if(at_u <= 0)
      result.push_back(u);
    if((at_u < 0 && at_v > 0) || (at_u > 0 && at_v < 0))
      result.push_back(u + (at_u / (at_u - at_v)) * (v - u));
  }
  return result;
}

Polygon euclidean_cell(Polygon cell, const std::vector<Point>& generators, const Point& z)
{
  for(const Point& other : generators)
    if(other != z)
      cell = clip(cell, z, other);
  return cell;
}

std::vector<Point> generators_of(const Diagram& diagram)
{
  std::vector<Point> result;
  for(const Diagram::Region& r : diagram.regions())
    result.push_back(r.generator);
  return result;
}

void check_regions_are_mapped_cells(const Linear_map& map, int n, const std::string& name)
{
  const Mesh mesh = mesh_of(square(), random_points(n, 5), map.field());
  const Diagram diagram(mesh, Directional(), strict_tolerance);
  check_areas(diagram, mesh, name);
  std::vector<Point> images;
  for(const Point& z : generators_of(diagram))
    images.push_back(map(z));
  Polygon domain;
  for(const Point& p : square())
    domain.push_back(map(p));
  for(std::size_t i = 0; i < images.size(); ++i) {
    const Polygon cell = euclidean_cell(domain, images, images[i]);
    const double area = signed_area(cell) / map.determinant();
    const Point c = map.inverse(centroid({cell}));
    CHECK(diagram.region(i).pieces.size() == 1);
    CHECK_MSG(std::abs(diagram.region(i).area / area - 1) < 1e-9, name + ": " + std::to_string(area));
    for(Measure measure : {Measure::RIEMANNIAN, Measure::LEBESGUE}) {
      const Diagram::Integrals integrals = diagram.integrals(i, measure);
      const double density = measure == Measure::RIEMANNIAN ? map.determinant() : 1;
      CHECK_MSG(std::abs(integrals.area / (density * area) - 1) < 1e-9, name);
      CHECK_MSG(CGAL::squared_distance(integrals.mass_centre, c) < 1e-18 * area, name);
    }
  }
}

// the centroid of a convex polygon with the density 2 + x + y/2, for which the
// midpoints of edges integrate exactly over triangles
Point weighted_centroid(const Polygon& p)
{
  double mass = 0, x = 0, y = 0;
  for(std::size_t i = 2; i < p.size(); ++i)
    for(const Point& m : {CGAL::midpoint(p[0], p[i]), CGAL::midpoint(p[0], p[i - 1]), CGAL::midpoint(p[i - 1], p[i])}) {
      const double w = CGAL::area(p[0], p[i - 1], p[i]) * (2 + m.x() + m.y()/2);
      mass += w;
      x += w * m.x();
      y += w * m.y();
    }
  return Point(x / mass, y / mass);
}

// Isotropic tensors change neither regions, nor the mass centres of the density by Lebesgue's measure.
void test_isotropic_metric()
{
  const Field field = [](const Point& p) { return Tensor::from_entries(2 + p.x() + p.y()/2, 0, 2 + p.x() + p.y()/2); };
  const Mesh mesh = mesh_of(square(), random_points(60, 6), field);
  const Diagram diagram(mesh, Directional(), strict_tolerance);
  check_areas(diagram, mesh, "isotropic");
  const std::vector<Point> generators = generators_of(diagram);
  for(std::size_t i = 0; i < generators.size(); ++i) {
    const Polygon cell = euclidean_cell(square(), generators, generators[i]);
    CHECK_MSG(std::abs(diagram.region(i).area / signed_area(cell) - 1) < 1e-9, std::to_string(diagram.region(i).area / signed_area(cell) - 1));
    CHECK(CGAL::squared_distance(diagram.integrals(i, Measure::LEBESGUE).mass_centre, weighted_centroid(cell))
          < 1e-18 * signed_area(cell));
  }
}

// ---------------------------------------------------------------- midpoints, scales and motions

double squared_length(const Tensor& m, const Point& p, const Point& q)
{
  const double x = q.x() - p.x(), y = q.y() - p.y();
  return m.m11()*x*x + 2*m.m12()*x*y + m.m22()*y*y;
}

// in the metric m
double distance_to_segment(const Tensor& m, const Point& x, const Point& p, const Point& q)
{
  const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = x.x() - p.x(), vy = x.y() - p.y();
  const double t = (m.m11()*ux*vx + m.m12() * (ux*vy + uy*vx) + m.m22()*uy*vy) / squared_length(m, p, q);
  return std::sqrt(squared_length(m, x, p + (std::min)(1., (std::max)(0., t)) * (q - p)));
}

double distance_to_bisectors(const Diagram& diagram, const Tensor& m, const Point& x, std::size_t i, std::size_t j)
{
  double least = 1e300;
  for(const Diagram::Bisector& b : diagram.bisectors())
    if((b.regions[0] == i && b.regions[1] == j) || (b.regions[0] == j && b.regions[1] == i))
      for(std::size_t k = 1; k < b.points.size(); ++k)
        least = (std::min)(least, distance_to_segment(m, x, b.points[k - 1], b.points[k]));
  return least;
}

// Two generators are equally far from their midpoint, whatever the tensor there (lemma 2.1).
void test_midpoints(const Named_field& f)
{
  const double tolerance = 1e-4;
  const Mesh mesh = mesh_of(square(), random_points(25, 8), f.field);
  const Diagram diagram(mesh, Directional(), tolerance);
  check_areas(diagram, mesh, f.name);
  int on_bisectors = 0;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
    for(std::size_t j = i + 1; j < diagram.number_of_regions(); ++j) {
      const Point m = CGAL::midpoint(diagram.region(i).generator, diagram.region(j).generator);
      const double distance = diagram.squared_distance(m, i);
      bool are_nearest = true;
      for(std::size_t k = 0; k < diagram.number_of_regions(); ++k)
        are_nearest = are_nearest && (k == i || k == j || diagram.squared_distance(m, k) > distance * 1.001);
      if(!are_nearest)
        continue;
      ++on_bisectors;
      const double off = distance_to_bisectors(diagram, f.field(m), m, i, j) / std::sqrt(distance);
      CHECK_MSG(off <= tolerance, f.name + ": " + std::to_string(off));
    }
  CHECK(on_bisectors > 20);
}

// Doubling all lengths changes no rounding.
void test_scale(const Named_field& f)
{
  const Field scaled = [=](const Point& p) {
    const Tensor m = f.field(p);
    return Tensor::from_entries(4 * m.m11(), 4 * m.m12(), 4 * m.m22());
  };
  const Mesh mesh = mesh_of(square(), random_points(12, 9), f.field), large = mesh_of(square(), random_points(12, 9), scaled);
  const Diagram diagram(mesh), of_large(large);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const Diagram::Region &r = diagram.region(i), &s = of_large.region(i);
    CHECK_MSG(r.pieces.size() == s.pieces.size(), f.name);
    for(std::size_t k = 0; k < r.pieces.size() && k < s.pieces.size(); ++k)
      CHECK_MSG(r.pieces[k].boundaries == s.pieces[k].boundaries, f.name);
    CHECK(diagram.integrals(i).mass_centre == of_large.integrals(i).mass_centre);
  }
}

// Turns and moves the plane; metrics move along.
void test_rigid_motion(const Named_field& f)
{
  const double c = 0.6, s = 0.8;
  const auto move = [=](const Point& p) { return Point(c*p.x() - s*p.y() + 3, s*p.x() + c*p.y() - 2); };
  const Field moved_field = [=](const Point& q) {
    const double x = q.x() - 3, y = q.y() + 2;
    const Tensor m = f.field(Point(c*x + s*y, c*y - s*x));
    return Tensor::from_entries(c*c*m.m11() - 2*c*s*m.m12() + s*s*m.m22(),
                                c*s * (m.m11() - m.m22()) + (c*c - s*s) * m.m12(),
                                s*s*m.m11() + 2*c*s*m.m12() + c*c*m.m22());
  };
  const std::vector<Point> inner = random_points(12, 10);
  Polygon moved_square;
  std::vector<Point> moved_inner;
  for(const Point& p : square())
    moved_square.push_back(move(p));
  for(const Point& p : inner)
    moved_inner.push_back(move(p));
  const Mesh mesh = mesh_of(square(), inner, f.field), moved = mesh_of(moved_square, moved_inner, moved_field);
  const Diagram diagram(mesh, Directional(), 1e-6), of_moved(moved, Directional(), 1e-6);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const Diagram::Region& r = diagram.region(i);
    const std::size_t j = index_of(of_moved, move(r.generator));
    CHECK_MSG(r.pieces.size() == of_moved.region(j).pieces.size(), f.name);
    CHECK_MSG(std::abs(r.area - of_moved.region(j).area) < 1e-5, f.name);
    const Diagram::Integrals a = diagram.integrals(i), b = of_moved.integrals(j);
    CHECK_MSG(std::abs(a.energy - b.energy) < 1e-4 * a.energy, f.name);
    CHECK_MSG(CGAL::squared_distance(move(a.mass_centre), b.mass_centre) < 1e-8, f.name);
  }
}

// ---------------------------------------------------------------- distances measured at generators

// Corners whose tensors are so large that their regions are tiny leave the domain to two generators.
const double corner_weight = 1000;
const Point left_generator(-0.5, 0), right_generator(0.5, 0);

// x + y^2 * 3/2 = 0 is where (x + 1/2)^2 + 4 y^2 = (x - 1/2)^2 + y^2.
void test_parabola()
{
  const Field field = [](const Point& p) {
    const double w = p == left_generator || p == right_generator ? 1 : corner_weight * corner_weight;
    return Tensor::from_entries(w, 0, p == left_generator ? 4 : w);
  };
  const Mesh mesh = mesh_of(square(), {left_generator, right_generator}, field);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Labelle_Shewchuk> diagram(mesh);
  check_areas(diagram, mesh, "parabola");
  const std::size_t left = index_of(diagram, left_generator), right = index_of(diagram, right_generator);
  const double y = std::sqrt(2/3.); // where the parabola leaves the square
  CHECK(std::abs(diagram.region(right).area - (4 - 2*y + y*y*y)) < 4e-4);
  std::size_t n = 0;
  for(const auto& b : diagram.bisectors())
    if((std::min)(b.regions[0], b.regions[1]) == (std::min)(left, right)
       && (std::max)(b.regions[0], b.regions[1]) == (std::max)(left, right)) {
      CHECK(b.is_between_main_pieces && !b.is_closed);
      n += b.points.size();
      for(const Point& p : b.points)
        CHECK(std::abs(p.x() + 1.5*p.y()*p.y()) < 1e-10);
    }
  CHECK(n > 10);
}

// The points twice as far from one generator as from the other form a circle.
void test_circle_of_apollonius()
{
  const Weight weight = [](Mesh::Vertex_handle v)
  { return v->point() == left_generator ? 1 : v->point() == right_generator ? 3 : corner_weight; };
  const Mesh mesh = mesh_of(square(), {left_generator, right_generator}, turning);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Weighted> diagram(mesh, Weighted(weight));
  check_areas(diagram, mesh, "circle");
  const auto &outer = diagram.region(index_of(diagram, left_generator)), &inner = diagram.region(index_of(diagram, right_generator));
  const double radius = 3 / 8.; // k d / (k^2 - 1) for the distance d of the generators and the ratio k
  CHECK(std::abs(inner.area - CGAL_PI * radius * radius) < 4e-4);
  CHECK(inner.pieces.size() == 1 && inner.pieces[0].boundaries.size() == 1);
  CHECK(outer.pieces.size() == 1 && outer.pieces[0].boundaries.size() == 2);
  const Polygon &first = outer.pieces[0].boundaries[0], &second = outer.pieces[0].boundaries[1];
  CHECK(signed_area(first) * signed_area(second) < 0);
  for(const Point& p : inner.pieces[0].boundaries[0])
    CHECK(std::abs(std::hypot(p.x() - 0.625, p.y()) - radius) < 1e-10);
  std::size_t closed = 0;
  for(const auto& b : diagram.bisectors())
    closed += b.is_closed;
  CHECK(closed == 1);
}

// ---------------------------------------------------------------- duality

Pair pair_of(const Diagram& diagram, const Point& p, const Point& q)
{
  const std::size_t i = index_of(diagram, p), j = index_of(diagram, q);
  return Pair((std::min)(i, j), (std::max)(i, j));
}

// The regions of the left and the right corners do not meet: the centre's lies between them.
void test_duality_of_figure()
{
  const Mesh mesh = mesh_of(square(), {centre}, constant_field(4, 0, 1));
  const Diagram diagram(mesh);
  const auto duality = diagram.duality();
  std::vector<Pair> expected = {pair_of(diagram, Point(-1, -1), Point(1, -1)), pair_of(diagram, Point(-1, 1), Point(1, 1))};
  std::sort(expected.begin(), expected.end());
  CHECK(duality.edges_without_bisector == expected);
  CHECK(duality.bisectors_without_edge.empty());
  CHECK(duality.number_of_dual_edges == 6);
  CHECK(duality.share_of_dual_edges() == 0.75);
  CHECK(Diagram::Duality().share_of_dual_edges() == 1);
}

// an edge that may be flipped, far from the boundary
Mesh::Edge inner_edge(const Mesh& mesh)
{
  for(const Mesh::Edge& e : mesh.edges_in_domain()) {
    const Mesh::Edge mirror = mesh.mirror_edge(e);
    bool is_inner = mesh.is_flippable(e.first, e.second) && !mesh.is_fixed(mirror.first->vertex(mirror.second));
    for(int i = 0; i < 3; ++i)
      is_inner = is_inner && !mesh.is_fixed(e.first->vertex(i));
    if(is_inner)
      return e;
  }
  CHECK_MSG(false, "no inner edge");
  return Mesh::Edge();
}

// With a constant metric the Delaunay triangulation is dual to the regions,
// but for edges of which a flip has made others.
void test_duality_of_flipped_mesh()
{
  const std::vector<Case> cases = paper_cases();
  Mesh mesh = CGAL::make_anisotropic_mesh_2(cases[4].domain, cases[4].field);
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(20));
  const auto before = Diagram(mesh).duality();
  CHECK(before.edges_without_bisector.empty() && before.bisectors_without_edge.empty());
  CHECK(before.share_of_dual_edges() == 1 && before.number_of_dual_edges == mesh.edges_in_domain().size());

  const Mesh::Edge e = inner_edge(mesh), mirror = mesh.mirror_edge(e);
  const Point p = e.first->vertex(Mesh::ccw(e.second))->point(), q = e.first->vertex(Mesh::cw(e.second))->point();
  const Point r = e.first->vertex(e.second)->point(), s = mirror.first->vertex(mirror.second)->point();
  mesh.flip(e.first, e.second);
  const Diagram diagram(mesh);
  check_areas(diagram, mesh, "flipped");
  const auto after = diagram.duality();
  CHECK(after.bisectors_without_edge == std::vector<Pair>(1, pair_of(diagram, p, q)));
  CHECK(after.edges_without_bisector == std::vector<Pair>(1, pair_of(diagram, r, s)));
  CHECK(after.number_of_dual_edges + 1 == before.number_of_dual_edges);
}

// ---------------------------------------------------------------- the subdivision

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// How far x is from the bisector of i and j, as the difference of its distances to them by their mean.
template <class Diagram>
double off_bisector(const Diagram& diagram, const Point& x, std::size_t i, std::size_t j)
{
  const double di = std::sqrt(diagram.squared_distance(x, i)), dj = std::sqrt(diagram.squared_distance(x, j));
  return 2 * std::abs(di - dj) / (di + dj);
}

template <class Diagram>
double length_of_bisectors(const Diagram& diagram)
{
  double sum = 0;
  for(const auto& b : diagram.bisectors()) {
    for(std::size_t k = 1; k < b.points.size(); ++k)
      sum += distance(b.points[k - 1], b.points[k]);
    if(b.is_closed)
      sum += distance(b.points.back(), b.points.front());
  }
  return sum;
}

// Each face has one label, edges between labels are the bisectors, and the faces tile the domain.
template <class Distance>
void test_subdivision(const Named_field& f, double tolerance)
{
  using namespace CGAL::Anisotropic_mesh_2::internal;
  typedef Mesh_generators<Mesh, Distance> Generators;
  typedef Region_subdivision<Generators, CGAL::Sequential_tag> Subdivision;
  const Mesh mesh = mesh_of(square(), random_points(10, 12), f.field);
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Distance> diagram(mesh, Distance(), tolerance);
  const Generators generators(mesh, Distance());
  const Subdivision subdivision(mesh, generators, tolerance);
  CHECK_MSG(subdivision.tds().is_valid(), f.name);
  const auto point = [](Region_tds::Vertex_handle v) { return Point(v->point.at.x, v->point.at.y); };
  double sum_of_areas = 0, length_of_edges = 0;
  std::set<std::size_t> on_edges, without_label;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
    for(Region_tds::Face_handle face : subdivision.faces(i)) {
      sum_of_areas += area(Region_tds::triangle(face));
      CHECK_MSG(Region_tds::label(face) == i, f.name);
      for(int k = 0; k < 3; ++k) {
        const Region_tds::Vertex_handle v = face->vertex(k);
        if(v->point.label == Labelled_point::none)
          without_label.insert(v->id);
        else
          CHECK_MSG(v->point.label == i && diagram.nearest_generator(point(v)) == i, f.name);
        const std::size_t j = face->neighbor(k)->region;
        if(j == i || j == Subdivision::outside)
          continue;
        const auto p = face->vertex(Mesh::ccw(k)), q = face->vertex(Mesh::cw(k));
        CHECK_MSG(off_bisector(diagram, point(p), i, j) < 4 * tolerance, f.name);
        CHECK_MSG(off_bisector(diagram, CGAL::midpoint(point(p), point(q)), i, j) < 8 * tolerance, f.name);
        on_edges.insert({p->id, q->id});
        length_of_edges += distance(point(p), point(q)) / 2; // met from both sides
      }
    }
  CHECK_MSG(on_edges == without_label && !on_edges.empty(), f.name);
  CHECK_MSG(std::abs(sum_of_areas - area_of(mesh)) < 1e-10, f.name);
  CHECK_MSG(std::abs(length_of_edges / length_of_bisectors(diagram) - 1) < 1e-10, f.name);
}

// ---------------------------------------------------------------- domains

void test_holes_and_constraints()
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 1);
  domain.add_circle(Point(1, 1), 0.5, 2);
  domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::segment(Point(2, 2), Point(2, 0), 3));
  const Field field = [](const Point& p) {
    const double x = p.x() - 1, y = p.y() - 1, distance = std::abs(std::hypot(x, y) - 0.5);
    return Tensor::from_sizes(0.05 + 0.2*distance, 0.2 + 0.1*distance, std::atan2(y, x));
  };
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(domain, field);
  const Diagram diagram(mesh);
  check_areas(diagram, mesh, "holes and constraints");
  check_areas(CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Labelle_Shewchuk>(mesh), mesh, "at generators");
  CHECK(diagram.number_of_regions() == mesh.number_of_vertices());
  std::size_t fixed = 0;
  for(const Diagram::Region& r : diagram.regions())
    fixed += r.is_fixed;
  CHECK(fixed > 0 && fixed < mesh.number_of_vertices());
}

void test_small_domains()
{
  const Mesh triangle = mesh_of({Point(0, 0), Point(2, 0), Point(0, 2)}, {}, constant_field(1, 0, 1));
  const Diagram diagram(triangle, Directional(), strict_tolerance);
  check_areas(diagram, triangle, "triangle");
  CHECK(diagram.number_of_regions() == 3);
  CHECK(std::abs(diagram.region(index_of(diagram, Point(0, 0))).area - 1) < 1e-11);
  CHECK(std::abs(diagram.region(index_of(diagram, Point(2, 0))).area - 0.5) < 1e-11);

  Mesh mesh{Metric_traits(turning)}; // nothing marks a domain
  for(const Point& p : {Point(0, 0), Point(1, 0), Point(2, 0), Point(0, 1), Point(3, 3)}) {
    const Diagram empty(mesh);
    CHECK(empty.number_of_regions() == 0 && empty.bisectors().empty());
    CHECK(empty.duality().share_of_dual_edges() == 1);
    mesh.insert(p);
  }
  CHECK(Diagram(mesh).number_of_regions() == 0);
}

// ---------------------------------------------------------------- repetition and failure

void test_determinism()
{
  const Mesh first = mesh_of(square(), random_points(20, 11), turning);
  std::vector<std::vector<int> > scattering(997); // other addresses for the second mesh
  const Mesh second = mesh_of(square(), random_points(20, 11), turning);
  const Diagram a(first), b(second);
  CHECK(a.number_of_regions() == b.number_of_regions() && a.bisectors().size() == b.bisectors().size());
  for(std::size_t i = 0; i < a.number_of_regions(); ++i) {
    CHECK(a.region(i).tiles == b.region(i).tiles && a.neighbors(i) == b.neighbors(i));
    CHECK(a.region(i).pieces.size() == b.region(i).pieces.size());
    for(std::size_t k = 0; k < a.region(i).pieces.size(); ++k)
      CHECK(a.region(i).pieces[k].boundaries == b.region(i).pieces[k].boundaries);
  }
  for(std::size_t i = 0; i < a.bisectors().size(); ++i)
    CHECK(a.bisectors()[i].points == b.bisectors()[i].points && a.bisectors()[i].regions == b.bisectors()[i].regions);
}

void test_failing_field()
{
  const Field field = [](const Point& p)
  { return std::hypot(p.x() - 0.3, p.y() - 0.2) < 0.2 ? Tensor::from_size(-1) : Tensor::from_size(1); };
  const Mesh mesh = mesh_of(square(), {centre}, field);
  CHECK_THROWS(Diagram d(mesh), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "at the point (");
  CHECK_THROWS(Diagram d(mesh), CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "the metric of size -1");
}

int main()
{
  test_figure_with_identity();
  test_figure_with_stretched_tensor();
  test_figure_with_orphans(1e-3);
  test_figure_with_orphans(1e-4);
  test_figure_with_orphans(1e-6);
  const std::vector<std::pair<double, double> > dips =
    {{0.7, 0.06}, {0.75, 0.06}, {0.7, 0.08}, {0.75, 0.08}, {0.75, 0.1}, {0.8, 0.15}, {0.85, 0.15}, {0.9, 0.15}};
  for(const auto& dip : dips)
    test_hidden_orphans(dip.first, dip.second);
  for(int n : {1, 10, 300}) {
    check_regions_are_mapped_cells({1, 0, 0, 1}, n, "identity");
    check_regions_are_mapped_cells({2, 1, 1, 3}, n, "oblique");
    check_regions_are_mapped_cells({1, 0.5, 0, 0.1}, n, "stretched");
  }
  test_isotropic_metric();
  for(const Named_field& f : {Named_field{"turning", turning}, Named_field{"layer", layer_field}}) {
    test_midpoints(f);
    test_scale(f);
    test_rigid_motion(f);
  }
  test_parabola();
  test_circle_of_apollonius();
  for(const Named_field& f : {Named_field{"turning", turning}, Named_field{"thin", thin_in_the_middle}}) {
    test_subdivision<Directional>(f, 1e-4);
    test_subdivision<Labelle_Shewchuk>(f, 1e-4);
  }
  test_duality_of_figure();
  test_duality_of_flipped_mesh();
  test_holes_and_constraints();
  test_small_domains();
  test_determinism();
  test_failing_field();
  return finish();
}

// What the pictures of the manual show that explain the method and the named parameters: prints lines of
// numbers, which doc/Anisotropic_mesh_2/figures.py draws. Each panel begins with a line of its own.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace am = CGAL::Anisotropic_mesh_2;
namespace np = am::parameters;

using K      = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point  = K::Point_2;
using Tensor = CGAL::Metric_tensor_2<K>;
using Field  = std::function<Tensor(const Point&)>;
using Mesh   = CGAL::Anisotropic_Delaunay_mesh_2<CGAL::Riemannian_metric_traits_2<K, Field> >;
using Domain = CGAL::Anisotropic_mesh_domain_2<K>;

struct Case
{
  Domain domain;
  Field  field;

  Mesh unit_mesh(am::Point_placement placement = am::Point_placement::ADVANCING_FRONT) const
  {
    return CGAL::make_anisotropic_mesh_2(domain, field, np::point_placement(placement));
  }
};

Case polygon(const std::vector<Point>& corners, const Field& field)
{
  Case c{{}, field};
  c.domain.add_polygon(corners);
  return c;
}

Case square(double side, const Field& field) { return polygon({{0, 0}, {side, 0}, {side, side}, {0, side}}, field); }

Case disc(double scale)
{
  Case c{{}, [=](const Point&) { return Tensor::from_sizes(1.5, 0.3, std::acos(-1.) / 4).scaled(scale); }};
  c.domain.add_circle(Point(0, 0), 10);
  return c;
}

Case square4(double scale, double least = 0.031)
{
  return square(4, [=](const Point& p) { return Tensor::from_sizes(least + p.x()/4, least + p.y()/4).scaled(scale); });
}

// small across the line y = 5 and long along it; the other way round if it is the paper's formula to the letter
Case square10(double scale, bool is_layer)
{
  return square(10, [=](const Point& p) {
    const double d = std::abs(p.y() - 5) / 5, small = d + 0.04, large = (5 - 4*d) * small;
    return (is_layer ? Tensor::from_sizes(large, small) : Tensor::from_sizes(small, large)).scaled(scale);
  });
}

Case parallelogram(double scale)
{
  return polygon({{0, 0}, {30, 0}, {40, 14}, {10, 14}},
                 [=](const Point&) { return Tensor::from_sizes(2, 0.5).scaled(scale); });
}

// a ring in the unit square: small across it, long along it
Case polar2(double scale)
{
  return square(1, [=](const Point& p) {
    const double r = std::hypot(p.x(), p.y()), ring = std::abs(r - 0.5), share = (std::min)(1., 10 * ring);
    return Tensor::from_sizes(0.001 + 0.198 * ring, 0.1 * share + 0.025 * (1 - share),
                              std::atan2(p.y(), p.x())).scaled(scale);
  });
}

// ------------------------------------------------------------------ what is printed

void print_triangle(const std::string& what, Mesh::Face_handle f, double quality = 1)
{
  std::cout << what;
  for(int i = 0; i < 3; ++i)
    std::cout << ' ' << f->vertex(i)->point();
  std::cout << ' ' << quality << '\n';
}

double quality(const Point& a, const Point& b, const Point& c, const Tensor& m)
{
  const double squares = m.squared_length(b - a) + m.squared_length(c - b) + m.squared_length(a - c);
  return 4 * std::sqrt(3.) * m.area_density() * CGAL::area(a, b, c) / squares;
}

void print_faces(const Mesh& mesh)
{
  const Field& field = mesh.geom_traits().metric_field();
  for(auto f : mesh.finite_face_handles())
    if(f->is_in_domain()) {
      const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
      print_triangle("face", f, quality(a, b, c, field(CGAL::centroid(a, b, c))));
    }
}

void print_regions(const Mesh& mesh)
{
  const CGAL::Anisotropic_Voronoi_diagram_2<Mesh> diagram(mesh);
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
    for(const auto& piece : diagram.region(i).pieces)
      for(const auto& border : piece.boundaries) {
        std::cout << "region";
        for(const Point& p : border)
          std::cout << ' ' << p;
        std::cout << '\n';
      }
}

void print_panel(const std::string& picture, const std::string& title, const Mesh& mesh, bool with_statistics = true)
{
  std::cout << "panel " << picture << ' ' << title;
  if(with_statistics) {
    const am::Mesh_statistics s = CGAL::anisotropic_mesh_statistics_2(mesh);
    std::cout << std::setprecision(3) << '|' << s.vertices << " vertices, edges " << s.edge_length_min << " to "
              << s.edge_length_max << "|quality " << s.quality_mean << ", least " << s.quality_min
              << std::setprecision(6);
  }
  std::cout << '\n';
  print_faces(mesh);
}

// ------------------------------------------------------------------ the pictures

// ellipses, the mesh that follows them, the regions of its vertices
void show_method()
{
  const Case c = square4(1, 0.25);
  Mesh mesh = c.unit_mesh();
  CGAL::optimize_anisotropic_mesh_2(mesh);
  std::cout << "panel method the metric\n";
  for(double y : {0.35, 1.1, 2., 3.2})
    for(double x : {0.35, 1.1, 2., 3.2})
      std::cout << "tensor " << x << ' ' << y << ' ' << c.field(Point(x, y)) << '\n';
  print_panel("method", "unit mesh, optimized", mesh, false);
  std::cout << "panel method regions of its vertices\n";
  print_regions(mesh);
}

void show_cases()
{
  const std::pair<const char*, Case> cases[] = {
    {"disc", disc(2.5)}, {"square4", square4(1.5)}, {"layer10", square10(1.5, true)},
    {"square10", square10(1.5, false)}, {"parallelogram", parallelogram(1.2)}, {"polar-2", polar2(2)}};
  for(const auto& [name, c] : cases) {
    Mesh mesh = c.unit_mesh();
    CGAL::optimize_anisotropic_mesh_2(mesh);
    print_panel("cases", name, mesh, false);
  }
}

Mesh::Cavity cavity_of(const Mesh& mesh, const Point& p)
{
  Mesh::Locate_type lt;
  int li;
  Mesh::Cavity cavity;
  const Mesh::Face_handle f = mesh.locate(p, lt, li);
  if(lt == Mesh::FACE)
    mesh.find_cavity(p, mesh.geom_traits().metric_field()(p), lt, f, li, cavity);
  return cavity;
}

void print_star(const Mesh& mesh, Mesh::Vertex_handle v)
{
  std::cout << "point " << v->point() << '\n';
  auto f = mesh.incident_faces(v), done = f;
  do
    print_triangle("cavity", f);
  while(++f != done);
}

// a point with a large cavity, before and after its insertion
void show_cavity()
{
  const Case c = square(4, [](const Point& p) { return Tensor::from_sizes(1.2, 0.4, 0.9 - 0.3 * p.x()); });
  Mesh mesh = c.unit_mesh();
  Point p;
  Mesh::Cavity cavity;
  for(double x = 1; x < 3; x += 0.05)
    for(double y = 1; y < 3; y += 0.05) {
      Mesh::Cavity other = cavity_of(mesh, Point(x, y));
      if(other.faces.size() > cavity.faces.size()) {
        p = Point(x, y);
        cavity = other;
      }
    }
  const Mesh::Face_handle f = cavity.faces.back();
  std::cout << "panel cavity a triangle, a point, four ellipses\n";
  print_triangle("face", f);
  std::cout << "tensor " << p << ' ' << c.field(p) << '\n';
  for(int i = 0; i < 3; ++i)
    std::cout << "tensor " << f->vertex(i)->point() << ' ' << f->vertex(i)->metric_tensor() << '\n';
  print_panel("cavity", "all triangles in conflict: the cavity", mesh, false);
  std::cout << "point " << p << '\n';
  for(auto g : cavity.faces)
    print_triangle("cavity", g);
  const Mesh::Vertex_handle v = mesh.insert(p);
  print_panel("cavity", "the point joined to its border", mesh, false);
  print_star(mesh, v);
}

void show_bisector()
{
  const std::vector<Point> corners = {{0, 0}, {2, 0.2}, {0.8, 1.6}};
  Mesh mesh{Mesh::Geom_traits([](const Point& p)
                              { return Tensor::from_sizes(0.5 + 0.6 * p.x(), 1.4 - 0.5 * p.x(), 0.4); })};
  Mesh::Boundary_graph triangle;
  triangle.points = corners;
  for(std::size_t i = 0; i < 3; ++i)
    triangle.segments.push_back({i, (i + 1) % 3, 1, true});
  mesh.insert_boundary(triangle);
  print_panel("bisector", "one face", mesh, false);
  print_regions(mesh);
}

template <class Parameters>
void show_optimized(const std::string& picture, const std::string& title, Mesh mesh, const Parameters& parameters)
{
  CGAL::optimize_anisotropic_mesh_2(mesh, parameters);
  print_panel(picture, title, mesh);
}

void show_parameters()
{
  const Case square = square4(1.7), layer = square10(2, true), rough = square10(1.5, false);
  show_optimized("measure", "RIEMANNIAN", square.unit_mesh(), np::measure(am::Measure::RIEMANNIAN));
  show_optimized("measure", "LEBESGUE", square.unit_mesh(), np::measure(am::Measure::LEBESGUE));

  const Mesh by_edges = layer.unit_mesh(am::Point_placement::EDGE_SUBDIVISION);
  print_panel("point_placement", "EDGE_SUBDIVISION", by_edges);
  print_panel("point_placement", "ADVANCING_FRONT", layer.unit_mesh());

  for(std::size_t n : {0, 2, 10, 100})
    show_optimized("number_of_iterations", "number_of_iterations(" + std::to_string(n) + ")", by_edges,
                   np::quality_moves(false).number_of_iterations(n));

  const std::pair<const char*, am::Region_evaluation> evaluations[] = {
    {"BY_FACES", am::Region_evaluation::BY_FACES}, {"VISIBILITY_REGIONS", am::Region_evaluation::VISIBILITY_REGIONS},
    {"FULL_REGIONS", am::Region_evaluation::FULL_REGIONS}};
  for(const auto& [name, evaluation] : evaluations)
    show_optimized("region_evaluation", name, layer.unit_mesh(),
                   np::region_evaluation(evaluation).number_of_iterations(20));

  show_optimized("quality_moves", "quality_moves(false)", rough.unit_mesh(), np::quality_moves(false));
  show_optimized("quality_moves", "quality_moves(true)", rough.unit_mesh(), np::quality_moves(true));
}

int main()
{
  std::cout.precision(6);
  show_method();
  show_cases();
  show_cavity();
  show_bisector();
  show_parameters();
  return 0;
}

// The energy by faces and its derivatives against their definitions, on single faces and on meshes as they are made.

#include "check.h"
#include "brute_force_acvt.h"
#include "Energy_by_faces.h"
#include "meshes.h"
#include "Random_numbers.h"

#include <CGAL/Anisotropic_mesh_2/internal/base/vector_operations.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Free_vertices.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Measure;

// ---------------------------------------------------------------- faces

// A face of some shape, in a metric that varies.
struct Test_face
{
  Triangle_of_doubles   z = {{{0, 0}, {1, 0.1}, {0.4, 0.9}}};
  Metric_sample       sample = {Symmetric_form(1.5, 0.2, 1.1), Symmetric_form(0.3, 0.1, -0.2),
                                  Symmetric_form(-0.1, 0.2, 0.4), std::sqrt(1.5*1.1 - 0.2*0.2)};

  double density(bool is_riemannian) const { return is_riemannian ? sample.root_of_determinant : 1; }

  // by parts: the gradient without and with the moments of the generators, which are the corners
  Face_gradient by_parts(int n, bool is_riemannian, std::array<Region_moments, 3>& moments) const
  {
    Face_gradient g;
    Part_generators generators;
    for(int i = 0; i < 3; ++i)
      generators.push_back({z[i], &moments[i]});
    for(const Face_part& part : parts_of_face(n)) {
      Part_integrator integrate(part.corners(z), sample.tensor, density(is_riemannian));
      integrate(generators);
      g.add(part, integrate.gradient());
      g.add({{1./3, 1./3, 1./3}}, sample, integrate.energy(), integrate.by_tensor(), is_riemannian);
    }
    g.add(z, g.energy / (2 * area(z)));
    return g;
  }
};

// The closed form for acute faces and the division of parts agree to rounding, whatever the number of parts.
void test_closed_form(bool is_riemannian)
{
  const Test_face face;
  const Metric_triangle triangle(face.z, face.sample.tensor);
  const Acute_face acute(triangle, face.sample, face.density(is_riemannian));
  CHECK(triangle.is_acute());
  std::array<Region_contribution, 3> sums;
  Face_gradient closed;
  acute.add_to(closed, is_riemannian, {{&sums[0], &sums[1], &sums[2]}});
  for(int n : {1, 2, 4}) {
    std::array<Region_moments, 3> moments;
    const Face_gradient g = face.by_parts(n, is_riemannian, moments);
    CHECK_MSG(std::abs(g.energy / closed.energy - 1) < 1e-13, std::to_string(g.energy / closed.energy));
    for(int i = 0; i < 3; ++i) {
      CHECK(std::abs(g.by_corner[i].x - 2*moments[i].gx - closed.by_corner[i].x) < 1e-13);
      CHECK(std::abs(g.by_corner[i].y - 2*moments[i].gy - closed.by_corner[i].y) < 1e-13);
      CHECK(std::abs(moments[i].a.a - sums[i].moments.a.a) + std::abs(moments[i].a.c - sums[i].moments.a.c) < 1e-13);
    }
  }
}

// By dense samples: each goes to the nearest corner.
void test_energy_of_face()
{
  const Test_face face;
  std::array<Region_moments, 3> moments;
  const double energy = face.by_parts(2, false, moments).energy;
  double sum = 0;
  const std::vector<Face_part> parts = similar_parts(300);
  for(const Face_part& part : parts) {
    const Vector_of_doubles x = point_of(face.z, part.barycentre);
    double least = face.sample.tensor(x.x - face.z[0].x, x.y - face.z[0].y);
    for(const Vector_of_doubles& z : face.z)
      least = (std::min)(least, face.sample.tensor(x.x - z.x, x.y - z.y));
    sum += least * area(face.z) / double(parts.size());
  }
  CHECK_MSG(std::abs(energy / sum - 1) < 1e-4, std::to_string(energy / sum));
}

// ---------------------------------------------------------------- regular meshes

// Lloyd's move leads from the generator to the centre of mass.
void test_mass_centre()
{
  Region_moments moments;
  const Symmetric_form m(3, 1, 2);
  moments.add(m, 0.5, -1);
  moments.add(3. * m, 1.5, 3);
  const Vector_of_doubles move = moments.lloyd_move();
  CHECK(std::abs(move.x - 1.25) < 1e-14 && std::abs(move.y - 2) < 1e-14);
}

// A hexagon with sides of n, in equilateral triangles of unit sides in the metric, stretched.
Mesh stretched_hexagon(int n)
{
  const Field field = [](const Point&) { return Tensor::from_entries(4, 0, 1); };
  Mesh mesh{CGAL::Riemannian_metric_traits_2<K, Field>(field)};
  Mesh::Boundary_graph boundary;
  const std::size_t parts = 6 * std::size_t(n);
  const auto corner = [n](int i)
                      { return n * CGAL::Vector_2<K>(std::cos(i * CGAL_PI / 3) / 2, std::sin(i * CGAL_PI / 3)); };
  for(int i = 0; i < 6; ++i)
    for(int k = 0; k < n; ++k) {
      boundary.points.push_back(CGAL::ORIGIN + corner(i) + (corner(i + 1) - corner(i)) * k / n);
      boundary.segments.push_back({boundary.points.size() - 1, boundary.points.size() % parts, 1, true});
    }
  mesh.insert_boundary(boundary);
  CGAL::refine_anisotropic_mesh_2(mesh);
  CHECK(mesh.number_of_vertices() == std::size_t(3*n*(n + 1) + 1));
  return mesh;
}

// A generator in the centre of regular hexagons: energy and mass centre in closed form, in any constant metric.
void test_constant_metric_in_closed_form()
{
  const Mesh mesh = stretched_hexagon(1);
  std::vector<Region_moments> moments;
  Energy_by_faces<Mesh>(mesh, Measure::RIEMANNIAN)(moments);
  // the cell of the centre is a hexagon of area sqrt(3)/2 in the metric, 2*det = 2 per unit of it
  const Region_moments& centre = moments[6];
  CHECK(std::abs(centre.a.a - 4 * std::sqrt(3.) / 2) < 1e-12);
  CHECK(std::abs(centre.a.c - 1 * std::sqrt(3.) / 2) < 1e-12);
  CHECK(std::abs(centre.gx) < 1e-12 && std::abs(centre.gy) < 1e-12);
}

// With a constant tensor 2 A - R is the Hessian where all faces are acute: its product with a random vector against
// differences of gradients.
void test_hessian()
{
  Mesh mesh = stretched_hexagon(4);
  const std::vector<Mesh::Vertex_handle> vertices = free_vertices(mesh);
  Random_numbers random(3);
  for(Mesh::Vertex_handle v : vertices) {
    const double x = v->point().x() + random.real(-0.05, 0.05);
    v->set_point(Point(x, v->point().y() + random.real(-0.1, 0.1)));
  }
  std::vector<Region_moments> moments;
  Bisector_hessian couplings;
  Energy_by_faces<Mesh>(mesh, Measure::RIEMANNIAN)(moments, couplings);

  Bisector_hessian::Vectors_of_floats direction(mesh.vertex_index_bound()), response;
  for(Mesh::Vertex_handle v : vertices) {
    const float x = float(random.real(-1, 1));
    direction[v->index()] = {x, float(random.real(-1, 1))};
  }
  couplings.multiply<CGAL::Sequential_tag>(direction, response);

  const double step = 1e-5;
  const auto gradients_at = [&](double t) {
    for(Mesh::Vertex_handle v : vertices)
      v->set_point(Point(v->point().x() + t * direction[v->index()].x, v->point().y() + t * direction[v->index()].y));
    std::vector<Region_moments> result;
    Bisector_hessian ignored;
    Energy_by_faces<Mesh>(mesh, Measure::RIEMANNIAN)(result, ignored);
    return result;
  };
  const std::vector<Region_moments> up = gradients_at(step), down = gradients_at(-2 * step);
  double error = 0, norm = 0;
  for(Mesh::Vertex_handle v : vertices) {
    const int i = v->index();
    const Symmetric_form& a = moments[i].a;
    const auto d = direction[i];
    const double unit = couplings.unit_of_stiffness();
    const double x = 2 * (a.a*d.x + a.b*d.y) - unit * response[i].x, y = 2 * (a.b*d.x + a.c*d.y) - unit * response[i].y;
    const double dx = (down[i].gx - up[i].gx) / step, dy = (down[i].gy - up[i].gy) / step;
    error += (x - dx) * (x - dx) + (y - dy) * (y - dy);
    norm += dx*dx + dy*dy;
  }
  CHECK_MSG(std::sqrt(error / norm) < 1e-4, "relative error of the Hessian " + std::to_string(std::sqrt(error / norm)));
}

// ---------------------------------------------------------------- meshes as they are made

// A mesh with many obtuse faces, where regions reach into the faces beyond each of the edges: by dense samples, which
// go to the nearest of all vertices.
void test_obtuse_faces()
{
  const Field field = [](const Point&) { return Tensor::from_sizes(0.5, 0.2, 0.6); };
  Random_numbers random(9);
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(box(0, 2), Mesh::Geom_traits(field));
  for(int i = 0; i < 60; ++i) {
    const double x = random.real(0.2, 1.8);
    mesh.insert(Point(x, random.real(0.2, 1.8)));
  }
  Brute_force_acvt<Field, Point> brute_force(field, true);
  std::array<int, 3> obtuse{{0, 0, 0}};
  for(const auto f : mesh.faces_in_domain()) {
    brute_force.add_triangle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), 30);
    const Symmetric_form m(field(Point(0, 0)));
    const Triangle_of_doubles t = triangle_of_doubles(f);
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = t[i], &q = t[(i + 1) % 3], &r = t[(i + 2) % 3];
      obtuse[i] += m(q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y) < 0;
    }
  }
  CHECK(obtuse[0] > 5 && obtuse[1] > 5 && obtuse[2] > 5);
  std::vector<Point> generators(mesh.number_of_vertices());
  for(const auto v : mesh.finite_vertex_handles())
    generators[v->index()] = v->point();
  std::vector<Brute_force_acvt<Field, Point>::Moments> moments;
  const double ratio = Energy_by_faces<Mesh>(mesh, Measure::RIEMANNIAN)() / brute_force(generators, moments);
  CHECK_MSG(std::abs(ratio - 1) < 1e-3, std::to_string(ratio));
}

// The energy with its gradient is that of the regions: closed forms and divided parts agree all over a mesh with obtuse
// faces, where regions reach into the faces nearby.
void test_both_assemblies(const Case& c, Measure measure)
{
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Energy_by_faces<Mesh> energy(mesh, measure, quick_tolerance);
  std::vector<Region_moments> moments;
  Bisector_hessian hessian;
  const double with_gradient = energy(moments, hessian);
  CHECK_MSG(std::abs(with_gradient / energy() - 1) < 1e-12, c.name);
}

// The derivative of the energy along a random move of all free vertices, and along a smooth one, is what the gradient
// says.
template <template <class> class Metric>
void test_slopes(const Case& c, Measure measure)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Energy_by_faces<Mesh, Metric> energy(mesh, measure, quick_tolerance);
  std::vector<Region_moments> gradient, ignored;
  Bisector_hessian hessian;
  energy(gradient, hessian);
  const Free_vertices<Mesh> free(mesh);
  const std::vector<double> start = free.positions();
  const double size = std::sqrt(c.area);
  Random_numbers random(5);
  for(bool is_smooth : {false, true}) {
    std::vector<double> step;
    double expected = 0;
    for(std::size_t i = 0; i < free.size(); ++i) {
      const double x = start[2*i] / size, y = start[2*i + 1] / size;
      const auto sizes = free[i]->metric_tensor().sizes();
      const double h = (std::min)(sizes.h1, sizes.h2);
      const double dx = h * (is_smooth ? std::sin(3*x) * std::cos(2*y) : random.real(-1, 1));
      const double dy = h * (is_smooth ? std::cos(2*x + 1) : random.real(-1, 1));
      step.insert(step.end(), {dx, dy});
      expected -= 2 * (gradient[free[i]->index()].gx * dx + gradient[free[i]->index()].gy * dy);
    }
    const auto energy_at = [&](double t) {
      std::vector<double> x = start;
      add_multiple<CGAL::Sequential_tag>(x, t, step);
      free.set_positions<CGAL::Sequential_tag>(x);
      return energy(ignored, hessian);
    };
    const double t = 1e-5, slope = (energy_at(t) - energy_at(-t)) / (2*t);
    CHECK_MSG(std::abs(slope - expected) <= 1e-4 * std::abs(expected), c.name + ": the slope "
              + std::to_string(slope) + " instead of " + std::to_string(expected));
    free.set_positions<CGAL::Sequential_tag>(start);
  }
}

// ---------------------------------------------------------------- samples of the metric

// The metric is sampled a bounded number of times, whatever it is, and from then on not any more.
void test_number_of_samples(const Case& c, double calls_per_vertex)
{
  std::size_t calls = 0;
  const Field counted = [&](const Point& p) { ++calls; return c.field(p); };
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, counted);
  calls = 0;
  Sampled_metric<Mesh> metric(mesh);
  CHECK_MSG(double(calls) < calls_per_vertex * double(mesh.number_of_vertices()),
            c.name + ": " + std::to_string(calls));
  calls = 0;
  for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
    metric(v);
  CHECK(calls == 0);
}

// The interpolated tensor of each face is that of the field, whichever vertex of the face the search starts at, also
// around the tips of notches.
void test_sampled_tensors(const Case& c, double tolerance)
{
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const Sampled_metric<Mesh> metric(mesh);
  double largest = 0;
  for(const auto f : mesh.faces_in_domain()) {
    const Triangle_of_doubles z = triangle_of_doubles(f);
    const Vector_of_doubles x = point_of(z, {{0.2, 0.3, 0.5}});
    const Symmetric_form m(c.field(Point(x.x, x.y)));
    for(int i = 0; i < 3; ++i) {
      const Symmetric_form s = metric.tensor(x, f->vertex(i));
      largest = (std::max)({largest, std::abs(s.determinant() / m.determinant() - 1),
                            std::abs((s.a + s.c) / (m.a + m.c) - 1)});
    }
  }
  CHECK_MSG(largest < tolerance, c.name + ": " + std::to_string(largest));
}

int main()
{
  const std::vector<Case> cases = paper_cases();
  test_closed_form(true);
  test_closed_form(false);
  test_energy_of_face();
  test_mass_centre();
  test_constant_metric_in_closed_form();
  test_hessian();
  test_obtuse_faces();
  for(Measure measure : {Measure::RIEMANNIAN, Measure::LEBESGUE})
    for(const Case& c : cases)
      test_both_assemblies(c, measure);
  for(const Case& c : {cases[0], cases[1], cases[2], cases[3], unit_square_cases()[1], unit_square_cases()[2]}) {
    test_slopes<Sampled_metric>(c, Measure::RIEMANNIAN);
    test_slopes<Field_metric>(c, Measure::LEBESGUE);
  }
  test_number_of_samples(cases[0], 6);
  test_number_of_samples(unit_square_cases()[0], 6);
  test_number_of_samples(rough_cases()[2], 60);
  test_sampled_tensors(cases[0], 1e-10);
  test_sampled_tensors(cases[1], 0.1);
  test_sampled_tensors(notched_square(), 0.2);
  return finish();
}

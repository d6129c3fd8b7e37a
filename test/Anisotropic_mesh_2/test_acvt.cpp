// The energy and the moments of the regions against their definitions, and the optimizers.

#include "check.h"
#include "brute_force_acvt.h"
#include "meshes.h"

#include <CGAL/Random.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Measure;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

typedef Brute_force_acvt<Field, Point> Brute_force;

std::vector<Point> generators_of(const Mesh& mesh)
{
  std::vector<Point> points(mesh.number_of_vertices());
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    points[v->index()] = v->point();
  return points;
}

Brute_force brute_force_of(const Mesh& mesh, const Field& field, Measure measure, int k)
{
  Brute_force result(field, measure == Measure::RIEMANNIAN);
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      result.add_triangle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), k);
  return result;
}

// The mass centres and the energy of the fast assembly against those of dense
// samples, on optimized meshes.
void test_moments(const Case& c, Measure measure, double energy_tolerance, double pull_tolerance)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::measure(measure).number_of_iterations(20));
  std::vector<Region_moments> moments;
  const double energy = Facewise_energy<Mesh>(mesh, measure)(moments);

  std::vector<Brute_force::Moments> exact;
  const double exact_energy = brute_force_of(mesh, c.field, measure, 20)(generators_of(mesh), exact);
  CHECK_MSG(std::abs(energy / exact_energy - 1) < energy_tolerance,
            c.name + ": " + std::to_string(energy) + " against " + std::to_string(exact_energy));

  double sum = 0;
  const std::vector<Mesh::Vertex_handle> vertices = free_vertices(mesh);
  for(Mesh::Vertex_handle v : vertices) {
    const Vector_of_doubles d = moments[v->index()].lloyd_move();
    double ex, ey;
    exact[v->index()].pull(ex, ey);
    sum += std::sqrt(v->metric_tensor().squared_length(d.x - ex, d.y - ey));
  }
  CHECK_MSG(sum / double(vertices.size()) < pull_tolerance,
            c.name + ": mean error of the mass centres " + std::to_string(sum / double(vertices.size())));
}

// dF/dz = -2 A times the Lloyd move, where F and the moments come from dense samples given to
// the nearest of all generators: so Lloyd's step is a preconditioned gradient step.
void test_gradient()
{
  const Case c = paper_cases()[1];
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const Brute_force brute_force = brute_force_of(mesh, c.field, Measure::RIEMANNIAN, 24);
  std::vector<Point> generators = generators_of(mesh);
  CGAL::Random random(7); // away from the minimum, where gradients are not small
  for(Mesh::Vertex_handle v : free_vertices(mesh)) {
    const double h = 0.3 * v->metric_tensor().sizes().h1;
    generators[v->index()] += CGAL::Vector_2<K>(random.get_double(-h, h), random.get_double(-h, h));
  }
  std::vector<Brute_force::Moments> moments, ignored;
  brute_force(generators, moments);
  const std::vector<Mesh::Vertex_handle> vertices = free_vertices(mesh);
  double error = 0, norm = 0;
  for(std::size_t i = 0; i < vertices.size(); i += vertices.size() / 12) {
    const Mesh::Vertex_handle v = vertices[i];
    const Point z = generators[v->index()];
    for(int axis = 0; axis < 2; ++axis) {
      const double step = 0.02 * v->metric_tensor().sizes().h1;
      const CGAL::Vector_2<K> d(axis == 0 ? step : 0, axis == 0 ? 0 : step);
      generators[v->index()] = z + d;
      const double up = brute_force(generators, ignored);
      generators[v->index()] = z - d;
      const double down = brute_force(generators, ignored);
      generators[v->index()] = z;
      const double difference = (up - down) / 2;
      const double gradient = -2 * (axis == 0 ? moments[v->index()].gx : moments[v->index()].gy) * step;
      error += (difference - gradient) * (difference - gradient);
      norm += difference * difference;
    }
  }
  CHECK_MSG(std::sqrt(error / norm) < 0.03, "relative error of the gradient " + std::to_string(std::sqrt(error / norm)));
}

// A generator in the centre of regular hexagons: energy and mass centre in closed form, in any constant metric.
void test_constant_metric_in_closed_form()
{
  const Field field = [](const Point&) { return Tensor::from_entries(4, 0, 1); };
  Mesh mesh{CGAL::Riemannian_metric_traits_2<K, Field>(field)};
  Mesh::Boundary_graph boundary; // a regular hexagon with unit sides in the metric, stretched
  for(int i = 0; i < 6; ++i) {
    boundary.points.push_back(Point(std::cos(i * std::acos(-1.) / 3) / 2, std::sin(i * std::acos(-1.) / 3)));
    boundary.segments.push_back({std::size_t(i), std::size_t(i + 1) % 6, 1, true});
  }
  mesh.insert_boundary(boundary);
  CGAL::refine_anisotropic_mesh_2(mesh);
  CHECK(mesh.number_of_vertices() == 7);
  std::vector<Region_moments> moments;
  Facewise_energy<Mesh>(mesh, Measure::RIEMANNIAN)(moments);
  // the cell of the centre is a hexagon of area sqrt(3)/2 in the metric, 2*det = 2 per unit of it
  const Region_moments& centre = moments[6];
  CHECK(std::abs(centre.a.a - 4 * std::sqrt(3.) / 2) < 1e-12);
  CHECK(std::abs(centre.a.c - 1 * std::sqrt(3.) / 2) < 1e-12);
  CHECK(std::abs(centre.gx) < 1e-12 && std::abs(centre.gy) < 1e-12);
}

// The closed form for acute elements and the general clipping agree: to rounding
// where the tensor is constant, else to the accuracy of their quadratures.
void test_both_integrators(double variation, double tolerance)
{
  Acvt_element e;
  e.corner = {{{0, 0}, {1, 0.1}, {0.4, 0.9}}};
  e.middle = Weighted_tensor(Symmetric_form(1, 0.05, 1.1), true);
  for(int i = 0; i < 3; ++i)
    e.tensor[i] = Weighted_tensor(Symmetric_form(1 + variation * (i - 1), 0.05 + variation * i, 1.1), true);
  e.guess_bends();
  std::array<Region_contribution, 3> m, n;
  Face_couplings mixed, other_mixed;
  Acute_element_integrator acute;
  CHECK(acute.prepare(e));
  const double energy = acute(e, {&m[0], &m[1], &m[2]}, &mixed);
  Clipped_element_integrator::Generators generators;
  for(int i = 0; i < 3; ++i)
    generators.push_back({e.corner[i], &n[i], i, {}});
  const double clipped = Clipped_element_integrator()(e, generators, &other_mixed);
  CHECK_MSG(std::abs(energy / clipped - 1) < tolerance, std::to_string(energy / clipped));
  for(int i = 0; i < 3; ++i) {
    const Region_moments &p = m[i].moments, &q = n[i].moments;
    CHECK(std::abs(p.a.a / q.a.a - 1) < tolerance);
    CHECK(std::hypot(p.gx - q.gx, p.gy - q.gy) < tolerance);
    CHECK(std::abs(m[i].response.a - n[i].response.a) + std::abs(m[i].response.c - n[i].response.c) < 20 * tolerance);
    const Face_couplings::Block &c = mixed.block[i], &d = other_mixed.block[i];
    CHECK(std::abs(c.xx - d.xx) + std::abs(c.xy - d.xy) + std::abs(c.yx - d.yx) + std::abs(c.yy - d.yy) < 20 * tolerance);
  }
}

// An element that is cut at the middles of its edges, and along the bisectors
// that pass there, gives the sums of its parts, whatever rounding does to the
// corners that lie on bisectors.
void test_cut_through_the_middles()
{
  const auto tensor = [](const Vector_of_doubles& x)
  { return Weighted_tensor(Symmetric_form(1 + 0.3*x.x, 0.1*x.y, 1 - 0.2*x.y), true); };
  const std::array<Vector_of_doubles, 3> z = {{{0, 0}, {1, 0.1}, {0.4, 0.9}}};
  const auto integrate = [&](const std::array<Vector_of_doubles, 3>& corner, std::array<Region_contribution, 3>& sums) {
    Acvt_element e;
    e.corner = corner;
    for(int i = 0; i < 3; ++i)
      e.tensor[i] = tensor(corner[i]);
    e.middle = tensor(e.barycentre());
    e.sample_bends(tensor);
    Clipped_element_integrator::Generators generators;
    for(int i = 0; i < 3; ++i)
      generators.push_back({z[i], &sums[i], i, {}});
    return Clipped_element_integrator()(e, generators, nullptr);
  };
  const std::array<Vector_of_doubles, 3> middle = {{{0.7, 0.5}, {0.2, 0.45}, {0.5, 0.05}}};
  std::array<Region_contribution, 3> whole, parts;
  const double energy = integrate(z, whole);
  double sum = integrate(middle, parts);
  for(int i = 0; i < 3; ++i)
    sum += integrate({z[i], middle[(i + 2) % 3], middle[(i + 1) % 3]}, parts);
  CHECK_MSG(std::abs(sum / energy - 1) < 1e-3, std::to_string(sum / energy));
  for(int i = 0; i < 3; ++i) {
    CHECK(std::abs(parts[i].moments.a.a / whole[i].moments.a.a - 1) < 2e-3);
    CHECK(std::hypot(parts[i].moments.gx - whole[i].moments.gx, parts[i].moments.gy - whole[i].moments.gy) < 2e-4);
  }
}

// With a constant tensor 2 A - R is the Hessian, but for the regions that reach
// beyond an obtuse face: its product with a random
// vector against differences of gradients.
void test_hessian()
{
  const Case c = paper_cases()[0];
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).quality_moves(false).number_of_iterations(5));
  const std::vector<Mesh::Vertex_handle> vertices = free_vertices(mesh);
  std::vector<Region_moments> moments;
  Bisector_hessian couplings;
  Facewise_energy<Mesh>(mesh, Measure::RIEMANNIAN)(moments, couplings);

  CGAL::Random random(3);
  Bisector_hessian::Vectors_of_floats direction(mesh.vertex_index_bound()), response;
  for(Mesh::Vertex_handle v : vertices)
    direction[v->index()] = {float(random.get_double(-1, 1)), float(random.get_double(-1, 1))};
  couplings.multiply<CGAL::Sequential_tag>(direction, response);

  const double step = 1e-5;
  const auto gradients_at = [&](double t) {
    for(Mesh::Vertex_handle v : vertices)
      v->set_point(Point(v->point().x() + t * direction[v->index()].x, v->point().y() + t * direction[v->index()].y));
    std::vector<Region_moments> result;
    Facewise_energy<Mesh>(mesh, Measure::RIEMANNIAN)(result);
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
  CHECK_MSG(std::sqrt(error / norm) < 0.01, "relative error of the Hessian " + std::to_string(std::sqrt(error / norm)));
}

void check_mesh(const Mesh& mesh, const Mesh& start, const std::string& name)
{
  CHECK_MSG(mesh.is_valid(true), name);
  CHECK_MSG(mesh.number_of_vertices() == start.number_of_vertices(), name);
  CHECK_MSG(mesh.number_of_faces_in_domain() == start.number_of_faces_in_domain(), name);
  CHECK_MSG(std::abs(area_of(mesh) / area_of(start) - 1) < 1e-12, name);
  std::size_t moved = 0;
  const std::vector<Point> before = generators_of(start), after = generators_of(mesh);
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v) {
    CHECK(v->metric_tensor() == mesh.geom_traits().metric_field()(v->point()));
    if(mesh.is_fixed(v))
      CHECK_MSG(before[v->index()] == after[v->index()], name);
    else
      moved += before[v->index()] != after[v->index()];
  }
  CHECK_MSG(moved > 0, name);
}

// The slope of the energy along Lloyd's step is what the gradient says. Without the bends of the tensors within a
// face the error is 1.6e-3, without the bends of the bisectors 4e-2.
void test_slope(const Case& c, double tolerance)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).quality_moves(false).number_of_iterations(5));
  std::vector<Region_moments> moments, ignored;
  Facewise_energy<Mesh> energy(mesh, Measure::RIEMANNIAN);
  energy(moments);
  const Free_vertices<Mesh> free(mesh);
  const std::vector<double> start = free.positions();
  std::vector<double> step;
  double expected = 0;
  for(std::size_t i = 0; i < free.size(); ++i) {
    const Region_moments& m = moments[free[i]->index()];
    const Vector_of_doubles d = m.lloyd_move();
    step.insert(step.end(), {d.x, d.y});
    expected -= 2 * (m.gx*d.x + m.gy*d.y);
  }
  const auto energy_at = [&](double t) {
    std::vector<double> x = start;
    for(std::size_t i = 0; i < x.size(); ++i)
      x[i] += t * step[i];
    free.set_positions<CGAL::Sequential_tag>(x);
    for(std::size_t i = 0; i < free.size(); ++i)
      free[i]->set_metric_tensor(c.field(free[i]->point()));
    return energy(ignored);
  };
  // no face changes its rule by so small a step
  const double t = 0.001, slope = (energy_at(t) - energy_at(-t)) / (2*t);
  CHECK_MSG(std::abs(slope - expected) <= tolerance * std::abs(expected), c.name + ": the slope "
            + std::to_string(slope) + " instead of " + std::to_string(expected));
}

// The quasi-Newton method is not worse than Lloyd's iteration after as many steps.
void test_lloyd(const Case& c, double rise)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Mesh mesh = start;
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.convergence(0.).number_of_iterations(12)).return_code
        == CGAL::MAX_ITERATION_NUMBER_REACHED);
  check_mesh(mesh, start, c.name + " by Lloyd's iteration");

  Mesh quick = start;
  CGAL::optimize_anisotropic_mesh_2(quick, np::convergence(0.).number_of_iterations(12));
  check_mesh(quick, start, c.name + " by the quasi-Newton method");
  std::vector<Region_moments> ignored;
  const double lloyd = Facewise_energy<Mesh>(mesh, Measure::RIEMANNIAN)(ignored);
  const double newton = Facewise_energy<Mesh>(quick, Measure::RIEMANNIAN)(ignored);
  const double before = Facewise_energy<Mesh>(start, Measure::RIEMANNIAN)(ignored);
  CHECK(lloyd < before);
  CHECK_MSG(newton < lloyd * (1 + rise), c.name);
}

class Monotone_visitor
{
public:
  explicit Monotone_visitor(double& largest_rise) : m_largest_rise(&largest_rise) {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& s)
  {
    if(m_last > 0)
      *m_largest_rise = (std::max)(*m_largest_rise, s.energy / m_last - 1);
    m_last = s.energy;
    return true;
  }

private:
  double* m_largest_rise;
  double m_last = 0;
};

// Lloyd's iteration lowers the energy in every step; the assembly takes part in
// that to its accuracy, which is perfect for a constant metric.
void test_energy_falls()
{
  for(const Case& c : paper_cases()) {
    if(c.name == "square10")
      continue; // the metric doubles within an element there
    Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
    double rise = 0;
    CGAL::optimize_anisotropic_mesh_2
      (mesh, lloyd_method.convergence(0.).number_of_iterations(25).visitor(Monotone_visitor(rise)));
    const bool is_constant = c.name == "disc" || c.name == "parallelogram";
    CHECK_MSG(rise < (is_constant ? 1e-9 : 5e-4), c.name + ": " + std::to_string(rise));
  }
}

class Recording_visitor
{
public:
  explicit Recording_visitor(std::vector<CGAL::Anisotropic_mesh_2::Optimization_state>& states) : m_states(&states) {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& s)
  {
    m_states->push_back(s);
    return true;
  }

private:
  std::vector<CGAL::Anisotropic_mesh_2::Optimization_state>* m_states;
};

// The quasi-Newton method comes below the energy of Lloyd's 100th iterate in a
// sixth of the evaluations; without the Hessian in its preconditioner it takes 20.
void test_acceleration(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2
    (c.domain, c.field, np::point_placement(CGAL::Anisotropic_mesh_2::Point_placement::EDGE_SUBDIVISION));
  Mesh by_lloyd = start, quick = start;
  std::vector<CGAL::Anisotropic_mesh_2::Optimization_state> lloyd, newton;
  CGAL::optimize_anisotropic_mesh_2
    (by_lloyd, lloyd_method.convergence(0.).number_of_iterations(100).visitor(Recording_visitor(lloyd)));
  CGAL::optimize_anisotropic_mesh_2(quick, np::convergence(0.).number_of_iterations(25).visitor(Recording_visitor(newton)));
  CHECK(newton.front().energy == lloyd.front().energy);
  const auto below = std::find_if(newton.begin(), newton.end(),
                                  [&](const auto& s) { return s.energy < lloyd.back().energy; });
  CHECK_MSG(below != newton.end() && below->evaluations <= 16, c.name + ": "
            + std::to_string(below == newton.end() ? 0 : below->evaluations) + " evaluations");
}

// The triangulation updated in place and the one built anew from the empty mesh
// after each step lead to the same energy.
void test_ways_to_move(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Mesh in_place = start, rebuilt = start;
  const auto method = [](auto& optimizer) { return optimizer.quasi_newton(); };
  const auto parameters = np::convergence(0.).number_of_iterations(30);
  optimize_acvt<CGAL::Sequential_tag, Vertex_mover<Mesh> >(in_place, 0., method, parameters);
  optimize_acvt<CGAL::Sequential_tag, Vertex_reinserter<Mesh> >(rebuilt, 0., method, parameters);
  std::vector<Region_moments> ignored;
  const double ratio = Facewise_energy<Mesh>(in_place, Measure::RIEMANNIAN)(ignored)
                     / Facewise_energy<Mesh>(rebuilt, Measure::RIEMANNIAN)(ignored);
  CHECK_MSG(std::abs(ratio - 1) < 2e-3, c.name + ": energy in place over that of a rebuild " + std::to_string(ratio));
  CHECK(in_place.is_valid() && rebuilt.is_valid());
}

// Energy and gradient agree well enough, even where the metric turns or changes
// within an element, that few trial steps are rejected.
void test_evaluations_of_rough_metrics(const Case& c)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  std::vector<CGAL::Anisotropic_mesh_2::Optimization_state> states;
  CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).number_of_iterations(50).visitor(Recording_visitor(states)));
  CHECK_MSG(double(states.back().evaluations) <= 1.1 * double(states.back().iteration) + 1, c.name + ": "
            + std::to_string(states.back().evaluations) + " evaluations for " + std::to_string(states.back().iteration));
}

// Where the energy cannot fall any more, the method ends by itself, and without many trials.
void test_end_of_descent(const Case& c)
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const auto result = CGAL::optimize_anisotropic_mesh_2
    (mesh, np::convergence(0.).energy_reduction(0.).quality_moves(false).number_of_iterations(200));
  CHECK(result.return_code == CGAL::CANT_IMPROVE_ANYMORE);
  CHECK_MSG(result.iterations < 100 && result.evaluations <= result.iterations + 3, c.name + ": "
            + std::to_string(result.evaluations) + " evaluations for " + std::to_string(result.iterations));
}

// An energy reduction that no ten iterations can reach ends both methods after them.
void test_energy_reduction(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  for(const auto method : {CGAL::Anisotropic_mesh_2::Optimization_method::QUASI_NEWTON,
                           CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD}) {
    Mesh mesh = start;
    const auto result = CGAL::optimize_anisotropic_mesh_2
      (mesh, np::convergence(0.).energy_reduction(0.9).method(method).number_of_iterations(60));
    CHECK(result.return_code == CGAL::CANT_IMPROVE_ANYMORE);
    CHECK_MSG(result.iterations >= 10 && result.iterations <= 12, std::to_string(result.iterations) + " iterations");
  }
}

class Stopping_visitor
{
public:
  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& s) const { return s.iteration < 3; }
};

void test_return_codes()
{
  const Case c = paper_cases()[4];
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Mesh mesh = start;
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(0)).return_code == CGAL::MAX_ITERATION_NUMBER_REACHED);
  CHECK(generators_of(mesh) == generators_of(start));
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).visitor(Stopping_visitor())).return_code == CGAL::BOUND_REACHED);
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).number_of_iterations(100000).maximum_running_time(1e-9)).return_code
        == CGAL::TIME_LIMIT_REACHED);
  CHECK(mesh.is_valid());
  CHECK(CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.01).number_of_iterations(1000)).return_code == CGAL::CONVERGENCE_REACHED);

  const Field coarse = [](const Point&) { return Tensor::from_size(1000); };
  Mesh empty = CGAL::make_anisotropic_mesh_2(c.domain, coarse);
  CHECK(CGAL::optimize_anisotropic_mesh_2(empty).return_code == CGAL::ALL_VERTICES_FROZEN);
  CHECK(CGAL::optimize_anisotropic_mesh_2(empty, lloyd_method).return_code == CGAL::ALL_VERTICES_FROZEN);
}

// A field that fails during the optimization leaves a valid mesh behind.
void test_failing_field()
{
  const Case c = paper_cases()[4];
  bool fails = false;
  const Field field = [&](const Point& p) { return fails ? Tensor::from_size(-1) : c.field(p); };
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, field);
  Mesh mesh = start;
  struct Sabotage
  {
    bool* fails;
    bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state&) { return *fails = true; }
  };
  CHECK_THROWS(CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::visitor(Sabotage{&fails})),
               CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "the metric of size -1");
  CHECK(mesh.is_valid(true));
  CHECK(generators_of(mesh) == generators_of(start));
  fails = false;
  CHECK_THROWS(CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.visitor(Sabotage{&fails})),
               CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception, "at the point (");
  CHECK(mesh.is_valid(true));
}

void test_determinism()
{
  for(const Case& c : unit_square_cases()) {
    Mesh first = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
    std::vector<std::vector<int> > scattering(997); // other addresses for the second mesh
    Mesh second = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
    CHECK(generators_of(first) == generators_of(second));
    CGAL::optimize_anisotropic_mesh_2(first, CGAL::parameters::number_of_iterations(10));
    CGAL::optimize_anisotropic_mesh_2(second, CGAL::parameters::number_of_iterations(10));
    CHECK(generators_of(first) == generators_of(second));
  }
}

int main()
{
  const std::vector<Case> cases = paper_cases();
  test_constant_metric_in_closed_form();
  test_both_integrators(0, 1e-14);
  test_both_integrators(0.1, 5e-3);
  test_cut_through_the_middles();
  test_hessian();
  test_moments(cases[4], Measure::RIEMANNIAN, 0.003, 0.005);
  test_moments(cases[1], Measure::RIEMANNIAN, 0.005, 0.01);
  test_moments(cases[1], Measure::LEBESGUE, 0.005, 0.01);
  test_moments(cases[2], Measure::RIEMANNIAN, 0.005, 0.01);
  test_gradient();
  test_lloyd(cases[0], 0);
  test_lloyd(cases[1], 1e-3);
  test_energy_falls();
  for(std::size_t i : {0, 2, 4})
    test_acceleration(cases[i]);
  for(const Case& c : cases)
    test_ways_to_move(c);
  test_evaluations_of_rough_metrics(cases[3]);
  test_evaluations_of_rough_metrics(unit_square_cases()[2]);
  test_end_of_descent(cases[1]);
  test_end_of_descent(unit_square_cases()[1]);
  test_energy_reduction(cases[4]);
  test_slope(cases[0], 1e-6);
  test_slope(unit_square_cases()[0], 5e-4);
  test_return_codes();
  test_failing_field();
  test_determinism();
  return finish();
}

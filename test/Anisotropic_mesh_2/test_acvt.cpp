// The moments of the regions of optimized meshes against their definition, and the optimizers.

#include "check.h"
#include "brute_force_acvt.h"
#include "Energy_by_faces.h"
#include "Recording_visitor.h"
#include "meshes.h"

#include <CGAL/Random.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <algorithm>
#include <array>
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
  const double energy = Energy_by_faces<Mesh>(mesh, measure)(moments);

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

// The optimizer asks the field for its samples only, however many iterations there are.
void test_number_of_evaluations(const Case& c, double calls_per_vertex)
{
  std::size_t calls = 0;
  const Field counted = [&](const Point& p) { ++calls; return c.field(p); };
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, counted);
  calls = 0;
  CGAL::optimize_anisotropic_mesh_2(mesh, np::quality_moves(false).number_of_iterations(30));
  CHECK_MSG(double(calls) < calls_per_vertex * double(mesh.number_of_vertices()), c.name + ": " + std::to_string(calls));
}

double merit(const CGAL::Anisotropic_mesh_2::Mesh_statistics& s)
{
  return s.edge_length_unit_share + s.quality_mean + s.quality_min / 10;
}

// Each iterate has a positive energy, and the mesh is not worse afterwards; where it would be, it is the same.
void test_never_worse(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  const auto before = CGAL::anisotropic_mesh_statistics_2(start);
  for(int iterations : {2, 40}) {
    Mesh mesh = start;
    std::vector<CGAL::Anisotropic_mesh_2::Optimization_state> states;
    const auto result = CGAL::optimize_anisotropic_mesh_2
      (mesh, np::quality_moves(false).number_of_iterations(iterations).visitor(Recording_visitor(states)));
    for(const auto& s : states)
      CHECK_MSG(s.energy > 0, c.name);
    const auto after = CGAL::anisotropic_mesh_statistics_2(mesh);
    CHECK_MSG(merit(after) > merit(before) - 2e-3, // lengths by Simpson's rule decide, the statistics are exact
              c.name + ": " + std::to_string(merit(before)) + ", " + std::to_string(merit(after)));
    CHECK_MSG(mesh.is_valid(true), c.name);
    if(!result.is_better) {
      CHECK(generators_of(mesh) == generators_of(start));
      CHECK(result.return_code == CGAL::CANT_IMPROVE_ANYMORE && result.energy == states.front().energy);
    }
  }
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
  const double lloyd = Energy_by_faces<Mesh>(mesh, Measure::RIEMANNIAN)();
  const double newton = Energy_by_faces<Mesh>(quick, Measure::RIEMANNIAN)();
  const double before = Energy_by_faces<Mesh>(start, Measure::RIEMANNIAN)();
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

// Fourteen iterations of the quasi-Newton method come below the energy of Lloyd's 100th iterate.
void test_acceleration(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2
    (c.domain, c.field, np::point_placement(CGAL::Anisotropic_mesh_2::Point_placement::EDGE_SUBDIVISION));
  Mesh by_lloyd = start, quick = start;
  CGAL::optimize_anisotropic_mesh_2(by_lloyd, lloyd_method.convergence(0.).number_of_iterations(100));
  CGAL::optimize_anisotropic_mesh_2(quick, np::convergence(0.).number_of_iterations(14).quality_moves(false));
  const double lloyd = Energy_by_faces<Mesh>(by_lloyd, Measure::RIEMANNIAN)();
  const double newton = Energy_by_faces<Mesh>(quick, Measure::RIEMANNIAN)();
  CHECK_MSG(newton < lloyd, c.name + ": " + std::to_string(newton) + " against " + std::to_string(lloyd));
}

// The triangulation updated in place and the one built anew from the empty mesh
// after each step lead to the same energy.
void test_ways_to_move(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  Mesh in_place = start, rebuilt = start;
  const auto method = [](auto& optimizer) { return optimizer.quasi_newton(); };
  const auto parameters = np::convergence(0.);
  const Stopping_criteria criteria{30, 0, 0, 0};
  std::optional<Sampled_metric<Mesh> > first, second;
  optimize_acvt<CGAL::Sequential_tag, Vertex_mover>(in_place, first, method, criteria, quick_tolerance, parameters);
  optimize_acvt<CGAL::Sequential_tag, Vertex_reinserter>(rebuilt, second, method, criteria, quick_tolerance, parameters);
  const double ratio = Energy_by_faces<Mesh>(in_place, Measure::RIEMANNIAN)()
                     / Energy_by_faces<Mesh>(rebuilt, Measure::RIEMANNIAN)();
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
  CHECK_MSG(result.iterations < 100 && result.evaluations <= 2 * result.iterations, c.name + ": "
            + std::to_string(result.evaluations) + " evaluations for " + std::to_string(result.iterations));
}

// An energy reduction that no five iterations can reach ends both methods after them.
void test_energy_reduction(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  for(const auto method : {CGAL::Anisotropic_mesh_2::Optimization_method::QUASI_NEWTON,
                           CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD}) {
    Mesh mesh = start;
    const auto result = CGAL::optimize_anisotropic_mesh_2
      (mesh, np::convergence(0.).energy_reduction(0.9).method(method).number_of_iterations(60));
    CHECK(result.return_code == CGAL::CANT_IMPROVE_ANYMORE);
    CHECK_MSG(result.iterations >= 5 && result.iterations <= 7, std::to_string(result.iterations) + " iterations");
  }
}

// Where a vertex finds no place in the mesh that is built anew, since another one has taken its old one, all are moved in
// place: also those at jumps, and their tensors are those of the field.
void test_reinsertion_in_place(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain, c.field);
  for(std::size_t k = 0; k < 8; ++k) { // in some of them the vertex k + 1 is inserted after k, which goes to its place
    Mesh mesh = start;
    Sampled_metric<Mesh> metric(mesh);
    CHECK(Free_vertices<Mesh>(mesh, metric).size() < Free_vertices<Mesh>(mesh).size());
    Vertex_reinserter<Mesh, Sampled_metric<Mesh> > reinserter(mesh, metric);
    const std::vector<double> before = reinserter.free_vertices().positions();
    std::vector<double> target = before;
    target[2*k] = before[2*k + 2];
    target[2*k + 1] = before[2*k + 3];
    target[2*k + 2] = target[2*k + 3] = 1e9;
    reinserter.move_to(target);
    CHECK(mesh.is_valid(true));
    const std::vector<double> after = reinserter.free_vertices().positions();
    CHECK(after.size() == before.size());
    for(std::size_t i = 0; i < after.size(); ++i)
      CHECK((2*k <= i && i < 2*k + 4) || after[i] == before[i]);
    for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
      CHECK(v->metric_tensor() == c.field(v->point()));
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

// The field is called a bounded number of times per vertex: by mesher and optimizer together, and by statistics.
void test_budget(const Case& c, double for_mesh, double for_statistics)
{
  std::size_t calls = 0;
  const Field counted = [&](const Point& p) { ++calls; return c.field(p); };
  Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, counted);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  const double vertices = double(mesh.number_of_vertices());
  CHECK_MSG(double(calls) <= for_mesh * vertices, c.name + ": " + std::to_string(double(calls) / vertices));
  calls = 0;
  CGAL::anisotropic_mesh_statistics_2(mesh);
  CHECK_MSG(double(calls) <= for_statistics * vertices, c.name + ": " + std::to_string(double(calls) / vertices));
}

int main()
{
  const std::vector<Case> cases = paper_cases();
  test_number_of_evaluations(cases[0], 9);
  test_number_of_evaluations(unit_square_cases()[0], 9);
  test_number_of_evaluations(rough_cases()[2], 73);
  for(const Case& c : rough_cases())
    test_never_worse(c);
  test_never_worse(notched_square());
  test_reinsertion_in_place(rough_cases()[0]);
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
  test_acceleration({"square4, finer", cases[1].domain, [&](const Point& p) { return cases[1].field(p).scaled(0.4); }, 16});
  test_acceleration(unit_square_cases()[2]);
  for(const Case& c : cases)
    test_ways_to_move(c);
  test_evaluations_of_rough_metrics(cases[3]);
  test_evaluations_of_rough_metrics(unit_square_cases()[2]);
  test_end_of_descent(cases[1]);
  test_end_of_descent(unit_square_cases()[1]);
  test_energy_reduction(cases[4]);
  test_return_codes();
  test_failing_field();
  test_determinism();
  for(const Case& c : {cases[0], cases[1], cases[2], cases[4], unit_square_cases()[0]})
    test_budget(c, 60, 15);
  test_budget(cases[3], 200, 30);
  for(const Case& c : rough_cases())
    test_budget(c, 200, 30);
  return finish();
}

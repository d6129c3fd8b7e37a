// The descent methods on functions whose minimum is known, without a mesh where that is possible: what they promise
// about steps, ends and failures; and how vertices are moved.

#include "check.h"
#include "meshes.h"
#include "Random_numbers.h"

#include <CGAL/Anisotropic_mesh_2/internal/optimization/Acvt_optimizer.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Best_mesh_keeper.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Lbfgs_history.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Region_preconditioner.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Optimization_state;

typedef std::vector<double> Array;

double product(const Array& u, const Array& v) { return std::inner_product(u.begin(), u.end(), v.begin(), 0.); }

Array random_array(std::size_t n, Random_numbers& random)
{
  Array v(n);
  for(double& x : v)
    x = random.real(-1, 1);
  return v;
}

// ---------------------------------------------------------------- history

// The approximate inverse of the Hessian maps the last difference of gradients to the last step, and makes descents of
// all gradients, also where curvatures have not been positive.
void test_history()
{
  Random_numbers random(2);
  const std::size_t n = 12;
  Lbfgs_history<CGAL::Sequential_tag> history(5);
  const auto precondition = [](Array& v) { for(double& x : v) x *= 3; };
  for(int k = 0; k < 9; ++k) {
    const Array step = random_array(n, random), noise = random_array(n, random);
    Array change(n);
    const bool is_convex = k % 3 != 2;
    for(std::size_t i = 0; i < n; ++i)
      change[i] = is_convex ? 2 * step[i] + noise[i] : noise[i] - 2 * step[i];
    history.add(step, change);
    Array v = change;
    history.direction(v, precondition);
    CHECK(product(change, v) < 0);
    for(std::size_t i = 0; i < n && is_convex; ++i)
      CHECK_MSG(std::abs(v[i] + step[i]) < 1e-4, std::to_string(v[i]) + " instead of " + std::to_string(-step[i]));
    for(int trial = 0; trial < 5; ++trial) {
      const Array gradient = random_array(n, random);
      v = gradient;
      history.direction(v, precondition);
      CHECK(product(gradient, v) < 0);
    }
  }
}

// ---------------------------------------------------------------- preconditioner

// Residuals of Chebyshev's iteration of degree 3 are bounded by 1 / T_3(sigma). The Hessian is that of a ring of
// triangles, relative to 2 A between 0 and 1; it is damped by a tenth.
void test_preconditioner()
{
  const int n = 30;
  std::vector<int> free(n);
  std::iota(free.begin(), free.end(), 0);
  std::vector<Region_moments> moments(n);
  Bisector_hessian couplings;
  couplings.resize(1, n, 1e-3, 1e5);
  couplings.block(0).clear(free);
  for(int i = 0; i < n; ++i) { // 2 A is the identity times 2e5, R half of it less what couples neighbors by a quarter
    moments[i].a = Symmetric_form(1e5, 0, 1e5);
    couplings.add_response(i, Symmetric_form(1e5, 0, 1e5));
    Face_couplings c;
    c.block[2] = {-5e4, 0, 0, -5e4};
    couplings.block(0).add({{std::uint16_t(i), std::uint16_t((i + 1) % n), std::uint16_t((i + 2) % n)}}, c);
  }
  const auto hessian = [&](const Array& v) {
    Array y(v.size());
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < 2; ++k)
        y[2*i + k] = 1.2e5 * v[2*i + k] - 5e4 * (v[2*((i + 1) % n) + k] + v[2*((i + n - 1) % n) + k]);
    return y;
  };
  Region_preconditioner<CGAL::Sequential_tag> precondition(free);
  Random_numbers random(6);
  const double sigma = 1.2, bound = 1 / (4*sigma*sigma*sigma - 3*sigma);
  for(int trial = 0; trial < 20; ++trial) {
    const Array u = random_array(2 * n, random), v = random_array(2 * n, random);
    Array pu = u, pv = v;
    precondition(moments, couplings, pu);
    precondition(moments, couplings, pv);
    CHECK(product(u, pu) > 0 && std::abs(product(u, pv) - product(v, pu)) < 1e-5 * product(u, pu));
    Array residual = hessian(pu);
    for(std::size_t i = 0; i < u.size(); ++i)
      residual[i] -= u[i];
    CHECK_MSG(product(residual, residual) <= 1.001 * bound * bound * product(u, u),
              std::to_string(std::sqrt(product(residual, residual) / product(u, u))));
  }
}

// ---------------------------------------------------------------- iteration

// points of the plane; lengths are measured in units of 1/2
struct Points
{
  Array x;

  std::vector<int> indices() const
  {
    std::vector<int> result(x.size() / 2);
    std::iota(result.begin(), result.end(), 0);
    return result;
  }
  const Array& positions() const { return x; }
  double metric_length(const Array& v, std::size_t i) const { return 2 * std::hypot(v[2*i], v[2*i + 1]); }
};

// writes down where they have been
struct Mover
{
  Points points;
  std::vector<Array> way;

  const Points& free_vertices() const { return points; }
  void move_to(const Array& x)
  {
    points.x = x;
    way.push_back(x);
  }
};

// the sum of squared distances to centres, each in a form of its own; or what `override` makes of it
struct Quadratic_energy
{
  static constexpr bool has_couplings = false;

  const Points& points;
  Array centres;
  std::function<double(double)> override = nullptr;

  static Symmetric_form form(std::size_t i) { return Symmetric_form(3 + double(i), 1, 2); }

  double operator()(std::vector<Region_moments>& moments) const
  {
    moments.assign(centres.size() / 2, Region_moments());
    double sum = 1;
    for(std::size_t i = 0; i < moments.size(); ++i)
      sum += moments[i].add(form(i), centres[2*i] - points.x[2*i], centres[2*i + 1] - points.x[2*i + 1]);
    return override ? override(sum) : sum;
  }
};

struct Visitor
{
  std::vector<Optimization_state>* states;
  std::size_t last = 1000000;

  bool iteration(const Optimization_state& s)
  {
    states->push_back(s);
    return s.iteration < last;
  }
};

struct Descent
{
  Mover                           mover;
  std::vector<Optimization_state> states;
  CGAL::Mesh_optimization_return_code code;

  Descent(bool by_lloyd, const Array& start, const Stopping_criteria& criteria,
          const std::function<double(double)>& override = nullptr)
  {
    mover.points.x = start;
    Array centres{1, 2, -5, 4, 30, 0};
    centres.resize(start.size());
    Quadratic_energy energy{mover.points, centres, override};
    Visitor visitor{&states};
    Acvt_optimizer<CGAL::Sequential_tag, Quadratic_energy, Mover, Visitor> optimizer(energy, mover, criteria, visitor);
    code = by_lloyd ? optimizer.lloyd() : optimizer.quasi_newton();
    CHECK(states.back().iteration == optimizer.state().iteration && states.back().energy == optimizer.state().energy);
  }
};

const Array start{0, 0, 1, 1, 2, 2};

// Lloyd's step is exact here. The other method comes to the same place, by steps of at most half a unit.
void test_quadratic()
{
  const Descent lloyd(true, start, {100, 1e-9, 0, 0}), quick(false, start, {1000, 1e-6, 0, 0});
  CHECK(lloyd.code == CGAL::CONVERGENCE_REACHED && lloyd.states.back().iteration == 1);
  CHECK(quick.code == CGAL::CONVERGENCE_REACHED && quick.states.back().largest_move <= 1e-6);
  for(const Descent* d : {&lloyd, &quick})
    CHECK(std::hypot(d->mover.points.x[4] - 30, d->mover.points.x[5]) < 1e-5
          && std::abs(d->states.back().energy - 1) < 1e-9);
  for(std::size_t k = 0; k < quick.mover.way.size(); ++k) {
    Array step = quick.mover.way[k];
    for(std::size_t i = 0; i < step.size(); ++i)
      step[i] -= k == 0 ? start[i] : quick.mover.way[k - 1][i];
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(quick.mover.points.metric_length(step, i) < 0.5 + 1e-9);
  }
}

void test_ends()
{
  for(bool by_lloyd : {false, true}) {
    const Descent none(by_lloyd, start, {0, 0, 0, 0});
    CHECK(none.code == CGAL::MAX_ITERATION_NUMBER_REACHED && none.mover.way.empty());
    const Descent brief(by_lloyd, start, {1000, 0, 0, 1e-6}, [](double energy) {
      CGAL::Real_timer timer;
      for(timer.start(); timer.time() < 1e-5;) {}
      return energy;
    });
    CHECK(brief.code == CGAL::TIME_LIMIT_REACHED && brief.mover.way.empty());
    CHECK(Descent(by_lloyd, start, {1000, 1e9, 0, 0}).code == CGAL::CONVERGENCE_REACHED);
  }
  CHECK(Descent(false, {}, {1000, 0, 0, 0}).code == CGAL::ALL_VERTICES_FROZEN);
}

// The energy falls once, and stays below what it was before that: five more iterations are granted, each of one
// evaluation.
void test_patience()
{
  int calls = 0;
  const Descent d(false, start, {1000, 0, 0, 0}, [&](double) {
    ++calls;
    return calls == 1 ? 1 : calls == 2 ? 0.5 : 0.9 - 1e-2 * calls;
  });
  CHECK_MSG(d.code == CGAL::CANT_IMPROVE_ANYMORE && d.states.back().iteration == 7 && calls == 8,
            std::to_string(d.states.back().iteration) + " iterations, " + std::to_string(calls) + " evaluations");
}

// Where the energy rises whatever the step, the points are where they were, after a few trials.
void test_no_descent()
{
  double first = 0;
  const Descent d(false, start, {1000, 0, 0, 0}, [&](double energy) {
    first = first == 0 ? energy : first;
    return first + std::abs(energy - first);
  });
  CHECK(d.code == CGAL::CANT_IMPROVE_ANYMORE && d.mover.points.x == start && d.states.back().evaluations <= 6);
  CHECK(d.states.back().energy == d.states.front().energy);
}

// ---------------------------------------------------------------- the best mesh

// keeps numbers in the place of meshes
struct Number_keeper
{
  double now, given, kept = -1;

  void keep() { kept = now; }
  void restore_kept() { now = kept; }
  void restore_given() { now = given; }
  void finish() { now += change_by_finish; }

  double change_by_finish = 0;
};

// The merits that a mesh has every five iterations, what finishing changes, and what must remain.
void test_best(const std::vector<double>& merits, double change_by_finish, double expected, bool is_better)
{
  Number_keeper mover{merits[0], merits[0], -1, change_by_finish};
  const auto merit = [&](const Optimization_state&) { return mover.now; };
  std::vector<Optimization_state> states;
  Visitor visitor{&states};
  const auto judge = [](double merit) { return merit; };
  Best_mesh_keeper<decltype(merit), decltype(judge), Number_keeper, Visitor> keeper(merit, judge, mover, visitor);
  Optimization_state s;
  for(double m : merits) {
    mover.now = m;
    s.energy = m;
    ++s.evaluations;
    keeper.iteration(s);
    s.iteration += 5;
  }
  const Optimization_state remaining = keeper.choose(s);
  CHECK_MSG(mover.now == expected && keeper.is_better() == is_better, std::to_string(mover.now));
  CHECK(remaining.energy == expected - (expected == mover.kept + change_by_finish ? change_by_finish : 0));
  CHECK(states.size() == merits.size());
}

void test_best_mesh()
{
  test_best({1, 1.25, 1.5}, 0, 1.5, true);     // better and better
  test_best({1, 1.5, 1.499}, 0, 1.499, true);  // as good as the best one, but of less energy
  test_best({1, 1.5, 1.25}, 0, 1.5, true);     // not as good as it has been
  test_best({1, 1.5, 0.75}, 0, 1.5, true);
  test_best({1, 1.5, 0.75}, -0.75, 1, false);  // what has been kept is worse in the field itself
  test_best({1, 0.999, 0.999}, 0, 1, false);
  test_best({1, 0.5, 0.75}, 0, 1, false);
}

// ---------------------------------------------------------------- moves

const Field field = [](const Point& p) { return Tensor::from_sizes(0.2 + p.x()/16, 0.3, p.y()); };

std::vector<Point> points_of(const Mesh& mesh) { return std::vector<Point>(mesh.points_begin(), mesh.points_end()); }

// tensors of the field, halved
struct Half_metric
  : Field_metric<Mesh>
{
  using Field_metric<Mesh>::Field_metric;
  using Field_metric<Mesh>::operator();

  Tensor operator()(Mesh::Vertex_handle v) const { return Field_metric<Mesh>::operator()(v).scaled(2); }
};

// Wherever vertices are sent, no face is turned over and no fixed vertex moves, and their tensors are those of the
// metric; in the end those of the field; and all can be taken back.
void test_moves()
{
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(box(0, 2), Mesh::Geom_traits(field));
  const Mesh given = mesh;
  const std::vector<Point> before = points_of(mesh);
  const Half_metric metric(mesh);
  Vertex_mover<Mesh, const Half_metric> mover(mesh, metric);
  const auto& free = mover.free_vertices();
  Random_numbers random(1);
  for(int round = 0; round < 4; ++round) {
    Array target = free.positions();
    for(double& x : target)
      x += random.real(-1, 1) * std::pow(0.1, round);
    mover.move_to(target);
    CHECK(mesh.is_valid(true) && std::abs(area_of(mesh) - 4) < 1e-12 && points_of(mesh) != before);
    for(std::size_t i = 0; i < free.size(); ++i)
      CHECK(free[i]->metric_tensor() == field(free[i]->point()).scaled(2));
    if(round == 2)
      mover.keep();
  }
  mover.restore_kept();
  mover.finish();
  for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
    CHECK(v->metric_tensor() == field(v->point()));
  CHECK(mesh.is_valid(true));
  mover.restore_given();
  CHECK(mesh.is_valid(true) && points_of(mesh) == before);
  auto f = given.finite_faces_begin();
  for(auto g = mesh.finite_faces_begin(); g != mesh.finite_faces_end(); ++g, ++f)
    for(int i = 0; i < 3; ++i)
      CHECK(f->vertex(i)->point() == g->vertex(i)->point());
}

// Where the metric fails, nothing has moved.
void test_failing_metric()
{
  int calls = -1;
  const Field failing = [&](const Point& p) {
    if(calls >= 0 && ++calls == 4)
      throw std::runtime_error("no tensor here");
    return field(p);
  };
  Mesh mesh = CGAL::make_anisotropic_mesh_2<Mesh>(box(0, 2), Mesh::Geom_traits(failing));
  const std::vector<Point> before = points_of(mesh);
  Field_metric<Mesh> metric(mesh);
  Vertex_mover<Mesh> mover(mesh, metric);
  Array target = mover.free_vertices().positions();
  for(double& x : target)
    x += 0.001;
  calls = 0;
  CHECK_THROWS(mover.move_to(target), std::runtime_error, "no tensor here");
  calls = -1;
  CHECK(points_of(mesh) == before && mesh.is_valid(true));
  for(Mesh::Vertex_handle v : mesh.finite_vertex_handles())
    CHECK(v->metric_tensor() == field(v->point()));
}

int main()
{
  test_history();
  test_preconditioner();
  test_quadratic();
  test_ends();
  test_patience();
  test_no_descent();
  test_best_mesh();
  test_moves();
  test_failing_metric();
  return finish();
}

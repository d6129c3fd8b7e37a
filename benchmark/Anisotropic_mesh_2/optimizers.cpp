// How many times each method evaluates the energy until it is below that of the
// hundredth iterate of Lloyd: the paper's iteration, over-relaxed and with Anderson's
// acceleration, and the L-BFGS method with several preconditioners.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Acvt_optimizer.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Anisotropic_mesh_2::internal;
using CGAL::Anisotropic_mesh_2::Measure;
using CGAL::Anisotropic_mesh_2::Optimization_state;
typedef std::vector<double> Array; // of coordinates

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef K::Point_2                                          Point;
typedef CGAL::Metric_tensor_2<K>                            Tensor;
typedef std::function<Tensor(const Point&)>                 Field;
typedef CGAL::Anisotropic_Delaunay_mesh_2<CGAL::Riemannian_metric_traits_2<K, Field> > Mesh;
typedef internal::Sampled_metric<Mesh>                      Metric;
typedef internal::Facewise_energy<Mesh, CGAL::Sequential_tag, Metric> Energy;
typedef internal::Vertex_mover<Mesh, Metric>                Mover;

constexpr double tolerance = internal::accurate_tolerance; // for all of them, so that energies can be compared

constexpr std::size_t bound = 100;

// the energies of all iterates, with the evaluations up to there
typedef std::vector<Optimization_state> States;

struct Recorder
{
  States* states;
  bool iteration(const Optimization_state& s)
  {
    states->push_back(s);
    return true;
  }
};

// without the motion of the bisectors only the matrices of the regions precondition
struct Energy_without_couplings
{
  static constexpr bool has_couplings = false;
  Energy evaluate;
  internal::Bisector_hessian ignored;

  Energy_without_couplings(const Mesh& mesh, const Metric& metric, Measure measure, double tolerance)
    : evaluate(mesh, metric, measure, tolerance)
  {}

  double operator()(std::vector<internal::Region_moments>& moments) { return evaluate(moments, ignored); }
};

template <class AnyEnergy, class Method>
States optimize(Mesh mesh, const Method& method)
{
  States states;
  Recorder recorder{&states};
  Metric metric(mesh);
  AnyEnergy energy(mesh, metric, Measure::RIEMANNIAN, tolerance);
  Mover mover(mesh, metric);
  const internal::Stopping_criteria criteria{bound, 0, 0, 0};
  internal::Acvt_optimizer<CGAL::Sequential_tag, AnyEnergy, Mover, Recorder> optimizer(energy, mover, criteria, recorder);
  method(optimizer);
  return states;
}

States lloyd(const Mesh& mesh) { return optimize<Energy>(mesh, [](auto& o) { o.lloyd(); }); }

States by_matrices(const Mesh& mesh)
{
  return optimize<Energy_without_couplings>(mesh, [](auto& o) { o.quasi_newton(); });
}

States by_hessian(const Mesh& mesh) { return optimize<Energy>(mesh, [](auto& o) { o.quasi_newton(); }); }

// Moves by what `step` makes of the vectors to the mass centres.
template <class Step>
States fixed_point_iteration(Mesh mesh, Step step)
{
  States states;
  Metric metric(mesh);
  Energy energy(mesh, metric, Measure::RIEMANNIAN, tolerance);
  Mover mover(mesh, metric);
  std::vector<internal::Region_moments> moments;
  Optimization_state state;
  for(; state.iteration <= bound; ++state.iteration) {
    state.energy = energy(moments);
    ++state.evaluations;
    states.push_back(state);
    Array target = mover.free_vertices().positions(), moves(target.size());
    for(std::size_t i = 0; i < mover.free_vertices().size(); ++i) {
      const internal::Vector_of_doubles d = moments[mover.free_vertices()[i]->index()].lloyd_move();
      moves[2*i] = d.x;
      moves[2*i + 1] = d.y;
    }
    step(target, moves);
    mover.move_to(target);
  }
  return states;
}

States over_relaxed(const Mesh& mesh)
{
  return fixed_point_iteration(mesh, [](Array& x, const Array& moves) {
    internal::add_multiple<CGAL::Sequential_tag>(x, 1.8, moves);
  });
}

// Anderson's acceleration with five differences, in the least squares of the moves.
class Anderson
{
public:
  void operator()(Array& x, const Array& moves)
  {
    const Eigen::VectorXd f = Eigen::Map<const Eigen::VectorXd>(moves.data(), moves.size());
    const Eigen::VectorXd g = Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()) + f;
    if(m_last_f.size() > 0) {
      m_df.push_back(f - m_last_f);
      m_dg.push_back(g - m_last_g);
      if(m_df.size() > 5) {
        m_df.pop_front();
        m_dg.pop_front();
      }
    }
    m_last_f = f;
    m_last_g = g;
    Eigen::Map<Eigen::VectorXd>(x.data(), x.size()) = g - correction(f);
  }

private:
  Eigen::VectorXd correction(const Eigen::VectorXd& f) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(f.size());
    if(m_df.empty())
      return result;
    Eigen::MatrixXd df(f.size(), m_df.size());
    for(std::size_t k = 0; k < m_df.size(); ++k)
      df.col(k) = m_df[k];
    const Eigen::VectorXd gamma = df.colPivHouseholderQr().solve(f);
    for(std::size_t k = 0; k < m_dg.size(); ++k)
      result += gamma[k] * m_dg[k];
    return result;
  }

  std::deque<Eigen::VectorXd> m_df, m_dg;
  Eigen::VectorXd m_last_f, m_last_g;
};

std::string evaluations_below(const States& states, double energy)
{
  for(const Optimization_state& s : states)
    if(s.energy <= energy)
      return std::to_string(s.evaluations);
  return "> " + std::to_string(states.back().evaluations);
}

struct Case
{
  std::string                        name;
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  Field                              field;
};

CGAL::Anisotropic_mesh_domain_2<K> polygon(const std::vector<Point>& points)
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(points);
  return domain;
}

std::vector<Case> cases()
{
  const double pi = std::acos(-1.), s = 0.1508;
  CGAL::Anisotropic_mesh_domain_2<K> disc;
  disc.add_circle(Point(0, 0), 10);
  return {
    {"disc", disc, [pi](const Point&) { return Tensor::from_sizes(1.5, 0.3, pi / 4); }},
    {"parallelogram", polygon({{0, 0}, {30, 0}, {40, 14}, {10, 14}}), [](const Point&) { return Tensor::from_sizes(2, 0.5); }},
    {"layer10", polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), [](const Point& p) {
       const double d = std::abs(p.y() - 5), h = d/5 + 0.04;
       return Tensor::from_sizes(std::abs(5 - 4*d/5) * h, h); }},
    {"polar-2", polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), [](const Point& p) {
       const double r = std::hypot(p.x(), p.y()), d = (std::min)(10*std::abs(r - 0.5), 1.);
       return Tensor::from_sizes(0.001 + 0.198*std::abs(r - 0.5), 0.1*d + 0.025*(1 - d), std::atan2(p.y(), p.x())); }},
    {"square4, 10 000", polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), [s](const Point& p) {
       return Tensor::from_sizes(s * (0.031 + p.x() / 4), s * (0.031 + p.y() / 4)); }}};
}

} // namespace

int main()
{
  namespace np = CGAL::Anisotropic_mesh_2::parameters;
  using CGAL::Anisotropic_mesh_2::Point_placement;
  std::printf("| case, start | over-relaxed by 1.8 | Anderson | L-BFGS, matrices | L-BFGS, Hessian | of these in all |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for(const Case& c : cases())
    for(const Point_placement placement : {Point_placement::ADVANCING_FRONT, Point_placement::EDGE_SUBDIVISION}) {
      const Mesh mesh = CGAL::make_anisotropic_mesh_2(c.domain, c.field, np::point_placement(placement));
      const double goal = lloyd(mesh).back().energy;
      const States last = by_hessian(mesh);
      std::printf("| `%s`, %s | %s | %s | %s | %s | %zu for %zu iterations |\n", c.name.c_str(),
                  placement == Point_placement::ADVANCING_FRONT ? "fronts" : "edges",
                  evaluations_below(over_relaxed(mesh), goal).c_str(),
                  evaluations_below(fixed_point_iteration(mesh, Anderson()), goal).c_str(),
                  evaluations_below(by_matrices(mesh), goal).c_str(), evaluations_below(last, goal).c_str(),
                  last.back().evaluations, last.back().iteration);
    }
  return 0;
}

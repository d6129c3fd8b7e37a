// The costs that the package promises, beside those of CGAL in the same run:
// building the generalized kernel against a constrained Delaunay triangulation,
// and an iteration of the optimizers against lloyd_optimize_mesh_2().

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Mesh_2/Lloyd_move_2.h>
#include <CGAL/Mesh_2/Mesh_global_optimizer_2.h>
#include <CGAL/Mesh_2/Mesh_sizing_field.h>
#include <CGAL/Random.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef K::Point_2                                          Point;
typedef CGAL::Metric_tensor_2<K>                            Tensor;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

// ------------------------------------------------------------- kernel

std::vector<Point> random_points(std::int64_t n)
{
  CGAL::Random random(1);
  std::vector<Point> points;
  for(std::int64_t i = 0; i < n; ++i)
    points.push_back(Point(random.get_double(0, 4), random.get_double(0, 4)));
  return points;
}

struct Graded
{
  Tensor operator()(const Point& p) const { return Tensor::from_sizes(0.031 + p.x() / 4, 0.031 + p.y() / 4); }
};

struct Rotating
{
  Tensor operator()(const Point& p) const { return Tensor::from_sizes(0.01, 1, 4*p.x() + p.y()); }
};

template <class Triangulation>
void build(benchmark::State& state, const Triangulation& empty)
{
  const std::vector<Point> points = random_points(state.range(0));
  for(auto _ : state) {
    Triangulation t = empty;
    t.insert(points.begin(), points.end());
    benchmark::DoNotOptimize(t.number_of_vertices());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

template <class Field>
void generalized_kernel(benchmark::State& state)
{
  typedef CGAL::Riemannian_metric_traits_2<K, Field> Traits;
  build(state, CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits>(Traits(Field())));
}

void delaunay(benchmark::State& state) { build(state, CGAL::Delaunay_triangulation_2<K>()); }
void constrained_delaunay(benchmark::State& state) { build(state, CGAL::Constrained_Delaunay_triangulation_2<K>()); }

BENCHMARK(delaunay)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(constrained_delaunay)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(generalized_kernel, Graded)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(generalized_kernel, Rotating)->Arg(100000)->Unit(benchmark::kMillisecond);

// ------------------------------------------------------------- iterations

struct Isotropic
{
  double size;
  Tensor operator()(const Point&) const { return Tensor::from_size(size); }
};

// sizes that grow along x and y, of which 10 000 vertices fill the square of side 4 for the scale 0.15
struct Scaled
{
  double scale;
  Tensor operator()(const Point& p) const
  {
    return Tensor::from_sizes(scale * (0.031 + p.x() / 4), scale * (0.031 + p.y() / 4));
  }
};

// a ratio of sizes of 1000, oblique to the axes and slowly turning
struct Thousand_to_one
{
  double size;
  Tensor operator()(const Point& p) const { return Tensor::from_sizes(size / 30, size * 1000 / 30, 0.3 + 1e-4 * p.x()); }
};

CGAL::Anisotropic_mesh_domain_2<K> square(double side)
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<Point>{{0, 0}, {side, 0}, {side, side}, {0, side}});
  return domain;
}

// By subdivision of edges, which leaves enough to do for an optimizer.
template <class Field>
auto mesh_to_optimize(double side, const Field& field)
{
  return CGAL::make_anisotropic_mesh_2
    (square(side), field, np::point_placement(CGAL::Anisotropic_mesh_2::Point_placement::EDGE_SUBDIVISION));
}

Isotropic isotropic(std::int64_t vertices) { return {std::sqrt(2 / std::sqrt(3.) / double(vertices))}; }

constexpr int iterations = 10;

template <class Mesh, class Optimize>
void time_iterations(benchmark::State& state, const Mesh& start, const Optimize& optimize)
{
  for(auto _ : state) {
    state.PauseTiming();
    Mesh mesh = start;
    state.ResumeTiming();
    optimize(mesh);
  }
  state.SetItemsProcessed(state.iterations() * iterations * std::int64_t(start.number_of_vertices()));
}

template <class Mesh>
void time_acvt(benchmark::State& state, const Mesh& start)
{
  time_iterations(state, start, [](Mesh& mesh) {
    CGAL::optimize_anisotropic_mesh_2(mesh, np::convergence(0.).quality_moves(false).number_of_iterations(iterations));
  });
}

// A mesh of the unit square as CGAL makes it, without a metric.
typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<K>,
                                             CGAL::Delaunay_mesh_face_base_2<K> > Tds;
typedef CGAL::Constrained_Delaunay_triangulation_2<K, Tds>                        Cdt;

Cdt cgal_mesh(std::int64_t vertices)
{
  typedef CGAL::Delaunay_mesh_size_criteria_2<Cdt> Criteria;
  Cdt cdt;
  const std::vector<Point> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(corners.begin(), corners.end(), true);
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(0.125, 1.6 / std::sqrt(vertices)));
  mesher.refine_mesh();
  return cdt;
}

// the same mesh with an isotropic metric
auto mesh_of(const Cdt& cdt)
{
  typedef CGAL::Riemannian_metric_traits_2<K, Isotropic> Traits;
  typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits>      Mesh;
  Mesh mesh{Traits(isotropic(cdt.number_of_vertices()))};
  typename Mesh::Boundary_graph boundary;
  std::map<Point, std::size_t> numbers;
  const auto number = [&](const Point& p)
  {
    const auto added = numbers.emplace(p, boundary.points.size());
    if(added.second)
      boundary.points.push_back(p);
    return added.first->second;
  };
  for(auto e = cdt.finite_edges_begin(); e != cdt.finite_edges_end(); ++e)
    if(cdt.is_constrained(*e))
      boundary.segments.push_back({number(e->first->vertex(Cdt::ccw(e->second))->point()),
                                   number(e->first->vertex(Cdt::cw(e->second))->point()), 0, true});
  mesh.insert_boundary(boundary);
  mesh.insert(cdt.points_begin(), cdt.points_end());
  return mesh;
}

void lloyd_iteration(benchmark::State& state)
{
  time_iterations(state, mesh_of(cgal_mesh(state.range(0))), [](auto& mesh) {
    CGAL::optimize_anisotropic_mesh_2(mesh, np::method(CGAL::Anisotropic_mesh_2::Optimization_method::LLOYD)
                                                .convergence(0.).number_of_iterations(iterations));
  });
}

void acvt_iteration(benchmark::State& state) { time_acvt(state, mesh_of(cgal_mesh(state.range(0)))); }

// The classes behind CGAL::lloyd_optimize_mesh_2(), whose interface differs between versions of CGAL.
void cgal_lloyd_iteration(benchmark::State& state)
{
  typedef CGAL::Mesh_2::Mesh_sizing_field<Cdt>    Sizing;
  typedef CGAL::Mesh_2::Lloyd_move_2<Cdt, Sizing> Move;
  const Cdt start = cgal_mesh(state.range(0));
  const int some = state.range(0) < 50000 ? iterations : 2; // minutes would pass
  for(auto _ : state) {
    state.PauseTiming();
    Cdt cdt = start;
    state.ResumeTiming();
    CGAL::Mesh_2::Mesh_global_optimizer_2<Cdt, Move> optimizer(cdt, 0., 0.);
    optimizer.set_time_limit(0); // none; not set by the constructor
    optimizer(some);
  }
  state.SetItemsProcessed(state.iterations() * some * std::int64_t(start.number_of_vertices()));
}

void acvt_iteration_graded(benchmark::State& state)
{
  time_acvt(state, mesh_to_optimize(4, Scaled{std::sqrt(226.88 / double(state.range(0)))}));
}

void acvt_iteration_1000_to_1(benchmark::State& state)
{
  time_acvt(state, mesh_to_optimize(1, Thousand_to_one{isotropic(state.range(0)).size}));
}

BENCHMARK(cgal_lloyd_iteration)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(lloyd_iteration)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(acvt_iteration)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(acvt_iteration_graded)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(acvt_iteration_1000_to_1)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

// ------------------------------------------------------------- from nothing

template <class Field>
void time_meshing(benchmark::State& state, double side, const Field& field)
{
  const auto domain = square(side);
  std::size_t n = 0;
  for(auto _ : state)
    n = CGAL::make_anisotropic_mesh_2(domain, field).number_of_vertices();
  state.SetItemsProcessed(state.iterations() * std::int64_t(n));
}

void unit_mesh(benchmark::State& state) { time_meshing(state, 1, isotropic(state.range(0))); }

void unit_mesh_graded(benchmark::State& state)
{
  time_meshing(state, 4, Scaled{std::sqrt(226.88 / double(state.range(0)))});
}

void unit_mesh_1000_to_1(benchmark::State& state)
{
  time_meshing(state, 1, Thousand_to_one{isotropic(state.range(0)).size});
}

BENCHMARK(unit_mesh)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(unit_mesh_graded)->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(unit_mesh_1000_to_1)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

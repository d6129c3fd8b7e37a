// The cavity criterion in plain doubles, filtered, and by intervals from the
// start, on the arguments that the construction of a mesh asks for; and what
// the filter costs in that construction.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel  K;
typedef CGAL::Simple_cartesian<double>                       Double;
typedef CGAL::Metric_tensor_2<K>                             Tensor;

template <class Kernel>
using Traits_of = CGAL::Riemannian_metric_traits_2<Kernel,
                    std::function<CGAL::Metric_tensor_2<Kernel>(const typename Kernel::Point_2&)> >;

template <class Kernel>
struct Arguments
{
  std::array<typename Kernel::Point_2, 4>          points;
  std::array<CGAL::Metric_tensor_2<Kernel>, 4>     tensors;
};

struct Square4 // about 10 000 vertices
{
  Tensor operator()(const K::Point_2& p) const
  { return Tensor::from_sizes(0.1507 * (0.031 + p.x() / 4), 0.1507 * (0.031 + p.y() / 4)); }
};

struct Turning
{
  Tensor operator()(const K::Point_2& p) const { return Tensor::from_sizes(0.02, 0.4, 3*p.x()); }
};

template <class Field>
std::vector<K::Point_2> vertices()
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<K::Point_2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto mesh = CGAL::make_anisotropic_mesh_2(square, Field());
  std::vector<K::Point_2> points;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    points.push_back(v->point());
  return points;
}

// traits that write down what is asked
template <class Field>
struct Recording_traits : public CGAL::Riemannian_metric_traits_2<K, Field>
{
  typedef CGAL::Riemannian_metric_traits_2<K, Field> Base;

  struct Side_of_metric_circle_2
  {
    std::vector<Arguments<K> >* record;

    CGAL::Oriented_side operator()(const K::Point_2& a, const K::Point_2& b, const K::Point_2& c, const K::Point_2& p,
                                   const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
    {
      record->push_back({{a, b, c, p}, {ma, mb, mc, mp}});
      return typename Base::Side_of_metric_circle_2()(a, b, c, p, ma, mb, mc, mp);
    }
  };

  Recording_traits() {}
  explicit Recording_traits(std::vector<Arguments<K> >& record) : Base(Field()), m_record(&record) {}
  Side_of_metric_circle_2 side_of_metric_circle_2_object() const { return {m_record}; }

private:
  std::vector<Arguments<K> >* m_record = nullptr;
};

template <class Field>
std::vector<Arguments<K> > recorded_arguments()
{
  std::vector<Arguments<K> > record;
  const std::vector<K::Point_2> points = vertices<Field>();
  CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Recording_traits<Field> > t{Recording_traits<Field>(record)};
  t.insert(points.begin(), points.end());
  return record;
}

template <class Kernel, class Predicate>
void measure(benchmark::State& state, const std::vector<Arguments<Kernel> >& arguments, const Predicate& side)
{
  for(auto _ : state) {
    long inside = 0;
    for(const auto& a : arguments)
      inside += CGAL::possibly(side(a.points[0], a.points[1], a.points[2], a.points[3],
                                    a.tensors[0], a.tensors[1], a.tensors[2], a.tensors[3]) == CGAL::ON_POSITIVE_SIDE);
    benchmark::DoNotOptimize(inside);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(arguments.size()));
}

template <class Field>
void plain(benchmark::State& state)
{
  const CGAL::Cartesian_converter<K, Double> convert;
  std::vector<Arguments<Double> > arguments;
  for(const auto& a : recorded_arguments<Field>()) {
    arguments.emplace_back();
    for(int i = 0; i < 4; ++i) {
      arguments.back().points[i] = convert(a.points[i]);
      arguments.back().tensors[i] = CGAL::Metric_tensor_2<Double>(a.tensors[i], convert);
    }
  }
  measure(state, arguments, Traits_of<Double>::Side_of_metric_circle_2());
}

template <class Field>
void filtered(benchmark::State& state)
{
  measure(state, recorded_arguments<Field>(), Traits_of<K>::Side_of_metric_circle_2());
}

template <class Field>
void intervals(benchmark::State& state)
{
  const Traits_of<K>::Side_of_metric_circle_2 side{};
  measure(state, recorded_arguments<Field>(), [&](const auto&... arguments) { return side.by_intervals(arguments...); });
}

// The whole construction, with one or the other criterion on the same points.
template <class Field>
struct Plain_traits : public CGAL::Riemannian_metric_traits_2<K, Field>
{
  using CGAL::Riemannian_metric_traits_2<K, Field>::Riemannian_metric_traits_2;
  typedef CGAL::Anisotropic_mesh_2::internal::Side_of_metric_circle_2<K> Side_of_metric_circle_2;
  Side_of_metric_circle_2 side_of_metric_circle_2_object() const { return Side_of_metric_circle_2(); }
};

template <class Traits>
void construction(benchmark::State& state)
{
  const std::vector<K::Point_2> points = vertices<typename Traits::Metric_field>();
  for(auto _ : state) {
    CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits> t{Traits(typename Traits::Metric_field())};
    t.insert(points.begin(), points.end());
    benchmark::DoNotOptimize(t.number_of_vertices());
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(points.size()));
}

BENCHMARK_TEMPLATE(plain, Square4)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(filtered, Square4)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(intervals, Square4)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(plain, Turning)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(filtered, Turning)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(intervals, Turning)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(construction, Plain_traits<Square4>)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(construction, CGAL::Riemannian_metric_traits_2<K, Square4>)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

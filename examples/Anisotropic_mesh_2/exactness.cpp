// What exact decisions cost, and what happens without them: the same points are
// triangulated with a cavity criterion in plain doubles, with the filtered one,
// and with exact numbers throughout.
//
//   exactness [NUMBER_OF_POINTS]

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using Epick  = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck  = CGAL::Exact_predicates_exact_constructions_kernel;
using Double = CGAL::Simple_cartesian<double>;
using Point  = Epick::Point_2;
using Points = std::vector<Point>;
using Tensor = CGAL::Metric_tensor_2<Epick>;
using Field  = std::function<Tensor(const Point&)>;

template <class Kernel>
using Field_of = std::function<CGAL::Metric_tensor_2<Kernel>(const typename Kernel::Point_2&)>;

using Filtered_traits = CGAL::Riemannian_metric_traits_2<Epick, Field>;
using Plain_side      = CGAL::Riemannian_metric_traits_2<Double, Field_of<Double> >::Side_of_metric_circle_2;

// ------------------------------------------------- traits of one's own: replace one functor

CGAL::Oriented_side plain_side(const std::array<Point, 4>& p, const std::array<Tensor, 4>& m)
{
  const CGAL::Cartesian_converter<Epick, Double> convert;
  const auto tensor = [&](int i) { return CGAL::Metric_tensor_2<Double>(m[i], convert); };
  return Plain_side()(convert(p[0]), convert(p[1]), convert(p[2]), convert(p[3]),
                      tensor(0), tensor(1), tensor(2), tensor(3));
}

// Only the criterion is plain: CGAL's point location asks for an exact orientation test.
struct Plain_traits : public Filtered_traits
{
  using Filtered_traits::Filtered_traits;
  static constexpr bool has_exact_predicates = false;

  struct Side_of_metric_circle_2
  {
    CGAL::Oriented_side operator()(const Point& a, const Point& b, const Point& c, const Point& p,
                                   const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
    {
      return plain_side({a, b, c, p}, {ma, mb, mc, mp});
    }
  };

  Side_of_metric_circle_2 side_of_metric_circle_2_object() const { return {}; }
};

struct Counts { long calls = 0, wrong = 0, not_by_doubles = 0, not_by_intervals = 0; };

// Decides exactly, and counts what each stage of the filter would have said.
struct Counting_traits : public Filtered_traits
{
  Counting_traits() {}
  Counting_traits(const Field& field, Counts& counts) : Filtered_traits(field), m_counts(&counts) {}

  struct Side_of_metric_circle_2
  {
    Counts* counts;

    CGAL::Oriented_side operator()(const Point& a, const Point& b, const Point& c, const Point& p,
                                   const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
    {
      const Filtered_traits::Side_of_metric_circle_2 filtered{};
      const CGAL::Oriented_side side = filtered(a, b, c, p, ma, mb, mc, mp);
      ++counts->calls;
      counts->wrong += plain_side({a, b, c, p}, {ma, mb, mc, mp}) != side;
      if(!CGAL::is_certain(filtered.by_doubles(a, b, c, p, ma, mb, mc, mp))) {
        ++counts->not_by_doubles;
        counts->not_by_intervals += !CGAL::is_certain(filtered.by_intervals(a, b, c, p, ma, mb, mc, mp));
      }
      return side;
    }
  };

  Side_of_metric_circle_2 side_of_metric_circle_2_object() const { return {m_counts}; }

private:
  Counts* m_counts = nullptr;
};

// ------------------------------------------------- building and comparing

template <class Traits>
using Triangulation = CGAL::Constrained_anisotropic_Delaunay_triangulation_2<Traits>;

// the median time of three
template <class Traits, class Point_range>
double build(Triangulation<Traits>& t, const Point_range& points)
{
  std::array<double, 3> times;
  for(double& time : times) {
    t.clear();
    CGAL::Real_timer timer;
    timer.start();
    t.insert(points.begin(), points.end());
    time = timer.time();
  }
  std::sort(times.begin(), times.end());
  return times[1];
}

// the exact triangulation, with the tensors of the other ones
double build_exactly(const Field& field, const Points& points)
{
  const CGAL::Cartesian_converter<Epick, Epeck> convert;
  const Field_of<Epeck> exact_field = [&](const Epeck::Point_2& p) {
    return CGAL::Metric_tensor_2<Epeck>(field(Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()))), convert);
  };
  std::vector<Epeck::Point_2> exact_points;
  for(const Point& p : points)
    exact_points.push_back(convert(p));
  using Traits = CGAL::Riemannian_metric_traits_2<Epeck, Field_of<Epeck> >;
  Triangulation<Traits> t{Traits(exact_field)};
  return build(t, exact_points);
}

template <class T>
std::vector<std::pair<Point, Point> > edges(const T& t)
{
  std::vector<std::pair<Point, Point> > result;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    const Point p = e->first->vertex(t.ccw(e->second))->point(), q = e->first->vertex(t.cw(e->second))->point();
    result.push_back(std::minmax(p, q));
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class T, class U>
long number_of_different_edges(const T& t, const U& u)
{
  const auto a = edges(t), b = edges(u);
  std::vector<std::pair<Point, Point> > difference;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(difference));
  return long(difference.size());
}

void experiment(const char* metric, const Field& field, const char* set, const Points& points)
{
  Triangulation<Plain_traits> plain{Plain_traits(field)};
  Triangulation<Filtered_traits> filtered{Filtered_traits(field)};
  const double plain_time = build(plain, points), filtered_time = build(filtered, points);
  const double exact_time = build_exactly(field, points);

  Counts counts;
  Triangulation<Counting_traits> counting{Counting_traits(field, counts)};
  counting.insert(points.begin(), points.end());

  const double percent = 100. / double((std::max)(1L, counts.calls));
  std::printf("| %-18s | %-14s | %6ld | %6.3f %% | %5ld | %6.2f %% | %6.2f %%  | %8.2f | %5.1f |\n", metric, set,
              counts.calls, percent * double(counts.wrong), number_of_different_edges(filtered, plain),
              percent * double(counts.not_by_doubles), percent * double(counts.not_by_intervals),
              filtered_time / plain_time, exact_time / plain_time);
}

// ------------------------------------------------- points and metrics

Points random_points(int n)
{
  CGAL::Random random(1);
  Points points;
  for(int i = 0; i < n; ++i) {
    const double x = random.get_double();
    points.push_back(Point(x, random.get_double()));
  }
  return points;
}

Points grid(int n)
{
  const int side = int(std::sqrt(double(n)));
  Points points;
  for(int i = 0; i < n; ++i)
    points.push_back(Point(double(i % side) / side, double(i / side) / side));
  return points;
}

// up to rounding on an ellipse that is a circle in the metric of sizes h and 1
Points ellipse(int n, double h)
{
  CGAL::Random random(2);
  Points points;
  for(int i = 0; i < n; ++i) {
    const double angle = 6.283 * random.get_double(), u = h * std::cos(angle), v = std::sin(angle);
    points.push_back(Point(0.8*u - 0.6*v, 0.6*u + 0.8*v));
  }
  return points;
}

Field smooth()
{
  return [](const Point& p) { return Tensor::from_sizes(0.03 + p.x() / 4, 0.03 + p.y() / 4); };
}

Field turning(double h)
{
  return [h](const Point& p) { return Tensor::from_sizes(h, 1, 3*p.x() + p.y()); };
}

Field constant(double h)
{
  return [h](const Point&) { return Tensor::from_sizes(h, 1, std::atan2(0.6, 0.8)); };
}

int main(int argc, char* argv[])
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 1000;
  std::printf("| metric             | points         | calls  | wrong    | edges | doubles  | intervals | filtered | exact |\n"
              "| ------------------ | -------------- | ------ | -------- | ----- | -------- | --------- | -------- | ----- |\n");
  for(const auto& set : {std::make_pair("random", random_points(n)), std::make_pair("grid", grid(n))}) {
    experiment("smooth", smooth(), set.first, set.second);
    experiment("turning 1 000", turning(1e-3), set.first, set.second);
    experiment("turning 1 000 000", turning(1e-6), set.first, set.second);
    experiment("constant 1 000", constant(1e-3), set.first, set.second);
    experiment("constant 1 000 000", constant(1e-6), set.first, set.second);
  }
  experiment("constant 1 000", constant(1e-3), "on one ellipse", ellipse(n, 1e-3));
  experiment("constant 1 000 000", constant(1e-6), "on one ellipse", ellipse(n, 1e-6));
  std::printf("\nmetric: with the ratio of its sizes; wrong: decisions of the plain criterion that are; edges: of the exact\n"
              "triangulation that the plain one has not; doubles, intervals: decisions that they left open; filtered,\n"
              "exact: time over that of the plain one\n");
  return 0;
}

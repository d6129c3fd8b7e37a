// How the qualities of the triangles are distributed, before and after
// optimization, for figure 5.3 of Du and Wang: the sizes as the paper reports them to
// work, and as printed, which change by a factor of two within a triangle. The quality
// of a triangle is 1 if it is equilateral in the metric at its barycentre.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/centroid.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using K         = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point     = K::Point_2;
using Tensor    = CGAL::Metric_tensor_2<K>;
using Histogram = std::array<double, 50>; // shares of the triangles, in percent

double quality(const Point& a, const Point& b, const Point& c, const Tensor& m)
{
  const double squares = m.squared_length(b - a) + m.squared_length(c - b) + m.squared_length(a - c);
  return 4 * std::sqrt(3.) * m.area_density() * CGAL::to_double(CGAL::area(a, b, c)) / squares;
}

template <class Mesh, class Field>
Histogram qualities(const Mesh& mesh, const Field& field)
{
  Histogram histogram = {};
  const double share = 100 / double(mesh.number_of_faces_in_domain());
  for(auto f : mesh.finite_face_handles()) {
    if(!f->is_in_domain())
      continue;
    const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    const double q = quality(a, b, c, field(CGAL::centroid(a, b, c)));
    const double bin = (std::min)(q, 0.999) * double(histogram.size());
    histogram[std::size_t(bin)] += share;
  }
  return histogram;
}

template <class Field>
void compare(const std::string& name, const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  auto mesh = CGAL::make_anisotropic_mesh_2(square, field);
  const Histogram before = qualities(mesh, field);
  CGAL::optimize_anisotropic_mesh_2(mesh);
  const Histogram after = qualities(mesh, field);
  for(std::size_t i = 0; i < before.size(); ++i)
    std::cout << name << '\t' << double(i) / double(before.size()) << '\t'
              << before[i] << '\t' << after[i] << '\n';
}

int main()
{
  const auto first = [](const Point& p) { return std::abs(p.y() - 5) / 5 + 0.04; };
  const auto second = [first](const Point& p) { return (5 - 4 * std::abs(p.y() - 5) / 5) * first(p); };

  std::cout << "case\tquality from\tunit mesh %\toptimized %\n";
  compare("layer10", [=](const Point& p) { return Tensor::from_sizes(second(p), first(p)); });
  compare("square10", [=](const Point& p) { return Tensor::from_sizes(first(p), second(p)); });
  return 0;
}

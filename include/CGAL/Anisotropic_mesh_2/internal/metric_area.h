// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_AREA_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_AREA_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/point_at.h>
#include <CGAL/Too_many_vertices_exception.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The integral of a density over triangles by a rule of degree 5 with seven
// points, quartered until four parts agree with the whole. The number of
// quarterings in all is bounded.
template <class Density>
class Adaptive_triangle_integral
{
public:
  Adaptive_triangle_integral(const Density& density, double relative_tolerance, std::size_t maximum_quarterings)
    : m_density(density), m_tolerance(relative_tolerance), m_budget(maximum_quarterings)
  {}

  typedef std::array<Vector_of_doubles, 3> Triangle;

  double operator()(const Triangle& t) { return refined(t, rule(t), maximum_depth); }

private:
  static constexpr int maximum_depth = 24;

  double refined(const Triangle& t, double whole, int depth)
  {
    if(depth == 0 || m_budget == 0)
      return whole;
    --m_budget;
    const std::array<Triangle, 4> parts = quarters(t);
    std::array<double, 4> values;
    double sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += values[i] = rule(parts[i]);
    if(std::abs(sum - whole) <= m_tolerance * sum)
      return sum;
    sum = 0;
    for(int i = 0; i < 4; ++i)
      sum += refined(parts[i], values[i], depth - 1);
    return sum;
  }

  static std::array<Triangle, 4> quarters(const Triangle& t)
  {
    const auto middle = [](const Vector_of_doubles& p, const Vector_of_doubles& q)
                        { return Vector_of_doubles{(p.x + q.x) / 2, (p.y + q.y) / 2}; };
    const Vector_of_doubles a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    return {{{{t[0], c, b}}, {{t[1], a, c}}, {{t[2], b, a}}, {{a, b, c}}}};
  }

  double rule(const Triangle& t) const
  {
    static const double r = std::sqrt(15.);
    const double outer = (6 - r) / 21, inner = (6 + r) / 21;
    const double sum = 0.225 * at(t, 1./3, 1./3)
      + (155 - r) / 1200 * (at(t, outer, outer) + at(t, outer, 1 - 2*outer) + at(t, 1 - 2*outer, outer))
      + (155 + r) / 1200 * (at(t, inner, inner) + at(t, inner, 1 - 2*inner) + at(t, 1 - 2*inner, inner));
    const double area = ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
    return area * sum;
  }

  double at(const Triangle& t, double l1, double l2) const
  {
    return m_density(t[0].x + l1 * (t[1].x - t[0].x) + l2 * (t[2].x - t[0].x),
                     t[0].y + l1 * (t[1].y - t[0].y) + l2 * (t[2].y - t[0].y));
  }

  Density     m_density;
  double      m_tolerance;
  std::size_t m_budget;
};

// The integral of (det M)^exponent over the domain of a mesh: its area in the
// metric for 1/2.
template <class Mesh>
double metric_area(const Mesh& mesh, double exponent, double relative_tolerance,
                   std::size_t maximum_quarterings)
{
  const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
  const auto density = [&](double x, double y) {
    const double det = CGAL::to_double(tensor(point_at<typename Mesh::Point>(x, y)).determinant());
    return exponent == 0.5 ? std::sqrt(det) : std::pow(det, exponent);
  };
  Adaptive_triangle_integral<decltype(density)> integral(density, relative_tolerance, maximum_quarterings);
  double sum = 0;
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f) {
    if(!f->is_in_domain())
      continue;
    std::array<Vector_of_doubles, 3> t;
    for(int i = 0; i < 3; ++i)
      t[i] = {CGAL::to_double(f->vertex(i)->point().x()), CGAL::to_double(f->vertex(i)->point().y())};
    sum += integral(t);
  }
  return sum;
}

// A unit mesh has 2/sqrt(3) vertices per unit of metric area.
inline double ideal_number_of_vertices(double metric_area) { return 2 / std::sqrt(3.) * metric_area; }

template <class Mesh>
void check_ideal_number_of_vertices(const Mesh& mesh, std::size_t limit)
{
  const double ideal = ideal_number_of_vertices(metric_area(mesh, 0.5, 0.05, 100000));
  if(ideal > 1.5 * double(limit)) // an estimate must not refuse what just fits
    throw Too_many_vertices_exception(ideal, limit);
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_AREA_H

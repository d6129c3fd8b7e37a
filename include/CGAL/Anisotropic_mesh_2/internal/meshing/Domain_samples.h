// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_DOMAIN_SAMPLES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_DOMAIN_SAMPLES_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Anisotropic_mesh_2::internal {

// The points of a lattice of equilateral triangles that lie in given triangles: no disc of more
// than 0.62 times the square root of a cell's area is without one. The lattice is turned, so that
// lines and cells along the axes do not fall between its points.
class Domain_samples
{
public:
  explicit Domain_samples(double area_of_cell)
    : m_spacing(std::sqrt(2 / std::sqrt(3.) * area_of_cell)),
      m_along{m_spacing * std::cos(turn), m_spacing * std::sin(turn)},
      m_across{m_spacing * std::cos(turn + sixty_degrees), m_spacing * std::sin(turn + sixty_degrees)}
  {}

  template <class Visit>
  void for_each_in(const Triangle_of_doubles& t, const Visit& visit) const
  {
    const Triangle_of_doubles l = {in_lattice(t[0]), in_lattice(t[1]), in_lattice(t[2])};
    const auto y = std::minmax({l[0].y, l[1].y, l[2].y});
    if(!are_countable(y.first, y.second))
      return;
    for(double row = std::ceil(y.first); row <= y.second; ++row) {
      double from = HUGE_VAL, to = -HUGE_VAL;
      for(int i = 0; i < 3; ++i)
        extend(l[i], l[(i + 1) % 3], row, from, to);
      if(!are_countable(from, to))
        continue;
      for(double column = std::ceil(from); column <= to; ++column)
        visit(Vector_of_doubles{column*m_along.x + row*m_across.x, column*m_along.y + row*m_across.y});
    }
  }

private:
  static constexpr double turn = 0.4, sixty_degrees = CGAL_PI / 3; // radians
  static constexpr double maximum_extent = 1e5; // needles that are longer are not worth it

  // Whether the whole numbers from the first to the last are not too many, and not so large that the next one is the
  // same.
  static bool are_countable(double first, double last)
  {
    return last - first <= maximum_extent && (std::max)(std::abs(first), std::abs(last)) < 1e15;
  }

  Vector_of_doubles in_lattice(const Vector_of_doubles& p) const
  {
    const double det = m_along.x*m_across.y - m_along.y*m_across.x;
    return {(p.x*m_across.y - p.y*m_across.x) / det, (m_along.x*p.y - m_along.y*p.x) / det};
  }

  // by where the edge from a to b meets the row
  static void extend(const Vector_of_doubles& a, const Vector_of_doubles& b, double row, double& from, double& to)
  {
    if((a.y < row) == (b.y < row))
      return;
    const double x = a.x + (b.x - a.x) * ((row - a.y) / (b.y - a.y));
    from = (std::min)(from, x);
    to = (std::max)(to, x);
  }

  double            m_spacing;
  Vector_of_doubles m_along, m_across;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_DOMAIN_SAMPLES_H

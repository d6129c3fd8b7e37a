// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DESCRIBE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DESCRIBE_H

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// the shortest of the usual notations that reads back as the same number
inline std::string describe(double x)
{
  if(std::isnan(x))
    return "nan"; // whatever its sign
  std::string text;
  for(int digits = 15; digits <= 17; ++digits) {
    std::ostringstream os;
    os.precision(digits);
    os << x;
    text = os.str();
    if(std::strtod(text.c_str(), nullptr) == x)
      break;
  }
  return text;
}

inline std::string describe(double x, double y)
{
  return "(" + describe(x) + ", " + describe(y) + ")";
}

template <class Point>
std::string describe(const Point& p)
{
  return describe(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_DESCRIBE_H

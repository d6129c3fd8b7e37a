// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SUMMARY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SUMMARY_H

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Anisotropic_mesh_2::internal {

// of some values
struct Summary
{
  std::size_t number = 0;
  double sum = 0, least = std::numeric_limits<double>::infinity(), largest = -least;

  void add(double value)
  {
    ++number;
    sum += value;
    least = (std::min)(least, value);
    largest = (std::max)(largest, value);
  }

  Summary& operator+=(const Summary& s)
  {
    number += s.number;
    sum += s.sum;
    least = (std::min)(least, s.least);
    largest = (std::max)(largest, s.largest);
    return *this;
  }

  double mean() const { return sum / double(number); }
};

// of the lengths of edges
struct Edge_summary
{
  Summary     lengths;
  std::size_t unit = 0; // in the unit band

  void add(double length)
  {
    lengths.add(length);
    unit += length * length >= 0.5 && length * length <= 2;
  }

  Edge_summary& operator+=(const Edge_summary& s)
  {
    lengths += s.lengths;
    unit += s.unit;
    return *this;
  }

  double unit_share() const { return double(unit) / double(lengths.number); }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_SUMMARY_H

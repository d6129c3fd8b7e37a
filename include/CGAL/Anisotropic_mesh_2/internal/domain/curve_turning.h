// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CURVE_TURNING_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CURVE_TURNING_H

#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The angles, in radians, between the chords of N equal parts of [t0, t1].
template <std::size_t N, class K>
std::array<double, N - 1> turning_angles(const Curve_piece_2<K>& curve, double t0, double t1)
{
  std::array<std::pair<double, double>, N> chords;
  typename K::Point_2 last = curve.point(t0);
  for(std::size_t i = 0; i < N; ++i) {
    const typename K::Point_2 next = curve.point(i + 1 == N ? t1 : t0 + double(i + 1)/N * (t1 - t0));
    chords[i] = std::make_pair(CGAL::to_double(next.x() - last.x()), CGAL::to_double(next.y() - last.y()));
    last = next;
  }
  std::array<double, N - 1> angles;
  for(std::size_t i = 0; i + 1 < N; ++i) {
    const auto &u = chords[i], &v = chords[i+1];
    angles[i] = std::abs(std::atan2(u.first*v.second - u.second*v.first, u.first*v.first + u.second*v.second));
  }
  return angles;
}

// The turning within [t0, t1] that four chords show, 3/4 of the whole for an arc.
template <class K>
double turning(const Curve_piece_2<K>& curve, double t0, double t1)
{
  double sum = 0;
  for(double angle : turning_angles<4>(curve, t0, t1))
    sum += angle;
  return sum;
}

// Tells whether the strongest turning within [t0, t1] is a corner, which no
// subdivision smooths: it is the same at a 10^6 times smaller scale.
template <class K>
bool has_corner(const Curve_piece_2<K>& curve, double t0, double t1)
{
  double strongest = 0;
  for(int zoom = 0; zoom < 10; ++zoom) {
    const std::array<double, 7> angles = turning_angles<8>(curve, t0, t1);
    std::size_t place = 0;
    for(std::size_t i = 1; i < angles.size(); ++i)
      if(angles[i] > angles[place])
        place = i;
    strongest = angles[place];
    const double part = (t1 - t0) / 8;
    t0 += double(place) * part;
    t1 = t0 + 2*part;
  }
  return strongest > 0.25;
}

// Parameters from 0 to 1 that cut the curve into parts of which none turns by
// more than about `angle`; at least 8 parts, and at most 2^12 in one of them.
template <class K>
std::vector<double> parameters_of_flat_parts(const Curve_piece_2<K>& curve, double angle)
{
  static constexpr double smallest = 1. / (8 * 4096);
  std::vector<double> parameters(1, 0.), ends;
  for(int i = 8; i > 0; --i)
    ends.push_back(i / 8.);
  while(!ends.empty()) {
    const double t0 = parameters.back(), t1 = ends.back();
    if(t1 - t0 > smallest && turning(curve, t0, t1) > 0.75 * angle)
      ends.push_back((t0 + t1) / 2);
    else {
      parameters.push_back(t1);
      ends.pop_back();
    }
  }
  return parameters;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DOMAIN_CURVE_TURNING_H

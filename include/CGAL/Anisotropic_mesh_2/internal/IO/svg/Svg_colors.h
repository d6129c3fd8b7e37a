// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_COLORS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_COLORS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

typedef std::array<double, 3> Svg_color; // red, green, blue, up to 255

// between two colors
inline Svg_color mixed(const Svg_color& a, const Svg_color& b, double share_of_b)
{
  Svg_color result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = (1 - share_of_b) * a[i] + share_of_b * b[i];
  return result;
}

inline std::string name_of(const Svg_color& color)
{
  static const char* const digits = "0123456789abcdef";
  std::string name = "#";
  for(double c : color) {
    const long value = std::lround(c);
    name += digits[value / 16];
    name += digits[value % 16];
  }
  return name;
}

constexpr std::size_t number_of_svg_colors = 8;

// Colors that people who see few colors can tell apart: those of Okabe and Ito, yellow last, which is
// hardly seen as a line. After eight they come again, darker.
inline Svg_color strong_color(std::size_t i)
{
  static constexpr Svg_color colors[number_of_svg_colors] = {
    {0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167},
    {86, 180, 233}, {230, 159, 0}, {128, 128, 128}, {240, 228, 66}};
  const double darkness = 1 - std::pow(0.8, static_cast<double>(i / number_of_svg_colors));
  return mixed(colors[i % number_of_svg_colors], {0, 0, 0}, darkness);
}

inline Svg_color soft_color(std::size_t i) { return mixed(strong_color(i), {255, 255, 255}, 0.75); }

// Numbers of colors, different for those that are adjacent. All of the first eight are used about as often, more
// only where they are needed.
inline std::vector<std::size_t> colors_of(const std::vector<std::vector<std::size_t> >& adjacent)
{
  std::vector<std::size_t> uses(number_of_svg_colors, 0), colors(adjacent.size(), static_cast<std::size_t>(-1));
  for(std::size_t i = 0; i < adjacent.size(); ++i) {
    std::vector<bool> is_taken(uses.size() + 1, false);
    for(std::size_t j : adjacent[i])
      if(colors[j] < is_taken.size())
        is_taken[colors[j]] = true;
    std::size_t best = uses.size();
    for(std::size_t c = uses.size(); c-- > 0;)
      if(!is_taken[c] && (best == uses.size() || uses[c] <= uses[best]))
        best = c;
    if(best == uses.size())
      uses.push_back(0);
    ++uses[best];
    colors[i] = best;
  }
  return colors;
}

// Numbers of colors for references, different for those of elements that share a vertex. Each
// element is given by a vertex and its reference, once for each of its vertices.
inline std::map<int, std::size_t> colors_of_references(std::vector<std::pair<std::size_t, int> > uses)
{
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  std::map<int, std::size_t> number;
  for(const auto& use : uses)
    number[use.second] = 0;
  std::size_t n = 0;
  for(auto& reference : number)
    reference.second = n++;
  std::vector<std::vector<std::size_t> > adjacent(n);
  for(std::size_t first = 0, i = 0; i < uses.size(); ++i) {
    while(uses[first].first != uses[i].first)
      ++first;
    for(std::size_t j = first; j < i; ++j) {
      adjacent[number[uses[i].second]].push_back(number[uses[j].second]);
      adjacent[number[uses[j].second]].push_back(number[uses[i].second]);
    }
  }
  const std::vector<std::size_t> colors = colors_of(adjacent);
  for(auto& reference : number)
    reference.second = colors[reference.second];
  return number;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_SVG_SVG_COLORS_H

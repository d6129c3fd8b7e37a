// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of Voronoi diagrams have in common: meshes of given
// generators, polygons, and what holds for all diagrams.

#ifndef ANISOTROPIC_MESH_2_TEST_VORONOI_DIAGRAMS_H
#define ANISOTROPIC_MESH_2_TEST_VORONOI_DIAGRAMS_H

#include "check.h"
#include "meshes.h"
#include "Random_numbers.h"

#include <CGAL/Anisotropic_Voronoi_diagram_2.h>
#include <CGAL/Anisotropic_mesh_2/Labelle_Shewchuk_distance_2.h>
#include <CGAL/Anisotropic_mesh_2/Multiplicative_weight_distance_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

typedef std::vector<Point>                                         Polygon;
typedef CGAL::Riemannian_metric_traits_2<K, Field>                 Metric_traits;
typedef std::function<double(Mesh::Vertex_handle)>                 Weight;
typedef CGAL::Anisotropic_mesh_2::Directional_distance_2           Directional;
typedef CGAL::Anisotropic_mesh_2::Labelle_Shewchuk_distance_2      Labelle_Shewchuk;
typedef CGAL::Anisotropic_mesh_2::Multiplicative_weight_distance_2<Weight> Weighted;
typedef CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Directional>     Diagram;
using CGAL::Anisotropic_mesh_2::Measure;

// ---------------------------------------------------------------- meshes

// A convex polygon and points in it, all of them generators.
inline Mesh mesh_of(const Polygon& boundary, const std::vector<Point>& inner, const Field& field)
{
  Mesh mesh{Metric_traits(field)};
  Mesh::Boundary_graph b;
  b.points = boundary;
  for(std::size_t i = 0; i < boundary.size(); ++i)
    b.segments.push_back({i, (i + 1) % boundary.size(), 1, true});
  mesh.insert_boundary(b);
  for(const Point& p : inner)
    mesh.insert(p);
  return mesh;
}

inline Polygon square() { return {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)}; }

inline std::vector<Point> random_points(int n, unsigned seed)
{
  Random_numbers random(seed);
  std::vector<Point> points;
  for(int i = 0; i < n; ++i) {
    const double x = random.real(-1, 1);
    points.push_back(Point(x, random.real(-1, 1)));
  }
  return points;
}

template <class Diagram>
std::size_t index_of(const Diagram& diagram, const Point& generator)
{
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i)
    if(diagram.region(i).generator == generator)
      return i;
  CHECK_MSG(false, "no such generator");
  return 0;
}

// ---------------------------------------------------------------- polygons

inline double signed_area(const Polygon& p)
{
  double sum = 0;
  for(std::size_t i = 2; i < p.size(); ++i)
    sum += CGAL::area(p[0], p[i - 1], p[i]);
  return sum;
}

inline double signed_area(const std::vector<Polygon>& boundaries)
{
  double sum = 0;
  for(const Polygon& p : boundaries)
    sum += signed_area(p);
  return sum;
}

inline Point centroid(const std::vector<Polygon>& boundaries)
{
  double area = 0, x = 0, y = 0;
  for(const Polygon& p : boundaries)
    for(std::size_t i = 2; i < p.size(); ++i) {
      const double a = CGAL::area(p[0], p[i - 1], p[i]);
      area += a;
      x += a * (p[0].x() + p[i - 1].x() + p[i].x()) / 3;
      y += a * (p[0].y() + p[i - 1].y() + p[i].y()) / 3;
    }
  return Point(x / area, y / area);
}

// whether a ray from x crosses the boundaries an odd number of times
inline bool contains(const std::vector<Polygon>& boundaries, const Point& x)
{
  bool is_inside = false;
  for(const Polygon& polygon : boundaries)
    for(std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Point &p = polygon[i], &q = polygon[j];
      if((p.y() > x.y()) != (q.y() > x.y())
         && x.x() < p.x() + (q.x() - p.x()) * (x.y() - p.y()) / (q.y() - p.y()))
        is_inside = !is_inside;
    }
  return is_inside;
}

// ---------------------------------------------------------------- what holds for all diagrams

template <class Piece>
void check_piece(const Piece& piece, const Point& generator, double scale, const std::string& name)
{
  CHECK_MSG(std::abs(signed_area(piece.boundaries) - piece.area) <= 1e-10 * scale,
            name + ": area " + std::to_string(piece.area) + " in boundaries of "
            + std::to_string(signed_area(piece.boundaries)));
  bool has_generator = contains(piece.boundaries, generator);
  for(const Polygon& p : piece.boundaries)
    has_generator = has_generator || std::count(p.begin(), p.end(), generator) > 0;
  CHECK_MSG(piece.is_main == has_generator, name);
}

// Tiles, pieces and boundaries have the areas that they should, and the regions that of the domain.
template <class Diagram>
void check_areas(const Diagram& diagram, const Mesh& mesh, const std::string& name)
{
  const double area = area_of(mesh);
  double sum = 0;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& r = diagram.region(i);
    CHECK(diagram.index(r.vertex) == i && r.vertex->point() == r.generator);
    double of_tiles = 0, of_pieces = 0;
    for(const auto& t : r.tiles)
      of_tiles += CGAL::area(t[0], t[1], t[2]);
    for(std::size_t k = 0; k < r.pieces.size(); ++k) {
      of_pieces += r.pieces[k].area;
      CHECK(k == 0 || r.pieces[k - 1].is_main || !r.pieces[k].is_main);
      check_piece(r.pieces[k], r.generator, area, name);
    }
    CHECK_MSG(std::abs(of_tiles - r.area) <= 1e-10 * area, name);
    CHECK_MSG(std::abs(of_pieces - r.area) <= 1e-10 * area, name);
    sum += r.area;
  }
  CHECK_MSG(std::abs(sum / area - 1) <= 1e-10, name + ": " + std::to_string(sum / area));
}

// ---------------------------------------------------------------- metrics

struct Named_field
{
  std::string name;
  Field       field;
};

inline Field constant_field(double a, double b, double c)
{
  return [=](const Point&) { return Tensor::from_entries(a, b, c); };
}

// the third metric of figure 2.2
inline Tensor thin_in_the_middle(const Point& p) { return Tensor::from_entries(7 - 6.3*std::abs(p.x()), 0, 1); }

// The centre has an orphan at the left border that reaches neither a corner of
// a face nor the bisector of the two corners of the square there.
inline Tensor thin_at_the_border(const Point& p)
{
  const double y = (p.y() - 0.3) / 0.3;
  return Tensor::from_entries(p.x() < 0 ? 7 - 6.9 * std::exp(-y*y) : 7, 0, 1);
}

inline Tensor turning(const Point& p) { return Tensor::from_sizes(0.2, 1, 2*p.x() + p.y()); }

inline Tensor layer_field(const Point& p)
{
  return Tensor::from_sizes(0.05 + std::abs(p.x() + p.y()/2), 1, 0.5);
}

// jumps across a line
inline Tensor broken(const Point& p)
{
  return p.x() + 0.3*p.y() < 0.1 ? Tensor::from_entries(1, 0, 1) : Tensor::from_sizes(0.3, 1, 1);
}

#endif // ANISOTROPIC_MESH_2_TEST_VORONOI_DIAGRAMS_H

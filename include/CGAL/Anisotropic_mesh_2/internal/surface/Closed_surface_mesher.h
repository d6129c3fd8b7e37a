// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CLOSED_SURFACE_MESHER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CLOSED_SURFACE_MESHER_H

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Boundary_unit_mesher.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Directed_edges.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_chart.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/append_chart_faces.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Riemannian_length_2.h>
#include <CGAL/Anisotropic_mesh_2/parameters.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/refine_anisotropic_mesh_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The unit mesh of a surface with a periodic parameter: the rectangle of
// parameters without what is close to poles is meshed with the same points on
// the sides that coincide, and so are the discs around the poles.
template <class Field>
class Closed_surface_mesher
{
  typedef Anisotropic_surface_mesh_3<Field>         Surface_mesh;
  typedef Surface_chart<Field>                      Chart;
  typedef typename Chart::Kernel                    Kernel;
  typedef typename Chart::Point_2                   Point_2;
  typedef Riemannian_metric_traits_2<Kernel>        Traits;
  typedef Anisotropic_Delaunay_mesh_2<Traits>       Mesh;

public:
  Closed_surface_mesher(Surface_mesh& surface_mesh, std::size_t maximum_number_of_vertices)
    : m_surface_mesh(surface_mesh), m_rectangle(surface_mesh.field().surface().parameters()),
      m_limit(maximum_number_of_vertices), m_v_low(m_rectangle.v_min), m_v_high(m_rectangle.v_max)
  {
    const double radius = radius_of_disc * m_rectangle.v_extent();
    if(m_rectangle.v_min_is_pole)
      m_v_low += radius;
    if(m_rectangle.v_max_is_pole)
      m_v_high -= radius;
  }

  void operator()()
  {
    const double u0 = m_rectangle.u_min, u1 = m_rectangle.u_max;
    const std::array<std::size_t, 4> corner = corners(); // from the lower left one counterclockwise
    const Side bottom = side(corner[0], corner[1], {u0, m_v_low}, {u1, m_v_low});
    const Side left = side(corner[0], corner[3], {u0, m_v_low}, {u0, m_v_high});
    const Side top = m_rectangle.v_is_periodic ? moved(bottom, {0, m_v_high - m_v_low})
                                               : side(corner[3], corner[2], {u0, m_v_high}, {u1, m_v_high});
    const Side right = m_rectangle.u_is_periodic ? moved(left, {m_rectangle.u_extent(), 0})
                                                 : side(corner[1], corner[2], {u1, m_v_low}, {u1, m_v_high});
    mesh_loop(window(), {bottom, right, reversed(top), reversed(left)});
    if(m_rectangle.v_min_is_pole)
      mesh_loop(Chart::cap(m_surface_mesh.field(), true), {around_pole(bottom, true)});
    if(m_rectangle.v_max_is_pole)
      mesh_loop(Chart::cap(m_surface_mesh.field(), false), {around_pole(top, false)});
    if(!Directed_edges(m_faces).are_simple())
      throw Invalid_domain_exception("the sizes are too large for a closed mesh of the surface: "
                                     "fewer than three edges would lead once around it");
    m_surface_mesh.replace_faces(std::move(m_faces));
  }

private:
  static constexpr double radius_of_disc = 0.25; // as a share of the range of v
  static constexpr double fewest_parts = 3;      // of a closed line, which needs three to bound a face

  struct Place
  {
    Vector_of_doubles coordinates; // in the current chart
    std::size_t       vertex;
  };
  typedef std::vector<Place> Side;

  Chart window() const { return Chart::window(m_surface_mesh.field(), m_rectangle.u_min, m_rectangle.v_min); }

  // Corners that coincide on the surface are the same vertex.
  std::array<std::size_t, 4> corners()
  {
    const double u0 = m_rectangle.u_min, u1 = m_rectangle.u_max;
    std::array<std::size_t, 4> v;
    v[0] = m_surface_mesh.add_vertex(point({u0, m_v_low}));
    v[1] = m_rectangle.u_is_periodic ? v[0] : m_surface_mesh.add_vertex(point({u1, m_v_low}));
    v[3] = m_rectangle.v_is_periodic ? v[0] : m_surface_mesh.add_vertex(point({u0, m_v_high}));
    v[2] = m_rectangle.u_is_periodic ? v[3]
         : m_rectangle.v_is_periodic ? v[1] : m_surface_mesh.add_vertex(point({u1, m_v_high}));
    return v;
  }

  static Point_2 point(const Vector_of_doubles& p) { return point_at<Point_2>(p.x, p.y); }

  // The straight line between two places, in parts of equal length close to 1.
  Side side(std::size_t source, std::size_t target, const Vector_of_doubles& p, const Vector_of_doubles& q)
  {
    const Chart chart = window();
    const Riemannian_length_2<Kernel, Chart> length(Curve_piece_2<Kernel>::segment(point(p), point(q)), chart,
                                                    double(m_limit));
    const double n = (std::max)(number_of_unit_parts(length.total()), source == target ? fewest_parts : 1);
    if(n > double(m_limit))
      throw Too_many_vertices_exception(n, m_limit, "a side of the parameters");
    Side result(1, {p, source});
    for(double k = 1; k < n; ++k) {
      const double t = length.parameter(k / n * length.total());
      const Vector_of_doubles x = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      result.push_back({x, m_surface_mesh.add_vertex(point(x))});
    }
    result.push_back({q, target});
    return result;
  }

  // the same vertices on the opposite side
  static Side moved(Side side, const Vector_of_doubles& by)
  {
    for(Place& p : side)
      p.coordinates = {p.coordinates.x + by.x, p.coordinates.y + by.y};
    return side;
  }

  static Side reversed(Side side)
  {
    std::reverse(side.begin(), side.end());
    return side;
  }

  // the ring of a side in the chart of a pole
  Side around_pole(Side side, bool at_v_min) const
  {
    const Chart cap = Chart::cap(m_surface_mesh.field(), at_v_min);
    for(Place& p : side)
      p.coordinates = cap.coordinates(p.coordinates);
    side.back() = side.front(); // which it is but for rounding
    return side;
  }

  // Fills a loop of sides, each of which begins where the one before ends.
  void mesh_loop(const Chart& chart, const std::vector<Side>& sides)
  {
    typename Mesh::Boundary_graph boundary;
    std::map<Point_2, std::size_t> numbers;
    for(const Side& side : sides)
      for(std::size_t k = 0; k + 1 < side.size(); ++k) {
        boundary.points.push_back(point(side[k].coordinates));
        numbers[boundary.points.back()] = side[k].vertex;
      }
    const std::size_t n = boundary.points.size();
    for(std::size_t k = 0; k < n; ++k)
      boundary.segments.push_back({k, (k + 1) % n, 1, true});
    Mesh mesh{Traits(chart)};
    mesh.insert_boundary(boundary);
    refine_anisotropic_mesh_2(mesh, parameters::maximum_number_of_vertices(m_limit));
    append_chart_faces(mesh, chart, numbers, m_surface_mesh, m_faces);
  }

  Surface_mesh&             m_surface_mesh;
  const Parameter_rectangle m_rectangle;
  const std::size_t         m_limit;
  double                    m_v_low, m_v_high; // of the rectangle without the discs around poles
  std::vector<typename Surface_mesh::Face> m_faces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_CLOSED_SURFACE_MESHER_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNCOVERED_AREA_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNCOVERED_AREA_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Adaptive_triangle_integral.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Domain_samples.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Finds the faces of the domain that have more area in the metric than one face should have, which
// the lengths of their edges need not show: the field is sampled on a lattice over the domain and at
// the barycentres of faces, and more closely where a sample tells of such a face.
template <class Mesh>
class Uncovered_area
{
  typedef typename Mesh::Point         Point;
  typedef typename Mesh::Vertex_handle Vertex_handle;
  typedef typename Mesh::Face_handle   Face_handle;

public:
  // samples the whole domain
  explicit Uncovered_area(const Mesh& mesh)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object())
  {
    const std::vector<Face_handle> faces = mesh.faces_in_domain();
    double total = 0;
    for(Face_handle f : faces) {
      add_barycentre(f);
      total += area(triangle_of_doubles(f));
    }
    const double cell = total / number_of_samples;
    if(!std::isnormal(cell))
      return;
    const Domain_samples lattice(cell);
    for(Face_handle f : faces) {
      const Triangle_of_doubles t = triangle_of_doubles(f);
      lattice.for_each_in(t, [&](const Vector_of_doubles& x) { add(x, (std::min)(cell, area(t))); });
    }
  }

  // samples the faces of these vertices
  void add_faces_of(const std::vector<Vertex_handle>& vertices)
  {
    std::set<Face_handle> seen;
    for(Vertex_handle v : vertices) {
      auto f = m_mesh.incident_faces(v), done(f);
      do {
        if(f->is_in_domain() && seen.insert(f).second)
          add_barycentre(f);
      } while(++f != done);
    }
  }

  // One point in each face that has too much area as the samples tell. What has been told is forgotten.
  std::vector<Point> places()
  {
    std::vector<Point> result;
    std::vector<Sample> kept;
    std::set<Face_handle> told;
    Face_handle hint;
    for(const Sample& s : m_samples) {
      typename Mesh::Locate_type lt;
      int li;
      hint = m_mesh.locate(s.point, lt, li, hint);
      if(!m_mesh.is_field_point(lt, hint, li) || !has_too_much(s, hint))
        continue;
      if(told.count(hint) > 0)
        kept.push_back(s);
      else if(is_confirmed(s, hint)) {
        result.push_back(s.point);
        told.insert(hint);
      }
    }
    m_samples.swap(kept);
    return result;
  }

private:
  static constexpr double number_of_samples = 2500;
  static constexpr double too_much = 2.5 * area_of_unit_triangle;
  static constexpr double smallest_share = 1e-6;
  static constexpr int    levels = 5;

  struct Sample
  {
    Point  point;
    double density;
    double cell;    // the area that it stands for
  };

  double density(const Point& p) const { return m_tensor(p).area_density(); }

  // returns whether it tells of too much area
  bool add(const Vector_of_doubles& x, double cell)
  {
    const Point p = point_at<Point>(x.x, x.y);
    const Sample s{p, density(p), cell};
    const bool tells = s.density * cell > too_much;
    if(tells)
      m_samples.push_back(s);
    return tells;
  }

  // If it tells nothing though the metric at one or two vertices does, samples follow nearer and nearer to these.
  void add_barycentre(Face_handle f)
  {
    const Triangle_of_doubles t = triangle_of_doubles(f);
    const Vector_of_doubles b = barycentre(t);
    std::array<double, 3> densities;
    for(int i = 0; i < 3; ++i)
      densities[i] = f->vertex(i)->metric_tensor().area_density();
    const double densest = *std::max_element(densities.begin(), densities.end());
    Vector_of_doubles v;
    int n = 0;
    for(int i = 0; i < 3; ++i)
      if(densities[i] > densest / 2) {
        v = {(n*v.x + t[i].x) / (n + 1), (n*v.y + t[i].y) / (n + 1)};
        ++n;
      }
    double share = 1, cell = area(t);
    while(!add({v.x + share * (b.x - v.x), v.y + share * (b.y - v.y)}, cell)
          && densest * cell > too_much && share > smallest_share) {
      share /= 2;
      cell /= n == 1 ? 4 : 2;
    }
  }

  static bool has_too_much(const Sample& s, Face_handle f)
  {
    return s.density * (std::min)(s.cell, area(triangle_of_doubles(f))) > too_much;
  }

  // What a single sample tells may hold for a tiny part of its face only: the area is measured on parts
  // similar to the face, as large as what the sample stands for or smaller.
  bool is_confirmed(const Sample& s, Face_handle f) const
  {
    const Triangle_of_doubles t = triangle_of_doubles(f);
    double scale = std::sqrt((std::min)(1., s.cell / area(t)));
    for(int level = 0; level < levels; ++level, scale /= 3)
      if(metric_area_around(to_doubles(s.point), t, scale) > too_much)
        return true;
    return false;
  }

  double metric_area_around(const Vector_of_doubles& p, const Triangle_of_doubles& t, double scale) const
  {
    const auto of_point = [this](double x, double y) { return density(point_at<Point>(x, y)); };
    Adaptive_triangle_integral<decltype(of_point)> integral(of_point, 0.1, 10);
    const auto shrunk = [&](const Vector_of_doubles& v)
                        { return Vector_of_doubles{p.x + scale * (v.x - p.x), p.y + scale * (v.y - p.y)}; };
    double sum = 0;
    for(int i = 0; i < 3; ++i)
      sum += integral({p, shrunk(t[i]), shrunk(t[(i + 1) % 3])});
    return sum;
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  std::vector<Sample> m_samples;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_UNCOVERED_AREA_H

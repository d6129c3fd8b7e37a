// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_INSERTER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_INSERTER_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Makes the points of the bisectors vertices, so that each face lies in a single
// region and bisectors are edges. Each face keeps a corner that lies on no bisector.
class Bisector_inserter
{
  typedef Region_tds::Vertex_handle Vertex_handle;
  typedef Region_tds::Face_handle   Face_handle;
  typedef Region_tds::Edge          Edge;

public:
  // The divisions of the faces are used up.
  explicit Bisector_inserter(Region_tds& tds) : m_tds(tds) {}

  void operator()()
  {
    insert_centres();
    insert_crossings();
    insert_curves();
  }

private:
  static constexpr std::size_t none = Labelled_point::none;

  void insert_centres()
  {
    for(Face_handle f : m_tds.faces_in_domain())
      if(f->division && f->division->number_of_labels() == 3)
        m_tds.split_face(f, {f->division->centre, none});
  }

  // Where two edges of a face are crossed, its parts have an edge from one crossing to the
  // other; where three are, they have one from each crossing to the centre.
  void insert_crossings()
  {
    std::vector<Face_handle> faces = m_tds.faces_in_domain();
    while(!faces.empty()) {
      const Face_handle f = faces.back();
      const int k = crossed_edge(f);
      if(k == 3) {
        faces.pop_back();
        continue;
      }
      const Vertex_handle v = m_tds.split_edge(Edge(f, k), {f->division->crossing[edge_of_division(f, k)], none});
      m_tds.for_each_face_in_domain(v, [&](Face_handle part) { faces.push_back(part); });
    }
  }

  // the first edge whose ends have different labels, or 3
  static int crossed_edge(Face_handle f)
  {
    for(int k = 0; k < 3; ++k) {
      const std::size_t p = f->vertex(Region_tds::ccw(k))->point.label, q = f->vertex(Region_tds::cw(k))->point.label;
      if(p != q && p != none && q != none)
        return k;
    }
    return 3;
  }

  // Which edge of the divided face edge k of its part f is: that opposite to the corner that is not an end.
  static int edge_of_division(Face_handle f, int k)
  {
    const Labelled_point *p = &f->vertex(Region_tds::ccw(k))->point, *q = &f->vertex(Region_tds::cw(k))->point;
    const auto& corner = f->division->corner;
    int i = 0;
    while(corner[i] == p || corner[i] == q)
      ++i;
    return i;
  }

  void insert_curves()
  {
    for(Face_handle f : m_tds.faces_in_domain())
      for(int k = 0; k < 3; ++k) {
        const Face_handle beyond = f->neighbor(k);
        if(!f->division || f->division != beyond->division)
          continue;
        for(Face_division::Curve& c : f->division->curves)
          if(!c.points.empty() && c.left == Region_tds::label(f) && c.right == Region_tds::label(beyond))
            insert_curve(Edge(f, k), std::exchange(c.points, Vectors()));
      }
  }

  // The edge has the left side of the curve in its face.
  void insert_curve(Edge e, const Vectors& points)
  {
    const Vertex_handle last = e.first->vertex(Region_tds::cw(e.second));
    for(const Vector_of_doubles& p : points) {
      const Vertex_handle v = m_tds.split_edge(e, {Metric_point{p, Symmetric_form()}, none});
      m_tds.is_edge(v, last, e.first, e.second);
    }
  }

  Region_tds& m_tds;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_BISECTOR_INSERTER_H

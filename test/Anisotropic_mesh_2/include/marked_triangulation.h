// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_MARKED_TRIANGULATION_H
#define ANISOTROPIC_MESH_2_TEST_MARKED_TRIANGULATION_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel        Kernel;
typedef CGAL::Triangulation_data_structure_2<
  CGAL::Triangulation_vertex_base_2<Kernel>,
  CGAL::Delaunay_mesh_face_base_2<Kernel> >                        Marked_tds;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Marked_tds> Marked_cdt;

// A triangulation of CGAL with nothing but marked faces: a rectangle [0,4]x[0,3]
// with an inner curve, in a larger convex hull.
inline Marked_cdt marked_rectangle(int number_of_inner_points = 1)
{
  Marked_cdt cdt;
  const std::vector<Kernel::Point_2> corners = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  cdt.insert_constraint(corners.begin(), corners.end(), true);
  cdt.insert_constraint(Kernel::Point_2(0, 0), Kernel::Point_2(4, 3));
  cdt.insert(Kernel::Point_2(-7, 5));
  cdt.insert(Kernel::Point_2(9, 9));
  for(int i = 0; i < number_of_inner_points; ++i)
    cdt.insert(Kernel::Point_2(3 + 0.9 * i / number_of_inner_points, 1 + 0.1 * (i * 37 % 11)));
  for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    const Kernel::Point_2 c = CGAL::centroid(cdt.triangle(f));
    f->set_in_domain(c.x() > 0 && c.x() < 4 && c.y() > 0 && c.y() < 3);
  }
  return cdt;
}

// The same with references of edges.
template <class Cdt>
struct With_references : Cdt
{
  explicit With_references(const Cdt& cdt) : Cdt(cdt) {}

  int edge_reference(const typename Cdt::Edge& e) const
  {
    const Kernel::Segment_2 s = this->segment(e);
    return s.is_horizontal() ? 2 : s.is_vertical() ? 3 : 4;
  }
};

#endif // ANISOTROPIC_MESH_2_TEST_MARKED_TRIANGULATION_H

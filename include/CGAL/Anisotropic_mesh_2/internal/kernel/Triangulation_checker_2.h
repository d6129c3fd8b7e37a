// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_TRIANGULATION_CHECKER_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_TRIANGULATION_CHECKER_2_H

#include <CGAL/Anisotropic_mesh_2/internal/base/exact_predicates.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/face_marks.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/have_multiples_of.h>

#include <CGAL/enum.h>

#include <iostream>
#include <type_traits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// What `is_valid()` of the generalized kernel checks, level by level.
template <class Triangulation>
class Triangulation_checker_2
{
  typedef typename Triangulation::Geom_traits::Kernel  Kernel;
  typedef Exact_predicates_kernel_of<Kernel>           Exact_kernel;
  typedef typename Triangulation::Edge                 Edge;
  typedef typename Triangulation::Point                Point;
  typedef typename Triangulation::Vertex_handle        Vertex_handle;

public:
  explicit Triangulation_checker_2(const Triangulation& t) : m_t(t) {}

  bool is_valid(bool verbose, int level) const
  {
    const char* const defect = first_defect(verbose, level);
    if(defect != nullptr && verbose)
      std::cerr << "Constrained_anisotropic_Delaunay_triangulation_2: " << defect << std::endl;
    return defect == nullptr;
  }

private:
  const char* first_defect(bool verbose, int level) const
  {
    if(!m_t.tds().is_valid(verbose, level))
      return "the data structure is not valid";
    if(m_t.dimension() == 2) {
      if(!has_matching_edges())
        return "an edge is constrained or has a reference from one side only";
      if(!has_counterclockwise_faces())
        return "a face is not counterclockwise";
      if(!has_convex_hull())
        return "the hull is not convex";
    }
    if(level >= 1 && !has_tensors_of_field())
      return "a vertex does not have the tensor of the field at its point";
    if(level >= 1 && !has_distinct_indices())
      return "the index of a vertex is out of range or not its own";
    if(level >= 2 && m_t.dimension() == 2 && is_uniform() && !is_locally_Delaunay())
      return "an edge is not locally Delaunay";
    return nullptr;
  }

  bool has_matching_edges() const
  {
    for(auto f = m_t.all_faces_begin(); f != m_t.all_faces_end(); ++f)
      for(int i = 0; i < 3; ++i) {
        const Edge e = m_t.mirror_edge(Edge(f, i));
        const Edge_mark mark = edge_mark(*f, i);
        if(!(mark == edge_mark(*e.first, e.second)) || !(mark.is_constrained || mark == Edge_mark()))
          return false;
      }
    return true;
  }

  bool has_counterclockwise_faces() const
  {
    for(auto f = m_t.finite_faces_begin(); f != m_t.finite_faces_end(); ++f)
      if(orientation(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) != LEFT_TURN)
        return false;
    return true;
  }

  bool has_convex_hull() const
  {
    auto p = m_t.incident_vertices(m_t.infinite_vertex()), done = p; // clockwise
    do {
      auto q = p, r = ++q;
      if(orientation(p->point(), q->point(), (++r)->point()) == LEFT_TURN)
        return false;
    } while(++p != done);
    return true;
  }

  bool has_tensors_of_field() const
  {
    const auto tensor = m_t.geom_traits().construct_metric_tensor_2_object();
    for(auto v = m_t.finite_vertices_begin(); v != m_t.finite_vertices_end(); ++v)
      if(v->metric_tensor() != tensor(v->point()))
        return false;
    return true;
  }

  bool has_distinct_indices() const
  {
    std::vector<bool> is_taken(m_t.vertex_index_bound(), false);
    for(auto v = m_t.finite_vertices_begin(); v != m_t.finite_vertices_end(); ++v) {
      if(v->index() < 0 || v->index() >= m_t.vertex_index_bound() || is_taken[v->index()])
        return false;
      is_taken[v->index()] = true;
    }
    return true;
  }

  bool is_uniform() const
  {
    return have_multiples_of(m_t.finite_vertex_handles(), m_t.finite_vertices_begin()->metric_tensor());
  }

  bool is_locally_Delaunay() const
  {
    for(auto e = m_t.finite_edges_begin(); e != m_t.finite_edges_end(); ++e)
      if(!m_t.is_locally_Delaunay(e->first, e->second))
        return false;
    return true;
  }

  // free of rounding errors also where that of the triangulation is not, if coordinates are doubles
  Orientation orientation(const Point& p, const Point& q, const Point& r) const
  {
    if constexpr(!Triangulation::Geom_traits::has_exact_predicates
                 && std::is_floating_point<typename Triangulation::Geom_traits::FT>::value)
      return Exact_kernel().orientation_2_object()(exact_point<Kernel>(p), exact_point<Kernel>(q),
                                                   exact_point<Kernel>(r));
    else
      return m_t.orientation(p, q, r);
  }

  const Triangulation& m_t;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_KERNEL_TRIANGULATION_CHECKER_2_H

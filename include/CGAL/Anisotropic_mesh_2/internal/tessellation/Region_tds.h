// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_TDS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_TDS_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <CGAL/Triangulation_data_structure_2.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

template <class Tds = void>
class Region_vertex_base
  : public Triangulation_ds_vertex_base_2<Tds>
{
public:
  template <class Tds2>
  struct Rebind_TDS { typedef Region_vertex_base<Tds2> Other; };

  Labelled_point point;
  std::size_t    id = 0;
  bool           is_generator = false;
};

template <class Tds = void>
class Region_face_base
  : public Triangulation_ds_face_base_2<Tds>
{
  typedef Triangulation_ds_face_base_2<Tds> Base;

public:
  template <class Tds2>
  struct Rebind_TDS { typedef Region_face_base<Tds2> Other; };
  using Base::Base;

  bool                           is_in_domain = false;
  bool                           is_pending = false;            // whether it is to be examined
  std::shared_ptr<Face_division> division;                      // of the examined face of which this is a part
  std::size_t                    region = Labelled_point::none; // in the end

  // for `Region_pieces`
  std::size_t                    piece = 0; // of the region
  bool                           is_collected = false;
  std::array<bool, 3>            is_followed = {{false, false, false}}; // by edges
};

// What both bases make up, with insertions that keep track of the domain and of divisions.
class Region_tds
  : public Triangulation_data_structure_2<Region_vertex_base<>, Region_face_base<> >
{
public:
  std::vector<Face_handle> faces_in_domain()
  {
    std::vector<Face_handle> faces;
    for(auto f = faces_begin(); f != faces_end(); ++f)
      if(f->is_in_domain)
        faces.push_back(f);
    return faces;
  }

  static Triangle_of_doubles triangle(Face_handle f)
  {
    return {f->vertex(0)->point.at, f->vertex(1)->point.at, f->vertex(2)->point.at};
  }

  // that of a corner which lies on no bisector
  static std::size_t label(Face_handle f)
  {
    int i = 0;
    while(f->vertex(i)->point.label == Labelled_point::none)
      ++i;
    return f->vertex(i)->point.label;
  }

  template <class Function>
  void for_each_face_in_domain(Vertex_handle v, const Function& function) const
  {
    auto f = incident_faces(v), first = f;
    do {
      if(f->is_in_domain)
        function(f);
    } while(++f != first);
  }

  Vertex_handle split_face(Face_handle f, const Labelled_point& point)
  {
    const std::shared_ptr<Face_division> division = f->division;
    const Vertex_handle v = take(insert_in_face(f), point);
    auto part = incident_faces(v), first = part;
    do {
      part->is_in_domain = true;
      part->division = division;
    } while(++part != first);
    return v;
  }

  Vertex_handle split_edge(const Edge& e, const Labelled_point& point)
  {
    const Edge mirror = mirror_edge(e);
    const Vertex_handle apex = e.first->vertex(e.second);
    const bool is_in_domain[] = {e.first->is_in_domain, mirror.first->is_in_domain};
    const std::shared_ptr<Face_division> division[] = {e.first->division, mirror.first->division};

    // from the other side: so no face of the domain becomes one outside
    const Vertex_handle v = take(insert_in_edge(mirror.first, mirror.second), point);
    auto part = incident_faces(v), first = part;
    do {
      const bool is_beyond = !part->has_vertex(apex);
      part->is_in_domain = is_in_domain[is_beyond];
      part->division = division[is_beyond];
    } while(++part != first);
    return v;
  }

private:
  Vertex_handle take(Vertex_handle v, const Labelled_point& point)
  {
    v->id = number_of_vertices() - 1;
    v->point = point;
    return v;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_TDS_H

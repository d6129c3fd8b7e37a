// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_divider.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <CGAL/Triangulation_data_structure_2.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

template <class Tds = void>
class Region_vertex_base
  : public Triangulation_ds_vertex_base_2<Tds>
{
public:
  template <class Tds2>
  struct Rebind_TDS { typedef Region_vertex_base<Tds2> Other; };

  Corner      corner;
  std::size_t id = 0;
  bool        is_generator = false;
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

  bool         is_in_domain = false;
  bool         is_pending = false; // whether it is to be examined
  Divided_face division;           // once it is examined
  std::size_t  number = 0;         // of the face in the domain, at the end
};

// The domain of a mesh, its faces bisected until each one lies in the regions
// of at most three generators in a way that the metric within it cannot upset.
//
// Edges are bisected that are the longest of both their faces, so that no face
// has a vertex within an edge and faces do not become needles.
//
// Faces are examined in rounds, at the same time with `Parallel_tag`; those that
// are refused are bisected one after the other before the next round.
template <class Mesh, class Place_at, class ConcurrencyTag>
class Region_subdivision
{
public:
  typedef Triangulation_data_structure_2<Region_vertex_base<>, Region_face_base<> > Tds;
  typedef typename Tds::Vertex_handle                                               Vertex_handle;
  typedef typename Tds::Face_handle                                                 Face_handle;
  typedef typename Tds::Edge                                                        Edge;

  // `region_of` maps the index of a vertex of the mesh to its generator, which
  // vertices outside of the domain do not have.
  Region_subdivision(const Mesh& mesh, const Generator_set& generators, const std::vector<std::size_t>& region_of,
                     const Place_at& place_at, double tolerance)
    : m_generators(generators), m_place_at(place_at), m_tolerance(tolerance),
      m_maximum_number_of_vertices(200000 + 200 * generators.size())
  {
    copy(mesh, region_of);
    std::vector<Face_handle> pending = faces_in_domain();
    while(!pending.empty())
      pending = bisect(examine(pending));
    m_faces = faces_in_domain();
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      m_faces[i]->number = i;
  }

  const Tds& tds() const { return m_tds; }

  // those of the domain, in the order of their numbers
  const std::vector<Face_handle>& faces() const { return m_faces; }

private:
  // Bisectors pass through the midpoints of generators, where vertices would
  // have two nearest generators: edges are cut a little off their midpoints.
  static constexpr double place_of_cut = 0.46;

  static constexpr std::size_t faces_of_chunk = 64;

  void copy(const Mesh& mesh, const std::vector<std::size_t>& region_of)
  {
    struct Convert_vertex
    {
      const Mesh& mesh;
      const std::vector<std::size_t>& region_of;
      const bool is_measured_at_generators;

      typename Tds::Vertex operator()(const typename Mesh::Triangulation_data_structure::Vertex&) const
      { return typename Tds::Vertex(); }
      void operator()(const typename Mesh::Triangulation_data_structure::Vertex& v, typename Tds::Vertex& copy) const
      {
        if(&v == &*mesh.infinite_vertex())
          return;
        copy.corner.label = region_of[v.index()];
        copy.corner.place.at = to_doubles(v.point());
        copy.corner.place.m = is_measured_at_generators ? Symmetric_form(1, 0, 1) : Symmetric_form(v.metric_tensor());
        copy.is_generator = true;
      }
    };
    struct Convert_face
    {
      typename Tds::Face operator()(const typename Mesh::Triangulation_data_structure::Face&) const
      { return typename Tds::Face(); }
      void operator()(const typename Mesh::Triangulation_data_structure::Face& f, typename Tds::Face& copy) const
      {
        copy.is_in_domain = f.is_in_domain();
      }
    };
    m_tds.copy_tds(mesh.tds(), mesh.infinite_vertex(),
                   Convert_vertex{mesh, region_of, m_generators.is_measured_at_generators()}, Convert_face());
    std::size_t id = 0;
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      v->id = id++;
    // one of two generators that coincide up to rounding has no region
    for(auto f = m_tds.faces_begin(); f != m_tds.faces_end(); ++f)
      if(f->is_in_domain)
        for(int i = 0; i < 3; ++i) {
          const std::size_t own = f->vertex(i)->corner.label;
          label(f->vertex(i)->corner);
          f->vertex(i)->is_generator = f->vertex(i)->is_generator && f->vertex(i)->corner.label == own;
        }
  }

  void label(Corner& c) const { c.label = m_generators.nearest(c.place, c.label); }

  std::vector<Face_handle> faces_in_domain()
  {
    std::vector<Face_handle> faces;
    for(auto f = m_tds.faces_begin(); f != m_tds.faces_end(); ++f)
      if(f->is_in_domain)
        faces.push_back(f);
    return faces;
  }

  // Divides faces among the generators; returns those that are to be bisected.
  std::vector<Face_handle> examine(const std::vector<Face_handle>& pending) const
  {
    const bool is_last = m_tds.number_of_vertices() > m_maximum_number_of_vertices;
    std::vector<std::vector<Face_handle> > refused(number_of_chunks(pending.size(), faces_of_chunk));
    for_each_chunk<ConcurrencyTag>(pending.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      Face_divider<Place_at> divide(m_generators, m_place_at, m_tolerance);
      for(std::size_t i = begin; i < end; ++i) {
        const Face_handle f = pending[i];
        f->is_pending = false;
        f->division = Divided_face();
        if(!divide(f->vertex(0)->corner, f->vertex(1)->corner, f->vertex(2)->corner, is_last, f->division))
          refused[chunk].push_back(f);
      }
    }, faces_of_chunk);
    return joined(std::move(refused));
  }

  // Bisects faces that have been refused, and others on the way; returns the faces to be examined next.
  std::vector<Face_handle> bisect(const std::vector<Face_handle>& refused)
  {
    std::vector<Face_handle> pending;
    for(Face_handle f : refused) {
      while(!f->is_pending && m_tds.number_of_vertices() <= m_maximum_number_of_vertices)
        cut(last_edge_of_path(f), pending);
      add_pending(f, pending); // if the bisection ends early
    }
    return pending;
  }

  static void add_pending(Face_handle f, std::vector<Face_handle>& pending)
  {
    if(f->is_pending)
      return;
    f->is_pending = true;
    pending.push_back(f);
  }

  // From the longest edge of the face on to the longest one of the face beyond,
  // until an edge is the longest one of both its faces, or for a number of
  // steps that only needles in the metric need.
  Edge last_edge_of_path(Face_handle f) const
  {
    Edge e = longest_edge(f);
    for(int step = 0; step < 20; ++step) {
      const Edge mirror = m_tds.mirror_edge(e);
      if(!mirror.first->is_in_domain)
        break;
      const Edge next = longest_edge(mirror.first);
      if(next == mirror)
        break;
      e = next;
    }
    return e;
  }

  // The order is total, and the same from both sides of the edges: so paths end.
  Edge longest_edge(Face_handle f) const
  {
    typedef std::pair<double, std::pair<std::size_t, std::size_t> > Rank;
    Rank greatest;
    int longest = 0;
    for(int i = 0; i < 3; ++i) {
      const auto uv = ends(Edge(f, i));
      const Rank rank(length(uv.first->corner.place, uv.second->corner.place), {uv.first->id, uv.second->id});
      if(i == 0 || greatest < rank) {
        greatest = rank;
        longest = i;
      }
    }
    return Edge(f, longest);
  }

  // Simpson's rule: a part of an edge must not be longer than the whole, or
  // paths would go round among edges that nearly coincide.
  double length(const Place& p, const Place& q) const
  {
    const double x = q.at.x - p.at.x, y = q.at.y - p.at.y;
    const Place middle = m_place_at({p.at.x + x / 2, p.at.y + y / 2});
    return (p.m.length(x, y) + 4 * middle.m.length(x, y) + q.m.length(x, y)) / 6;
  }

  static std::pair<Vertex_handle, Vertex_handle> ends(const Edge& e)
  {
    const Vertex_handle u = e.first->vertex(Tds::ccw(e.second)), v = e.first->vertex(Tds::cw(e.second));
    return u->id < v->id ? std::make_pair(u, v) : std::make_pair(v, u);
  }

  void cut(const Edge& e, std::vector<Face_handle>& pending)
  {
    const auto uv = ends(e);
    const Vector_of_doubles p = uv.first->corner.place.at, q = uv.second->corner.place.at;
    const std::size_t hint = uv.first->corner.label;
    const Edge mirror = m_tds.mirror_edge(e);
    const bool is_other_in_domain = mirror.first->is_in_domain;
    const Vertex_handle apex = e.first->vertex(e.second);

    // from the other side: so no face of the domain becomes one outside
    const Vertex_handle v = m_tds.insert_in_edge(mirror.first, mirror.second);
    v->id = m_tds.number_of_vertices() - 1;
    v->corner.place = m_place_at({p.x + place_of_cut * (q.x - p.x), p.y + place_of_cut * (q.y - p.y)});
    v->corner.label = hint;
    label(v->corner);
    auto f = m_tds.incident_faces(v), first = f;
    do {
      f->is_in_domain = f->has_vertex(apex) || is_other_in_domain;
      if(f->is_in_domain)
        add_pending(f, pending);
    } while(++f != first);
  }

  const Generator_set&     m_generators;
  const Place_at&          m_place_at;
  const double             m_tolerance;
  const std::size_t        m_maximum_number_of_vertices;
  Tds                      m_tds;
  std::vector<Face_handle> m_faces;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

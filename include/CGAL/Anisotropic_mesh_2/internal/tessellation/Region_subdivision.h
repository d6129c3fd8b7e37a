// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_divider.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Face_division.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Triangulation_data_structure_2.h>

#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
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
  bool                           is_pending = false; // whether it is to be examined
  std::shared_ptr<Face_division> division;           // of the examined face of which this is a part
  std::size_t                    region = Labelled_point::none; // in the end
  // for `Region_pieces`
  bool                           is_collected = false;
  std::array<bool, 3>            is_followed = {{false, false, false}}; // by edges
  std::size_t                    piece = 0;          // of the region
};

// The domain of a mesh, its faces divided until each one lies in a single region.
//
// First faces are bisected until each lies in the regions of at most three
// generators in a way that the metric within it cannot upset. Edges are bisected
// that are the longest of both their faces, so that no face has a vertex within
// an edge and faces do not become needles. Faces are examined in rounds, at the
// same time with `Parallel_tag`; those that are refused are bisected one after
// the other before the next round.
//
// Then the points of the bisectors become vertices, so that bisectors are the
// edges between regions. Each face keeps a corner that lies on no bisector.
template <class Generators, class ConcurrencyTag>
class Region_subdivision
{
  typedef typename Generators::Mesh                                                 Mesh;

public:
  typedef Triangulation_data_structure_2<Region_vertex_base<>, Region_face_base<> > Tds;
  typedef typename Tds::Vertex_handle                                               Vertex_handle;
  typedef typename Tds::Face_handle                                                 Face_handle;
  typedef typename Tds::Edge                                                        Edge;
  typedef Iterator_range<typename std::vector<Face_handle>::const_iterator>         Face_range;

  static constexpr std::size_t outside = Labelled_point::none; // the region of faces outside of the domain

  Region_subdivision(const Mesh& mesh, const Generators& generators, double tolerance)
    : m_generators(generators), m_tolerance(tolerance),
      m_maximum_number_of_vertices(200000 + 200 * generators.set().size())
  {
    copy(mesh);
    std::vector<Face_handle> pending = faces_in_domain();
    while(!pending.empty())
      pending = bisect(examine(pending));
    insert_centres();
    insert_crossings();
    insert_curves();
    sort_faces();
  }

  const Tds& tds() const { return m_tds; }

  // the faces of region i
  Face_range faces(std::size_t i) const
  {
    const auto at = [&](std::size_t k) { return m_faces.begin() + static_cast<std::ptrdiff_t>(m_first_face[k]); };
    return Face_range(at(i), at(i + 1));
  }

  static Triangle_of_doubles triangle(Face_handle f)
  {
    return {position(f->vertex(0)), position(f->vertex(1)), position(f->vertex(2))};
  }

  static const Vector_of_doubles& position(Vertex_handle v) { return v->point.place.at; }

private:
  // Bisectors pass through the midpoints of generators, where vertices would
  // have two nearest generators: edges are cut a little off their midpoints.
  static constexpr double place_of_cut = 0.46;

  static constexpr std::size_t faces_of_chunk = 64;
  static constexpr std::size_t none = Labelled_point::none;

  void copy(const Mesh& mesh)
  {
    typedef typename Mesh::Triangulation_data_structure Source;
    struct Convert_vertex
    {
      const Mesh&       mesh;
      const Generators& generators;

      typename Tds::Vertex operator()(const typename Source::Vertex&) const { return typename Tds::Vertex(); }
      void operator()(const typename Source::Vertex& v, typename Tds::Vertex& copy) const
      {
        if(&v == &*mesh.infinite_vertex())
          return;
        copy.point.place = generators.place_of(v);
        copy.point.label = generators.numbers()[v.index()];
        copy.is_generator = true;
      }
    };
    struct Convert_face
    {
      typename Tds::Face operator()(const typename Source::Face&) const { return typename Tds::Face(); }
      void operator()(const typename Source::Face& f, typename Tds::Face& copy) const
      {
        copy.is_in_domain = f.is_in_domain();
      }
    };
    m_tds.copy_tds(mesh.tds(), mesh.infinite_vertex(), Convert_vertex{mesh, m_generators}, Convert_face());
    std::size_t id = 0;
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      v->id = id++;
    // one of two generators that coincide up to rounding has no region
    for(Face_handle f : faces_in_domain())
      for(int i = 0; i < 3; ++i) {
        Labelled_point& p = f->vertex(i)->point;
        const std::size_t own = p.label;
        p.label = nearest(p.place, own);
        f->vertex(i)->is_generator = f->vertex(i)->is_generator && p.label == own;
      }
  }

  std::size_t nearest(const Place& p, std::size_t hint) const { return m_generators.set().nearest(p, hint); }

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
      Face_divider<Generators> divide(m_generators, m_tolerance);
      for(std::size_t i = begin; i < end; ++i) {
        const Face_handle f = pending[i];
        Face_division d;
        d.corner = {&f->vertex(0)->point, &f->vertex(1)->point, &f->vertex(2)->point};
        f->is_pending = false;
        if(!divide(is_last, d))
          refused[chunk].push_back(f);
        else if(d.number_of_labels() > 1)
          f->division = std::make_shared<Face_division>(std::move(d));
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
    f->division.reset();
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
      const Rank rank(length(uv.first->point.place, uv.second->point.place), {uv.first->id, uv.second->id});
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
    const Place middle = m_generators.place_at({p.at.x + x / 2, p.at.y + y / 2});
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
    const Vector_of_doubles p = position(uv.first), q = position(uv.second);
    const Place place = m_generators.place_at({p.x + place_of_cut * (q.x - p.x), p.y + place_of_cut * (q.y - p.y)});
    const Vertex_handle v = insert_in_edge(e, {place, nearest(place, uv.first->point.label)});
    for_each_face_in_domain(v, [&](Face_handle f) { add_pending(f, pending); });
  }

  template <class Function>
  void for_each_face_in_domain(Vertex_handle v, const Function& function) const
  {
    auto f = m_tds.incident_faces(v), first = f;
    do {
      if(f->is_in_domain)
        function(f);
    } while(++f != first);
  }

  // Parts of faces belong to the domain and to the division of the whole.
  Vertex_handle insert_in_edge(const Edge& e, const Labelled_point& point)
  {
    const Edge mirror = m_tds.mirror_edge(e);
    const Vertex_handle apex = e.first->vertex(e.second);
    const bool is_in_domain[] = {e.first->is_in_domain, mirror.first->is_in_domain};
    const std::shared_ptr<Face_division> division[] = {e.first->division, mirror.first->division};

    // from the other side: so no face of the domain becomes one outside
    const Vertex_handle v = m_tds.insert_in_edge(mirror.first, mirror.second);
    v->id = m_tds.number_of_vertices() - 1;
    v->point = point;
    auto f = m_tds.incident_faces(v), first = f;
    do {
      const bool is_beyond = !f->has_vertex(apex);
      f->is_in_domain = is_in_domain[is_beyond];
      f->division = division[is_beyond];
    } while(++f != first);
    return v;
  }

  void insert_centres()
  {
    for(Face_handle f : faces_in_domain()) {
      const std::shared_ptr<Face_division> d = f->division;
      if(!d || d->number_of_labels() != 3)
        continue;
      const Vertex_handle v = m_tds.insert_in_face(f);
      v->id = m_tds.number_of_vertices() - 1;
      v->point.place = d->centre;
      auto part = m_tds.incident_faces(v), first = part;
      do {
        part->is_in_domain = true;
        part->division = d;
      } while(++part != first);
    }
  }

  // Where two edges of a face are crossed, its parts have an edge from one crossing to the
  // other; where three are, they have one from each crossing to the centre.
  void insert_crossings()
  {
    std::vector<Face_handle> faces = faces_in_domain();
    while(!faces.empty()) {
      const Face_handle f = faces.back();
      const int k = crossed_edge(f);
      if(k == 3) {
        faces.pop_back();
        continue;
      }
      const Vertex_handle v = insert_in_edge(Edge(f, k), {f->division->crossing[edge_of_division(f, k)], none});
      for_each_face_in_domain(v, [&](Face_handle part) { faces.push_back(part); });
    }
  }

  // the first edge whose ends have different labels, or 3
  static int crossed_edge(Face_handle f)
  {
    int k = 0;
    const auto label = [&](int i) { return f->vertex(i)->point.label; };
    while(k < 3 && (label(Tds::ccw(k)) == label(Tds::cw(k)) || label(Tds::ccw(k)) == none || label(Tds::cw(k)) == none))
      ++k;
    return k;
  }

  // Which edge of the divided face edge k of its part f is: that opposite to the corner that is not an end.
  static int edge_of_division(Face_handle f, int k)
  {
    const Labelled_point *p = &f->vertex(Tds::ccw(k))->point, *q = &f->vertex(Tds::cw(k))->point;
    const auto& corner = f->division->corner;
    int i = 0;
    while(corner[i] == p || corner[i] == q)
      ++i;
    return i;
  }

  void insert_curves()
  {
    for(Face_handle f : faces_in_domain())
      for(int k = 0; k < 3; ++k) {
        const Face_handle beyond = f->neighbor(k);
        if(!f->division || f->division != beyond->division)
          continue;
        for(Face_division::Curve& c : f->division->curves)
          if(!c.points.empty() && c.left == label(f) && c.right == label(beyond))
            insert_curve(Edge(f, k), std::exchange(c.points, Vectors()));
      }
  }

  // The edge has the left side of the curve in its face.
  void insert_curve(Edge e, const Vectors& points)
  {
    const Vertex_handle last = e.first->vertex(Tds::cw(e.second));
    for(const Vector_of_doubles& p : points) {
      const Vertex_handle v = insert_in_edge(e, {Place{p, Symmetric_form()}, none});
      m_tds.is_edge(v, last, e.first, e.second);
    }
  }

  static std::size_t label(Face_handle f)
  {
    int i = 0;
    while(f->vertex(i)->point.label == none)
      ++i;
    return f->vertex(i)->point.label;
  }

  // by regions
  void sort_faces()
  {
    const std::vector<Face_handle> faces = faces_in_domain();
    m_first_face.assign(m_generators.set().size() + 1, 0);
    for(Face_handle f : faces) {
      f->division.reset();
      f->region = label(f);
      ++m_first_face[f->region + 1];
    }
    std::partial_sum(m_first_face.begin(), m_first_face.end(), m_first_face.begin());
    std::vector<std::size_t> next(m_first_face);
    m_faces.resize(faces.size());
    for(Face_handle f : faces)
      m_faces[next[f->region]++] = f;
  }

  const Generators&        m_generators;
  const double             m_tolerance;
  const std::size_t        m_maximum_number_of_vertices;
  Tds                      m_tds;
  std::vector<Face_handle> m_faces;      // by regions
  std::vector<std::size_t> m_first_face; // of the regions
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_TESSELLATION_REGION_SUBDIVISION_H

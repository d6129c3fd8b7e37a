// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H

#include <CGAL/Anisotropic_mesh_vertex_base_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/Vertex_remover_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Field_memo.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// the tensor at the barycentre of a face, and the quality in it, negative unless counterclockwise
struct Face_shape
{
  Symmetric_form metric;
  double         quality = -1;
};

// Some connected faces of a mesh in a small triangulation of their own, on
// which operations are tried: move, flip, split and unite, of which all others
// consist. They are recorded, and `write_to()` repeats them on the mesh by
// operations of the mesh, which carry along constraints, references, subdomains
// and what users store.
//
// Trials on the mesh itself, undone if rejected, would not be simpler: faces of
// the mesh have no place for their shapes, a vertex that is removed must keep
// its handle until the end of the trial, and the field may fail at any point.
// Here a trial is undone by forgetting it.
//
// Around the patch and on both sides of constrained edges within it is its
// *border*, whose edges and vertices stay. Beyond each border edge there is a
// face without further neighbors that does not belong to the patch; its vertex 0
// is that of the mesh, or none if the edge is constrained or on the hull.
template <class Mesh_>
class Mesh_patch
{
public:
  typedef Mesh_                                               Mesh;
  typedef typename Mesh::Geom_traits                          Geom_traits;
  typedef typename Mesh::Point                                Point;
  typedef typename Mesh::Metric_tensor_2                      Metric_tensor_2;
  typedef Sampled_metric<Mesh>                                Metric;
  // the index of a vertex is its number in the patch, its info whether it may move and be removed
  typedef Triangulation_data_structure_2<
    Triangulation_vertex_base_with_info_2<bool, Geom_traits, Anisotropic_mesh_vertex_base_2<Geom_traits> >,
    Triangulation_face_base_with_info_2<Face_shape, Geom_traits, Triangulation_ds_face_base_2<> > > Tds;
  typedef typename Tds::Vertex                                Vertex;
  typedef typename Tds::Vertex_handle                         Vertex_handle;
  typedef typename Tds::Face_handle                           Face_handle;
  typedef typename Tds::Edge                                  Edge;
  typedef boost::container::small_vector<Face_shape, 12>      Face_shapes;

  // The given faces of the mesh, which edges that are not constrained connect.
  Mesh_patch(const Mesh& mesh, Metric& metric, const std::vector<typename Mesh::Face_handle>& faces)
    : m_mesh(&mesh), m_metric(&metric)
  {
    m_tds.set_dimension(2);
    std::vector<Vertex_handle> vertices;
    std::vector<Face_handle> copies;
    for(const auto f : faces) {
      const Face_handle copy = m_tds.create_face();
      for(int i = 0; i < 3; ++i) {
        copy->set_vertex(i, copy_of(f->vertex(i), vertices, true));
        copy->vertex(i)->set_face(copy);
      }
      update_shape(copy);
      copies.push_back(copy);
    }
    for(std::size_t k = 0; k < faces.size(); ++k)
      for(int i = 0; i < 3; ++i) {
        const auto g = faces[k]->neighbor(i);
        const auto found = std::find(faces.begin(), faces.end(), g);
        const bool is_open = !faces[k]->is_constrained(i) && !mesh.is_infinite(g);
        if(is_open && found != faces.end())
          copies[k]->set_neighbor(i, copies[found - faces.begin()]);
        else
          add_border(copies[k], i, is_open ? copy_of(g->vertex(mesh.mirror_index(faces[k], i)), vertices, false)
                                           : Vertex_handle());
      }
  }

  const Geom_traits& geom_traits() const { return m_mesh->geom_traits(); }
  const Tds& tds() const { return m_tds; }

  // the copy of the first of the given faces, as long as nothing has been done
  Face_handle first_face() const { return m_tds.faces_begin(); }

  // those of the mesh, by the indices that they have here; none for those that the mesh does not have
  const std::vector<typename Mesh::Vertex_handle>& mesh_vertices() const { return m_mesh_vertices; }

  static bool is_free(Vertex_handle v) { return v->info(); }
  static bool is_in_patch(Face_handle f) { return f->neighbor(1) != Face_handle(); }
  static bool is_on_border(const Edge& e) { return !is_in_patch(e.first->neighbor(e.second)); }

  template <class Visit>
  void for_each_face(const Visit& visit) const
  {
    for(auto f = m_tds.faces_begin(); f != m_tds.faces_end(); ++f)
      if(is_in_patch(f))
        visit(Face_handle(f));
  }

  // Calls `visit` for the edges that are not on the border.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for_each_face([&](Face_handle f) {
      for(int i = 0; i < 3; ++i)
        if(f->vertex(Tds::ccw(i))->index() < f->vertex(Tds::cw(i))->index() && !is_on_border(Edge(f, i)))
          visit(Edge(f, i));
    });
  }

  // Calls `visit` for the edges on the border beyond which there is a vertex, as seen from within.
  template <class Visit>
  void for_each_open_border_edge(const Visit& visit) const
  {
    for(auto f = m_tds.faces_begin(); f != m_tds.faces_end(); ++f)
      if(!is_in_patch(f) && f->vertex(0) != Vertex_handle())
        visit(m_tds.mirror_edge(Edge(f, 0)));
  }

  // Calls `visit(f, i)` for the faces f of a free vertex, of which it is the i-th vertex, counterclockwise.
  template <class Visit>
  void for_each_face_at(Vertex_handle v, const Visit& visit) const
  {
    Face_handle f = v->face();
    do {
      const int i = f->index(v);
      visit(f, i);
      f = f->neighbor(Tds::ccw(i));
    } while(f != v->face());
  }

  // the vertex of the face of an edge that is not on it, its first end, the vertex beyond it, and its second end
  std::array<Vertex_handle, 4> quadrilateral(const Edge& e) const
  {
    return {{e.first->vertex(e.second), e.first->vertex(Tds::ccw(e.second)), m_tds.mirror_vertex(e.first, e.second),
             e.first->vertex(Tds::cw(e.second))}};
  }

  // whether the two faces of an edge form a strictly convex quadrilateral
  bool is_in_convex_quadrilateral(const Edge& e) const
  {
    const auto v = quadrilateral(e);
    return m_mesh->orientation(v[0]->point(), v[1]->point(), v[2]->point()) == LEFT_TURN
        && m_mesh->orientation(v[2]->point(), v[3]->point(), v[0]->point()) == LEFT_TURN;
  }

  // The tensor at x, which lies near a vertex: by the samples, unless the field is used.
  Symmetric_form tensor(const Vector_of_doubles& x, const Vertex& near) const
  {
    if(m_field)
      return (*m_field)(x);
    Place place = m_places[near.index()];
    const Symmetric_form m = m_metric->tensor(x, place);
    m_is_accurate = m_is_accurate && m_metric->is_accurate(place);
    return m;
  }

  Metric_tensor_2 metric_tensor(const Point& p, const Vertex& near) const
  {
    Place place = m_places[near.index()];
    return m_metric->metric_tensor(to_doubles(p), place);
  }

  bool uses_field() const { return m_field != nullptr; }

  // whether samples agreed with their interpolation wherever there was an evaluation
  bool is_accurate() const { return m_is_accurate; }

  // Takes the tensors of all free vertices from the field.
  void take_tensors_from_field()
  {
    const auto tensor = geom_traits().construct_metric_tensor_2_object();
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      if(is_free(v))
        v->set_metric_tensor(tensor(v->point()));
  }

  // Takes tensors from the field, from now on, but for those of the vertices, which are as they are.
  void use_field(Field_memo<Mesh>& field)
  {
    m_field = &field;
    for_each_face([this](Face_handle f) { update_shape(f); });
  }

  // of a face of these points, which lie near a vertex
  Face_shape shape(const Point& a, const Point& b, const Point& c, const Vertex& near) const
  {
    Face_shape result;
    if(m_mesh->orientation(a, b, c) != LEFT_TURN)
      return result; // its barycentre may be where the field has no value
    result.metric = tensor(barycentre({to_doubles(a), to_doubles(b), to_doubles(c)}), near);
    result.quality = metric_quality(a, b, c, result.metric);
    return result;
  }

  Face_shape shape(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    return shape(u->point(), v->point(), w->point(), *u);
  }

  // those that the faces of a free vertex have if it stands at `p`
  Face_shapes shapes_around(Vertex_handle v, const Point& p) const
  {
    Face_shapes result;
    for_each_face_at(v, [&](Face_handle f, int i) {
      result.push_back(shape(p, f->vertex(Tds::ccw(i))->point(), f->vertex(Tds::cw(i))->point(), *v));
    });
    return result;
  }

  // Moves a free vertex to `p`, where its tensor is `m` and its faces have the given shapes.
  void move(Vertex_handle v, const Point& p, const Metric_tensor_2& m, const Face_shapes& shapes)
  {
    v->set_point(p);
    v->set_metric_tensor(m);
    m_metric->metric_tensor(to_doubles(p), m_places[v->index()]);
    auto shape = shapes.begin();
    for_each_face_at(v, [&](Face_handle f, int) { f->info() = *shape++; });
    m_operations.push_back({MOVE, {{v->index()}}, p, m});
  }

  // Replaces an edge that is not on the border by the other diagonal of its two faces.
  void flip(const Edge& e)
  {
    const Face_handle f = e.first, g = f->neighbor(e.second);
    const int u = f->vertex(Tds::ccw(e.second))->index(), v = f->vertex(Tds::cw(e.second))->index();
    m_operations.push_back({FLIP, {{u, v}}, {}, {}});
    m_tds.flip(f, e.second);
    update_shape(f);
    update_shape(g);
  }

  // Divides a face into three at `p`, which may lie on an edge of it that is flipped next.
  Vertex_handle split(Face_handle f, const Point& p)
  {
    const Metric_tensor_2 m = metric_tensor(p, *f->vertex(0));
    const int a = f->vertex(0)->index(), b = f->vertex(1)->index(), c = f->vertex(2)->index();
    const Vertex_handle v = m_tds.insert_in_face(f);
    initialize(v, p, m, true);
    m_mesh_vertices.push_back({});
    m_places.push_back(m_places[a]);
    m_operations.push_back({SPLIT, {{a, b, c, v->index()}}, p, m});
    for_each_face_at(v, [&](Face_handle g, int) { update_shape(g); });
    return v;
  }

  // Removes a free vertex of degree 3.
  void unite(Vertex_handle v)
  {
    const Face_handle f = v->face();
    m_operations.push_back({UNITE, {{v->index()}}, {}, {}});
    m_tds.remove_degree_3(v, f);
    update_shape(f);
  }

  // Does on the mesh what has been done on the patch, whose tensors should be those of the field. Afterwards
  // `mesh_vertices()` has the new ones too.
  void write_to(Mesh& mesh)
  {
    for(const Operation& o : m_operations) {
      const auto vertex = [&](int k) { return m_mesh_vertices[o.vertices[k]]; };
      typename Mesh::Face_handle f;
      int i;
      if(o.kind == MOVE) {
        vertex(0)->set_point(o.point);
        vertex(0)->set_metric_tensor(o.tensor);
      }
      else if(o.kind == FLIP && mesh.is_edge(vertex(0), vertex(1), f, i))
        mesh.flip(f, i);
      else if(o.kind == SPLIT && mesh.is_face(vertex(0), vertex(1), vertex(2), f)) {
        typename Mesh::Cavity cavity;
        cavity.faces.push_back(f);
        for(i = 0; i < 3; ++i)
          cavity.boundary.push_back(mesh.mirror_edge(typename Mesh::Edge(f, i)));
        m_mesh_vertices[o.vertices[3]] = mesh.insert_in_cavity(o.point, o.tensor, cavity);
      }
      else if(o.kind == UNITE) {
        std::vector<typename Mesh::Edge> changed;
        Vertex_remover_2<Mesh>(mesh, vertex(0))(changed);
        m_mesh_vertices[o.vertices[0]] = {};
      }
    }
    m_operations.clear();
    for(auto v = m_tds.vertices_begin(); v != m_tds.vertices_end(); ++v)
      if(is_free(v)) {
        const auto w = m_mesh_vertices[v->index()];
        w->set_metric_tensor(v->metric_tensor());
        m_metric->set_place(w, m_places[v->index()]);
      }
  }

private:
  typedef typename Metric::Place Place;

  enum Kind { MOVE, FLIP, SPLIT, UNITE };

  struct Operation
  {
    Kind               kind;
    std::array<int, 4> vertices; // the vertex, the ends of the edge, or those of the face and the new one
    Point              point;
    Metric_tensor_2    tensor;
  };

  void update_shape(Face_handle f) { f->info() = shape(f->vertex(0), f->vertex(1), f->vertex(2)); }

  // to be called before the vertex is entered into m_mesh_vertices
  void initialize(Vertex_handle v, const Point& p, const Metric_tensor_2& m, bool is_free)
  {
    v->set_point(p);
    v->set_metric_tensor(m);
    v->set_index(int(m_mesh_vertices.size()));
    v->info() = is_free;
  }

  // `copies` has one for each of m_mesh_vertices
  Vertex_handle copy_of(typename Mesh::Vertex_handle v, std::vector<Vertex_handle>& copies, bool is_within)
  {
    const auto found = std::find(m_mesh_vertices.begin(), m_mesh_vertices.end(), v);
    if(found != m_mesh_vertices.end())
      return copies[found - m_mesh_vertices.begin()];
    copies.push_back(m_tds.create_vertex());
    initialize(copies.back(), v->point(), v->metric_tensor(), is_within && !m_mesh->is_fixed(v));
    m_mesh_vertices.push_back(v);
    m_places.push_back(m_metric->place_near(v));
    return copies.back();
  }

  void add_border(Face_handle f, int i, Vertex_handle beyond)
  {
    const Vertex_handle u = f->vertex(Tds::ccw(i)), v = f->vertex(Tds::cw(i));
    u->info() = v->info() = false;
    m_tds.set_adjacency(f, i, m_tds.create_face(beyond, v, u), 0);
  }

  const Mesh*                                m_mesh;
  Metric*                                    m_metric;
  std::vector<Place>                         m_places; // of the vertices
  mutable bool                               m_is_accurate = true;
  Field_memo<Mesh>*                          m_field = nullptr;
  Tds                                        m_tds;
  std::vector<typename Mesh::Vertex_handle>  m_mesh_vertices;
  std::vector<Operation>                     m_operations;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H

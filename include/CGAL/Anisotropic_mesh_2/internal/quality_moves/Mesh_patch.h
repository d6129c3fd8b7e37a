// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H

#include <CGAL/Anisotropic_mesh_2/internal/quality_moves/Patch_triangulation.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A copy of some faces of a mesh, on which changes are tried: only a patch that
// turns out better is written back, by `Patch_writer`.
//
// On its rim are the edges around it and constrained edges within it; they
// stay, and so do their vertices.
template <class Mesh_>
class Mesh_patch
  : public Patch_triangulation
{
public:
  typedef Mesh_                              Mesh;
  typedef typename Mesh::Point               Point;
  typedef typename Mesh::Metric_tensor_2     Metric_tensor_2;
  typedef typename Mesh::Vertex_handle       Vertex_handle;
  typedef typename Mesh::Face_handle         Face_handle;

  struct Vertex
  {
    Point           point;
    Metric_tensor_2 tensor;
    Vertex_handle   handle;         // none if the mesh does not have it yet
    bool            is_free = true; // neither fixed nor on the rim

    Vertex(const Point& p, const Metric_tensor_2& m) : point(p), tensor(m) {}
    explicit Vertex(Vertex_handle v) : point(v->point()), tensor(v->metric_tensor()), handle(v) {}
  };

  // an edge of the rim, with the patch on its left, and the vertex of the mesh
  // beyond it unless it is constrained or on the hull
  struct Rim_edge
  {
    int           source, target;
    Vertex_handle beyond;
  };

  typedef std::vector<Shape> Shapes;

  // The given faces of the mesh, which edges that are not constrained connect.
  Mesh_patch(const Mesh& mesh, const std::vector<Face_handle>& faces)
    : m_mesh(&mesh)
  {
    for(Face_handle f : faces)
      copy_face(f);
    connect(faces);
    for(int f = 0; f < number_of_faces(); ++f)
      update_shape(f);
  }

  const std::vector<Vertex>&   vertices() const { return m_vertices; }
  const std::vector<Rim_edge>& rim()      const { return m_rim; }

  // whether a vertex may move
  bool is_free(int v) const { return m_vertices[v].is_free && !is_removed(v); }

  Shape shape(int u, int v, int w) const
  {
    return shape(m_vertices[u].point, m_vertices[v].point, m_vertices[w].point);
  }

  Shape shape(const Point& a, const Point& b, const Point& c) const
  {
    Shape result;
    if(m_mesh->orientation(a, b, c) != LEFT_TURN)
      return result; // its barycentre may be where the field has no value
    result.metric = metric_at_barycentre(a, b, c, m_mesh->geom_traits().construct_metric_tensor_2_object());
    result.quality = metric_quality(a, b, c, result.metric);
    return result;
  }

  // the shapes that the faces of a free vertex have after a move
  Shapes shapes_around(int v, const Point& p) const
  {
    Shapes result;
    for_each_face_at(v, [&](int f, int i) {
      const auto& w = faces()[f].vertex;
      result.push_back(shape(p, m_vertices[w[ccw(i)]].point, m_vertices[w[cw(i)]].point));
    });
    return result;
  }

  double least_quality() const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Face& f : faces())
      if(f.is_used)
        least = (std::min)(least, f.shape.quality);
    return least;
  }

  // whether the edge is not on the rim and its two faces form a strictly convex quadrilateral
  bool is_flippable(int f, int i) const
  {
    const Face& face = faces()[f];
    if(face.neighbor[i] == none)
      return false;
    const int p = face.vertex[i], q = opposite(f, i);
    return is_counterclockwise(p, face.vertex[ccw(i)], q) && is_counterclockwise(q, face.vertex[cw(i)], p);
  }

  // Moves a free vertex.
  void move(int v, const Point& p) { move(v, Vertex(p, tensor(p)), shapes_around(v, p)); }

  // Moves it to the place of `to`, where its faces have the given shapes.
  void move(int v, const Vertex& to, const Shapes& shapes)
  {
    m_vertices[v].point = to.point;
    m_vertices[v].tensor = to.tensor;
    auto shape = shapes.begin();
    for_each_face_at(v, [&](int f, int) { m_faces[f].shape = *shape++; });
  }

  // Replaces an edge that is not on the rim; the faces keep their numbers.
  void flip(int f, int i)
  {
    const int g = faces()[f].neighbor[i];
    flip_edge(f, i);
    update_shape(f);
    update_shape(g);
  }

  // Divides a face into three at `p`, which may lie on the edge opposite to the
  // first vertex of one of them if that is flipped next.
  void split(int f, const Point& p)
  {
    m_vertices.push_back(Vertex(p, tensor(p)));
    split_face(f);
    for(int g : {f, number_of_faces() - 2, number_of_faces() - 1})
      update_shape(g);
  }

  // Removes a free vertex of degree 3.
  void unite(int v) { update_shape(unite_faces(v)); }

private:
  Metric_tensor_2 tensor(const Point& p) const
  {
    return m_mesh->geom_traits().construct_metric_tensor_2_object()(p);
  }

  bool is_counterclockwise(int u, int v, int w) const
  {
    return m_mesh->orientation(m_vertices[u].point, m_vertices[v].point, m_vertices[w].point) == LEFT_TURN;
  }

  void update_shape(int f)
  {
    Face& face = m_faces[f];
    face.shape = shape(face.vertex[0], face.vertex[1], face.vertex[2]);
  }

  void copy_face(Face_handle f)
  {
    Face copy;
    copy.neighbor = {{none, none, none}};
    for(int i = 0; i < 3; ++i) {
      copy.vertex[i] = number_of(f->vertex(i));
      m_face_of[copy.vertex[i]] = number_of_faces();
    }
    m_faces.push_back(copy);
  }

  int number_of(Vertex_handle v)
  {
    for(int i = 0; i < number_of_vertices(); ++i)
      if(m_vertices[i].handle == v)
        return i;
    m_vertices.push_back(Vertex(v));
    m_vertices.back().is_free = !m_mesh->is_fixed(v);
    m_face_of.push_back(none);
    return number_of_vertices() - 1;
  }

  void connect(const std::vector<Face_handle>& faces)
  {
    for(int f = 0; f < number_of_faces(); ++f)
      for(int i = 0; i < 3; ++i) {
        const Face_handle g = faces[f]->neighbor(i);
        const auto found = std::find(faces.begin(), faces.end(), g);
        if(found != faces.end() && !faces[f]->is_constrained(i)) {
          m_faces[f].neighbor[i] = int(found - faces.begin());
          continue;
        }
        const int u = m_faces[f].vertex[ccw(i)], v = m_faces[f].vertex[cw(i)];
        const bool is_fixed = faces[f]->is_constrained(i) || m_mesh->is_infinite(g);
        m_rim.push_back({u, v, is_fixed ? Vertex_handle() : g->vertex(m_mesh->mirror_index(faces[f], i))});
        m_vertices[u].is_free = m_vertices[v].is_free = false;
      }
  }

  const Mesh*           m_mesh;
  std::vector<Vertex>   m_vertices;
  std::vector<Rim_edge> m_rim;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_QUALITY_MOVES_MESH_PATCH_H

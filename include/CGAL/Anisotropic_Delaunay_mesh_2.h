// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_DELAUNAY_MESH_2_H
#define CGAL_ANISOTROPIC_DELAUNAY_MESH_2_H

#include <CGAL/Anisotropic_mesh_face_base_2.h>
#include <CGAL/Anisotropic_mesh_vertex_base_2.h>
#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/assign_data.h>
#include <CGAL/Anisotropic_mesh_2/Boundary_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/graph_of_triangulation.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/spatial_order.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// An anisotropic mesh: a generalized constrained Delaunay triangulation whose
/// faces know whether they belong to the domain and to which subdomain, and
/// whose constrained edges keep the references of the curves they come from.
///
/// The boundary mesh of a domain, inserted by `insert_boundary()`, gives the
/// *empty mesh* of section 3.2 of \cgalCite{dw-acvt-05}; refinement and
/// optimization leave its vertices and edges as they are.
///
/// \tparam Gt a model of `RiemannianMetricTraits_2`.
/// \tparam Tds_ a model of `TriangulationDataStructure_2` whose vertices model
/// `AnisotropicMeshVertexBase_2` and whose faces model `AnisotropicMeshFaceBase_2`; by default
/// `Triangulation_data_structure_2<Anisotropic_mesh_vertex_base_2<Gt>, Anisotropic_mesh_face_base_2<Gt> >`.
///
/// \sa `make_anisotropic_mesh_2()`
/// \sa `refine_anisotropic_mesh_2()`
/// \sa `optimize_anisotropic_mesh_2()`
template <class Gt, class Tds_ = Default>
class Anisotropic_Delaunay_mesh_2
#ifdef DOXYGEN_RUNNING
  : public Constrained_anisotropic_Delaunay_triangulation_2<Gt, Tds_>
#else
  : public Constrained_anisotropic_Delaunay_triangulation_2<
      Gt,
      typename Default::Get<Tds_, Triangulation_data_structure_2<
                                    Anisotropic_mesh_vertex_base_2<Gt>,
                                    Anisotropic_mesh_face_base_2<Gt> > >::type>
#endif
{
public:
  /// \name Types
  /// @{

  /// the data structure, which vertices and faces belong to.
#ifdef DOXYGEN_RUNNING
  typedef unspecified_type Tds;
#else
  typedef typename Default::Get<Tds_, Triangulation_data_structure_2<
                                        Anisotropic_mesh_vertex_base_2<Gt>,
                                        Anisotropic_mesh_face_base_2<Gt> > >::type  Tds;
#endif
  /// the base class: the triangulation, without a domain.
  typedef Constrained_anisotropic_Delaunay_triangulation_2<Gt, Tds>               Triangulation_kernel;

  typedef typename Gt::Kernel                            Kernel;          ///< that of the traits
  typedef typename Gt::Metric_tensor_2                   Metric_tensor_2; ///< a tensor of the field
  typedef typename Triangulation_kernel::Point           Point;           ///< a point
  typedef typename Triangulation_kernel::Edge            Edge;            ///< a face and an index in it
  typedef typename Triangulation_kernel::Vertex_handle   Vertex_handle;   ///< a vertex
  typedef typename Triangulation_kernel::Face_handle     Face_handle;     ///< a face
  typedef typename Triangulation_kernel::Face_circulator Face_circulator; ///< goes around a vertex
  typedef typename Triangulation_kernel::Locate_type     Locate_type;     ///< where a point has been found
  typedef typename Triangulation_kernel::Cavity          Cavity;          ///< what an insertion replaces

  typedef Anisotropic_mesh_2::Boundary_graph_2<Kernel> Boundary_graph; ///< what `insert_boundary()` takes
  /// @}

  /// \cond SKIP_IN_MANUAL
  using Triangulation_kernel::ccw;
  using Triangulation_kernel::cw;
  using Triangulation_kernel::insert;
  using Triangulation_kernel::insert_constraint;
  /// \endcond

  /// \name Creation
  /// @{

  /// the empty mesh under the metric field of `gt`.
  explicit Anisotropic_Delaunay_mesh_2(const Gt& gt = Gt()) : Triangulation_kernel(gt) {}

  /// inserts the vertices and edges of a boundary mesh, by `spatial_sort()` of its points, and marks the domain.
  /// The references of its regions are kept for later calls of `mark_domain()`.
  ///
  /// After a throw the mesh holds a part of the boundary without a domain, to be cleared or assigned to.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if edges cross.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at a point.
  void insert_boundary(const Boundary_graph& boundary)
  try
  {
    m_regions = boundary.regions;
    const std::vector<Vertex_handle> vertices = insert_boundary_points(boundary.points);
    for(const auto& s : boundary.segments)
      insert_boundary_segment(vertices[s.source], vertices[s.target],
                              Edge_mark{s.reference, s.is_boundary});
    mark_domain();
  }
  catch(const typename Triangulation_kernel::Intersection_of_constraints_exception&) {
    throw Anisotropic_mesh_2::Invalid_domain_exception
      ("the boundary curves or the constraints of the domain cross each other");
  }

  /// inserts the vertices and the constrained edges of a triangulation of \cgal, and marks the domain as it is there.
  /// Constrained edges get the reference 1.
  /// \tparam Triangulation an instance of `Constrained_triangulation_2` or of a class derived from it, whose points are
  /// those of the mesh and whose faces are models of `DelaunayMeshFaceBase_2`, like those of a `Delaunay_mesher_2`.
  /// \pre the mesh is empty, and the boundary of the domain is constrained in `triangulation`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at a vertex.
  template <class Triangulation>
  void insert_triangulation(const Triangulation& triangulation)
  {
    insert_boundary(Anisotropic_mesh_2::internal::graph_of_triangulation<Kernel>(triangulation));
  }

  /// the mesh of the fixed vertices and the constrained edges alone, with the
  /// same indices, references and domain: the stored empty mesh of section 4
  /// of \cgalCite{dw-acvt-05}. Vertices keep what their type stores.
  Anisotropic_Delaunay_mesh_2 empty_mesh() const
  {
    Anisotropic_Delaunay_mesh_2 result(this->geom_traits());
    result.m_edge_marks = m_edge_marks;
    result.m_regions = m_regions;
    std::unordered_map<int, Vertex_handle> copies;
    Vertex_handle last; // not a face, which the next constraint may delete
    const auto copy = [&](Vertex_handle v)
    {
      Vertex_handle& c = copies[v->index()];
      if(c == Vertex_handle()) {
        c = result.insert(v->point(), last == Vertex_handle() ? Face_handle() : last->face());
        Anisotropic_mesh_2::internal::assign_data(*c, *v);
      }
      return last = c;
    };
    for(auto f = this->all_faces_begin(); f != this->all_faces_end(); ++f)
      for(int i = 0; i < 3; ++i) {
        const Vertex_handle u = f->vertex(ccw(i)), v = f->vertex(cw(i));
        if(f->is_constrained(i) && u->index() < v->index())
          result.insert_constraint(copy(u), copy(v));
      }
    result.set_vertex_index_bound(this->vertex_index_bound());
    result.mark_domain();
    return result;
  }

  /// exchanges the two meshes, with their traits and their domains.
  void swap(Anisotropic_Delaunay_mesh_2& other)
  {
    Triangulation_kernel::swap(other);
    std::swap(m_edge_marks, other.m_edge_marks);
    std::swap(m_regions, other.m_regions);
  }
  /// @}

  /// \name Domain
  /// @{

  /// the reference of the curve that a constrained edge comes from, and 0 for any other edge.
  int edge_reference(const Edge& e) const
  {
    const auto mark = m_edge_marks.find(key(e));
    return mark == m_edge_marks.end() ? 0 : mark->second.reference;
  }

  /// whether the domain lies on exactly one side of the edge.
  bool is_on_boundary(const Edge& e) const
  {
    return e.first->is_in_domain() != e.first->neighbor(e.second)->is_in_domain();
  }

  /// whether the vertex is an end point of a constrained edge.
  bool is_fixed(Vertex_handle v) const { return this->are_there_incident_constraints(v); }

  /// the edges of the domain, each seen from the face from which its vertices
  /// are in the order of their indices, in an order that is the same in every run.
  std::vector<Edge> edges_in_domain() const
  {
    std::vector<Edge> edges;
    for(auto f = this->finite_faces_begin(); f != this->finite_faces_end(); ++f)
      for(int i = 0; i < 3 && f->is_in_domain(); ++i)
        if(f->vertex(ccw(i))->index() < f->vertex(cw(i))->index() || !f->neighbor(i)->is_in_domain())
          edges.push_back(Edge(f, i));
    return edges;
  }

  /// the number of faces of the domain; takes time linear in the number of all faces.
  std::size_t number_of_faces_in_domain() const
  {
    std::size_t n = 0;
    for(auto f = this->finite_faces_begin(); f != this->finite_faces_end(); ++f)
      n += f->is_in_domain();
    return n;
  }

  /// decides for every face whether it belongs to the domain, and to which
  /// subdomain. To be called after constraints were added or removed; insertion, removal
  /// and relocation of vertices keep the marks. The domain is bounded by what `insert_boundary()` has been given
  /// as a boundary; other constraints divide it into subdomains. Takes time linear in the number of faces.
  void mark_domain()
  {
    for(auto f = this->all_faces_begin(); f != this->all_faces_end(); ++f) {
      f->set_in_domain(false);
      f->set_subdomain_index(unvisited);
    }
    if(this->dimension() < 2)
      return;
    const std::vector<bool> inside = find_components();
    std::vector<int> references(inside.size(), 0);
    for(const auto& region : m_regions)
      references[component_at(region.seed)] = region.reference;
    for(auto f = this->all_faces_begin(); f != this->all_faces_end(); ++f) {
      f->set_in_domain(inside[f->subdomain_index()]);
      f->set_subdomain_index(references[f->subdomain_index()]);
    }
  }
  /// @}

  /// \name Insertion
  /// @{

  /// whether a point that `locate()` has found there lies inside of the domain
  /// and neither on a vertex nor on a constrained edge.
  bool is_field_point(Locate_type lt, Face_handle f, int li) const
  {
    return (lt == Triangulation_kernel::FACE
            || (lt == Triangulation_kernel::EDGE && this->dimension() == 2 && !f->is_constrained(li)))
        && f->is_in_domain();
  }

  /// inserts a point of the domain whose cavity is known; the new faces belong
  /// to the subdomain of the old ones.
  /// \pre `is_field_point()` holds where `p` lies, and `cavity` is what `find_cavity()` has found.
  Vertex_handle insert_field_point(const Point& p, const Metric_tensor_2& m, const Cavity& cavity)
  {
    const Face_mark mark(cavity.faces.front());
    const Vertex_handle v = this->insert_in_cavity(p, m, cavity);
    mark_star(v, [&](Face_handle) { return mark; });
    return v;
  }

  /// inserts `p`, where `m` is the tensor of the field at `p`. The new faces
  /// belong to the subdomains of the old ones, and both parts of a constrained
  /// edge on which `p` lies have its reference.
  Vertex_handle insert(const Point& p, const Metric_tensor_2& m, Locate_type lt, Face_handle f, int li) override
  {
    if(lt == Triangulation_kernel::VERTEX || this->dimension() < 2)
      return Triangulation_kernel::insert(p, m, lt, f, li);
    if(lt == Triangulation_kernel::EDGE && f->is_constrained(li))
      return split_constrained_edge(p, m, f, li);
    const Face_mark mark(f);
    const Vertex_handle v = Triangulation_kernel::insert(p, m, lt, f, li);
    mark_star(v, [&](Face_handle) { return mark; });
    return v;
  }
  /// @}

private:
  typedef Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel> Graph;

  struct Edge_mark
  {
    int  reference;
    bool is_boundary;
  };

  // what a face knows of the domain
  struct Face_mark
  {
    bool is_in_domain;
    int  subdomain;

    explicit Face_mark(Face_handle f) : is_in_domain(f->is_in_domain()), subdomain(f->subdomain_index()) {}
  };

  // a face from which a component is filled
  struct Seed
  {
    Face_handle face;
    bool        is_inside;
  };

  static constexpr int unvisited = -1;

  static std::uint64_t key(Vertex_handle u, Vertex_handle v)
  {
    const std::uint64_t i = (std::min)(u->index(), v->index()), j = (std::max)(u->index(), v->index());
    return (i << 32) | j;
  }
  static std::uint64_t key(const Edge& e)
  {
    return key(e.first->vertex(ccw(e.second)), e.first->vertex(cw(e.second)));
  }

  std::vector<Vertex_handle> insert_boundary_points(const std::vector<Point>& points)
  {
    std::vector<Vertex_handle> vertices(points.size());
    Face_handle hint;
    for(std::size_t i : Anisotropic_mesh_2::internal::spatial_order(points, this->geom_traits())) {
      vertices[i] = this->insert(points[i], hint);
      hint = vertices[i]->face();
    }
    return vertices;
  }

  // A segment that passes through other vertices becomes several edges.
  void insert_boundary_segment(Vertex_handle u, Vertex_handle v, const Edge_mark& mark)
  {
    insert_constraint(u, v);
    while(u != v) {
      Vertex_handle next;
      Face_handle f;
      int i;
      if(!this->includes_edge(u, v, next, f, i))
        return;
      const auto added = m_edge_marks.emplace(key(u, next), mark);
      if(!added.second) // two coinciding boundary edges have the same on both sides
        added.first->second.is_boundary = added.first->second.is_boundary != mark.is_boundary;
      u = next;
    }
  }

  template <class Mark_of_face>
  void mark_star(Vertex_handle v, const Mark_of_face& mark_of)
  {
    Face_circulator f = this->incident_faces(v), done(f);
    do {
      const Face_mark mark = mark_of(f);
      f->set_in_domain(mark.is_in_domain);
      f->set_subdomain_index(mark.subdomain);
    } while(++f != done);
  }

  Vertex_handle split_constrained_edge(const Point& p, const Metric_tensor_2& m, Face_handle f, int li)
  {
    const Face_mark left(f), right(f->neighbor(li));
    const Vertex_handle u = f->vertex(ccw(li)), w = f->vertex(cw(li)); // f is on the left from u to w
    const bool is_outside_left = this->is_infinite(f);
    const Vertex_handle v = Triangulation_kernel::insert(p, m, Triangulation_kernel::EDGE, f, li);
    mark_star(v, [&](Face_handle g) {
      if(this->is_infinite(g))
        return is_outside_left ? left : right;
      const int i = g->index(v);
      const Vertex_handle a = g->vertex(ccw(i)), b = g->vertex(cw(i)), off = a == u || a == w ? b : a;
      return this->orientation(u->point(), w->point(), off->point()) == LEFT_TURN ? left : right;
    });
    const auto mark = m_edge_marks.find(key(u, w));
    if(mark != m_edge_marks.end()) {
      const Edge_mark parts = mark->second;
      m_edge_marks.erase(mark);
      m_edge_marks[key(u, v)] = m_edge_marks[key(v, w)] = parts;
    }
    return v;
  }

  // Numbers the components that constrained edges separate, from the outermost
  // on, in the subdomain indices of the faces; returns which belong to the domain.
  std::vector<bool> find_components()
  {
    std::vector<bool> inside;
    std::deque<Seed> seeds(1, Seed{this->infinite_face(), false});
    for(; !seeds.empty(); seeds.pop_front()) {
      const Seed seed = seeds.front();
      if(seed.face->subdomain_index() != unvisited)
        continue;
      flood(seed, static_cast<int>(inside.size()), seeds);
      inside.push_back(seed.is_inside);
    }
    return inside;
  }

  void flood(const Seed& seed, int component, std::deque<Seed>& seeds)
  {
    std::vector<Face_handle> stack(1, seed.face);
    seed.face->set_subdomain_index(component);
    while(!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      for(int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if(g->subdomain_index() != unvisited)
          continue;
        if(f->is_constrained(i))
          seeds.push_back(Seed{g, is_inside_beyond(Edge(f, i), seed.is_inside)});
        else {
          g->set_subdomain_index(component);
          stack.push_back(g);
        }
      }
    }
  }

  bool is_inside_beyond(const Edge& e, bool inside) const
  {
    const auto mark = m_edge_marks.find(key(e));
    return inside != (mark != m_edge_marks.end() && mark->second.is_boundary);
  }

  int component_at(const Point& p) const { return this->locate(p)->subdomain_index(); }

  std::unordered_map<std::uint64_t, Edge_mark> m_edge_marks;
  std::vector<typename Graph::Region>          m_regions;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_DELAUNAY_MESH_2_H

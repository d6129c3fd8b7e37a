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
#include <CGAL/Anisotropic_mesh_2/internal/mesh/is_own_edge.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/flood.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/assign_data.h>
#include <CGAL/Anisotropic_mesh_2/Boundary_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/graph_of_triangulation.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/spatial_order.h>

#include <cstddef>
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
  /// \endcond

  /// \name Creation
  /// @{

  /// the empty mesh under the metric field of `gt`.
  explicit Anisotropic_Delaunay_mesh_2(const Gt& gt = Gt()) : Triangulation_kernel(gt) {}

  /// inserts the vertices and edges of a boundary mesh, by `spatial_sort()` of its points, and marks the domain.
  /// The references of its regions are kept for later calls of `mark_domain()`. Edges that have a reference keep it,
  /// and of two boundaries on the same edge none is left.
  ///
  /// After a throw the mesh holds a part of the boundary without a domain, to be cleared or assigned to.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if edges cross.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at a point.
  void insert_boundary(const Boundary_graph& boundary)
  try
  {
    const std::vector<Vertex_handle> vertices = insert_boundary_points(boundary.points);
    for(const auto& s : boundary.segments)
      insert_segment(vertices[s.source], vertices[s.target], {true, s.reference, s.is_boundary});
    m_regions.insert(m_regions.end(), boundary.regions.begin(), boundary.regions.end());
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
    result.m_regions = m_regions;
    std::vector<Vertex_handle> copies(this->vertex_index_bound());
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
    for(Vertex_handle v : this->finite_vertex_handles())
      if(v->is_required())
        copy(v);
    for(const Edge& e : constrained_edges()) {
      const Vertex_handle source = copy(e.first->vertex(ccw(e.second))), target = copy(e.first->vertex(cw(e.second)));
      result.insert_segment(source, target, Anisotropic_mesh_2::internal::edge_mark(*e.first, e.second));
    }
    result.set_vertex_index_bound(this->vertex_index_bound());
    result.mark_domain();
    return result;
  }

  /// removes all vertices, and forgets the domain.
  void clear()
  {
    Triangulation_kernel::clear();
    m_regions.clear();
  }

  /// exchanges the two meshes, with their traits and their domains.
  void swap(Anisotropic_Delaunay_mesh_2& other)
  {
    Triangulation_kernel::swap(other);
    std::swap(m_regions, other.m_regions);
  }
  /// @}

  /// \name Domain
  /// @{

  /// the reference of the curve that a constrained edge comes from, and 0 for any other edge.
  int edge_reference(const Edge& e) const { return e.first->edge_reference(e.second); }

  /// whether the domain lies on exactly one side of the edge.
  bool is_on_boundary(const Edge& e) const
  {
    return this->dimension() == 2 && e.first->is_in_domain() != e.first->neighbor(e.second)->is_in_domain();
  }

  /// the faces of the domain, in an order that is the same in every run.
  std::vector<Face_handle> faces_in_domain() const
  {
    std::vector<Face_handle> faces;
    for(Face_handle f : this->finite_face_handles())
      if(f->is_in_domain())
        faces.push_back(f);
    return faces;
  }

  /// the constrained edges, each seen from the face, which may be infinite, from which its vertices are in
  /// the order of their indices; in an order that is the same in every run.
  std::vector<Edge> constrained_edges() const
  {
    std::vector<Edge> edges;
    if(this->dimension() == 1) // there are no faces to go through
      edges.assign(this->constrained_edges_begin(), this->constrained_edges_end());
    for(Face_handle f : this->all_face_handles())
      for(int i = 0; i < 3; ++i)
        if(f->is_constrained(i) && f->vertex(ccw(i))->index() < f->vertex(cw(i))->index())
          edges.push_back(Edge(f, i));
    return edges;
  }

  /// the edges of the domain, in an order that is the same in every run; each seen from the domain, and if that
  /// lies on both sides, as by `constrained_edges()`.
  std::vector<Edge> edges_in_domain() const
  {
    std::vector<Edge> edges;
    for(Face_handle f : faces_in_domain())
      for(int i = 0; i < 3; ++i)
        if(Anisotropic_mesh_2::internal::is_own_edge(f, i))
          edges.push_back(Edge(f, i));
    return edges;
  }

  /// the vertices of the faces of the domain, in the order of `finite_vertices_begin()`.
  std::vector<Vertex_handle> vertices_in_domain() const
  {
    std::vector<bool> is_used(this->vertex_index_bound(), false);
    for(Face_handle f : faces_in_domain())
      for(int i = 0; i < 3; ++i)
        is_used[f->vertex(i)->index()] = true;
    std::vector<Vertex_handle> vertices;
    for(Vertex_handle v : this->finite_vertex_handles())
      if(is_used[v->index()])
        vertices.push_back(v);
    return vertices;
  }

  /// the number of faces of the domain; takes time linear in the number of all faces.
  std::size_t number_of_faces_in_domain() const
  {
    std::size_t n = 0;
    for(Face_handle f : this->finite_face_handles())
      n += f->is_in_domain();
    return n;
  }

  /// the number of vertices of faces of the domain; takes time linear in the number of all faces.
  std::size_t number_of_vertices_in_domain() const { return vertices_in_domain().size(); }

  /// decides for every face to which subdomain it belongs. To be called after constraints were added or
  /// removed; insertion, removal and relocation of vertices keep the marks. The domain stays what `insert_boundary()`
  /// has been given. Where a constraint between inside and outside was removed, both become what the part is that fewer
  /// boundaries separate from the infinite face. Takes time linear in the number of faces.
  void mark_domain()
  {
    for(auto f = this->all_faces_begin(); f != this->all_faces_end(); ++f)
      f->set_subdomain_index(unvisited);
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
  /// @}

private:
  typedef Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel> Graph;
  typedef Anisotropic_mesh_2::internal::Edge_mark                  Edge_mark;

  // a face from which a component is filled
  struct Seed
  {
    Face_handle face;
    bool        is_inside;
  };

  static constexpr int unvisited = -1;

  std::vector<Vertex_handle> insert_boundary_points(const std::vector<Point>& points)
  {
    std::vector<Vertex_handle> vertices(points.size());
    Face_handle hint;
    for(std::size_t i : Anisotropic_mesh_2::internal::spatial_order(points)) {
      vertices[i] = this->insert(points[i], hint);
      hint = vertices[i]->face();
    }
    return vertices;
  }

  // A segment that passes through other vertices becomes several edges. Where these are constrained already, they
  // keep their reference, and of two coinciding boundaries none is left, since both sides are alike.
  void insert_segment(Vertex_handle u, Vertex_handle v, const Edge_mark& mark)
  {
    this->insert_constraint(u, v);
    while(u != v) {
      Vertex_handle next;
      Edge e;
      if(!this->includes_edge(u, v, next, e.first, e.second))
        return;
      const Edge_mark old = Anisotropic_mesh_2::internal::edge_mark(*e.first, e.second);
      this->set_mark(e, {true, old.reference != 0 ? old.reference : mark.reference,
                         old.is_boundary != mark.is_boundary});
      u = next;
    }
  }

  // Numbers the components that constrained edges separate, from the outermost
  // on, in the subdomain indices of the faces; returns which belong to the domain.
  std::vector<bool> find_components()
  {
    std::vector<bool> inside;
    std::vector<Seed> seeds(1, Seed{this->infinite_face(), false});
    for(std::size_t i = 0; i < seeds.size(); ++i) {
      const Seed seed = seeds[i];
      if(seed.face->subdomain_index() != unvisited)
        continue;
      const int component = static_cast<int>(inside.size());
      inside.push_back(seed.is_inside);
      seed.face->set_subdomain_index(component);
      Anisotropic_mesh_2::internal::flood(std::vector<Face_handle>(1, seed.face), [&](Face_handle f, int i) {
        const Face_handle g = f->neighbor(i);
        if(g->subdomain_index() != unvisited)
          return false;
        if(f->is_constrained(i)) {
          seeds.push_back(Seed{g, seed.is_inside != f->is_boundary(i)});
          return false;
        }
        g->set_subdomain_index(component);
        return true;
      });
    }
    return inside;
  }

  int component_at(const Point& p) const { return this->locate(p)->subdomain_index(); }

  std::vector<typename Graph::Region> m_regions;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_DELAUNAY_MESH_2_H

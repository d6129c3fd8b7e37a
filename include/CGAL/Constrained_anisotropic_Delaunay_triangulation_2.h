// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONSTRAINED_ANISOTROPIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_CONSTRAINED_ANISOTROPIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/Anisotropic_mesh_vertex_base_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/face_marks.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/Flip_policy.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/Triangulation_checker_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/kernel/Vertex_remover_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/spatial_order.h>

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_data_structure_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <iostream>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// The generalized constrained Delaunay kernel (\cgalCite{bghls-dmg-97}, section 3.1 of
/// \cgalCite{dw-acvt-05}): a constrained triangulation in which a new point is
/// joined to the boundary of its *cavity*, the connected set of faces that are
/// in conflict with it under the metric tensors of the point and of the three
/// vertices of the face.
///
/// Constraints are never crossed. With a constant metric the triangulation is
/// the constrained Delaunay triangulation of the points in that metric, with an
/// isotropic metric it is the Euclidean one. With any other metric it depends
/// on the order of insertion; what always holds is that every face is strictly
/// counterclockwise and that all constraints are there.
///
/// Where the traits decide exactly, a cavity is star-shaped by itself; where
/// they do not, faces that the point does not see are left out of it.
///
/// Members of the base class that are not listed here, such as `locate()`, ranges and circulators, are unchanged,
/// except for those that would leave vertices without tensor and index or edges without their marks:
/// `insert_in_face()`, `insert_in_edge()`, `insert_outside_convex_hull()`, `insert_outside_affine_hull()`,
/// `insert_first()`, `insert_second()`, `remove_first()`, `remove_second()`, `remove_degree_3()`,
/// `remove_and_give_new_faces()`, `remove_constraint()`, `star_hole()`, `make_hole()`, `copy_triangulation()`,
/// `create_face()`, `delete_face()`, `delete_vertex()`, `collapse_edge()`, `file_input()` and the operator `>>` cannot
/// be called.
///
/// \tparam Gt a model of `RiemannianMetricTraits_2`.
/// \tparam Tds_ a model of `TriangulationDataStructure_2` whose vertices model
/// `AnisotropicMeshVertexBase_2` and whose faces model `ConstrainedTriangulationFaceBase_2`; by default
/// `Triangulation_data_structure_2<Anisotropic_mesh_vertex_base_2<Gt>, Constrained_triangulation_face_base_2<Gt> >`.
/// \tparam Itag_ what to do about intersecting constraints, as in `Constrained_triangulation_2`. The
/// default, `No_constraint_intersection_requiring_constructions_tag`, refuses them; with another one `Gt` must
/// also model `ConstrainedTriangulationTraits_2`.
template <class Gt, class Tds_ = Default, class Itag_ = Default>
class Constrained_anisotropic_Delaunay_triangulation_2
#ifdef DOXYGEN_RUNNING
  : public Constrained_triangulation_2<Gt, Tds_, Itag_>
#else
  : public Constrained_triangulation_2<
      Gt,
      typename Default::Get<Tds_, Triangulation_data_structure_2<
                                    Anisotropic_mesh_vertex_base_2<Gt>,
                                    Constrained_triangulation_face_base_2<Gt> > >::type,
      typename Default::Get<Itag_, No_constraint_intersection_requiring_constructions_tag>::type>
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
                                        Constrained_triangulation_face_base_2<Gt> > >::type  Tds;
#endif
  /// what to do about intersecting constraints.
#ifdef DOXYGEN_RUNNING
  typedef unspecified_type Itag;
#else
  typedef typename Default::Get<Itag_, No_constraint_intersection_requiring_constructions_tag>::type Itag;
#endif
  /// the base class.
  typedef Constrained_triangulation_2<Gt, Tds, Itag>  Constrained_triangulation;

  typedef Gt                                                   Geom_traits;     ///< the traits
  typedef typename Gt::Metric_tensor_2                         Metric_tensor_2; ///< a tensor of the field
  typedef typename Constrained_triangulation::Point            Point;           ///< a point
  typedef typename Constrained_triangulation::Edge             Edge;            ///< a face and an index in it
  typedef typename Constrained_triangulation::Vertex_handle    Vertex_handle;   ///< a vertex
  typedef typename Constrained_triangulation::Face_handle      Face_handle;     ///< a face
  typedef typename Constrained_triangulation::Face_circulator  Face_circulator; ///< goes around a vertex
  typedef typename Constrained_triangulation::Locate_type      Locate_type;     ///< where a point has been found
  typedef typename Constrained_triangulation::List_faces       List_faces;      ///< faces of a hole
  typedef typename Constrained_triangulation::List_edges       List_edges;      ///< edges around a hole
  typedef typename Constrained_triangulation::size_type        size_type;       ///< a number of items
  /// @}

  /// \cond SKIP_IN_MANUAL
  using Constrained_triangulation::ccw;
  using Constrained_triangulation::cw;
  using Constrained_triangulation::dimension;
  using Constrained_triangulation::geom_traits;
  using Constrained_triangulation::are_there_incident_constraints;
  using Constrained_triangulation::insert_constraint;
  using Constrained_triangulation::is_constrained;
  using Constrained_triangulation::is_infinite;
  using Constrained_triangulation::locate;
  using Constrained_triangulation::mirror_edge;
  using Constrained_triangulation::mirror_index;
  using Constrained_triangulation::number_of_vertices;
  using Constrained_triangulation::orientation;
  /// \endcond

  /// \name Creation
  /// @{

  /// the empty triangulation under the metric field of `gt`.
  explicit Constrained_anisotropic_Delaunay_triangulation_2(const Gt& gt = Gt())
    : Constrained_triangulation(gt)
  {}
  /// @}

  /// \name Insertion and Removal
  /// @{

  /// inserts `p` and returns its vertex, which is an old one if there is one at `p`.
  /// The search for `p` starts at `start`.
  ///
  /// The cost is that of the location plus the size of the cavity, on average constant.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at `p`.
  Vertex_handle insert(const Point& p, Face_handle start = Face_handle())
  {
    Locate_type lt;
    int li;
    const Face_handle f = locate(p, lt, li, start);
    return insert(p, lt, f, li);
  }

  /// inserts `p` where `locate()` has found it.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at `p`.
  Vertex_handle insert(const Point& p, Locate_type lt, Face_handle f, int li)
  {
    if(lt == Constrained_triangulation::VERTEX)
      return dimension() == 0 ? this->finite_vertex() : f->vertex(li);
    return insert(p, geom_traits().construct_metric_tensor_2_object()(p), lt, f, li);
  }

  /// inserts `p`, where `m` is the tensor of the field at `p`. Both parts of a constrained edge on which `p` lies
  /// are constrained.
  Vertex_handle insert(const Point& p, const Metric_tensor_2& m, Locate_type lt, Face_handle f, int li)
  {
    if(lt == Constrained_triangulation::VERTEX)
      return dimension() == 0 ? this->finite_vertex() : f->vertex(li);
    if(dimension() < 2)
      return insert_in_low_dimension(p, m, lt, f, li);
    if(!is_inside_hull(lt, f, li))
      return insert_at_hull(p, m, lt, f, li);
    Cavity cavity;
    find_cavity(p, m, lt, f, li, cavity);
    return insert_in_cavity(p, m, cavity);
  }

  /// inserts `p`, so that `std::back_inserter()` takes the triangulation.
  Vertex_handle push_back(const Point& p) { return insert(p); }

  /// removes `v` and restores the local criterion around its place.
  ///
  /// All that faces and other vertices store stays. The cost is linear in the
  /// degree of `v` and in the number of flips.
  /// \return whether `v` was removed. That is always so if the traits decide
  /// exactly; if they do not, rounding errors may leave no way to fill the hole
  /// with counterclockwise faces, and `v` stays.
  /// \pre `v` is a finite vertex of the triangulation and not fixed.
  bool remove(Vertex_handle v)
  {
    CGAL_precondition(v != Vertex_handle() && !is_infinite(v));
    CGAL_precondition(!is_fixed(v));
    if(dimension() < 2 || this->test_dim_down(v)) {
      Constrained_triangulation::remove(v);
      return true;
    }
    std::vector<Edge> changed;
    const bool is_removed = Anisotropic_mesh_2::internal::Vertex_remover_2<Self>(*this, v)(changed);
    restore_local_criterion(std::move(changed));
    return is_removed;
  }

  /// moves `v` to `p` unless another vertex stands there, and restores the local criterion.
  ///
  /// The vertex keeps its handle, its index and all that it stores, and takes
  /// the tensor of `p`. It may move anywhere if it is not fixed. An
  /// end of constrained edges takes them along.
  /// \return `v`, or the vertex that stands at `p`, in which case nothing changes.
  /// If the traits do not decide exactly, `v` may also stay where it is, as with `remove()`; a constrained edge on
  /// which `p` lies then keeps a new vertex there.
  /// \pre `v` is a finite vertex of the triangulation. If it is fixed, its faces are finite and are still
  /// counterclockwise with `v` at `p`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at
  /// `p`; nothing changes.
  Vertex_handle move_if_no_collision(Vertex_handle v, const Point& p)
  {
    CGAL_precondition(v != Vertex_handle() && !is_infinite(v));
    if(this->xy_equal(v->point(), p))
      return v;
    const Metric_tensor_2 m = geom_traits().construct_metric_tensor_2_object()(p);
    if(is_star_around(v, p)) {
      v->set_point(p);
      v->set_metric_tensor(m);
      restore_local_criterion(edges_of_star(v));
      return v;
    }
    CGAL_precondition(!is_fixed(v));
    Locate_type lt;
    int li;
    const Face_handle f = locate(p, lt, li, v->face());
    if(lt == Constrained_triangulation::VERTEX)
      return dimension() == 0 ? this->finite_vertex() : f->vertex(li);
    const int index_bound = m_vertex_index_bound;
    const Vertex_handle w = insert(p, m, lt, f, li);
    exchange(v, w);
    bool is_removed = remove(w);
    if(!is_removed) { // rounding errors leave no way to fill the hole: v stays
      exchange(v, w);
      is_removed = !is_fixed(w) && remove(w);
    }
    if(is_removed)
      m_vertex_index_bound = index_bound;
    return v;
  }

  /// moves `v` to `p`; if another vertex stands there, `v` is removed.
  /// \return the vertex at `p`.
  /// \pre as for `move_if_no_collision()`, and `v` is not fixed if another vertex stands at `p`.
  Vertex_handle move(Vertex_handle v, const Point& p)
  {
    const Vertex_handle w = move_if_no_collision(v, p);
    if(w != v)
      remove(v);
    return w;
  }

  /// whether `v` ends a constrained edge or is required. Algorithms that move or remove vertices leave it as it is.
  bool is_fixed(Vertex_handle v) const { return v->is_required() || are_there_incident_constraints(v); }

  /// makes the constrained edge a free one, and restores the local criterion.
  void remove_constrained_edge(Face_handle f, int i)
  {
    set_mark(Edge(f, i), Edge_mark());
    if(dimension() == 2)
      restore_local_criterion(std::vector<Edge>(1, Edge(f, i)));
  }

  /// makes all edges of `v` free ones, and restores the local criterion.
  void remove_incident_constraints(Vertex_handle v)
  {
    std::vector<Edge> constrained;
    this->incident_constraints(v, std::back_inserter(constrained));
    for(const Edge& e : constrained)
      set_mark(e, Edge_mark());
    if(dimension() == 2)
      restore_local_criterion(edges_of_star(v));
  }

  /// inserts the points of a range in the order of `spatial_sort()` and returns
  /// the number of vertices added. Takes \f$ O(n \log n) \f$ time on average.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at a point; the
  /// points before it are inserted.
  /// \tparam PointIterator an input iterator with value type `Point`.
  template <class PointIterator>
  std::ptrdiff_t insert(PointIterator first, PointIterator last)
  {
    const size_type before = number_of_vertices();
    const std::vector<Point> points(first, last);
    Face_handle hint;
    for(std::size_t i : Anisotropic_mesh_2::internal::spatial_order(points))
      hint = insert(points[i], hint)->face();
    return number_of_vertices() - before;
  }

  /// inserts the points of a range and the segments between consecutive ones
  /// as constraints, and if `close` the segment from the last to the first.
  /// \throw Intersection_of_constraints_exception of the base class if constraints cross and `Itag` is the default.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field has no valid tensor at a point.
  /// \tparam PointIterator an input iterator with value type `Point`.
  template <class PointIterator>
  void insert_constraint(PointIterator first, PointIterator last, bool close = false)
  {
    if(first == last)
      return;
    const Vertex_handle start = insert(*first);
    Vertex_handle v = start;
    for(++first; first != last; ++first) {
      const Vertex_handle w = insert(*first, v->face());
      if(v != w)
        insert_constraint(v, w);
      v = w;
    }
    if(close && v != start)
      insert_constraint(v, start);
  }
  /// @}

  /// \name Indices
  /// Vertices are numbered in the order of their insertion.
  /// @{

  /// a number larger than the index of any vertex; the next vertex gets it as its index.
  int vertex_index_bound() const { return m_vertex_index_bound; }

  /// \cgalAdvancedBegin
  /// makes `bound` the index of the next vertex, for algorithms that number vertices themselves.
  /// \cgalAdvancedEnd
  void set_vertex_index_bound(int bound) { m_vertex_index_bound = bound; }

  /// removes all vertices, and starts their numbers from 0.
  void clear()
  {
    Constrained_triangulation::clear();
    m_vertex_index_bound = 0;
  }

  /// exchanges the two triangulations, with their traits.
  void swap(Constrained_anisotropic_Delaunay_triangulation_2& other)
  {
    Constrained_triangulation::swap(other);
    std::swap(m_vertex_index_bound, other.m_vertex_index_bound);
  }
  /// @}

  /// \name Cavities
  /// \cgalAdvancedBegin
  /// For algorithms that look at what an insertion would replace before they insert; others call `insert()`.
  /// \cgalAdvancedEnd
  /// @{

  /// what the insertion of a point replaces.
  struct Cavity
  {
    boost::container::small_vector<Face_handle, 16> faces;    ///< connected
    boost::container::small_vector<Edge, 18>        boundary; ///< around them, counterclockwise, as seen from outside
    int split_edge = -1; ///< the index of the edge in the first face on which the point lies, if it is constrained
  };

  /// whether the finite face `f` is in conflict with a point `p` of tensor `m`.
  bool is_in_conflict(Face_handle f, const Point& p, const Metric_tensor_2& m) const
  {
    const auto &a = *f->vertex(0), &b = *f->vertex(1), &c = *f->vertex(2);
    return geom_traits().side_of_metric_circle_2_object()
             (a.point(), b.point(), c.point(), p,
              a.metric_tensor(), b.metric_tensor(), c.metric_tensor(), m) == ON_POSITIVE_SIDE;
  }

  /// finds the cavity of `p`, which `locate()` has found inside of a finite face or of an edge with two finite
  /// faces. It extends to both sides of that edge, be it constrained.
  /// \param p the point
  /// \param m the tensor of the field at `p`
  /// \param lt what `locate()` has found: `FACE` or `EDGE`
  /// \param f the face that it has returned
  /// \param li the index of the edge in `f`
  /// \param[out] cavity is added to; empty before
  void find_cavity(const Point& p, const Metric_tensor_2& m, Locate_type lt, Face_handle f, int li,
                   Cavity& cavity) const
  {
    CGAL_precondition(is_inside_hull(lt, f, li));
    boost::container::small_vector<Edge, 16> to_cross; // a stack: the next edge counterclockwise on top
    const auto enter = [&](Face_handle g, int from)
    {
      cavity.faces.push_back(g);
      to_cross.push_back(Edge(g, cw(from)));
      to_cross.push_back(Edge(g, ccw(from)));
    };

    cavity.split_edge = -1;
    if(lt == Constrained_triangulation::EDGE) {
      const Edge e = mirror_edge(Edge(f, li));
      cavity.split_edge = f->is_constrained(li) ? e.second : -1;
      enter(e.first, e.second);
      enter(f, li);
    }
    else {
      cavity.faces.push_back(f);
      for(int i = 2; i >= 0; --i)
        to_cross.push_back(Edge(f, i));
    }
    while(!to_cross.empty()) {
      const Edge inner = to_cross.back();
      to_cross.pop_back();
      const Edge outer = mirror_edge(inner);
      if(is_crossed(inner, outer, p, m))
        enter(outer.first, outer.second);
      else
        cavity.boundary.push_back(outer);
    }
  }

  /// replaces `cavity` by the ball of `p`, the faces that join `p` to its boundary, and returns the new vertex.
  /// The new faces belong to the subdomains of the old ones, and both parts of a divided edge have its reference.
  /// \param p the point
  /// \param m the tensor of the field at `p`
  /// \param cavity what `find_cavity()` has found, as long as the triangulation has not changed
  Vertex_handle insert_in_cavity(const Point& p, const Metric_tensor_2& m, const Cavity& cavity)
  {
    const Divided_edge divided(cavity.faces.front(), cavity.split_edge);
    const Vertex_handle v = Triangulation::star_hole(p, cavity.boundary.begin(), cavity.boundary.end(),
                                                     cavity.faces.begin(), cavity.faces.end());
    initialize(v, m);
    mark_star(v, divided);
    return v;
  }
  /// @}

  /// \name Flips
  /// \cgalAdvancedBegin
  /// For algorithms that move vertices without the triangulation's knowledge.
  /// \cgalAdvancedEnd
  /// @{

  /// whether the edge is neither constrained nor on the hull, and its two faces
  /// form a strictly convex quadrilateral.
  bool is_flippable(Face_handle f, int i) const
  {
    const Face_handle g = f->neighbor(i);
    if(f->is_constrained(i) || is_infinite(f) || is_infinite(g))
      return false;
    const Point& p = f->vertex(i)->point();
    const Point& q = g->vertex(mirror_index(f, i))->point();
    return orientation(p, f->vertex(ccw(i))->point(), q) == LEFT_TURN
        && orientation(q, f->vertex(cw(i))->point(), p) == LEFT_TURN;
  }

  /// replaces the edge by the other diagonal of its two faces.
  /// \pre `is_flippable(f, i)`
  void flip(Face_handle f, int i)
  {
    using namespace Anisotropic_mesh_2::internal;
    const Face_handle g = f->neighbor(i);
    const int j = mirror_index(f, i);
    // around the quadrilateral f->vertex(i), f->vertex(ccw(i)), g->vertex(j), f->vertex(cw(i)):
    const Edge_mark m0 = edge_mark(*f, cw(i)), m1 = edge_mark(*g, ccw(j));
    const Edge_mark m2 = edge_mark(*g, cw(j)), m3 = edge_mark(*f, ccw(i));
    const Vertex_handle v0 = f->vertex(i), v1 = f->vertex(ccw(i)), v2 = g->vertex(j), v3 = f->vertex(cw(i));

    this->tds().flip(f, i);

    const auto mark = [&](Face_handle h, Vertex_handle opposite, const Edge_mark& m)
                      { set_edge_mark(*h, h->index(opposite), m); };
    const Face_handle h = f->has_vertex(v1) ? f : g, k = f->has_vertex(v1) ? g : f;
    mark(h, v1, Edge_mark()); mark(h, v2, m0); mark(h, v0, m1); // h = v0 v1 v2
    mark(k, v3, Edge_mark()); mark(k, v0, m2); mark(k, v2, m3); // k = v2 v3 v0
  }

  /// whether the edge satisfies the criterion from at least one of its sides,
  /// or cannot be flipped.
  bool is_locally_Delaunay(Face_handle f, int i) const
  {
    if(f->is_constrained(i) || is_infinite(f) || is_infinite(f->neighbor(i)))
      return true;
    const Edge e = mirror_edge(Edge(f, i));
    // most often the first test decides
    return !is_in_conflict(f, e.first->vertex(e.second)) || !is_flippable(f, i)
        || !is_in_conflict(e.first, f->vertex(i));
  }

  /// flips the given edges, and then those around the flipped ones, until all
  /// are locally Delaunay.
  ///
  /// This ends by itself where all tensors involved are multiples of
  /// one, as with a constant or an isotropic metric. With different tensors flips
  /// might go around in a circle; therefore, after a number of flips
  /// proportional to that of the edges, only those are done that raise the lower quality of the two faces, measured
  /// in the mean of the tensors of the vertices of each;
  /// and since rounding errors may let even qualities rise endlessly, all flips end after
  /// a fixed multiple of that number.
  /// \return the number of flips.
  size_type restore_local_criterion(std::vector<Edge> edges)
  {
    using namespace Anisotropic_mesh_2::internal;
    Flip_policy<Self, Quality_in_mean_tensor> policy(*this, Quality_in_mean_tensor(), edges.size());
    return flip_edges(std::move(edges), [&](const Edge& e) { return policy(e); });
  }

  /// flips those of the given edges for which `is_wanted` holds, and then those
  /// around the flipped ones, until none is left.
  /// \tparam Is_wanted a predicate on edges that holds for flippable ones only,
  /// and that does not hold endlessly.
  /// \return the number of flips.
  template <class Is_wanted>
  size_type flip_edges(std::vector<Edge> edges, const Is_wanted& is_wanted)
  {
    size_type flips = 0;
    while(!edges.empty()) {
      const Edge e = edges.back();
      edges.pop_back();
      if(!is_wanted(e))
        continue;
      const Face_handle f = e.first, g = f->neighbor(e.second);
      flip(f, e.second);
      ++flips;
      for(int i = 0; i < 3; ++i) {
        if(f->neighbor(i) != g)
          edges.push_back(Edge(f, i));
        if(g->neighbor(i) != f)
          edges.push_back(Edge(g, i));
      }
    }
    return flips;
  }
  /// @}

  /// \name Checking
  /// @{

  /// checks the triangulation.
  ///
  /// \param verbose whether the first defect is written to `std::cerr`.
  /// \param level what is checked:
  /// - 0: the data structure, the marks of the constraints, and the geometry:
  ///   every finite face is strictly counterclockwise and the hull is convex.
  ///   Coordinates that are floating point numbers are compared exactly.
  /// - 1: also the vertices: each has the tensor of the field at its point and
  ///   an index of its own below `vertex_index_bound()`.
  /// - 2: also the criterion, if the tensors of all vertices are multiples of one:
  ///   every edge is locally Delaunay, or constrained. This holds in constant and
  ///   isotropic metrics; where vertices of other tensors were there and have been
  ///   removed, it need not. How close any other triangulation comes to being Delaunay is
  ///   measured by `anisotropic_Delaunay_consistency_2()`.
  bool is_valid(bool verbose = false, int level = 0) const
  {
    return Anisotropic_mesh_2::internal::Triangulation_checker_2<Self>(*this).is_valid(verbose, level);
  }
  /// @}

  /// \cond SKIP_IN_MANUAL
protected:
  typedef Anisotropic_mesh_2::internal::Edge_mark     Edge_mark;
  typedef Anisotropic_mesh_2::internal::Region_mark   Region_mark;

  // what the base class calls to insert a point
  Vertex_handle virtual_insert(const Point& p, Face_handle start = Face_handle()) override
  {
    return insert(p, start);
  }

  Vertex_handle virtual_insert(const Point& p, Locate_type lt, Face_handle f, int li) override
  {
    return insert(p, lt, f, li);
  }

  // The hole that a new constraint leaves is triangulated in any way, and then
  // flipped until its edges are locally Delaunay.
  void triangulate_hole(List_faces& faces, List_edges& boundary_ab, List_edges& boundary_ba) override
  {
    using namespace Anisotropic_mesh_2::internal;
    const Region_mark region = region_mark(*faces.front());
    std::vector<Marked_ends> around;
    for(const List_edges* part : {&boundary_ab, &boundary_ba})
      for(const Edge& e : *part)
        if(is_constrained(e))
          around.push_back(Marked_ends(e));
    List_edges new_edges;
    Constrained_triangulation::triangulate_hole(faces, boundary_ab, boundary_ba, new_edges);
    for(const Edge& e : new_edges)
      set_region_mark(*e.first, region);
    restore_marks(around);
    restore_local_criterion(std::vector<Edge>(new_edges.begin(), new_edges.end()));
  }

  // marks an edge on both its sides
  void set_mark(const Edge& e, const Edge_mark& m)
  {
    using namespace Anisotropic_mesh_2::internal;
    set_edge_mark(*e.first, e.second, m);
    if(dimension() < 2)
      return;
    const Edge other = mirror_edge(e);
    set_edge_mark(*other.first, other.second, m);
  }
  /// \endcond

private:
  // what would break the invariants
  using Constrained_triangulation::collapse_edge;
  using Constrained_triangulation::copy_triangulation;
  using Constrained_triangulation::create_face;
  using Constrained_triangulation::delete_face;
  using Constrained_triangulation::delete_vertex;
  using Constrained_triangulation::file_input;
  using Constrained_triangulation::insert_first;
  using Constrained_triangulation::insert_in_edge;
  using Constrained_triangulation::insert_in_face;
  using Constrained_triangulation::insert_outside_affine_hull;
  using Constrained_triangulation::insert_outside_convex_hull;
  using Constrained_triangulation::insert_second;
  using Constrained_triangulation::make_hole;
  using Constrained_triangulation::remove_and_give_new_faces;
  using Constrained_triangulation::remove_constraint;
  using Constrained_triangulation::remove_degree_3;
  using Constrained_triangulation::remove_first;
  using Constrained_triangulation::remove_second;
  using Constrained_triangulation::star_hole;
  friend std::istream& operator>>(std::istream&, Constrained_anisotropic_Delaunay_triangulation_2&) = delete;

  typedef Constrained_anisotropic_Delaunay_triangulation_2   Self;
  typedef typename Constrained_triangulation::Triangulation  Triangulation;

  void initialize(Vertex_handle v, const Metric_tensor_2& m)
  {
    v->set_metric_tensor(m);
    v->set_index(m_vertex_index_bound++);
  }

  bool is_in_conflict(Face_handle f, Vertex_handle v) const
  {
    return is_in_conflict(f, v->point(), v->metric_tensor());
  }

  bool is_inside_hull(Locate_type lt, Face_handle f, int li) const
  {
    return dimension() == 2
        && (lt == Constrained_triangulation::FACE
            || (lt == Constrained_triangulation::EDGE && !is_infinite(f) && !is_infinite(f->neighbor(li))));
  }

  // The base class joins p to what it sees of the hull.
  Vertex_handle insert_at_hull(const Point& p, const Metric_tensor_2& m, Locate_type lt, Face_handle f, int li)
  {
    const Divided_edge divided(f, lt == Constrained_triangulation::EDGE && f->is_constrained(li) ? li : -1);
    const Vertex_handle v = Constrained_triangulation::insert(p, lt, f, li);
    initialize(v, m);
    mark_star(v, divided);
    restore_star(v);
    return v;
  }

  // What is known of the i-th edge of a face, which a point divides, and of both sides; if i < 0, of the face alone.
  struct Divided_edge
  {
    Vertex_handle source, target; // with the face on the left
    Edge_mark     mark;
    Region_mark   left, right;

    Divided_edge(Face_handle f, int i)
      : left(Anisotropic_mesh_2::internal::region_mark(*f)), right(left)
    {
      using namespace Anisotropic_mesh_2::internal;
      if(i < 0)
        return;
      source = f->vertex(ccw(i));
      target = f->vertex(cw(i));
      mark = edge_mark(*f, i);
      right = region_mark(*f->neighbor(i));
    }
  };

  // Gives the faces of a new vertex the marks of what they replace.
  void mark_star(Vertex_handle v, const Divided_edge& divided)
  {
    using namespace Anisotropic_mesh_2::internal;
    const auto mark_to = [&](Vertex_handle w)
                         { return w == divided.source || w == divided.target ? divided.mark : Edge_mark(); };
    Face_circulator f = this->incident_faces(v);
    while(divided.target != Vertex_handle() && f->vertex(ccw(f->index(v))) != divided.target)
      ++f;
    bool is_left = true;
    const Face_circulator done(f);
    do {
      const int i = f->index(v);
      const Edge beyond = mirror_edge(Edge(f, i));
      is_left = is_left && f->vertex(ccw(i)) != divided.source;
      set_edge_mark(*f, i, edge_mark(*beyond.first, beyond.second));
      set_edge_mark(*f, ccw(i), mark_to(f->vertex(cw(i))));
      set_edge_mark(*f, cw(i), mark_to(f->vertex(ccw(i))));
      set_region_mark(*f, is_left ? divided.left : divided.right);
    } while(++f != done);
  }

  // the mark of an edge while faces are replaced
  struct Marked_ends
  {
    Vertex_handle source, target;
    Edge_mark     mark;

    explicit Marked_ends(const Edge& e)
      : source(e.first->vertex(ccw(e.second))), target(e.first->vertex(cw(e.second))),
        mark(Anisotropic_mesh_2::internal::edge_mark(*e.first, e.second))
    {}
  };

  void restore_marks(const std::vector<Marked_ends>& edges)
  {
    for(const Marked_ends& ends : edges) {
      Edge e;
      if(this->is_edge(ends.source, ends.target, e.first, e.second))
        set_mark(e, ends.mark);
    }
  }

  // The base class inserts into a triangulation of points on a line.
  Vertex_handle insert_in_low_dimension(const Point& p, const Metric_tensor_2& m, Locate_type lt, Face_handle f, int li)
  {
    using namespace Anisotropic_mesh_2::internal;
    std::vector<Marked_ends> edges;
    if(lt == Constrained_triangulation::OUTSIDE_AFFINE_HULL)
      for(const Edge& e : this->constrained_edges())
        edges.push_back(Marked_ends(e));
    const Edge_mark divided = lt == Constrained_triangulation::EDGE ? edge_mark(*f, li) : Edge_mark();
    const Vertex_handle v = Constrained_triangulation::insert(p, lt, f, li);
    initialize(v, m);
    restore_marks(edges);
    if(dimension() == 1) {
      auto e = this->incident_edges(v), done(e);
      do {
        set_mark(*e, divided);
      } while(++e != done);
    }
    return v;
  }

  bool is_crossed(const Edge& inner, const Edge& outer, const Point& p, const Metric_tensor_2& m) const
  {
    if(inner.first->is_constrained(inner.second) || is_infinite(outer.first)
       || !is_in_conflict(outer.first, p, m))
      return false;
    const bool seen = Gt::has_exact_predicates || sees_other_edges(outer, p);
    CGAL_expensive_assertion(!Gt::has_exact_predicates || sees_other_edges(outer, p));
    return seen;
  }

  // whether p lies strictly on the inner side of the two edges of the face other than e
  bool sees_other_edges(const Edge& e, const Point& p) const
  {
    const Point& a = e.first->vertex(e.second)->point();
    return orientation(a, e.first->vertex(ccw(e.second))->point(), p) == LEFT_TURN
        && orientation(e.first->vertex(cw(e.second))->point(), a, p) == LEFT_TURN;
  }

  // Flips the edges opposite to v until no face beyond them is in conflict with
  // it. A flip adds an edge to v and none is ever taken away, which ends it.
  void restore_star(Vertex_handle v)
  {
    std::vector<Edge> opposite;
    Face_circulator f = this->incident_faces(v), done(f);
    do {
      opposite.push_back(Edge(f, f->index(v)));
    } while(++f != done);

    while(!opposite.empty()) {
      const Edge e = opposite.back();
      opposite.pop_back();
      const Face_handle outside = e.first->neighbor(e.second);
      if(is_infinite(e.first) || is_infinite(outside) || e.first->is_constrained(e.second)
         || !is_in_conflict(outside, v) || !is_flippable(e.first, e.second))
        continue;
      flip(e.first, e.second);
      opposite.push_back(Edge(e.first, e.first->index(v)));
      opposite.push_back(Edge(outside, outside->index(v)));
    }
  }

  // whether the faces of v would be counterclockwise if v stood at p
  bool is_star_around(Vertex_handle v, const Point& p) const
  {
    if(dimension() < 2)
      return false;
    Face_circulator f = this->incident_faces(v), done(f);
    do {
      const int i = f->index(v);
      if(is_infinite(f)
         || orientation(p, f->vertex(ccw(i))->point(), f->vertex(cw(i))->point()) != LEFT_TURN)
        return false;
    } while(++f != done);
    return true;
  }

  // the edges of the faces of v
  std::vector<Edge> edges_of_star(Vertex_handle v) const
  {
    std::vector<Edge> edges;
    Face_circulator f = this->incident_faces(v), done(f);
    do {
      const int i = f->index(v);
      edges.push_back(Edge(f, i));
      edges.push_back(Edge(f, ccw(i)));
    } while(++f != done);
    return edges;
  }

  // the faces that have v, each with the index of v; in low dimension these are edges and vertices
  std::vector<Edge> corners_at(Vertex_handle v) const
  {
    std::vector<Edge> corners;
    if(dimension() == 2) {
      Face_circulator f = this->incident_faces(v), done(f);
      do {
        corners.push_back(Edge(f, f->index(v)));
      } while(++f != done);
    }
    else
      for(auto f = this->tds().faces().begin(); f != this->tds().faces().end(); ++f)
        if(f->has_vertex(v))
          corners.push_back(Edge(f, f->index(v)));
    return corners;
  }

  // lets two vertices take each other's place; everything but point and tensor stays theirs
  void exchange(Vertex_handle v, Vertex_handle w)
  {
    const std::vector<Edge> at_v = corners_at(v), at_w = corners_at(w);
    for(const Edge& c : at_v)
      c.first->set_vertex(c.second, w);
    for(const Edge& c : at_w)
      c.first->set_vertex(c.second, v);
    const Point p = v->point();
    const Metric_tensor_2 m = v->metric_tensor();
    const Face_handle f = v->face();
    v->set_point(w->point());
    v->set_metric_tensor(w->metric_tensor());
    v->set_face(w->face());
    w->set_point(p);
    w->set_metric_tensor(m);
    w->set_face(f);
  }

  int m_vertex_index_bound = 0;
};

} // namespace CGAL

#endif // CGAL_CONSTRAINED_ANISOTROPIC_DELAUNAY_TRIANGULATION_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_DOMAIN_2_H
#define CGAL_ANISOTROPIC_MESH_DOMAIN_2_H

#include <CGAL/license/Anisotropic_mesh_2.h>

#include <CGAL/Anisotropic_mesh_2/Curve_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_piece_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/domain_from_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_preparation.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {

template <class Kernel, class Container>
class Polygon_with_holes_2;

/// \ingroup PkgAnisotropicMesh2Classes
///
/// A domain of the plane, bounded by closed loops of curve pieces, with inner
/// curves that become edges of its mesh (the input of section 3.2 of \cgalCite{dw-acvt-05}).
///
/// The `rule()` decides what is inside. By default, crossing a loop toggles
/// (even-odd), so that a loop within another one is a hole; with the first call
/// of `add_hole()`, outside is what is reached from infinity or from a hole's
/// seed without crossing any curve. Where two boundary pieces coincide, they
/// cancel to an inner curve (even-odd rule only).
///
/// Inner curves may touch each other and the boundary in end points, or with an
/// end on a segment or curve. An end that misses a segment or a curve by the
/// rounding of the coordinates (2<sup>-46</sup> of them) counts as on it.
///
/// Nothing is checked for being a domain before `validate()` or the meshing.
/// Messages number pieces from 1 in the order in which they were added, and
/// edges of a graph in the order of the graph.
///
/// \tparam K a model of `Kernel`. With a floating point number type, all decisions
/// are made with exact predicates.
///
/// \sa `CGAL::Anisotropic_mesh_2::Curve_piece_2`
template <class K>
class Anisotropic_mesh_domain_2
{
public:
  typedef K                                                        Kernel;      ///< the kernel
  typedef typename K::FT                                           FT;          ///< its number type
  typedef typename K::Point_2                                      Point_2;     ///< its points
  typedef Anisotropic_mesh_2::Curve_piece_2<K>  Curve_piece; ///< a piece of a curve
  typedef Anisotropic_mesh_2::Domain_rule                          Domain_rule; ///< what decides what is inside
  typedef Anisotropic_mesh_2::Planar_straight_line_graph_2<K>      Graph;       ///< what files hold
  typedef typename Graph::Region                                   Region;      ///< a seed and its reference

#ifndef DOXYGEN_RUNNING
  typedef std::vector<Anisotropic_mesh_2::internal::Domain_piece_2<K> >  Pieces;
#endif

  /// \name Creation
  /// @{

  /// a domain without curves.
  Anisotropic_mesh_domain_2() {}

  /// the domain that a graph bounds, as files hold it.
  ///
  /// If the graph has triangles, these are the domain: their boundary edges
  /// bound it, with the references of the listed edges; listed edges within,
  /// and edges between triangles of different reference, are inner curves
  /// (reference 0 if not listed). With `triangle_references`, a region is added
  /// for each part that the inner curves leave connected.
  ///
  /// If it has none, edges that belong to a cycle bound the domain, others are
  /// inner curves. Where a cycle is divided, so that an odd number of edges
  /// meets at a vertex, only the outer cycle of the connected edges bounds.
  ///
  /// Points that no edge uses are ignored. Holes of the graph are added.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if an index is out of range, a point is
  /// not finite, two points are equal, or an edge has more than two triangles.
  explicit Anisotropic_mesh_domain_2(const Graph& graph)
  {
    namespace internal = Anisotropic_mesh_2::internal;
    internal::check_graph(graph);
    if(graph.triangles.empty())
      m_pieces = internal::pieces_of_edges(graph);
    else {
      const internal::Domain_from_triangles<K> domain(graph);
      m_pieces = domain.pieces();
      m_regions = domain.regions();
    }
    for(const Point_2& seed : graph.holes)
      add_hole(seed);
    for(const Region& region : graph.regions)
      add_region(region.seed, region.reference);
  }

  /// adds the closed loop of segments through the given points, in any direction.
  /// \tparam PointRange a range of `Point_2`, for example `CGAL::Polygon_2<K>`
  /// \param points the corners, the first one not repeated
  /// \param reference the reference of the edges on the loop
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if a coordinate is not finite.
  template <class PointRange>
  void add_polygon(const PointRange& points, int reference = 1)
  {
    const std::vector<Point_2> p(points.begin(), points.end());
    for(std::size_t i = 0; i < p.size(); ++i)
      add(Curve_piece::segment(p[i], p[(i+1) % p.size()], reference), Role::BOUNDARY);
  }

  /// adds the outer boundary and the holes of a polygon, as closed loops of segments.
  /// \param polygon the polygon
  /// \param reference the reference of the edges on the loops
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if a coordinate is not finite.
  template <class Container>
  void add_polygon(const Polygon_with_holes_2<K, Container>& polygon, int reference = 1)
  {
    add_polygon(polygon.outer_boundary(), reference);
    for(auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      add_polygon(*hole, reference);
  }

  /// adds a closed loop of curve pieces, each of which ends exactly where the
  /// next one starts.
  /// \tparam CurvePieceRange a range of `Anisotropic_mesh_2::Curve_piece_2<K>`
  /// \param pieces the pieces, in order; what does not close is reported by `validate()` and by the meshing only.
  template <class CurvePieceRange>
  void add_loop(const CurvePieceRange& pieces)
  {
    for(const Curve_piece& piece : pieces)
      add(piece, Role::BOUNDARY);
  }

  /// adds a circle.
  /// \param center the center
  /// \param radius the radius, in units of the coordinates
  /// \param reference the reference of the edges on it
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if an argument is not finite or the radius is not positive.
  void add_circle(const Point_2& center, const FT& radius, int reference = 1)
  {
    add(Curve_piece::arc(center, radius, 0, 6.283185307179586, reference), Role::BOUNDARY);
  }

  /// adds an inner curve, which stays in the mesh as a chain of edges.
  void add_constraint(const Curve_piece& piece) { add(piece, Role::CONSTRAINT); }

  /// adds an inner curve of segments through the given points, open unless the
  /// first point is repeated at the end.
  /// \tparam PointRange a range of `Point_2`
  /// \param points the corners
  /// \param reference the reference of the edges on the line
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if a coordinate is not finite.
  template <class PointRange>
  void add_polyline(const PointRange& points, int reference = 1)
  {
    const std::vector<Point_2> p(points.begin(), points.end());
    for(std::size_t i = 1; i < p.size(); ++i)
      add(Curve_piece::segment(p[i-1], p[i], reference), Role::CONSTRAINT);
  }

  /// declares what is around the seed a hole, and sets the rule to `FLOOD_FROM_SEEDS`.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if a coordinate is not finite.
  void add_hole(const Point_2& seed)
  {
    check_finite(seed, "hole");
    m_holes.push_back(seed);
    m_rule = Domain_rule::FLOOD_FROM_SEEDS;
  }

  /// gives a reference to the subdomain around the seed, that is, to the faces that are reached from it without
  /// crossing a curve. Of several seeds in a subdomain the last one counts; without a seed the reference is 0.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception if a coordinate is not finite.
  void add_region(const Point_2& seed, int reference)
  {
    check_finite(seed, "region");
    m_regions.push_back(Region{seed, reference});
  }

  /// sets the rule that decides what is inside.
  void set_rule(Domain_rule rule) { m_rule = rule; }
  /// @}

  /// \name Access
  /// @{

  /// the rule that decides what is inside: `EVEN_ODD` unless `add_hole()` or `set_rule()` was called.
  Domain_rule rule() const { return m_rule; }

  /// the seeds of the holes, as they were added.
  const std::vector<Point_2>& holes() const { return m_holes; }

  /// the seeds of subdomains with their references, as they were added.
  const std::vector<Region>& regions() const { return m_regions; }

  /// returns whether there are no curves at all.
  bool empty() const { return m_pieces.empty(); }

  /// the number of curve pieces.
  std::size_t number_of_pieces() const { return m_pieces.size(); }

#ifndef DOXYGEN_RUNNING
  const Pieces& pieces() const { return m_pieces; }
#endif
  /// @}

  /// checks that the curves bound a domain.
  ///
  /// Takes \f$ O(n \log n) \f$ time for \f$ n \f$ pieces whose bounding boxes hardly overlap.
  /// \throw Anisotropic_mesh_2::Invalid_domain_exception naming what is wrong and where: no curve
  /// or no area, a piece without length or with a coordinate beyond 10<sup>150</sup>,
  /// an open boundary, curves that cross or overlap, a boundary that touches itself,
  /// the seed of a hole on a curve, or an inner curve outside.
  void validate() const
  {
    Anisotropic_mesh_2::internal::Domain_preparation<K>(m_pieces, m_rule, m_holes);
  }

private:
  typedef Anisotropic_mesh_2::internal::Piece_role Role;

  void add(const Curve_piece& piece, Role role)
  {
    m_pieces.push_back({piece, role, m_pieces.size() + 1});
  }

  static void check_finite(const Point_2& seed, const char* what)
  {
    if(!(CGAL::is_finite(seed.x()) && CGAL::is_finite(seed.y())))
      throw Anisotropic_mesh_2::Invalid_domain_exception("the seed " + Anisotropic_mesh_2::internal::describe(seed)
                                                         + " of a " + what + " is not finite");
  }

  Pieces               m_pieces;
  Domain_rule          m_rule = Domain_rule::EVEN_ODD;
  std::vector<Point_2> m_holes;
  std::vector<Region>  m_regions;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_DOMAIN_2_H

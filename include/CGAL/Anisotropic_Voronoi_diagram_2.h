// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H
#define CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H

#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Mesh_generators.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_pieces.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_subdivision.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_tds.h>
#include <CGAL/Anisotropic_mesh_2/Directional_distance_2.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// The anisotropic Voronoi tessellation of the vertices of a mesh: each point
/// of the domain belongs to the region of its nearest generator
/// (section 2.3 of \cgalCite{dw-acvt-05}).
///
/// Regions are complete: a region need not be connected, and its pieces that
/// do not contain the generator, its *orphans*, are found wherever the metric
/// makes them. The triangulation serves as a covering of the domain only; it
/// may be any constrained triangulation of the generators. The regions tile the
/// domain, and neighboring pieces have the points of their common bisector in common.
///
/// The faces of the triangulation are bisected until the tensors at their
/// corners and in their middle show that at most three generators are nearest
/// in each, and which. Bisectors are traced by root finding. Features of the
/// metric that escape all these samples are not seen, and below the tolerance
/// nothing is resolved: tips of regions that are narrower may be taken for
/// orphans. In the wildest metrics the bisection ends early, at 200000 vertices
/// and 200 more per generator. Everything is computed in `double`, whatever the kernel.
///
/// For a smooth metric and a mesh of good quality, the construction takes
/// \f$ O(n \log n) \f$ time with a few evaluations of the field per face.
///
/// \tparam Mesh_ an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam Distance_ a model of `GeneratorMetric_2`.
/// \tparam ConcurrencyTag_ enables sequential or parallel construction: `Sequential_tag`, `Parallel_tag` or
/// `Parallel_if_available_tag`. `Parallel_tag` needs TBB and calls the metric field, but not the distance, from
/// several threads at the same time. The diagram is the same to the bit; with every tag several
/// threads may call its members at the same time.
template <class Mesh_, class Distance_ = Anisotropic_mesh_2::Directional_distance_2,
          class ConcurrencyTag_ = Sequential_tag>
class Anisotropic_Voronoi_diagram_2
{
public:
  /// \name Types
  /// @{
  typedef Mesh_                                                          Mesh;           ///< the mesh
  typedef Distance_                                                      Distance;       ///< the distance
  typedef ConcurrencyTag_                                                ConcurrencyTag; ///< the tag
  typedef typename Mesh::Kernel                                          Kernel;         ///< that of the mesh
  typedef typename Mesh::Point                                           Point_2;        ///< a point
  typedef typename Mesh::Vertex_handle                                   Vertex_handle;  ///< a generator in the mesh

  /// a connected part of the region of a generator: a main or an orphan subregion in section 2.3 of
  /// \cgalCite{dw-acvt-05}.
  struct Piece
  {
    typedef std::vector<Point_2> Polygon; ///< the corners of a closed line

    bool                 is_main = false; ///< whether it contains the generator; else it is an orphan
    double               area = 0;        ///< the Euclidean area
    std::vector<Polygon> boundaries;      ///< the outer ones counterclockwise, those of holes clockwise
  };

  /// the region of a generator, within the domain (definition 2.2 of \cgalCite{dw-acvt-05}).
  struct Region
  {
    typedef std::array<Point_2, 3> Tile; ///< the corners of a triangle

    Vertex_handle      vertex;           ///< the generator in the mesh
    Point_2            generator;        ///< its position
    bool               is_fixed = false; ///< whether the generator is a fixed vertex of the mesh
    double             area = 0;         ///< the Euclidean area of all pieces
    std::vector<Piece> pieces;           ///< the main ones first
    /// triangles that make up the region, counterclockwise; next to bisectors
    /// that turn sharply a few of them may be clockwise, and count as negative.
    std::vector<Tile>  tiles;

    /// the number of pieces that do not contain the generator.
    std::size_t number_of_orphans() const
    {
      return static_cast<std::size_t>(
        std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return !p.is_main; }));
    }
  };

  /// a curve along which the regions of two generators meet, as a polygonal line
  /// (definition 2.2 of \cgalCite{dw-acvt-05}).
  struct Bisector
  {
    std::array<std::size_t, 2> regions;  ///< the one on the left and the one on the right
    bool                       is_between_main_pieces; ///< else a piece beside it is an orphan
    bool                       is_closed; ///< whether the last point is joined to the first one
    std::vector<Point_2>       points;    ///< the corners of the line, in order
  };

  /// the integrals over the region of a generator (section 2.4 of \cgalCite{dw-acvt-05}).
  struct Integrals
  {
    Point_2 mass_centre;           ///< the generator itself, if the region is empty
    double  mass_centre_error = 0; ///< a bound of the error of the quadrature, as a length in the mean tensor
    double  area = 0;              ///< in the measure
    double  energy = 0;            ///< the integral of the squared distance to the generator
    /// the entries a, b, c of the matrix \f$ A \f$ with the rows (a, b) and (b, c), the integral of the tensor
    std::array<double, 3> matrix = {{0, 0, 0}};
    /// the derivatives of the energy by the coordinates of the generator, for the
    /// directional distance: \f$ 2 A \f$ times the vector from the mass centre to the generator
    std::array<double, 2> energy_gradient = {{0, 0}};
  };

  /// how far a triangulation is dual to a tessellation in the sense of definition
  /// 2.3 of \cgalCite{dw-acvt-05}: which of its edges join generators whose main
  /// pieces share a bisector. Generators are named by the indices of their regions.
  struct Duality
  {
    typedef std::pair<std::size_t, std::size_t> Pair; ///< two regions, the smaller index first

    std::size_t       number_of_dual_edges = 0;   ///< edges with a bisector
    std::vector<Pair> edges_without_bisector;     ///< in increasing order
    std::vector<Pair> bisectors_without_edge;     ///< in increasing order

    /// the share of dual edges among all pairs joined by an edge or sharing a bisector; 1 if there are none.
    double share_of_dual_edges() const
    {
      const std::size_t all = number_of_dual_edges + edges_without_bisector.size() + bisectors_without_edge.size();
      return all == 0 ? 1 : double(number_of_dual_edges) / double(all);
    }
  };
  /// @}

  /// \name Creation
  /// @{

  /// the tessellation of the domain of `mesh`, which must outlive it and not be changed meanwhile.
  ///
  /// \param mesh the mesh, with its domain marked.
  /// \param distance the distance from points to generators.
  /// \param tolerance how far bisectors may be from where they should be,
  /// relative to the distance to their generators.
  /// \pre `tolerance` lies between 10<sup>-9</sup> and 0.1.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
  explicit Anisotropic_Voronoi_diagram_2(const Mesh& mesh, const Distance& distance = Distance(),
                                         double tolerance = 1e-4)
    : m_mesh(mesh), m_generators(mesh, distance)
  {
    CGAL_precondition(tolerance >= 1e-9 && tolerance <= 0.1);
    const Subdivision subdivision(mesh, m_generators, tolerance);
    take_regions(subdivision);
    collect_neighbors();
  }

  /// a temporary mesh would not outlive the tessellation.
  explicit Anisotropic_Voronoi_diagram_2(const Mesh&&, const Distance& = Distance(), double = 1e-4) = delete;
  /// @}

  /// the mesh that was given.
  const Mesh& mesh() const { return m_mesh; }

  /// \name Regions
  /// @{

  /// the number of vertices of the domain.
  std::size_t number_of_regions() const { return m_regions.size(); }

  /// the regions of the vertices of the domain, in the order of the mesh.
  const std::vector<Region>& regions() const { return m_regions; }

  /// the region with the index `i`.
  /// \pre `i < number_of_regions()`
  const Region& region(std::size_t i) const { return m_regions[i]; }

  /// the index of the region of a vertex.
  /// \pre `v` is a vertex of a face of the domain.
  std::size_t index(Vertex_handle v) const { return m_generators.numbers()[v->index()]; }

  /// the curves between the regions.
  const std::vector<Bisector>& bisectors() const { return m_bisectors; }

  /// the regions whose main pieces share a bisector with that of region `i`, in increasing order.
  const std::vector<std::size_t>& neighbors(std::size_t i) const { return m_neighbors[i]; }

  /// the index of the region to which `p` belongs, the least one if there are
  /// several; decided by the distances to the generators alone, without the regions.
  /// \pre `number_of_regions() > 0`
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the distance is measured at points and the field
  /// fails at `p`.
  std::size_t nearest_generator(const Point_2& p) const
  {
    CGAL_precondition(number_of_regions() > 0);
    return m_generators.set().nearest(metric_point_at(p));
  }

  /// the squared distance from `p` to the generator of region `i`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the distance is measured at points and the field
  /// fails at `p`.
  double squared_distance(const Point_2& p, std::size_t i) const
  {
    return m_generators.set().squared_distance(metric_point_at(p), i);
  }
  /// @}

  /// \name Integrals
  /// @{

  /// the mass centre, area and energy of a region, by adaptive quadrature
  /// (sections 2.4 and 4.2 of \cgalCite{dw-acvt-05}).
  ///
  /// \param i the index of the region
  /// \param measure whether areas are weighted by the root of the determinant of the tensor
  /// \param tolerance of the mass centre, relative to the root mean square distance to the generator
  /// \return the integrals, with a bound of the error of the mass centre
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the region.
  Integrals integrals(std::size_t i,
                      Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN,
                      double tolerance = 1e-4) const
  {
    Integrals result;
    const auto sum = m_generators.integrate(i, triangles(i), measure, tolerance, result.mass_centre_error);
    const Vector& z = m_generators.set().position(i);
    const Vector d = sum.moments.lloyd_move();
    result.mass_centre = point({z.x + d.x, z.y + d.y});
    result.area = sum.mass;
    result.energy = sum.energy;
    result.matrix = {sum.moments.a.a, sum.moments.a.b, sum.moments.a.c};
    result.energy_gradient = {-2 * sum.moments.gx, -2 * sum.moments.gy};
    return result;
  }

  /// compares the edges of the triangulation with the neighbors of regions (definition 2.3 of
  /// \cgalCite{dw-acvt-05}); takes \f$ O(n \log n) \f$ time.
  Duality duality() const
  {
    typedef typename Duality::Pair Pair;
    std::vector<Pair> edges, neighbors, dual;
    for(const typename Mesh::Edge& e : m_mesh.edges_in_domain()) {
      const std::size_t i = index(e.first->vertex(Mesh::ccw(e.second))), j = index(e.first->vertex(Mesh::cw(e.second)));
      edges.emplace_back((std::min)(i, j), (std::max)(i, j));
    }
    std::sort(edges.begin(), edges.end());
    for(std::size_t i = 0; i < m_neighbors.size(); ++i)
      for(std::size_t j : m_neighbors[i])
        if(i < j)
          neighbors.emplace_back(i, j);
    Duality result;
    std::set_difference(edges.begin(), edges.end(), neighbors.begin(), neighbors.end(),
                        std::back_inserter(result.edges_without_bisector));
    std::set_difference(neighbors.begin(), neighbors.end(), edges.begin(), edges.end(),
                        std::back_inserter(result.bisectors_without_edge));
    result.number_of_dual_edges = edges.size() - result.edges_without_bisector.size();
    return result;
  }
  /// @}

private:
  typedef Anisotropic_mesh_2::internal::Vector_of_doubles                              Vector;
  typedef Anisotropic_mesh_2::internal::Triangle_of_doubles                            Triangle;
  typedef Anisotropic_mesh_2::internal::Mesh_generators<Mesh, Distance>                Generators;
  typedef Anisotropic_mesh_2::internal::Region_subdivision<Generators, ConcurrencyTag> Subdivision;
  typedef Anisotropic_mesh_2::internal::Region_tds                                     Tds;
  typedef Anisotropic_mesh_2::internal::Region_pieces::Border                          Border;

  static constexpr std::size_t regions_of_chunk = 128;

  static Point_2 point(const Vector& x) { return Anisotropic_mesh_2::internal::point_at<Point_2>(x.x, x.y); }

  Anisotropic_mesh_2::internal::Metric_point metric_point_at(const Point_2& p) const
  {
    return m_generators.metric_point_at(Anisotropic_mesh_2::internal::to_doubles(p));
  }

  std::vector<Triangle> triangles(std::size_t i) const
  {
    using Anisotropic_mesh_2::internal::to_doubles;
    std::vector<Triangle> result;
    for(const typename Region::Tile& t : m_regions[i].tiles)
      result.push_back({to_doubles(t[0]), to_doubles(t[1]), to_doubles(t[2])});
    return result;
  }

  // Bisectors are those of each piece with the pieces after it, in the order of the regions.
  void take_regions(const Subdivision& subdivision)
  {
    using namespace Anisotropic_mesh_2::internal;
    const std::size_t n = m_generators.set().size();
    m_regions.resize(n);
    std::vector<std::vector<Border> > borders(n);
    for_each_chunk<ConcurrencyTag>(n, [&](std::size_t, std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        take_region(subdivision, i, borders[i]);
    }, regions_of_chunk);

    std::vector<std::vector<Bisector> > bisectors(number_of_chunks(n, regions_of_chunk));
    for_each_chunk<ConcurrencyTag>(n, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        for(const Border& b : borders[i])
          take_bisectors(b, bisectors[chunk]);
    }, regions_of_chunk);
    m_bisectors = joined(std::move(bisectors));
  }

  void take_region(const Subdivision& subdivision, std::size_t i, std::vector<Border>& borders)
  {
    Region& r = m_regions[i];
    r.vertex = m_generators.vertices()[i];
    r.generator = r.vertex->point();
    r.is_fixed = m_mesh.is_fixed(r.vertex);
    r.tiles.reserve(subdivision.faces(i).size());
    const Anisotropic_mesh_2::internal::Region_pieces pieces(subdivision.tds());
    for(const auto& p : pieces(subdivision.faces(i))) {
      Piece piece;
      piece.is_main = p.is_main;
      for(Tds::Face_handle f : p.faces) {
        const Triangle t = Tds::triangle(f);
        r.tiles.push_back({point(t[0]), point(t[1]), point(t[2])});
        piece.area += Anisotropic_mesh_2::internal::area(t);
      }
      for(Border& b : pieces.borders(p)) {
        piece.boundaries.push_back(points(b.begin(), b.end()));
        borders.push_back(std::move(b));
      }
      r.area += piece.area;
      r.pieces.push_back(std::move(piece));
    }
  }

  // The bisectors are where the face beyond the border stays in the same piece of another region.
  void take_bisectors(Border border, std::vector<Bisector>& bisectors) const
  {
    typedef std::pair<std::size_t, std::size_t> Region_and_piece;
    const auto piece = [](Tds::Face_handle f) { return Region_and_piece(f->region, f->piece); };
    const auto beyond = [&](const Tds::Edge& e) { return piece(e.first->neighbor(e.second)); };
    const auto is_main = [&](const Region_and_piece& p) { return m_regions[p.first].pieces[p.second].is_main; };
    const auto change = std::adjacent_find(border.begin(), border.end(), [&](const auto& d, const auto& e)
                                           { return beyond(d) != beyond(e); });
    const bool is_closed = change == border.end();
    if(!is_closed)
      std::rotate(border.begin(), change + 1, border.end());
    for(auto first = border.begin(), last = first; first != border.end(); first = last) {
      last = std::find_if(first, border.end(), [&](const auto& e) { return beyond(e) != beyond(*first); });
      const Region_and_piece left = piece(first->first), right = beyond(*first);
      if(right.first == Subdivision::outside || right < left)
        continue;
      Bisector b{{left.first, right.first}, is_main(left) && is_main(right), is_closed, points(first, last)};
      if(!is_closed)
        b.points.push_back(point(target(*std::prev(last))->point.at));
      bisectors.push_back(std::move(b));
    }
  }

  static Tds::Vertex_handle source(const Tds::Edge& e) { return e.first->vertex(Tds::ccw(e.second)); }
  static Tds::Vertex_handle target(const Tds::Edge& e) { return e.first->vertex(Tds::cw(e.second)); }

  // the points at which the edges begin
  template <class Iterator>
  static std::vector<Point_2> points(Iterator first, Iterator last)
  {
    std::vector<Point_2> result;
    for(; first != last; ++first)
      result.push_back(point(source(*first)->point.at));
    return result;
  }

  void collect_neighbors()
  {
    m_neighbors.resize(m_regions.size());
    for(const Bisector& b : m_bisectors)
      if(b.is_between_main_pieces) {
        m_neighbors[b.regions[0]].push_back(b.regions[1]);
        m_neighbors[b.regions[1]].push_back(b.regions[0]);
      }
    for(std::vector<std::size_t>& n : m_neighbors) {
      std::sort(n.begin(), n.end());
      n.erase(std::unique(n.begin(), n.end()), n.end());
    }
  }

  const Mesh&                            m_mesh;
  Generators                             m_generators;
  std::vector<Region>                    m_regions;
  std::vector<Bisector>                  m_bisectors;
  std::vector<std::vector<std::size_t> > m_neighbors;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H

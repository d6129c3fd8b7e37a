// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H
#define CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H

#include <CGAL/Anisotropic_mesh_2/internal/Generator_set.h>
#include <CGAL/Anisotropic_mesh_2/internal/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/Region_assembler.h>
#include <CGAL/Anisotropic_mesh_2/internal/Region_integrator.h>
#include <CGAL/Anisotropic_mesh_2/internal/Region_subdivision.h>
#include <CGAL/Anisotropic_mesh_2/Directional_distance_2.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/Region_integrals_2.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_bisector_2.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_duality_2.h>
#include <CGAL/Anisotropic_mesh_2/Voronoi_region_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vector_of_doubles.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
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
/// corners and in their middle tell that at most three generators are nearest
/// in it, and which. Bisectors are traced by root finding. Features of the
/// metric that escape all these samples are not seen, and below the tolerance
/// nothing is resolved: tips of regions that are narrower may be taken for
/// orphans. In the wildest metrics the bisection ends early, at 200000 vertices
/// and 200 more per generator. All is computed in `double`, whatever the kernel.
///
/// For a smooth metric and a mesh of good quality, the construction takes
/// \f$ O(n \log n) \f$ time with few evaluations of the field per face.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam Distance a model of `VoronoiDistance_2`.
template <class Mesh_, class Distance_ = Anisotropic_mesh_2::Directional_distance_2>
class Anisotropic_Voronoi_diagram_2
{
public:
  typedef Mesh_                                                          Mesh;
  typedef Distance_                                                      Distance;
  typedef typename Mesh::Kernel                                          Kernel;
  typedef typename Mesh::Point                                           Point_2;
  typedef typename Mesh::Vertex_handle                                   Vertex_handle;
  typedef Anisotropic_mesh_2::Voronoi_region_2<Kernel, Vertex_handle>    Region;
  typedef Anisotropic_mesh_2::Voronoi_piece_2<Kernel>                    Piece;
  typedef Anisotropic_mesh_2::Voronoi_bisector_2<Kernel>                 Bisector;
  typedef Anisotropic_mesh_2::Region_integrals_2<Kernel>                 Integrals;

  /// \name Creation
  /// @{

  /// the tessellation of the domain of `mesh`, which must outlive it and not be changed meanwhile.
  ///
  /// \param mesh the mesh, with its domain marked.
  /// \param distance the distance from points to generators.
  /// \param tolerance how far bisectors may be from where they should be,
  /// relative to the distance to their generators; between 10<sup>-9</sup> and 0.1.
  /// \throw Invalid_metric_tensor_exception if the field fails at a point of the domain.
  explicit Anisotropic_Voronoi_diagram_2(const Mesh& mesh, const Distance& distance = Distance(),
                                         double tolerance = 1e-4)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_generators(collect_generators(distance))
  {
    CGAL_precondition(tolerance >= 1e-9 && tolerance <= 0.1);
    const auto place_at = [this](const Vector& x) { return this->place_at(x); };
    typedef Anisotropic_mesh_2::internal::Region_subdivision<Mesh, decltype(place_at)> Subdivision;
    const Subdivision subdivision(mesh, m_generators, m_region_of, place_at, tolerance);
    const Anisotropic_mesh_2::internal::Region_assembler<Subdivision> assembler(subdivision);
    take_pieces(assembler);
    take_tiles(assembler);
    take_bisectors(assembler);
  }
  /// @}

  /// the mesh that was given.
  const Mesh& mesh() const { return m_mesh; }

  /// \name Regions
  /// @{

  std::size_t number_of_regions() const { return m_regions.size(); }

  /// the regions of the vertices of the domain, in the order of the mesh.
  const std::vector<Region>& regions() const { return m_regions; }

  /// \pre `i < number_of_regions()`
  const Region& region(std::size_t i) const { return m_regions[i]; }

  /// the index of the region of a vertex of the domain.
  std::size_t index(Vertex_handle v) const { return m_region_of[v->index()]; }

  /// the curves between the regions.
  const std::vector<Bisector>& bisectors() const { return m_bisectors; }

  /// the regions whose main pieces share a bisector with that of region `i`, in increasing order.
  const std::vector<std::size_t>& neighbors(std::size_t i) const { return m_neighbors[i]; }

  /// the index of the region to which `p` belongs, the least one if there are
  /// several; decided by the distances to the generators alone, without the regions.
  std::size_t nearest_generator(const Point_2& p) const
  {
    CGAL_precondition(m_generators.size() > 0);
    return m_generators.nearest(place_at(Anisotropic_mesh_2::internal::to_doubles(p)));
  }

  /// the squared distance from `p` to the generator of region `i`.
  double squared_distance(const Point_2& p, std::size_t i) const
  {
    return m_generators.squared_distance(place_at(Anisotropic_mesh_2::internal::to_doubles(p)), i);
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
  Integrals integrals(std::size_t i,
                      Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN,
                      double tolerance = 1e-4) const
  {
    Integrals result;
    const auto sum = integrate(i, measure, tolerance, result.mass_centre_error);
    const Vector& z = m_generators.position(i);
    Vector pull;
    sum.moments.pull(pull.x, pull.y);
    result.mass_centre = point({z.x + pull.x, z.y + pull.y});
    result.area = sum.mass;
    result.energy = sum.energy;
    result.matrix = {sum.moments.a.a, sum.moments.a.b, sum.moments.a.c};
    result.energy_gradient = {-2 * sum.moments.gx, -2 * sum.moments.gy};
    return result;
  }

  /// compares the edges of the triangulation with the neighbors of regions.
  Anisotropic_mesh_2::Voronoi_duality_2 duality() const
  {
    typedef Anisotropic_mesh_2::Voronoi_duality_2::Pair Pair;
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
    Anisotropic_mesh_2::Voronoi_duality_2 result;
    std::set_difference(edges.begin(), edges.end(), neighbors.begin(), neighbors.end(),
                        std::back_inserter(result.edges_without_bisector));
    std::set_difference(neighbors.begin(), neighbors.end(), edges.begin(), edges.end(),
                        std::back_inserter(result.bisectors_without_edge));
    result.number_of_dual_edges = edges.size() - result.edges_without_bisector.size();
    return result;
  }
  /// @}

private:
  typedef Anisotropic_mesh_2::internal::Vector_of_doubles Vector;
  typedef Anisotropic_mesh_2::internal::Symmetric_form    Form;
  typedef Anisotropic_mesh_2::internal::Place             Place;

  static Point_2 point(const Vector& x) { return Anisotropic_mesh_2::internal::point_at<Point_2>(x.x, x.y); }

  Form tensor_at(const Vector& x) const { return Form(m_tensor(point(x))); }

  Place place_at(const Vector& x) const
  {
    return {x, m_generators.is_measured_at_generators() ? Form(1, 0, 1) : tensor_at(x)};
  }

  Anisotropic_mesh_2::internal::Region_sum integrate(std::size_t i, Anisotropic_mesh_2::Measure measure,
                                                     double tolerance, double& error) const
  {
    const bool is_riemannian = measure == Anisotropic_mesh_2::Measure::RIEMANNIAN;
    const auto density = [&](const Vector& x, Form& m, double& w) {
      if(is_riemannian || !m_generators.is_measured_at_generators())
        m = tensor_at(x);
      w = is_riemannian ? std::sqrt(m.determinant()) : 1;
      m = m_generators.tensor({x, m}, i);
    };
    using Anisotropic_mesh_2::internal::to_doubles;
    std::vector<Anisotropic_mesh_2::internal::Triangle_of_doubles> triangles;
    for(const typename Region::Tile& t : m_regions[i].tiles)
      triangles.push_back({to_doubles(t[0]), to_doubles(t[1]), to_doubles(t[2])});
    const Anisotropic_mesh_2::internal::Region_integrator<decltype(density)> integrator(density, tolerance);
    return integrator(triangles, m_generators.position(i), error);
  }

  Anisotropic_mesh_2::internal::Generator_set collect_generators(const Distance& distance)
  {
    std::vector<bool> is_used(m_mesh.vertex_index_bound(), false);
    for(auto f = m_mesh.finite_faces_begin(); f != m_mesh.finite_faces_end(); ++f)
      for(int i = 0; i < 3 && f->is_in_domain(); ++i)
        is_used[f->vertex(i)->index()] = true;
    m_region_of.assign(is_used.size(), static_cast<std::size_t>(-1));
    Anisotropic_mesh_2::internal::Vectors positions;
    std::vector<Form> tensors;
    for(auto v = m_mesh.finite_vertices_begin(); v != m_mesh.finite_vertices_end(); ++v) {
      if(!is_used[v->index()])
        continue;
      m_region_of[v->index()] = m_regions.size();
      m_regions.emplace_back();
      m_regions.back().vertex = v;
      m_regions.back().generator = v->point();
      m_regions.back().is_fixed = m_mesh.is_fixed(v);
      positions.push_back(Anisotropic_mesh_2::internal::to_doubles(v->point()));
      if constexpr(Distance::is_measured_at_generators)
        tensors.push_back(Form(distance(Vertex_handle(v))));
    }
    return Anisotropic_mesh_2::internal::Generator_set(std::move(positions), std::move(tensors));
  }

  template <class Assembler>
  static std::vector<Point_2> points(const Assembler& assembler, const std::vector<std::size_t>& line)
  {
    std::vector<Point_2> result;
    for(std::size_t i : line)
      result.push_back(point(assembler.points()[i]));
    return result;
  }

  template <class Assembler>
  void take_pieces(const Assembler& assembler)
  {
    for(const auto& p : assembler.pieces()) {
      Piece piece;
      piece.is_main = p.is_main;
      piece.area = p.area;
      for(const auto& line : Anisotropic_mesh_2::internal::Polyline_chainer(p.boundary, assembler.points())())
        piece.boundaries.push_back(points(assembler, line.points));
      m_regions[p.region].area += p.area;
      m_regions[p.region].pieces.push_back(std::move(piece));
    }
    for(Region& r : m_regions)
      std::stable_partition(r.pieces.begin(), r.pieces.end(), [](const Piece& p) { return p.is_main; });
  }

  // Parts of faces are seen from their first points.
  template <class Assembler>
  void take_tiles(const Assembler& assembler)
  {
    assembler.for_each_part([&](std::size_t region, const std::vector<std::size_t>& polygon) {
      const std::vector<Point_2> p = points(assembler, polygon);
      for(std::size_t i = 2; i < p.size(); ++i)
        m_regions[region].tiles.push_back({p[0], p[i - 1], p[i]});
    });
  }

  template <class Assembler>
  void take_bisectors(const Assembler& assembler)
  {
    m_neighbors.resize(m_regions.size());
    for(const auto& b : assembler.bisectors()) {
      const auto &left = assembler.pieces()[b.pieces[0]], &right = assembler.pieces()[b.pieces[1]];
      m_bisectors.push_back(Bisector{{left.region, right.region}, left.is_main && right.is_main, b.line.is_closed,
                                     points(assembler, b.line.points)});
      if(m_bisectors.back().is_between_main_pieces) {
        m_neighbors[left.region].push_back(right.region);
        m_neighbors[right.region].push_back(left.region);
      }
    }
    for(std::vector<std::size_t>& n : m_neighbors) {
      std::sort(n.begin(), n.end());
      n.erase(std::unique(n.begin(), n.end()), n.end());
    }
  }

  const Mesh&                                             m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  std::vector<std::size_t>                                m_region_of; // by the index of the vertex
  std::vector<Region>                                     m_regions;
  Anisotropic_mesh_2::internal::Generator_set             m_generators;
  std::vector<Bisector>                                   m_bisectors;
  std::vector<std::vector<std::size_t> >                  m_neighbors;
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_VORONOI_DIAGRAM_2_H

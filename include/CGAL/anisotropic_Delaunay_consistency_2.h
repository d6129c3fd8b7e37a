// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_DELAUNAY_CONSISTENCY_2_H
#define CGAL_ANISOTROPIC_DELAUNAY_CONSISTENCY_2_H

#include <CGAL/Anisotropic_mesh_2/internal/kernel/Star_consistency_2.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// how far a triangulation is Delaunay in its varying metric, by the criterion of section 3.1 of
/// \cgalCite{dw-acvt-05}.
///
/// \sa `CGAL::anisotropic_Delaunay_consistency_2()`
struct Delaunay_consistency
{
  std::size_t edges = 0;             ///< free edges between two faces
  std::size_t consistent_edges = 0;  ///< those that pass `CGAL::is_consistent_edge()`
  std::size_t stars = 0;             ///< vertices
  std::size_t consistent_stars = 0;  ///< those that pass `CGAL::is_consistent_star()`

  /// the share of consistent edges, 1 if there are no edges.
  double edge_share() const { return share(consistent_edges, edges); }

  /// the share of consistent stars, 1 if there are no stars.
  double star_share() const { return share(consistent_stars, stars); }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Delaunay_consistency& c)
  {
    return os << "edges: " << c.edges << "\nconsistent_edges: " << c.consistent_edges
              << "\nstars: " << c.stars << "\nconsistent_stars: " << c.consistent_stars << '\n';
  }

private:
  static double share(std::size_t part, std::size_t whole) { return whole == 0 ? 1. : double(part) / double(whole); }
};

} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns whether the two faces of an edge agree with the cavity criterion
/// (section 3.1 of \cgalCite{dw-acvt-05}): neither is in conflict with the vertex
/// opposite to the edge in the other, by the tensors of the four vertices.
///
/// Constrained edges and edges of the hull agree with any criterion.
/// \tparam Triangulation a `Constrained_anisotropic_Delaunay_triangulation_2`.
/// \param t the triangulation
/// \param e an edge of it
/// \return whether the edge is consistent
/// \pre `t.dimension() == 2`
template <class Triangulation>
bool is_consistent_edge(const Triangulation& t, const typename Triangulation::Edge& e)
{
  const typename Triangulation::Edge m = t.mirror_edge(e);
  if(t.is_infinite(e.first) || t.is_infinite(m.first) || e.first->is_constrained(e.second))
    return true;
  const auto p = e.first->vertex(e.second), q = m.first->vertex(m.second);
  return !t.is_in_conflict(e.first, q->point(), q->metric_tensor())
      && !t.is_in_conflict(m.first, p->point(), p->metric_tensor());
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns whether the star of a vertex is the one that the vertex has in the
/// constrained Delaunay triangulation under its own tensor: no vertex that is
/// visible from a triangle of the star lies inside of the ellipse through the
/// three vertices of that triangle.
///
/// A triangulation in which all stars are consistent is Delaunay wherever one
/// looks, each place in its own metric. The vertices are decided exactly if the traits do.
/// \tparam Triangulation a `Constrained_anisotropic_Delaunay_triangulation_2`.
/// \param t the triangulation
/// \param v a finite vertex of it
/// \return whether the star is consistent
/// \pre `t.dimension() == 2`
template <class Triangulation>
bool is_consistent_star(const Triangulation& t, typename Triangulation::Vertex_handle v)
{
  CGAL_precondition(t.dimension() == 2);
  return Anisotropic_mesh_2::internal::Star_consistency_2<Triangulation>(t, v)();
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures how far a triangulation is Delaunay in its varying metric. For a
/// constant or an isotropic metric all edges and all stars are consistent. For
/// any other metric no triangulation need have these properties everywhere, and
/// the shares are a certificate of how far this one has them.
///
/// The time is linear in the number of faces if stars are well shaped in their metrics.
/// \tparam Triangulation a `Constrained_anisotropic_Delaunay_triangulation_2`, or a
/// class derived from it. Of an `Anisotropic_Delaunay_mesh_2` only the domain is looked at.
/// \param t the triangulation
/// \return the numbers of edges and stars, and how many of them are consistent
template <class Triangulation>
Anisotropic_mesh_2::Delaunay_consistency anisotropic_Delaunay_consistency_2(const Triangulation& t)
{
  Anisotropic_mesh_2::Delaunay_consistency result;
  const auto counts = [&](typename Triangulation::Face_handle f)
                      { return Anisotropic_mesh_2::internal::is_face_of_interest(t, f, 0); };
  for(auto e = t.finite_edges_begin(); t.dimension() == 2 && e != t.finite_edges_end(); ++e)
    if(!t.is_constrained(*e) && counts(e->first) && counts(e->first->neighbor(e->second))) {
      ++result.edges;
      result.consistent_edges += is_consistent_edge(t, *e);
    }
  std::vector<bool> is_seen(std::size_t(t.vertex_index_bound()), false);
  for(auto f = t.finite_faces_begin(); t.dimension() == 2 && f != t.finite_faces_end(); ++f)
    for(int i = 0; i < 3 && counts(f); ++i) {
      const auto v = f->vertex(i);
      if(is_seen[std::size_t(v->index())])
        continue;
      is_seen[std::size_t(v->index())] = true;
      ++result.stars;
      result.consistent_stars += is_consistent_star(t, v);
    }
  return result;
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_DELAUNAY_CONSISTENCY_2_H

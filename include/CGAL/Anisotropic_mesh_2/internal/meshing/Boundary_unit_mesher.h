// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_BOUNDARY_UNIT_MESHER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_BOUNDARY_UNIT_MESHER_H

#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Boundary_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/curve_turning.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Domain_preparation.h>
#include <CGAL/Anisotropic_mesh_2/internal/meshing/Riemannian_length_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/domain/Chord_separator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// The number of parts of a curve of this length that are closest to unit, in
// the sense that 2 is as far from 1 as 1/2 is.
inline double number_of_unit_parts(double length)
{
  const double n = std::floor(length);
  return n >= 1 && length*length <= n*(n + 1) ? n : n + 1;
}

// Cuts the pieces of a prepared domain into parts of unit metric length
// (section 3.2 of the paper): equal lengths along each piece, and on curves
// enough parts that none turns by more than about 45 degrees, and that none is
// farther from its chord than a quarter of the unit, in the metric of the curve:
// a layer of elements along the curve lies on one side of its chords then. In
// a uniform metric the chords of unit length that turn by 45 degrees are 0.1 away.
template <class K, class Field>
class Boundary_unit_mesher
{
public:
  typedef std::vector<Domain_piece_2<K> >      Pieces;
  typedef Chord_graph_2<K>                     Graph;
  typedef std::vector<std::vector<double> >    Parameters;

  Boundary_unit_mesher(const Pieces& pieces, const Field& field, std::size_t max_vertices, bool keep_points)
    : m_pieces(pieces), m_field(field), m_limit(max_vertices)
  {
    for(const auto& piece : pieces)
      m_extent += extent(piece.curve);
    for(std::size_t i = 0; i < pieces.size(); ++i)
      m_parameters.push_back(keep_points && pieces[i].curve.is_straight() ? std::vector<double>{0., 1.}
                                                                          : unit_parts(i));
  }

  Graph operator()()
  {
    const auto middle = [this](std::size_t piece, double t0, double t1) { return middle_of_part(piece, t0, t1); };
    return Chord_separator<K>(m_pieces, m_parameters, middle)();
  }

private:
  typedef Riemannian_length_2<K, Field> Length;
  static constexpr double strong_turning = 0.6;  // radians; an arc of 45 degrees shows 0.589
  static constexpr double few_parts = 16;
  static constexpr double largest_distance = 0.22; // at a third of a part; 0.25 at the middle of an arc
  static constexpr int    maximum_levels = 12;

  std::vector<double> unit_parts(std::size_t i)
  {
    const Curve_piece_2<K>& curve = m_pieces[i].curve;
    const Length length(curve, m_field, double(m_limit), number_of_panels(curve));
    const double n = number_of_unit_parts(length.total());
    count(n);
    if(curve.is_straight())
      return equal_parts(length, n);
    m_lengths.emplace(i, length);
    const std::vector<double> parts = recognizable_parts(curve, length, n);
    count(double(parts.size() - 1) - n);
    return parts;
  }

  void count(double parts)
  {
    m_wanted += parts;
    if(m_wanted > double(m_limit))
      throw Too_many_vertices_exception(m_wanted, m_limit, "the boundary");
  }

  // The longer a piece is in comparison with all of them, the more panels its length begins with, so that
  // fine places are seen.
  int number_of_panels(const Curve_piece_2<K>& curve) const
  {
    const double share = extent(curve) / m_extent;
    return share > 0.25 ? 27 : share > 0.1 ? 13 : Length::fewest_panels;
  }

  static double extent(const Curve_piece_2<K>& curve)
  {
    double sum = 0;
    for(int i = 0; i < 8; ++i)
      sum += std::sqrt(CGAL::to_double(CGAL::squared_distance(curve.point(i / 8.), curve.point((i + 1) / 8.))));
    return sum;
  }

  static std::vector<double> equal_parts(const Length& length, double n)
  {
    std::vector<double> parameters(1, 0.);
    for(double k = 1; k < n; ++k)
      parameters.push_back(length.parameter(k / n * length.total()));
    parameters.push_back(1.);
    return parameters;
  }

  static bool turns_strongly(const Curve_piece_2<K>& curve, double t0, double t1)
  {
    return turning(curve, t0, t1) > strong_turning && !has_corner(curve, t0, t1);
  }

  // A few more equal parts if that is enough, else the parts that need it are bisected.
  std::vector<double> recognizable_parts(const Curve_piece_2<K>& curve, const Length& length, double n) const
  {
    if(curve.is_closed())
      n = (std::max)(n, 3.);
    std::vector<double> parameters = equal_parts(length, n);
    while(n < few_parts && any_turns_strongly(curve, parameters))
      parameters = equal_parts(length, ++n);
    std::vector<double> result(1, 0.);
    for(std::size_t k = 1; k < parameters.size(); ++k)
      append_flat_parts(curve, length, parameters[k], maximum_levels, result);
    return result;
  }

  static bool any_turns_strongly(const Curve_piece_2<K>& curve, const std::vector<double>& parameters)
  {
    for(std::size_t k = 1; k < parameters.size(); ++k)
      if(turns_strongly(curve, parameters[k-1], parameters[k]))
        return true;
    return false;
  }

  void append_flat_parts(const Curve_piece_2<K>& curve, const Length& length, double t1, int levels,
                         std::vector<double>& result) const
  {
    const double t0 = result.back();
    const double parts = levels == 0 ? 1 : number_of_flat_parts(curve, t0, t1);
    if(parts == 1 || double(result.size()) > double(m_limit)) {
      result.push_back(t1);
      return;
    }
    const double l0 = length.length(t0), l1 = length.length(t1);
    for(double k = 1; k < parts; ++k) {
      const double t = length.parameter(l0 + k / parts * (l1 - l0));
      if(result.back() < t && t < t1)
        append_flat_parts(curve, length, t, levels - 1, result);
    }
    append_flat_parts(curve, length, t1, levels - 1, result);
  }

  // Into how many parts this one must be divided, as the distance from the chord falls with the square of
  // their number.
  double number_of_flat_parts(const Curve_piece_2<K>& curve, double t0, double t1) const
  {
    const double distance = (std::max)(distance_from_chord(curve, t0, t1, 1./3),
                                       distance_from_chord(curve, t0, t1, 2./3));
    const double parts = std::ceil(std::sqrt((std::min)(distance / largest_distance, 1e8)));
    return (std::max)(parts, turns_strongly(curve, t0, t1) ? 2. : 1.);
  }

  // normal to the chord, in the metric at the point of the curve
  double distance_from_chord(const Curve_piece_2<K>& curve, double t0, double t1, double share) const
  {
    const typename K::Point_2 a = curve.point(t0), b = curve.point(t1), p = curve.point(t0 + share * (t1 - t0));
    const double ux = CGAL::to_double(b.x() - a.x()), uy = CGAL::to_double(b.y() - a.y());
    const double vx = CGAL::to_double(p.x() - a.x()), vy = CGAL::to_double(p.y() - a.y());
    const double square = ux*ux + uy*uy;
    return square > 0 ? Symmetric_form(metric_at(m_field, p)).length(-uy, ux) * std::abs(ux*vy - uy*vx) / square : 0;
  }

  static double middle(const Length& length, double t0, double t1)
  {
    const double t = length.parameter((length.length(t0) + length.length(t1)) / 2);
    return t0 < t && t < t1 ? t : (t0 + t1) / 2;
  }

  double middle_of_part(std::size_t piece, double t0, double t1) const
  {
    return middle(m_lengths.at(piece), t0, t1);
  }

  const Pieces&                  m_pieces;
  const Field&                   m_field;
  std::size_t                    m_limit;
  double                         m_extent = 0; // of all pieces, about
  double                         m_wanted = 0;
  std::map<std::size_t, Length>  m_lengths;    // of the curved pieces
  Parameters                     m_parameters;
};

// Refuses a metric that asks for too many vertices before the boundary is
// subdivided. Where the chords of curves enclose a little more than the domain,
// the field may have no value; then there is no estimate.
template <class K, class Field>
void check_metric_of_domain(const Domain_preparation<K>& domain, const Field& field, std::size_t max_vertices)
{
  try {
    check_ideal_number_of_vertices<typename K::Point_2>(domain.triangles(), field, max_vertices);
  }
  catch(const Invalid_metric_tensor_exception&) {}
}

// The straight graph that bounds the unit mesh of a domain. Boundary segments
// have the domain on their left side: whatever the rule of the domain was,
// exactly one side of such a segment is inside.
//
// \param keep_points takes segments as they are; curves are still subdivided
// Throws Invalid_domain_exception, Invalid_metric_tensor_exception naming the
// point, and Too_many_vertices_exception if the pieces want more than
// `max_vertices` points, or the domain half as many again.
template <class K, class Field>
Boundary_graph_2<K> unit_boundary_graph(const Anisotropic_mesh_domain_2<K>& domain, const Field& field,
                                      std::size_t max_vertices, bool keep_points = false)
{
  const Domain_preparation<K> prepared(domain.pieces(), domain.rule(), domain.holes());
  check_metric_of_domain(prepared, field, max_vertices);
  const auto& pieces = prepared.pieces();
  const Chord_graph_2<K> graph = Boundary_unit_mesher<K, Field>(pieces, field, max_vertices, keep_points)();
  Boundary_graph_2<K> mesh;
  mesh.points = graph.points();
  for(const auto& chord : graph.chords())
    mesh.segments.push_back({chord.source, chord.target, pieces[chord.piece].curve.reference(),
                             pieces[chord.piece].role == Piece_role::BOUNDARY});
  mesh.regions = domain.regions();
  return mesh;
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESHING_BOUNDARY_UNIT_MESHER_H

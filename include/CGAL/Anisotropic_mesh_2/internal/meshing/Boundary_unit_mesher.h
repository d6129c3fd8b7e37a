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
// enough parts that none turns by more than about 45 degrees.
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
    for(std::size_t i = 0; i < pieces.size(); ++i)
      m_parameters.push_back(keep_points && pieces[i].curve.is_straight() ? std::vector<double>{0., 1.}
                                                                          : unit_parts(i));
  }

  Graph operator()()
  {
    const auto middle = [this](std::size_t piece, double t0, double t1) { return middle_of_part(piece, t0, t1); };
    return separate_chords<K>(m_pieces, m_parameters, middle);
  }

private:
  typedef Riemannian_length_2<K, Field> Length;
  static constexpr double strong_turning = 0.6;  // radians; an arc of 45 degrees shows 0.589
  static constexpr double few_parts = 16;
  static constexpr int    maximum_bisections = 12;

  std::vector<double> unit_parts(std::size_t i)
  {
    const Curve_piece_2<K>& curve = m_pieces[i].curve;
    const Length length(curve, m_field, double(m_limit));
    const double n = number_of_unit_parts(length.total());
    m_wanted += n;
    if(m_wanted > double(m_limit))
      throw Too_many_vertices_exception(m_wanted, m_limit, "the boundary");
    if(curve.is_straight())
      return equal_parts(length, n);
    m_lengths.emplace(i, length);
    return recognizable_parts(curve, length, n);
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
  static std::vector<double> recognizable_parts(const Curve_piece_2<K>& curve, const Length& length, double n)
  {
    if(curve.is_closed())
      n = (std::max)(n, 3.);
    std::vector<double> parameters = equal_parts(length, n);
    while(n < few_parts && any_turns_strongly(curve, parameters))
      parameters = equal_parts(length, ++n);
    std::vector<double> result(1, 0.);
    for(std::size_t k = 1; k < parameters.size(); ++k)
      append_flat_parts(curve, length, parameters[k], maximum_bisections, result);
    return result;
  }

  static bool any_turns_strongly(const Curve_piece_2<K>& curve, const std::vector<double>& parameters)
  {
    for(std::size_t k = 1; k < parameters.size(); ++k)
      if(turns_strongly(curve, parameters[k-1], parameters[k]))
        return true;
    return false;
  }

  static void append_flat_parts(const Curve_piece_2<K>& curve, const Length& length, double t1, int bisections,
                                std::vector<double>& result)
  {
    const double t0 = result.back();
    if(bisections > 0 && turns_strongly(curve, t0, t1)) {
      append_flat_parts(curve, length, middle(length, t0, t1), bisections - 1, result);
      append_flat_parts(curve, length, t1, bisections - 1, result);
    } else
      result.push_back(t1);
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

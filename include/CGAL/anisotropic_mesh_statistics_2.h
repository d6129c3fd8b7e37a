// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_STATISTICS_2_H
#define CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

#include <CGAL/Anisotropic_mesh_2/internal/statistics/Energy_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Shape_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/mesh_warning.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/write_statistics.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Free_vertices.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/Sampled_metric.h>
#include <CGAL/Anisotropic_mesh_2/internal/mesh/is_own_edge.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_quality.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/Measure.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// measures of how good a mesh is in its metric (section 5.1 of \cgalCite{dw-acvt-05}).
///
/// The quality of a triangle \f$ T \f$ with the edges \f$ e_i \f$ in a tensor \f$ M \f$ is
/// \f$ 4 \sqrt 3 \sqrt{\det M} |T| / \sum_i e_i^T M e_i \f$: 1 if it is equilateral in \f$ M \f$, else less, and
/// more than 0. Without triangles all of them are 0.
/// \sa `CGAL::anisotropic_mesh_statistics_2()`
struct Mesh_statistics
{
  std::size_t vertices = 0;            ///< of the domain
  std::size_t triangles = 0;           ///< of the domain
  double ideal_vertices = 0;           ///< \f$ 2/\sqrt 3 \f$ times the area in the metric: those of a unit mesh without
                                       ///< boundary, which brings about half of its own vertices in addition
  double edge_length_mean = 0;         ///< Riemannian lengths of the edges of the domain: their mean; 1 is ideal
  double edge_length_min = 0;          ///< the least of them
  double edge_length_max = 0;          ///< the largest of them
  double edge_length_unit_share = 0;   ///< the share of edges with lengths in \f$ [\sqrt{1/2}, \sqrt 2] \f$, at most 1
  double quality_mean = 0;             ///< qualities with the tensor at the barycentre: their mean
  double quality_min = 0;              ///< the least of them
  double quality_min3_mean = 0;        ///< the least qualities of triangles with the tensors at the vertices: the mean
  double quality_min3_min = 0;         ///< the least of these
  double energy = 0;                   ///< of the anisotropic Voronoi tessellation, in the measure asked for
  double energy_ratio = 0;             ///< the energy over that of equally many regular hexagons; 1 is perfect
  double gradient_norm = 0;            ///< the largest metric length from a free vertex to its mass centre; after
                                       ///< `improve_anisotropic_mesh_2()` some hundredths, since it takes vertices away
                                       ///< from there
  std::string warning;                 ///< what `CGAL::anisotropic_mesh_warning_2()` tells

  /// calls `visit(name, value)` for each number, from `vertices` to `gradient_norm`.
  /// \tparam Visit a functor of a `const char*` and either a `std::size_t` or a `double`
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    visit("vertices", vertices);
    visit("triangles", triangles);
    visit("ideal_vertices", ideal_vertices);
    visit("edge_length_mean", edge_length_mean);
    visit("edge_length_min", edge_length_min);
    visit("edge_length_max", edge_length_max);
    visit("edge_length_unit_share", edge_length_unit_share);
    visit("quality_mean", quality_mean);
    visit("quality_min", quality_min);
    visit("quality_min3_mean", quality_min3_mean);
    visit("quality_min3_min", quality_min3_min);
    visit("energy", energy);
    visit("energy_ratio", energy_ratio);
    visit("gradient_norm", gradient_norm);
  }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Mesh_statistics& s)
  {
    return internal::write_statistics(os, s);
  }

  /// writes the statistics as a flat JSON object.
  void write_json(std::ostream& os) const { internal::write_statistics_as_json(os, *this); }
};

namespace internal {

template <class Mesh, class ConcurrencyTag>
class Statistics_collector
{
  typedef typename Mesh::Point       Point;
  typedef typename Mesh::Face_handle Face_handle;

public:
  Statistics_collector(const Mesh& mesh, Measure measure)
    : m_mesh(mesh), m_metric(ConcurrencyTag(), mesh, sampling_for_statistics), m_measure(measure)
  {}

  Mesh_statistics operator()()
  {
    m_faces = m_mesh.faces_in_domain();
    m_result.triangles = m_faces.size();
    m_result.vertices = m_mesh.number_of_vertices_in_domain();
    if(m_result.triangles == 0)
      return m_result;
    measure_shapes();
    measure_energy();
    return m_result;
  }

private:
  typedef std::pair<double, std::size_t> Doubtful_edge; // minus its error; three times its face, plus its number there

  static constexpr std::size_t faces_of_integrated_edge = 100;
  static constexpr int         panels_of_integrated_edge = 64;
  static constexpr double      negligible_error = 0.02;

  void measure_shapes()
  {
    const std::vector<double> lengths = lengths_of_edges();
    sum_of_chunks<ConcurrencyTag, Shape_summary>(m_faces.size(), [&](std::size_t k, Shape_summary& sum) {
      for(int i = 0; i < 3; ++i)
        if(is_own_edge(m_faces[k], i))
          sum.edges.add(lengths[3*k + i]);
      measure_qualities(m_faces[k], m_metric.at_barycentre(int(k)), sum);
    }).write_to(m_result);
  }

  // of the own edges of the faces; those that samples tell least about are integrated
  std::vector<double> lengths_of_edges() const
  {
    std::vector<double> lengths(3 * m_faces.size());
    std::vector<Doubtful_edge> doubtful;
    doubtful = selected_of_chunks<ConcurrencyTag, Doubtful_edge>(m_faces.size(), [&](std::size_t k, auto& selected) {
      for(int i = 0; i < 3; ++i)
        if(is_own_edge(m_faces[k], i)) {
          const Control_space::Mean l = m_metric.length(m_faces[k], int(k), i);
          lengths[3*k + i] = l.value;
          if(l.error > negligible_error)
            selected.push_back({-l.error, 3*k + i});
        }
    });
    const std::size_t n = (std::min)(doubtful.size(), m_faces.size() / faces_of_integrated_edge + 2);
    std::partial_sort(doubtful.begin(), doubtful.begin() + std::ptrdiff_t(n), doubtful.end());
    for_each_index<ConcurrencyTag>(n, [&](std::size_t r) {
      const std::size_t edge = doubtful[r].second;
      lengths[edge] = integrated_length(m_faces[edge / 3], int(edge % 3));
    });
    return lengths;
  }

  double integrated_length(Face_handle f, int i) const
  {
    const auto u = f->vertex(Mesh::ccw(i)), v = f->vertex(Mesh::cw(i));
    const Vector_of_doubles p = to_doubles(u->point()), q = to_doubles(v->point());
    const auto tensor = m_mesh.geom_traits().construct_metric_tensor_2_object();
    return length_by_simpson(Symmetric_form(u->metric_tensor()), Symmetric_form(v->metric_tensor()), p,
                             {q.x - p.x, q.y - p.y}, panels_of_integrated_edge, [&](const Vector_of_doubles& x) {
                               return Symmetric_form(tensor(point_at<Point>(x.x, x.y)));
                             });
  }

  static void measure_qualities(Face_handle f, const Symmetric_form& at_barycentre, Shape_summary& sum)
  {
    const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    sum.qualities.add(metric_quality(a, b, c, at_barycentre));
    double least = 1;
    for(int i = 0; i < 3; ++i)
      least = (std::min)(least, metric_quality(a, b, c, Symmetric_form(f->vertex(i)->metric_tensor())));
    sum.qualities_min3.add(least);
  }

  void measure_energy()
  {
    Energy_summary<Mesh, ConcurrencyTag> summary(m_measure);
    const auto vertices = free_vertices(m_mesh);
    std::vector<int> places(m_faces.size());
    std::iota(places.begin(), places.end(), 0);
    summary.add(m_mesh, m_metric, m_faces, places, {}, vertices);
    summary.write_to(m_result);
    if(!follows_metric(double(vertices.size()), m_result.ideal_vertices, m_result.quality_mean))
      m_result.warning = mesh_warning(m_mesh);
  }

  const Mesh& m_mesh;
  const Sampled_metric<Mesh> m_metric;
  const Measure m_measure;
  std::vector<Face_handle> m_faces; // of the domain
  Mesh_statistics m_result;
};

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// tells in one line if a mesh does not follow its metric, since that varies too much within elements: if it has more
/// than twice the ideal number of vertices besides those of the boundary, or a mean quality below 0.5. Costs one
/// evaluation of the field per face.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \return what is wrong, the place of the worst face and what would help, or nothing if all is well.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a barycentre.
template <class Mesh>
std::string anisotropic_mesh_warning_2(const Mesh& mesh)
{
  return Anisotropic_mesh_2::internal::mesh_warning(mesh);
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures a mesh in its metric, as section 5.1 of \cgalCite{dw-acvt-05} does.
///
/// The field is sampled 5 to 15 times per vertex in mild metrics and some 30 times in any. Qualities are exact. Where
/// the metric varies little between samples, areas, mean lengths and the energy are right to a thousandth and better;
/// where it jumps or is as fine as the elements, areas and mean lengths to some thousandths, and the energy to some
/// hundredths or, in needles that no metric asks for, a fifth. See \ref AnisotropicMesh2Sampling.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`; the result is the same to the bit.
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \param mesh the mesh, with its domain marked.
/// \param measure the measure of the energy.
/// \return the statistics.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class ConcurrencyTag = Sequential_tag, class Mesh>
Anisotropic_mesh_2::Mesh_statistics
anisotropic_mesh_statistics_2(const Mesh& mesh,
                              Anisotropic_mesh_2::Measure measure = Anisotropic_mesh_2::Measure::RIEMANNIAN)
{
  return Anisotropic_mesh_2::internal::Statistics_collector<Mesh, ConcurrencyTag>(mesh, measure)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_STATISTICS_2_H

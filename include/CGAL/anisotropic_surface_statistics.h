// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_SURFACE_STATISTICS_H
#define CGAL_ANISOTROPIC_SURFACE_STATISTICS_H

#include <CGAL/Anisotropic_mesh_2/Surface_mesh_statistics.h>
#include <CGAL/Anisotropic_mesh_2/internal/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/Directed_edges.h>
#include <CGAL/Anisotropic_mesh_2/internal/Face_block_assembler.h>
#include <CGAL/Anisotropic_mesh_2/internal/Summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/internal/Surface_cover.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy_of_hexagons.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric_area.h>
#include <CGAL/Anisotropic_mesh_2/internal/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface_geometry.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

template <class Field, class ConcurrencyTag>
class Surface_statistics_collector
{
  typedef Anisotropic_surface_mesh_3<Field>  Surface_mesh;
  typedef typename Surface_mesh::Face        Face;
  typedef typename Surface_mesh::Kernel      Kernel;
  typedef typename Kernel::Point_2           Point_2;
  typedef typename Kernel::Point_3           Point_3;
  typedef Metric_tensor_3<Kernel>            Tensor_3;
  typedef Chart_mesh<Field>                  Part_mesh;
  typedef typename Part_mesh::Mesh           Mesh;
  typedef typename Mesh::Face_handle         Face_handle;

public:
  explicit Surface_statistics_collector(const Surface_mesh& mesh)
    : m_mesh(mesh), m_field(mesh.field()), m_atlas(mesh.field()), m_cover(mesh, m_atlas),
      m_edges(mesh.faces())
  {}

  Surface_mesh_statistics operator()()
  {
    m_result.vertices = m_mesh.number_of_vertices();
    m_result.triangles = m_mesh.number_of_faces();
    if(m_result.triangles > 0) {
      measure_shapes();
      measure_energy();
    }
    return m_result;
  }

private:
  struct Shapes
  {
    Edge_summary edges;
    Summary      qualities, qualities_min3, distances, deviations;

    Shapes& operator+=(const Shapes& s)
    {
      edges += s.edges;
      qualities += s.qualities;
      qualities_min3 += s.qualities_min3;
      distances += s.distances;
      deviations += s.deviations;
      return *this;
    }
  };

  void measure_shapes()
  {
    std::vector<Shapes> of_chunk(number_of_chunks(m_mesh.number_of_faces()));
    for_each_chunk<ConcurrencyTag>(m_mesh.number_of_faces(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for(std::size_t f = begin; f < end; ++f)
        measure_face(f, of_chunk[chunk]);
    });
    Shapes s;
    for(const Shapes& t : of_chunk)
      s += t;
    m_result.edge_length_mean = s.edges.lengths.mean();
    m_result.edge_length_min = s.edges.lengths.least;
    m_result.edge_length_max = s.edges.lengths.largest;
    m_result.edge_length_unit_share = s.edges.unit_share();
    m_result.quality_mean = s.qualities.mean();
    m_result.quality_min = s.qualities.least;
    m_result.quality_min3_mean = s.qualities_min3.mean();
    m_result.quality_min3_min = s.qualities_min3.least;
    m_result.distance_mean = s.distances.mean();
    m_result.distance_max = s.distances.largest;
    m_result.normal_deviation_mean = s.deviations.mean();
    m_result.normal_deviation_max = s.deviations.largest;
  }

  // the parameters of the place in a face whose barycentric coordinates are l
  Point_2 parameters(std::size_t f, const std::array<double, 3>& l) const
  {
    const auto& chart = m_atlas.parts[m_cover.part_of_face(f)].chart;
    Vector_of_doubles x;
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles c = chart.coordinates(to_doubles(m_mesh.parameters(m_mesh.faces()[f][i])));
      x = {x.x + l[i] * c.x, x.y + l[i] * c.y};
    }
    const Vector_of_doubles p = chart.parameters(x);
    return point_at<Point_2>(p.x, p.y);
  }

  void measure_face(std::size_t f, Shapes& s) const
  {
    const Face& face = m_mesh.faces()[f];
    const std::array<Point_3, 3> corner = {m_mesh.point(face[0]), m_mesh.point(face[1]), m_mesh.point(face[2])};
    const Point_2 barycentre = parameters(f, {1./3, 1./3, 1./3});
    std::array<Tensor_3, 3> tensor;
    double least = 1;
    for(int i = 0; i < 3; ++i) {
      tensor[i] = m_field.metric_tensor_3(m_mesh.parameters(face[i]));
      least = std::min(least, surface_quality(corner, tensor[i]));
    }
    s.qualities.add(surface_quality(corner, m_field.metric_tensor_3(barycentre)));
    s.qualities_min3.add(least);
    s.deviations.add(normal_deviation(m_field.surface(), barycentre, corner));
    s.distances.add(distance_to_surface(m_field.surface(), barycentre, CGAL::centroid(corner[0], corner[1], corner[2])));
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if(face[i] > face[j] && m_edges.contains(face[j], face[i])) // it belongs to the other face
        continue;
      std::array<double, 3> l = {0.5, 0.5, 0.5};
      l[(i + 2) % 3] = 0;
      const Point_2 middle = parameters(f, l);
      s.edges.add(chord_length(corner[j] - corner[i], tensor[i], m_field.metric_tensor_3(middle), tensor[j]));
      s.distances.add(distance_to_surface(m_field.surface(), middle, CGAL::midpoint(corner[i], corner[j])));
    }
  }

  // Each part of the atlas contributes the faces that are given to it.
  void measure_energy()
  {
    double area = 0;
    for(std::size_t k = 0; k < m_atlas.parts.size(); ++k) {
      Part_mesh part(m_mesh, m_atlas.parts[k]);
      if(part.faces().empty() || !part.copy_faces())
        continue;
      const std::vector<Face_handle> faces = faces_given_to(k, part);
      Face_block_assembler<Mesh> assembler(part.mesh(), true, Acvt_accuracy{0.01, 0.05, 0.2, 3});
      for(std::size_t begin = 0; begin < faces.size(); begin += faces_of_block) {
        assembler(faces.data() + begin, faces.data() + std::min(faces.size(), begin + faces_of_block), nullptr);
        m_result.energy += assembler.energy();
      }
      area += metric_area<ConcurrencyTag>(part.mesh(), faces, 0.5, 1e-5, 1000000 + 4 * faces.size());
    }
    m_result.ideal_vertices = ideal_number_of_vertices(area);
    m_result.energy_ratio = m_result.energy / energy_of_hexagons(area, double(m_result.triangles) / 2);
  }

  std::vector<Face_handle> faces_given_to(std::size_t k, Part_mesh& part) const
  {
    std::set<Face> given;
    for(std::size_t f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_cover.part_of_face(f) == k)
        given.insert(sorted(m_mesh.faces()[f]));
    std::vector<Face_handle> faces;
    for(auto f = part.mesh().finite_faces_begin(); f != part.mesh().finite_faces_end(); ++f)
      if(f->is_in_domain()
         && given.count(sorted({part.number(f->vertex(0)), part.number(f->vertex(1)), part.number(f->vertex(2))})) > 0)
        faces.push_back(f);
    return faces;
  }

  static Face sorted(Face f)
  {
    std::sort(f.begin(), f.end());
    return f;
  }

  static constexpr std::size_t faces_of_block = 512;

  const Surface_mesh&        m_mesh;
  const Field&               m_field;
  const Surface_atlas<Field> m_atlas;
  const Surface_cover<Field> m_cover;
  const Directed_edges       m_edges;
  Surface_mesh_statistics    m_result;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
/// \ingroup PkgAnisotropicMesh2Functions
///
/// measures a mesh of a surface in the metric of the space, and how close it is to the surface.
///
/// Metric and surface are evaluated a few dozen times per vertex, more often where the metric varies much.
///
/// \tparam ConcurrencyTag as for `acvt_optimize_mesh_2()`; the result is the same to the bit.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \param mesh the mesh.
template <class ConcurrencyTag = Parallel_if_available_tag, class Field>
Anisotropic_mesh_2::Surface_mesh_statistics anisotropic_surface_statistics(const Anisotropic_surface_mesh_3<Field>& mesh)
{
  return Anisotropic_mesh_2::internal::Surface_statistics_collector<Field, ConcurrencyTag>(mesh)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_SURFACE_STATISTICS_H

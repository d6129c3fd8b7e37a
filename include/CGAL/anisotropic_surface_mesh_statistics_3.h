// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_SURFACE_MESH_STATISTICS_3_H
#define CGAL_ANISOTROPIC_SURFACE_MESH_STATISTICS_3_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Chart_mesh.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Directed_edges.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Energy_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/statistics/Shape_summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Summary.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_atlas.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_cover.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/surface_geometry.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <set>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// measures of how good a mesh of a surface is, in the metric of the space at the surface
/// and as an approximation of the surface (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// Lengths are those of the straight edges in space, qualities those of the flat triangles
/// \f$ T \f$ there, \f$ 4 \sqrt 3 |T|_M / \sum_i e_i^T M e_i \f$. Tessellation and mass centres are those in
/// charts of the surface, in each of which the vertices that are far from where it is cut are measured.
/// Vertices at the border of the mesh are not free. Faces that overlap others in every chart have no share in the
/// tessellation, nor in its ideal number of vertices.
/// \sa `CGAL::anisotropic_surface_mesh_statistics_3()`
struct Surface_mesh_statistics
  : public Mesh_statistics
{
  double distance_mean = 0;            ///< from barycentres and midpoints of edges to the surface, in units of space
  double distance_max = 0;             ///< the largest of these distances
  double normal_deviation_mean = 0;    ///< from the normal of the surface, at barycentres, in radians
  double normal_deviation_max = 0;     ///< the largest of these angles

  /// calls `visit(name, value)` for each value, those of `Mesh_statistics` first.
  /// \tparam Visit a functor of a `const char*` and either a `std::size_t` or a `double`
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    Mesh_statistics::for_each(visit);
    visit("distance_mean", distance_mean);
    visit("distance_max", distance_max);
    visit("normal_deviation_mean", normal_deviation_mean);
    visit("normal_deviation_max", normal_deviation_max);
  }

  /// writes one line per value.
  friend std::ostream& operator<<(std::ostream& os, const Surface_mesh_statistics& s)
  {
    return internal::write_statistics(os, s);
  }

  /// writes the statistics as a flat JSON object.
  void write_json(std::ostream& os) const { internal::write_statistics_as_json(os, *this); }
};

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
  typedef typename Mesh::Vertex_handle       Vertex_handle;

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
  // a face in space
  struct Triangle
  {
    std::array<Point_3, 3>  corner;
    std::array<Tensor_3, 3> tensor;
  };

  struct Surface_summary
  {
    Shape_summary shapes;
    Summary       distances, deviations;

    Surface_summary& operator+=(const Surface_summary& s)
    {
      shapes += s.shapes;
      distances += s.distances;
      deviations += s.deviations;
      return *this;
    }
  };

  void measure_shapes()
  {
    const auto sum = sum_of_chunks<ConcurrencyTag, Surface_summary>
      (m_mesh.number_of_faces(), [&](std::size_t f, Surface_summary& s) {
      const Triangle t = triangle(m_mesh.faces()[f]);
      measure_face(f, t, s);
      measure_edges(f, t, s);
    });
    sum.shapes.write_to(m_result);
    m_result.distance_mean = sum.distances.mean();
    m_result.distance_max = sum.distances.largest;
    m_result.normal_deviation_mean = sum.deviations.mean();
    m_result.normal_deviation_max = sum.deviations.largest;
  }

  Triangle triangle(const Face& face) const
  {
    Triangle t;
    for(int i = 0; i < 3; ++i) {
      t.corner[i] = m_mesh.point(face[i]);
      t.tensor[i] = m_field.metric_tensor_3(m_mesh.parameters(face[i]));
    }
    return t;
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

  void measure_face(std::size_t f, const Triangle& t, Surface_summary& s) const
  {
    const Point_2 barycentre = parameters(f, {1./3, 1./3, 1./3});
    double least = 1;
    for(const Tensor_3& m : t.tensor)
      least = (std::min)(least, surface_quality(t.corner, m));
    s.shapes.qualities.add(surface_quality(t.corner, m_field.metric_tensor_3(barycentre)));
    s.shapes.qualities_min3.add(least);
    s.deviations.add(normal_deviation(m_field.surface(), barycentre, t.corner));
    s.distances.add(distance_to_surface(m_field.surface(), barycentre,
                                        CGAL::centroid(t.corner[0], t.corner[1], t.corner[2])));
  }

  // the edges that do not belong to the face beyond
  void measure_edges(std::size_t f, const Triangle& t, Surface_summary& s) const
  {
    const Face& face = m_mesh.faces()[f];
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if(face[i] > face[j] && m_edges.contains(face[j], face[i]))
        continue;
      std::array<double, 3> l = {0.5, 0.5, 0.5};
      l[(i + 2) % 3] = 0;
      const Point_2 middle = parameters(f, l);
      s.shapes.edges.add(chord_length(t.corner[j] - t.corner[i],
                                      t.tensor[i], m_field.metric_tensor_3(middle), t.tensor[j]));
      s.distances.add(distance_to_surface(m_field.surface(), middle, CGAL::midpoint(t.corner[i], t.corner[j])));
    }
  }

  // Each part of the atlas contributes the faces and the vertices that are given to it.
  void measure_energy()
  {
    Energy_summary<Mesh, ConcurrencyTag> summary(Measure::RIEMANNIAN);
    for(std::size_t k = 0; k < m_atlas.parts.size(); ++k) {
      Part_mesh part(m_mesh, m_atlas.parts[k]);
      if(part.faces().empty() || !part.copy_faces())
        continue;
      std::vector<Face_handle> faces, others;
      std::vector<int> places;
      divide_faces(k, part, faces, places, others);
      const Sampled_metric<Mesh> metric(ConcurrencyTag(), part.mesh(), sampling_for_statistics);
      summary.add(part.mesh(), metric, faces, places, others, free_vertices_given_to(k, part));
    }
    summary.write_to(m_result);
  }

  // Tells the faces that are given to a part, and their places among all, from the others in it.
  void divide_faces(std::size_t k, Part_mesh& part, std::vector<Face_handle>& given, std::vector<int>& places,
                    std::vector<Face_handle>& others) const
  {
    std::set<Face> faces;
    for(std::size_t f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_cover.part_of_face(f) == k)
        faces.insert(sorted(m_mesh.faces()[f]));
    const std::vector<Face_handle> all = part.mesh().faces_in_domain();
    for(std::size_t i = 0; i < all.size(); ++i) {
      const Face_handle f = all[i];
      if(faces.count(sorted({part.number(f->vertex(0)), part.number(f->vertex(1)), part.number(f->vertex(2))})) > 0) {
        given.push_back(f);
        places.push_back(int(i));
      }
      else
        others.push_back(f);
    }
  }

  // Vertices on the border have no whole region in the part.
  std::vector<Vertex_handle> free_vertices_given_to(std::size_t k, Part_mesh& part) const
  {
    std::vector<bool> is_on_rim(m_mesh.number_of_vertices(), false);
    for(const auto& e : part.border())
      is_on_rim[e[0]] = true; // the target of an edge is the source of another one
    std::vector<Vertex_handle> vertices;
    for(auto v = part.mesh().finite_vertices_begin(); v != part.mesh().finite_vertices_end(); ++v)
      if(m_cover.part_of_vertex(part.number(v)) == k && !is_on_rim[part.number(v)])
        vertices.push_back(v);
    return vertices;
  }

  static Face sorted(Face f)
  {
    std::sort(f.begin(), f.end());
    return f;
  }

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
/// measures a mesh of a surface in the metric of the space, and how close it is to the surface
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// Metric and surface are evaluated some 20 to 60 times per vertex; what is said of the accuracy of
/// `anisotropic_mesh_statistics_2()` holds here too.
///
/// \tparam ConcurrencyTag as for `optimize_anisotropic_mesh_2()`; the result is the same to the bit.
/// \tparam Field an instance of `Surface_metric_field_2`.
/// \param mesh the mesh.
/// \return the statistics; those of the tessellation are in the Riemannian measure.
/// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric fails at a point of the surface.
template <class ConcurrencyTag = Sequential_tag, class Field>
Anisotropic_mesh_2::Surface_mesh_statistics
anisotropic_surface_mesh_statistics_3(const Anisotropic_surface_mesh_3<Field>& mesh)
{
  return Anisotropic_mesh_2::internal::Surface_statistics_collector<Field, ConcurrencyTag>(mesh)();
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_SURFACE_MESH_STATISTICS_3_H

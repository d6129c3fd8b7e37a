// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ENERGY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ENERGY_H

#include <CGAL/Anisotropic_mesh_2/Measure.h>
#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/Region_moments.h>

#include <CGAL/number_utils.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The energy of the anisotropic Voronoi tessellation of the vertices of a mesh
// and the moments of the regions, assembled face by face: each face is divided
// among the vertices nearby by their bisectors. Where the metric varies within
// a face, the face is quartered until it does not, so that mild metrics do not
// pay for rough ones.
template <class Mesh>
class Acvt_energy
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;
  typedef typename Mesh::Edge            Edge;

public:
  // `tolerance` is the variation of the metric within an element that is left as it is
  Acvt_energy(const Mesh& mesh, Measure measure, double tolerance = 0.3, int maximum_depth = 2)
    : m_mesh(mesh), m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()),
      m_is_riemannian(measure == Measure::RIEMANNIAN), m_tolerance(tolerance), m_maximum_depth(maximum_depth)
  {}

  // Returns the energy and sets the moments, by the index of the vertex.
  double operator()(std::vector<Region_moments>& moments)
  {
    weigh_vertices();
    moments.assign(m_vertex_tensors.size(), Region_moments());
    double energy = 0;
    for(auto f = m_mesh.finite_faces_begin(); f != m_mesh.finite_faces_end(); ++f)
      if(f->is_in_domain())
        energy += add_face(f, moments);
    return energy;
  }

private:
  typedef Clipped_element_integrator::Generators Generators;

  void weigh_vertices()
  {
    m_vertex_tensors.resize(m_mesh.vertex_index_bound());
    for(auto v = m_mesh.finite_vertices_begin(); v != m_mesh.finite_vertices_end(); ++v)
      m_vertex_tensors[v->index()] = Weighted_tensor(Symmetric_form(v->metric_tensor()), m_is_riemannian);
  }

  Weighted_tensor tensor_at(const Vector_of_doubles& x) const
  {
    return Weighted_tensor(Symmetric_form(m_tensor(point_at<Point>(x.x, x.y))), m_is_riemannian);
  }

  double add_face(Face_handle f, std::vector<Region_moments>& moments) const
  {
    Acvt_element e;
    std::array<Region_moments*, 3> of_corners;
    for(int i = 0; i < 3; ++i) {
      const Vertex_handle v = f->vertex(i);
      e.corner[i] = to_doubles(v->point());
      e.tensor[i] = m_vertex_tensors[v->index()];
      of_corners[i] = &moments[v->index()];
    }
    e.middle = tensor_at(e.barycentre());

    if(e.variation() > m_tolerance)
      return add_refined(e, generators_near(f, 2, moments), m_maximum_depth);
    e.prepare_interpolation();
    Acute_element_integrator acute;
    if(acute.prepare(e) && !has_obtuse_neighbor(f, e.middle.m))
      return acute(e, of_corners);
    return Clipped_element_integrator()(e, generators_near(f, 1, moments));
  }

  // In an obtuse neighbor the vertex opposite to the common edge is nearer to a
  // part of this face than its own vertices.
  bool has_obtuse_neighbor(Face_handle f, const Symmetric_form& m) const
  {
    for(int i = 0; i < 3; ++i) {
      const Edge e = m_mesh.mirror_edge(Edge(f, i));
      if(!e.first->is_in_domain())
        continue;
      const Vector_of_doubles p = to_doubles(f->vertex(Mesh::ccw(i))->point()), q = to_doubles(f->vertex(Mesh::cw(i))->point());
      const Vector_of_doubles o = to_doubles(e.first->vertex(e.second)->point());
      if(m(p.x - o.x, p.y - o.y, q.x - o.x, q.y - o.y) < 0)
        return true;
    }
    return false;
  }

  double add_refined(Acvt_element& e, const Generators& generators, int depth) const
  {
    if(depth == 0 || e.variation() <= m_tolerance) {
      e.prepare_interpolation();
      return Clipped_element_integrator()(e, generators);
    }
    std::array<Vector_of_doubles, 3> middle; // of the edge opposite to the corner
    std::array<Weighted_tensor, 3> tensor;
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = e.corner[(i + 1) % 3], &q = e.corner[(i + 2) % 3];
      middle[i] = {(p.x + q.x) / 2, (p.y + q.y) / 2};
      tensor[i] = tensor_at(middle[i]);
    }
    double energy = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      energy += add_part({e.corner[i], middle[k], middle[j]}, {e.tensor[i], tensor[k], tensor[j]},
                         generators, depth - 1);
    }
    return energy + add_part(middle, tensor, generators, depth - 1);
  }

  double add_part(const std::array<Vector_of_doubles, 3>& corner, const std::array<Weighted_tensor, 3>& tensor,
                  const Generators& generators, int depth) const
  {
    Acvt_element part;
    part.corner = corner;
    part.tensor = tensor;
    part.middle = tensor_at(part.barycentre());
    return add_refined(part, generators, depth);
  }

  // the vertices of the face and of the faces up to `rings` edges away
  Generators generators_near(Face_handle f, int rings, std::vector<Region_moments>& moments) const
  {
    Generators generators;
    for(int i = 0; i < 3; ++i)
      add_generator(f->vertex(i), moments, generators);
    for(int i = 0; i < 3; ++i)
      add_generators_beyond(m_mesh.mirror_edge(Edge(f, i)), rings, moments, generators);
    return generators;
  }

  void add_generators_beyond(const Edge& e, int rings, std::vector<Region_moments>& moments,
                             Generators& generators) const
  {
    if(rings == 0 || !e.first->is_in_domain())
      return;
    add_generator(e.first->vertex(e.second), moments, generators);
    add_generators_beyond(m_mesh.mirror_edge(Edge(e.first, Mesh::ccw(e.second))), rings - 1, moments, generators);
    add_generators_beyond(m_mesh.mirror_edge(Edge(e.first, Mesh::cw(e.second))), rings - 1, moments, generators);
  }

  static void add_generator(Vertex_handle v, std::vector<Region_moments>& moments, Generators& generators)
  {
    Region_moments* m = &moments[v->index()];
    for(const auto& g : generators)
      if(g.moments == m)
        return;
    generators.push_back({to_doubles(v->point()), m, {}});
  }

  const Mesh& m_mesh;
  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  const bool m_is_riemannian;
  const double m_tolerance;
  const int m_maximum_depth;
  std::vector<Weighted_tensor> m_vertex_tensors;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ENERGY_H

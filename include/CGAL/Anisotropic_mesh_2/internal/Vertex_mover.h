// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_VERTEX_MOVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_VERTEX_MOVER_H

#include <CGAL/Anisotropic_mesh_2/internal/Acvt_element.h>
#include <CGAL/Anisotropic_mesh_2/internal/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/restore_connectivity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The vertices of the domain that end no constrained edge, in the order of their indices.
template <class Mesh>
std::vector<typename Mesh::Vertex_handle> free_vertices(const Mesh& mesh)
{
  typedef typename Mesh::Vertex_handle Vertex_handle;
  std::vector<bool> is_free(mesh.vertex_index_bound(), true);
  for(auto f = mesh.all_faces_begin(); f != mesh.all_faces_end(); ++f)
    for(int i = 0; i < 3; ++i)
      if(!mesh.is_infinite(f->vertex(i)) && (f->is_constrained(Mesh::ccw(i)) || !f->is_in_domain()))
        is_free[f->vertex(i)->index()] = false;
  std::vector<Vertex_handle> result;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    if(is_free[v->index()])
      result.push_back(v);
  std::sort(result.begin(), result.end(),
            [](Vertex_handle v, Vertex_handle w) { return v->index() < w->index(); });
  return result;
}

template <class Vertex_handle>
Vectors positions_of(const std::vector<Vertex_handle>& vertices)
{
  Vectors result(vertices.size());
  for(std::size_t i = 0; i < vertices.size(); ++i)
    result[i] = to_doubles(vertices[i]->point());
  return result;
}

// Moves the free vertices of a mesh in place. A vertex whose move would invert
// a face goes only a part of its way; afterwards the criterion of the
// triangulation is restored by flips.
template <class Mesh>
class Vertex_mover
{
  typedef typename Mesh::Point           Point;
  typedef typename Mesh::Vertex_handle   Vertex_handle;
  typedef typename Mesh::Face_handle     Face_handle;

public:
  explicit Vertex_mover(Mesh& mesh)
    : m_mesh(mesh), m_free(internal::free_vertices(mesh))
  {}

  // the vertices that may move, in the order of their indices
  const std::vector<Vertex_handle>& free_vertices() const { return m_free; }

  Vectors positions() const { return positions_of(m_free); }

  // Moves the free vertices towards `target`; they end there or, where faces
  // would turn over, on the way. Should the field fail, all stay where they are.
  void move_to(const Vectors& target)
  {
    const Vectors start = positions();
    place_all(target);
    untangle(start, target);
    try {
      evaluate_tensors();
    }
    catch(...) {
      place_all(start);
      throw;
    }
    restore_connectivity(m_mesh);
  }

private:
  static constexpr int halvings = 6;

  // Halves, again and again, the moves of the free vertices of inverted faces,
  // until none is left; from some point on the moves are taken back at once.
  // In each round a vertex is shortened, so that there is an end to it.
  void untangle(const Vectors& start, const Vectors& target)
  {
    std::vector<unsigned char> shortened(m_mesh.vertex_index_bound(), 0);
    std::vector<std::size_t> rank(m_mesh.vertex_index_bound(), 0);
    std::vector<bool> is_free(m_mesh.vertex_index_bound(), false);
    for(std::size_t i = 0; i < m_free.size(); ++i) {
      rank[m_free[i]->index()] = i;
      is_free[m_free[i]->index()] = true;
    }
    std::vector<Face_handle> suspects;
    for(auto f = m_mesh.finite_faces_begin(); f != m_mesh.finite_faces_end(); ++f)
      if(f->is_in_domain())
        suspects.push_back(f);

    while(!suspects.empty()) {
      std::vector<Vertex_handle> to_shorten;
      for(Face_handle f : suspects)
        if(is_inverted(f))
          for(int i = 0; i < 3; ++i) {
            const Vertex_handle v = f->vertex(i);
            if(is_free[v->index()] && shortened[v->index()] <= halvings)
              to_shorten.push_back(v);
          }
      std::sort(to_shorten.begin(), to_shorten.end(),
                [](Vertex_handle v, Vertex_handle w) { return v->index() < w->index(); });
      to_shorten.erase(std::unique(to_shorten.begin(), to_shorten.end()), to_shorten.end());
      suspects.clear();
      for(Vertex_handle v : to_shorten) {
        const std::size_t i = rank[v->index()];
        place(v, start[i], target[i], ++shortened[v->index()]);
        auto f = m_mesh.incident_faces(v), done(f);
        do {
          suspects.push_back(f);
        } while(++f != done);
      }
    }
  }

  static void place(Vertex_handle v, const Vector_of_doubles& start, const Vector_of_doubles& target, int times)
  {
    if(times > halvings) {
      v->set_point(point_at<Point>(start.x, start.y));
      return;
    }
    const double t = 1. / (1 << times);
    v->set_point(point_at<Point>(start.x + t * (target.x - start.x), start.y + t * (target.y - start.y)));
  }

  bool is_inverted(Face_handle f) const
  {
    return m_mesh.orientation(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) != LEFT_TURN;
  }

  void place_all(const Vectors& positions)
  {
    for(std::size_t i = 0; i < m_free.size(); ++i)
      m_free[i]->set_point(point_at<Point>(positions[i].x, positions[i].y));
  }

  // Sets all tensors or, if the field fails at a vertex, none.
  void evaluate_tensors()
  {
    const auto tensor = m_mesh.geom_traits().construct_metric_tensor_2_object();
    std::vector<typename Mesh::Metric_tensor_2> tensors;
    tensors.reserve(m_free.size());
    for(Vertex_handle v : m_free)
      tensors.push_back(tensor(v->point()));
    for(std::size_t i = 0; i < m_free.size(); ++i)
      m_free[i]->set_metric_tensor(tensors[i]);
  }

  Mesh& m_mesh;
  std::vector<Vertex_handle> m_free;
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_VERTEX_MOVER_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_VORONOI_CELLS_2_H
#define CGAL_ANISOTROPIC_VORONOI_CELLS_2_H

#include <CGAL/Anisotropic_mesh_2/Voronoi_cell_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// The part of a triangle that is nearer to its vertex 0 than to the other two,
// as the points on its boundary between the two edges at vertex 0, in order.
template <class Point_2>
class Corner_part
{
public:
  Corner_part(const Point_2& a, const Point_2& b, const Point_2& c, const Symmetric_form& m) : m_form(m)
  {
    m_polygon = {a, b, c};
    clip(a, b);
    clip(a, c);
  }

  // The polygon from the corner on, without the corner itself.
  std::vector<Point_2> boundary() const { return std::vector<Point_2>(m_polygon.begin() + 1, m_polygon.end()); }

private:
  // keeps what is not farther from a than from z; the corner a stays first
  void clip(const Point_2& a, const Point_2& z)
  {
    std::vector<Point_2> kept;
    for(std::size_t i = 0; i < m_polygon.size(); ++i) {
      const Point_2 &p = m_polygon[i], &q = m_polygon[(i + 1) % m_polygon.size()];
      const double vp = excess(p, a, z), vq = excess(q, a, z);
      if(vp <= 0)
        kept.push_back(p);
      if((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
        const Coordinate<Point_2> t(vp / (vp - vq));
        kept.push_back(Point_2(p.x() + t * (q.x() - p.x()), p.y() + t * (q.y() - p.y())));
      }
    }
    m_polygon.swap(kept);
  }

  double excess(const Point_2& x, const Point_2& a, const Point_2& z) const
  {
    return m_form(CGAL::to_double(x.x() - a.x()), CGAL::to_double(x.y() - a.y()))
         - m_form(CGAL::to_double(x.x() - z.x()), CGAL::to_double(x.y() - z.y()));
  }

  Symmetric_form m_form;
  std::vector<Point_2> m_polygon;
};

// The polygons of the cell of v: one around v, or one for each run of faces of
// the domain at v, with v as its first point.
template <class Mesh, class Construct_tensor>
std::vector<std::vector<typename Mesh::Point> >
cell_polygons(const Mesh& mesh, typename Mesh::Vertex_handle v, const Construct_tensor& tensor)
{
  typedef typename Mesh::Point Point;
  auto first = mesh.incident_faces(v), f = first;
  while(f->is_in_domain() && ++f != first)
    ;
  const bool is_surrounded = f->is_in_domain();
  first = f; // the faces before this one are not in its run
  std::vector<std::vector<Point> > polygons;
  bool is_in_run = false;
  do {
    if(f->is_in_domain()) {
      if(!is_in_run)
        polygons.push_back(is_surrounded ? std::vector<Point>() : std::vector<Point>(1, v->point()));
      const int i = f->index(v);
      const Point &a = v->point(), &b = f->vertex(Mesh::ccw(i))->point(), &c = f->vertex(Mesh::cw(i))->point();
      const Point barycentre((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
      for(const Point& p : Corner_part<Point>(a, b, c, Symmetric_form(tensor(barycentre))).boundary())
        if(polygons.back().empty() || !mesh.xy_equal(polygons.back().back(), p))
          polygons.back().push_back(p);
    }
    is_in_run = f->is_in_domain();
  } while(++f != first);
  return polygons;
}

} // namespace internal
} // namespace Anisotropic_mesh_2

/// \ingroup PkgAnisotropicMesh2Functions
///
/// the anisotropic Voronoi tessellation of the vertices of a mesh, as the fast
/// assembly of the optimizer sees it: each face is divided among its vertices
/// by their bisectors in the tensor at its barycentre. The cells tile the domain.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \return the cells of the vertices of the domain, in the order of the mesh.
template <class Mesh>
std::vector<Anisotropic_mesh_2::Voronoi_cell_2<typename Mesh::Kernel> >
anisotropic_voronoi_cells_2(const Mesh& mesh)
{
  namespace internal = Anisotropic_mesh_2::internal;
  const auto tensor = mesh.geom_traits().construct_metric_tensor_2_object();
  std::vector<Anisotropic_mesh_2::Voronoi_cell_2<typename Mesh::Kernel> > cells;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v) {
    auto polygons = internal::cell_polygons(mesh, typename Mesh::Vertex_handle(v), tensor);
    if(!polygons.empty())
      cells.push_back({v->point(), std::move(polygons), mesh.is_fixed(v)});
  }
  return cells;
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_VORONOI_CELLS_2_H

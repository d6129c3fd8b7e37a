// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_TRIANGULATED_SURFACE_3_H
#define CGAL_ANISOTROPIC_MESH_2_TRIANGULATED_SURFACE_3_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Border_curves.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/triangulated/Parametrized_disc.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a surface of triangles with the topology of a disc, in parameters that distort it little
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// The parameters are found by the *as rigid as possible* method \cgalCite{lzxgg-lgamp-08} of \cgal's package for the
/// parametrization of surface meshes, with a free border, or, where that folds over, by mean value coordinates
/// \cgalCite{f-mvc-03} in a circle. Points are on the triangles, up to rounding, so that a mesh made of this
/// surface has its vertices there. The first derivatives are constant on each triangle. The second ones give the
/// curvature of a cubic polynomial that is fitted to the vertices around each vertex \cgalCite{cp-edqpf-05}, and
/// is linear in between.
///
/// Parameters outside of the `domain()` stand for the nearest ones within.
///
/// A program with this header must link `CGAL::Eigen3_support`, and takes 110 s and 2.7 GB of memory to compile with
/// its mesher and optimizer (g++ 12, `-O2`). Copies share their data and are cheap. A query takes \f$ O(\log n) \f$
/// time for reasonable meshes of `n` triangles.
///
/// \tparam K a model of `Kernel` with exact predicates
/// \cgalModels{ParametricSurface_3}
/// \sa `Vertex_metric_3`
template <class K>
class Triangulated_surface_3
{
public:
  typedef K                        Kernel;   ///< the kernel
  typedef typename K::FT           FT;       ///< its number type
  typedef typename K::Point_2      Point_2;  ///< a point of the parameters
  typedef typename K::Point_3      Point_3;  ///< a point of space
  typedef typename K::Vector_3     Vector_3; ///< a vector of space

  /// a place on a triangle.
  struct Place
  {
    std::array<std::size_t, 3> vertices; ///< their numbers
    std::array<double, 3>      weights;  ///< the barycentric coordinates, none negative
  };

  /// the surface of the faces of `mesh`, whose vertices are numbered in the order of `vertices(mesh)`.
  /// \tparam TriangleMesh a model of `FaceListGraph`, such as `Surface_mesh<K::Point_3>`, with
  /// an internal property map of points.
  /// \throw Invalid_triangle_mesh_exception if `mesh` is not a topological disc of triangles, a vertex is not finite, a
  /// triangle has no area, or the mesh cannot be mapped to the plane without folds.
  template <class TriangleMesh>
  explicit Triangulated_surface_3(const TriangleMesh& mesh) : m_disc(std::make_shared<const Disc>(mesh)) {}

  /// \name Parametric Surface
  /// @{

  /// the bounding box of the parameters.
  Anisotropic_mesh_2::Parameter_rectangle parameters() const { return m_disc->rectangle; }

  /// the point with the parameters `uv`, on a triangle.
  Point_3 point(const Point_2& uv) const
  {
    const Place place = locate(uv);
    const auto corner = [&](int i) { return m_disc->points[place.vertices[i]]; };
    return corner(0) + FT(place.weights[1]) * (corner(1) - corner(0)) + FT(place.weights[2]) * (corner(2) - corner(0));
  }

  /// the derivatives by u and by v, the same within a triangle.
  std::array<Vector_3, 2> first_derivatives(const Point_2& uv) const { return first_derivatives(locate(uv)); }

  /// the derivatives twice by u, by u and v, and twice by v, without their parts along the triangle.
  std::array<Vector_3, 3> second_derivatives(const Point_2& uv) const
  {
    const Place place = locate(uv);
    const std::array<Vector_3, 2> d = first_derivatives(place);
    const Vector_3 normal = cross_product(d[0], d[1]);
    const Vector_3 n = normal / FT(std::sqrt(CGAL::to_double(normal * normal)));
    const Shape_operator s = shape_operator(place);
    return {second_form(s, d[0], d[0]) * n, second_form(s, d[0], d[1]) * n, second_form(s, d[1], d[1]) * n};
  }
  /// @}

  /// \name Access
  /// @{

  /// the number of vertices of the mesh that was given.
  std::size_t number_of_vertices() const { return m_disc->points.size(); }

  /// the parameters of the vertex with the number `v`.
  const Point_2& vertex_parameters(std::size_t v) const { return m_disc->places[v]; }

  /// the triangle that has the parameters `uv`, and where it has them. It interpolates whatever is given at vertices.
  Place locate(const Point_2& uv) const
  {
    const auto place = m_disc->locator->locate(uv);
    return {place.vertices, place.weights};
  }

  /// the domain of the parameters, to be given to `make_anisotropic_surface_mesh_3()` if `corner_angle` is to differ.
  ///
  /// The border is divided into curves at its corners. These become vertices of a mesh; all others
  /// of the border lie on its edges, up to rounding. With a `corner_angle` of 0 each vertex of the border is kept.
  /// \param corner_angle vertices where the border turns by more than this angle, in space, are corners, in radians;
  /// those where it turns by more than 0.2 in the plane of parameters, or by more than `corner_angle` if that is
  /// less, are too.
  Anisotropic_mesh_domain_2<K> domain(double corner_angle = 0.5) const
  {
    Anisotropic_mesh_domain_2<K> result;
    result.add_loop(Anisotropic_mesh_2::internal::Border_curves<K>(m_disc, corner_angle)());
    return result;
  }
  /// @}

private:
  typedef Anisotropic_mesh_2::internal::Parametrized_disc<K>  Disc;
  typedef Anisotropic_mesh_2::internal::Shape_operator        Shape_operator;

  std::array<Vector_3, 2> first_derivatives(const Place& place) const
  {
    const auto corner = [&](int i) { return m_disc->points[place.vertices[i]]; };
    const auto uv = [&](int i) { return m_disc->places[place.vertices[i]]; };
    const auto a = uv(1) - uv(0), b = uv(2) - uv(0);
    const Vector_3 p = corner(1) - corner(0), q = corner(2) - corner(0);
    const FT det = a.x()*b.y() - a.y()*b.x();
    return {(b.y()*p - a.y()*q) / det, (a.x()*q - b.x()*p) / det};
  }

  Shape_operator shape_operator(const Place& place) const
  {
    Shape_operator s = {};
    for(int i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < s.size(); ++k)
        s[k] += place.weights[i] * m_disc->shape_operators[place.vertices[i]][k];
    return s;
  }

  static FT second_form(const Shape_operator& s, const Vector_3& v, const Vector_3& w)
  {
    return v.x() * (FT(s[0])*w.x() + FT(s[1])*w.y() + FT(s[2])*w.z())
         + v.y() * (FT(s[1])*w.x() + FT(s[3])*w.y() + FT(s[4])*w.z())
         + v.z() * (FT(s[2])*w.x() + FT(s[4])*w.y() + FT(s[5])*w.z());
  }

  std::shared_ptr<const Disc> m_disc;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_TRIANGULATED_SURFACE_3_H

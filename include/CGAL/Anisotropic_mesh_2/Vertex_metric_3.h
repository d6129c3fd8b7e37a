// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_VERTEX_METRIC_3_H
#define CGAL_ANISOTROPIC_MESH_2_VERTEX_METRIC_3_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/Anisotropic_mesh_2/Triangulated_surface_3.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric of the space that interpolates tensors given at the vertices of a triangulated surface
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// In a triangle, the matrix logarithms of the three tensors are interpolated linearly, as by
/// `Discrete_metric_field_2`. Copies share their data and are cheap.
///
/// A program with this header must link `CGAL::Eigen3_support`.
///
/// \tparam K a model of `Kernel` with exact predicates, as `Triangulated_surface_3` wants it
/// \sa `Surface_metric_field_2`
template <class K>
class Vertex_metric_3
{
public:
  typedef Triangulated_surface_3<K>    Surface;       ///< the surface
  typedef typename K::FT               FT;            ///< the number type
  typedef typename K::Point_2          Point_2;       ///< a point of the parameters
  typedef Metric_tensor_3<K>           Metric_tensor; ///< a tensor of the space

  /// the metric with the given tensors, in the order of the vertices of `surface`.
  /// \throw Invalid_triangle_mesh_exception if the numbers of tensors and vertices differ.
  Vertex_metric_3(const Surface& surface, const std::vector<Metric_tensor>& tensors)
  {
    if(tensors.size() != surface.number_of_vertices())
      throw Invalid_triangle_mesh_exception("the surface has " + std::to_string(surface.number_of_vertices())
                                  + " vertices, but " + std::to_string(tensors.size()) + " metric tensors are given");
    auto logarithms = std::make_shared<std::vector<Matrix> >();
    for(const Metric_tensor& m : tensors)
      logarithms->push_back(logarithm(m));
    m_logarithms = logarithms;
  }

  /// returns the tensor of the space at the point of the surface with the parameters `uv`.
  /// \pre `surface` is the one whose tensors were given, or a copy of it.
  Metric_tensor operator()(const Surface& surface, const Point_2& uv) const
  {
    CGAL_precondition(m_logarithms->size() == surface.number_of_vertices());
    const typename Surface::Place place = surface.locate(uv);
    Matrix l = Matrix::Zero();
    for(int i = 0; i < 3; ++i)
      l += place.weights[i] * (*m_logarithms)[place.vertices[i]];
    return exponential(l);
  }

private:
  typedef Eigen::Matrix3d                          Matrix;
  typedef Eigen::SelfAdjointEigenSolver<Matrix>    Eigen_solver;

  static Matrix logarithm(const Metric_tensor& m)
  {
    std::array<double, 6> e;
    for(int k = 0; k < 6; ++k)
      e[k] = CGAL::to_double(m.entries()[k]);
    Matrix a;
    a << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5];
    const Eigen_solver solver(a);
    const auto& basis = solver.eigenvectors();
    return basis * solver.eigenvalues().array().log().matrix().asDiagonal() * basis.transpose();
  }

  static Metric_tensor exponential(const Matrix& l)
  {
    const Eigen_solver solver(l);
    const Matrix a = solver.eigenvectors() * solver.eigenvalues().array().exp().matrix().asDiagonal()
                   * solver.eigenvectors().transpose();
    return Metric_tensor::from_entries({FT(a(0, 0)), FT(a(0, 1)), FT(a(0, 2)), FT(a(1, 1)), FT(a(1, 2)), FT(a(2, 2))});
  }

  std::shared_ptr<const std::vector<Matrix> > m_logarithms; // by vertex
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_VERTEX_METRIC_3_H

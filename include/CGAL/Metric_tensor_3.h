// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_METRIC_TENSOR_3_H
#define CGAL_METRIC_TENSOR_3_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/refuse_metric_tensor.h>
#include <CGAL/number_utils.h>

#include <array>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// a symmetric positive definite matrix by which lengths are measured at a point of space.
///
/// The vectors of length 1 form an ellipsoid, whose half axes are the *sizes*.
/// No invalid tensor can be built: every way to build one throws
/// `Anisotropic_mesh_2::Invalid_metric_tensor_exception` unless the result is finite and positive
/// definite. A default constructed tensor is the identity.
///
/// With `double` entries, sizes lie between 10<sup>-50</sup> and 10<sup>50</sup>; beyond, the determinant leaves the
/// range of numbers and the tensor is refused.
///
/// \tparam K a model of `Kernel`
/// \sa `Metric_tensor_2`
template <class K>
class Metric_tensor_3
{
public:
  typedef K                      Kernel;   ///< the kernel
  typedef typename K::FT         FT;       ///< its number type
  typedef typename K::Vector_3   Vector_3; ///< a vector of space
  typedef std::array<FT, 6>      Entries; ///< 11, 12, 13, 22, 23, 33

  /// \name Creation
  /// @{

  /// the identity: lengths are the Euclidean ones.
  Metric_tensor_3() : m_entries{FT(1), FT(0), FT(0), FT(1), FT(0), FT(1)} {}

  /// the tensor with the given entries.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if it is not finite or not positive definite.
  static Metric_tensor_3 from_entries(const Entries& entries)
  {
    const Metric_tensor_3 m(entries);
    const Entries& e = entries;
    if(!m.is_positive_definite())
      Anisotropic_mesh_2::internal::refuse_metric_tensor({{"the metric tensor with the entries ", e[0]}, {" ", e[1]},
                                                          {" ", e[2]}, {" ", e[3]}, {" ", e[4]}, {" ", e[5]}});
    return m;
  }

  /// the isotropic tensor of size `h`.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if `h` is not positive or not finite.
  static Metric_tensor_3 from_size(const FT& h) { return from_sizes(h, h, h); }

  /// the tensor with the given sizes along the axes of coordinates, type (5.1) of \cgalCite{dw-acvt-05}.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if a size is not positive or not finite.
  static Metric_tensor_3 from_sizes(const FT& h1, const FT& h2, const FT& h3)
  {
    return from_entries({eigenvalue(h1), FT(0), FT(0), eigenvalue(h2), FT(0), eigenvalue(h3)});
  }

  /// the tensor with the given sizes along the given directions.
  /// \pre the directions are orthogonal to each other and have unit length, up to rounding.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if a size is not positive or not finite, or a
  /// direction is not finite.
  static Metric_tensor_3 from_directions(const std::array<Vector_3, 3>& directions, const std::array<FT, 3>& sizes)
  {
    Entries e{FT(0), FT(0), FT(0), FT(0), FT(0), FT(0)};
    for(int i = 0; i < 3; ++i) {
      const Vector_3& d = directions[i];
      const FT l = eigenvalue(sizes[i]);
      e = {e[0] + l*d.x()*d.x(), e[1] + l*d.x()*d.y(), e[2] + l*d.x()*d.z(),
           e[3] + l*d.y()*d.y(), e[4] + l*d.y()*d.z(), e[5] + l*d.z()*d.z()};
    }
    return from_entries(e);
  }
  /// @}

  /// the entries, row by row, of the upper triangle.
  const Entries& entries() const { return m_entries; }

  /// the determinant.
  FT determinant() const
  {
    const Entries& e = m_entries;
    return e[0] * (e[3]*e[5] - e[4]*e[4]) - e[1] * (e[1]*e[5] - e[4]*e[2]) + e[2] * (e[1]*e[4] - e[3]*e[2]);
  }

  /// the squared length \f$ v^T M v \f$.
  FT squared_length(const Vector_3& v) const { return scalar_product(v, v); }

  /// the scalar product \f$ v^T M w \f$.
  FT scalar_product(const Vector_3& v, const Vector_3& w) const
  {
    const Entries& e = m_entries;
    return v.x() * (e[0]*w.x() + e[1]*w.y() + e[2]*w.z()) + v.y() * (e[1]*w.x() + e[3]*w.y() + e[4]*w.z())
         + v.z() * (e[2]*w.x() + e[4]*w.y() + e[5]*w.z());
  }

private:
  explicit Metric_tensor_3(const Entries& entries) : m_entries(entries) {}

  static FT eigenvalue(const FT& size)
  {
    if(!(CGAL::is_finite(size) && size > 0))
      Anisotropic_mesh_2::internal::refuse_metric_tensor({{"the metric with the size ", size}});
    return FT(1) / (size*size);
  }

  bool is_positive_definite() const
  {
    const Entries& e = m_entries;
    for(const FT& x : e)
      if(!CGAL::is_finite(x))
        return false;
    const FT det = determinant();
    return e[0] > 0 && e[0]*e[3] - e[1]*e[1] > 0 && det > 0 && CGAL::is_finite(det);
  }

  Entries m_entries;
};

} // namespace CGAL

#endif // CGAL_METRIC_TENSOR_3_H

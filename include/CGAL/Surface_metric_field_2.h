// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_METRIC_FIELD_2_H
#define CGAL_SURFACE_METRIC_FIELD_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Metric_tensor_3.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the metric that a surface induces in the plane of its parameters from one of
/// the space: \f$ M_{2D} = (\sigma_u, \sigma_v)^T M_{3D} (\sigma_u, \sigma_v) \f$
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// \tparam Surface_ a model of `ParametricSurface_3`
/// \tparam Metric_ a functor, callable from several threads, of a `K::Point_3`
/// that returns a size (then \f$ M_{3D} = h^{-2} I \f$) or a `Metric_tensor_3<K>`; or of a
/// `const Surface&` and a `K::Point_2` of parameters that returns such a tensor, like
/// `Anisotropic_mesh_2::Curvature_metric_3`.
/// `K` is the kernel of the surface.
/// \cgalModels{MetricField_2}
/// \sa `make_surface_metric_field_2()`
template <class Surface_, class Metric_>
class Surface_metric_field_2
{
public:
  typedef Surface_                       Surface;       ///< the surface
  typedef Metric_                        Metric;        ///< the metric of the space
  typedef typename Surface::Kernel       Kernel;        ///< the kernel of the surface
  typedef typename Kernel::FT            FT;            ///< its number type
  typedef typename Kernel::Point_2       Point_2;       ///< a point of the parameters
  typedef typename Kernel::Point_3       Point_3;       ///< a point of space
  typedef typename Kernel::Vector_3      Vector_3;      ///< a vector of space
  typedef Metric_tensor_2<Kernel>        Metric_tensor; ///< a tensor of the parameters

  /// the metric that `surface` induces from `metric`; both are copied.
  Surface_metric_field_2(Surface surface, Metric metric)
    : m_surface(std::move(surface)), m_metric(std::move(metric)),
      m_u_extent(m_surface.parameters().u_extent()), m_v_extent(m_surface.parameters().v_extent())
  {}

  /// the surface.
  const Surface& surface() const { return m_surface; }
  /// the metric of the space.
  const Metric& metric() const { return m_metric; }

  /// returns the tensor in the plane of parameters.
  /// \throw Anisotropic_mesh_2::Degenerate_parametrization_exception if the surface or its first derivatives are
  /// not finite there, or if these are parallel.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric of the space fails.
  Metric_tensor operator()(const Point_2& uv) const
  {
    const std::array<Vector_3, 2> d = m_surface.first_derivatives(uv);
    check_tangents(d, uv);
    const Metric_tensor_3<Kernel> m = metric_tensor_3(uv);
    return Metric_tensor::from_entries(m.squared_length(d[0]), m.scalar_product(d[0], d[1]), m.squared_length(d[1]));
  }

  /// returns the tensor of the space at the point of the surface.
  /// \throw Anisotropic_mesh_2::Degenerate_parametrization_exception if that point is not finite.
  /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the metric of the space fails.
  Metric_tensor_3<Kernel> metric_tensor_3(const Point_2& uv) const
  {
    if constexpr(std::is_invocable<const Metric&, const Point_3&>::value) {
      const Point_3 p = m_surface.point(uv);
      if(!(CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z())))
        refuse("the surface is not finite", uv);
      if constexpr(std::is_convertible<std::invoke_result_t<const Metric&, const Point_3&>, FT>::value)
        return Metric_tensor_3<Kernel>::from_size(FT(m_metric(p)));
      else
        return m_metric(p);
    } else
      return m_metric(m_surface, uv);
  }

private:
  static constexpr double least_sine = 1e-7;   // of the angle between the derivatives; rounded entries hold no less
  static constexpr double least_ratio = 1e-12; // of their lengths, in units of the extents of the parameters

  void check_tangents(const std::array<Vector_3, 2>& d, const Point_2& uv) const
  {
    const double uu = CGAL::to_double(d[0]*d[0]), vv = CGAL::to_double(d[1]*d[1]);
    if(!std::isfinite(uu))
      refuse("the derivative of the surface by u is not finite", uv);
    if(!std::isfinite(vv))
      refuse("the derivative of the surface by v is not finite", uv);
    const double u = std::sqrt(uu) * m_u_extent, v = std::sqrt(vv) * m_v_extent;
    if(!(u > least_ratio * v))
      refuse("the derivative of the surface by u is zero", uv);
    if(!(v > least_ratio * u))
      refuse("the derivative of the surface by v is zero", uv);
    const Vector_3 normal = cross_product(d[0], d[1]);
    if(!(CGAL::to_double(normal*normal) > least_sine*least_sine * uu*vv))
      refuse("the derivatives of the surface by u and v are parallel", uv);
  }

  [[noreturn]] static void refuse(const std::string& what, const Point_2& uv)
  {
    throw Anisotropic_mesh_2::Degenerate_parametrization_exception(what, CGAL::to_double(uv.x()),
                                                                   CGAL::to_double(uv.y()));
  }

  Surface m_surface;
  Metric  m_metric;
  double  m_u_extent, m_v_extent;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the metric that `surface` induces from `metric`.
///
/// \tparam Surface a model of `ParametricSurface_3`
/// \tparam Metric as for `Surface_metric_field_2`
/// \param surface the surface
/// \param metric the metric of the space
/// \return the metric of the parameters
template <class Surface, class Metric>
Surface_metric_field_2<Surface, Metric> make_surface_metric_field_2(Surface surface, Metric metric)
{
  return Surface_metric_field_2<Surface, Metric>(std::move(surface), std::move(metric));
}

} // namespace CGAL

#endif // CGAL_SURFACE_METRIC_FIELD_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_CALLABLE_SURFACE_3_H
#define CGAL_ANISOTROPIC_MESH_2_CALLABLE_SURFACE_3_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/surface/Surface_differentiator.h>
#include <CGAL/assertions.h>

#include <array>
#include <utility>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the parametric surface of any function, which is differentiated numerically
/// (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// On a torus, first derivatives err by up to 1.3e-12 of their length inside of the range of parameters and
/// by 4e-12 at a side of it, second ones by 3e-10 inside and 5e-8 at a side. A function with details much
/// smaller than a hundredth of the range loses more. A first derivative costs 5 calls of the function,
/// or 6 close to a side, the second ones 29 to 38 in all.
///
/// \tparam K a model of `Kernel`
/// \tparam Function a functor `K::Point_3(const K::Point_2&)`, copyable and callable from several threads
/// \cgalModels{ParametricSurface_3}
/// \sa `make_callable_surface_3()`
template <class K, class Function>
class Callable_surface_3
{
public:
  typedef K                      Kernel;   ///< the kernel
  typedef typename K::FT         FT;       ///< its number type
  typedef typename K::Point_2    Point_2;  ///< a point of the parameters
  typedef typename K::Point_3    Point_3;  ///< a point of space
  typedef typename K::Vector_3   Vector_3; ///< a vector of space

  /// the surface of `function`, defined on `parameters`, outside of which it is not called, but for
  /// periodic parameters.
  /// \pre `parameters.is_valid()`
  Callable_surface_3(Function function, const Anisotropic_mesh_2::Parameter_rectangle& parameters)
    : m_function(std::move(function)), m_parameters(parameters)
  {
    CGAL_precondition(parameters.is_valid());
  }

  /// the rectangle of parameters.
  Anisotropic_mesh_2::Parameter_rectangle parameters() const { return m_parameters; }

  /// the point with the parameters `uv`.
  Point_3 point(const Point_2& uv) const { return m_function(uv); }

  /// the derivatives by u and by v.
  std::array<Vector_3, 2> first_derivatives(const Point_2& uv) const
  {
    const Differentiator derivative(m_function, m_parameters);
    return {derivative(uv, 1, 0), derivative(uv, 0, 1)};
  }

  /// the derivatives twice by u, by u and v, and twice by v.
  std::array<Vector_3, 3> second_derivatives(const Point_2& uv) const
  {
    const Differentiator derivative(m_function, m_parameters);
    return {derivative(uv, 2, 0), derivative(uv, 1, 1), derivative(uv, 0, 2)};
  }

private:
  typedef Anisotropic_mesh_2::internal::Surface_differentiator<K, Function> Differentiator;

  Function                                m_function;
  Anisotropic_mesh_2::Parameter_rectangle m_parameters;
};

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the surface of `function`; `K` is to be named, as in `make_callable_surface_3<K>(function, parameters)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Function a functor `K::Point_3(const K::Point_2&)`, copyable and callable from several threads
/// \param function the function
/// \param parameters the rectangle on which it is defined
/// \return the surface
/// \pre `parameters.is_valid()`
template <class K, class Function>
Callable_surface_3<K, Function> make_callable_surface_3(Function function,
                                                        const Anisotropic_mesh_2::Parameter_rectangle& parameters)
{
  return Callable_surface_3<K, Function>(std::move(function), parameters);
}

/// \ingroup PkgAnisotropicMesh2Functions
///
/// returns the graph \f$ z = f(x, y) \f$ over a rectangle; `K` is to be named, as in
/// `make_graph_surface_3<K>(f, parameters)`.
///
/// \tparam K a model of `Kernel`
/// \tparam Height a functor `K::FT(const K::Point_2&)`, copyable and callable from several threads
/// \param height the function \f$ f \f$
/// \param parameters the rectangle, in x and y
/// \return the surface, a `Callable_surface_3`
/// \pre `parameters.is_valid()`
template <class K, class Height>
auto make_graph_surface_3(Height height, const Anisotropic_mesh_2::Parameter_rectangle& parameters)
{
  return make_callable_surface_3<K>([height](const typename K::Point_2& p) {
    return typename K::Point_3(p.x(), p.y(), height(p));
  }, parameters);
}

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_CALLABLE_SURFACE_3_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DOMAIN_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DOMAIN_H

#include <CGAL/Anisotropic_mesh_2/Parameter_rectangle.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Throws Invalid_domain_exception unless the rectangle is valid.
inline void check_parameters(const Parameter_rectangle& r)
{
  if(!r.is_valid())
    throw Invalid_domain_exception
      ("the rectangle [" + describe(r.u_min) + ", " + describe(r.u_max) + "] x [" + describe(r.v_min) + ", "
       + describe(r.v_max) + "] of the parameters of the surface is not valid: its extents must be positive and "
       "finite, and it may have poles only where u is periodic and v is not");
}

template <class Surface, class = void>
struct Has_domain : std::false_type {};

template <class Surface>
struct Has_domain<Surface, std::void_t<decltype(std::declval<const Surface&>().domain())> >
  : std::is_convertible<decltype(std::declval<const Surface&>().domain()),
                        Anisotropic_mesh_domain_2<typename Surface::Kernel> >
{};

// The domain of the parameters: that of the surface, if it has one, or the rectangle.
template <class Surface>
Anisotropic_mesh_domain_2<typename Surface::Kernel> surface_domain(const Surface& surface)
{
  if constexpr(Has_domain<Surface>::value)
    return surface.domain();
  else {
    typedef typename Surface::Kernel::Point_2 Point_2;
    const Parameter_rectangle r = surface.parameters();
    const auto corner = [](double u, double v) { return point_at<Point_2>(u, v); };
    Anisotropic_mesh_domain_2<typename Surface::Kernel> domain;
    domain.add_polygon(std::vector<Point_2>{corner(r.u_min, r.v_min), corner(r.u_max, r.v_min),
                                            corner(r.u_max, r.v_max), corner(r.u_min, r.v_max)});
    return domain;
  }
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_SURFACE_DOMAIN_H

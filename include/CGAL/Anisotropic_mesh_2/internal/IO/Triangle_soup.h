// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TRIANGLE_SOUP_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TRIANGLE_SOUP_H

#include <CGAL/Anisotropic_mesh_2/internal/IO/domain_graph.h>
#include <CGAL/Anisotropic_mesh_2/internal/IO/Text_writer.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Field> class Anisotropic_surface_mesh_3;

namespace Anisotropic_mesh_2::internal {

// points of space and triangles between them
struct Triangle_soup
{
  std::vector<std::array<double, 3>>      points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

template <class Tr, class = If_marked<Tr>>
Triangle_soup triangle_soup(const Tr& tr)
{
  const Domain_graph graph = domain_graph(tr);
  Triangle_soup soup;
  for(const auto& p : graph.points)
    soup.points.push_back({p.x(), p.y(), 0});
  soup.triangles = graph.triangles;
  return soup;
}

template <class Field>
Triangle_soup triangle_soup(const Anisotropic_surface_mesh_3<Field>& mesh)
{
  Triangle_soup soup;
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const auto p = mesh.point(v);
    soup.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  for(const auto& f : mesh.faces())
    soup.triangles.push_back({f[0], f[1], f[2]});
  return soup;
}

template <class Mesh>
using If_soup = std::void_t<decltype(triangle_soup(std::declval<const Mesh&>()))>;

// as OFF and PLY files have them
inline void write_elements(Text_writer& out, const Triangle_soup& soup)
{
  for(const auto& p : soup.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const auto& t : soup.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

} // namespace Anisotropic_mesh_2::internal
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TRIANGLE_SOUP_H

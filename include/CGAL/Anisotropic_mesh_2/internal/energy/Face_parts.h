// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_PARTS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_PARTS_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>

#include <array>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A triangular part of a face, whose corners move with those of the face.
struct Face_part
{
  std::array<Barycentric, 3> corner;
  Barycentric                barycentre;

  Face_part(const Barycentric& p, const Barycentric& q, const Barycentric& r) : corner{{p, q, r}}
  {
    for(int i = 0; i < 3; ++i)
      barycentre[i] = (p[i] + q[i] + r[i]) / 3;
  }

  Triangle_of_doubles corners(const Triangle_of_doubles& z) const
  {
    return {point_of(z, corner[0]), point_of(z, corner[1]), point_of(z, corner[2])};
  }
};

// the n^2 similar parts of a face whose edges are divided into n
inline std::vector<Face_part> similar_parts(int n)
{
  const auto at = [n](int i, int j) { return Barycentric{{1 - double(i + j) / n, double(i) / n, double(j) / n}}; };
  std::vector<Face_part> parts;
  for(int i = 0; i < n; ++i)
    for(int j = 0; i + j < n; ++j) {
      parts.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
      if(i + j < n - 1)
        parts.emplace_back(at(i + 1, j + 1), at(i, j + 1), at(i + 1, j));
    }
  return parts;
}

// for n = 1, 2 or 4
inline const std::vector<Face_part>& parts_of_face(int n)
{
  static const std::array<std::vector<Face_part>, 3> parts = {{similar_parts(1), similar_parts(2), similar_parts(4)}};
  return parts[n / 2];
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_FACE_PARTS_H

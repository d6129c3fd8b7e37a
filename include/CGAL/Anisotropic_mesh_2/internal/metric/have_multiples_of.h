// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_HAVE_MULTIPLES_OF_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_HAVE_MULTIPLES_OF_H

#include <algorithm>

namespace CGAL::Anisotropic_mesh_2::internal {

// Whether the tensors of all vertices of a range of handles are multiples of one: then the criterion of the
// triangulation is that of a flat metric, which does not depend on the order of insertion.
template <class Vertices, class Metric_tensor>
bool have_multiples_of(const Vertices& vertices, const Metric_tensor& m)
{
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](const auto& v) { return is_multiple_of(v->metric_tensor(), m); });
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_HAVE_MULTIPLES_OF_H

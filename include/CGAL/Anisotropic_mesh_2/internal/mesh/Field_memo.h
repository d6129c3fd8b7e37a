// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_MEMO_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_MEMO_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/point_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <unordered_map>
#include <utility>

namespace CGAL::Anisotropic_mesh_2::internal {

// The metric field of a mesh, evaluated once at each point that is asked for.
template <class Mesh>
class Field_memo
{
  typedef std::pair<double, double> Key;

public:
  explicit Field_memo(const Mesh& mesh) : m_tensor(mesh.geom_traits().construct_metric_tensor_2_object()) {}

  Symmetric_form operator()(const Vector_of_doubles& x)
  {
    const Key key(x.x, x.y);
    const auto found = m_values.find(key);
    return found != m_values.end() ? found->second : m_values.emplace(key, evaluated(x)).first->second;
  }

  std::size_t number_of_evaluations() const { return m_values.size(); }

private:
  Symmetric_form evaluated(const Vector_of_doubles& x) const
  {
    return Symmetric_form(m_tensor(point_at<typename Mesh::Point>(x.x, x.y)));
  }

  const typename Mesh::Geom_traits::Construct_metric_tensor_2 m_tensor;
  std::unordered_map<Key, Symmetric_form, boost::hash<Key> >  m_values;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_MESH_FIELD_MEMO_H

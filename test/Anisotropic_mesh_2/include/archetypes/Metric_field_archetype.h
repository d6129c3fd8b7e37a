// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_METRIC_FIELD_ARCHETYPE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_METRIC_FIELD_ARCHETYPE_H

#include "Only_copyable.h"

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/number_utils.h>

#include <stdexcept>

// The concept `MetricField_2` on the square [0, 4] x [0, 4]: it must not be
// asked beyond.
template <class K>
class Metric_field_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  static Metric_field_archetype make() { return Metric_field_archetype(Made_on_purpose()); }

  CGAL::Metric_tensor_2<K> operator()(const typename K::Point_2& p) const
  {
    typedef typename K::FT FT;
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    if(!(x >= 0 && x <= 4 && y >= 0 && y <= 4))
      throw std::logic_error("the field is asked outside of its domain");
    return CGAL::Metric_tensor_2<K>::from_sizes(FT(0.5 + x/8), FT(0.7 + y/4), y/8);
  }
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_METRIC_FIELD_ARCHETYPE_H

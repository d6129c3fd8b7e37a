// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SHAPE_SUMMARY_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SHAPE_SUMMARY_H

#include <CGAL/Anisotropic_mesh_2/internal/base/Summary.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// of the edges and the faces of a mesh
struct Shape_summary
{
  Edge_summary edges;
  Summary      qualities, qualities_min3;

  Shape_summary& operator+=(const Shape_summary& s)
  {
    edges += s.edges;
    qualities += s.qualities;
    qualities_min3 += s.qualities_min3;
    return *this;
  }

  template <class Statistics>
  void write_to(Statistics& statistics) const
  {
    statistics.edge_length_mean = edges.lengths.mean();
    statistics.edge_length_min = edges.lengths.least;
    statistics.edge_length_max = edges.lengths.largest;
    statistics.edge_length_unit_share = edges.unit_share();
    statistics.quality_mean = qualities.mean();
    statistics.quality_min = qualities.least;
    statistics.quality_min3_mean = qualities_min3.mean();
    statistics.quality_min3_min = qualities_min3.least;
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_SHAPE_SUMMARY_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of domains share.

#ifndef ANISOTROPIC_MESH_2_TEST_DOMAIN_TEST_H
#define ANISOTROPIC_MESH_2_TEST_DOMAIN_TEST_H

#include "check.h"

#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>
#include <limits>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel       K;
typedef K::Point_2                                                Point;
typedef std::vector<Point>                                        Points;
typedef CGAL::Anisotropic_mesh_domain_2<K>                        Domain;
typedef CGAL::Anisotropic_mesh_2::Curve_piece_2<K>                                    Piece;
typedef CGAL::Anisotropic_mesh_2::Domain_rule                     Rule;
typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<K> Graph;
typedef CGAL::Anisotropic_mesh_2::internal::Domain_preparation<K> Preparation;
typedef CGAL::Anisotropic_mesh_2::internal::Piece_role            Role;
typedef CGAL::Anisotropic_mesh_2::Invalid_domain_exception                            Bad;

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

inline Points square(double s, double x = 0, double y = 0)
{
  return Points{Point(x, y), Point(x + s, y), Point(x + s, y + s), Point(x, y + s)};
}

inline Domain polygon(const Points& points)
{
  Domain domain;
  domain.add_polygon(points);
  return domain;
}

inline bool is_valid(const Domain& domain)
{
  try {
    domain.validate();
    return true;
  } catch(const Bad& e) {
    std::cerr << "unexpected: " << e.what() << std::endl;
    return false;
  }
}

inline int count(const Domain& domain, Role role)
{
  const Preparation preparation(domain.pieces(), domain.rule(), domain.holes());
  int n = 0;
  for(const auto& piece : preparation.pieces())
    n += piece.role == role;
  return n;
}

#endif // ANISOTROPIC_MESH_2_TEST_DOMAIN_TEST_H

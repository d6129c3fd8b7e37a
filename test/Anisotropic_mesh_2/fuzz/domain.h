// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A graph that was read, as the domain of a mesh.

#ifndef ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H
#define ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H

#include "reader.h"

#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>  Graph;
typedef CGAL::Anisotropic_mesh_domain_2<Kernel>                         Domain;
typedef CGAL::Anisotropic_mesh_2::Domain_rule                           Domain_rule;

// the domain that the graph bounds, or nothing if it bounds none
inline std::optional<Domain> valid_domain(const Graph& graph, Domain_rule rule)
{
  try {
    Domain domain(graph);
    domain.set_rule(rule);
    domain.validate();
    return domain;
  }
  catch(const CGAL::Anisotropic_mesh_2::Invalid_domain_exception& e) {
    require_readable(e.what());
    const std::string what = e.what();
    require(what.find("inf)") == std::string::npos && what.find("nan") == std::string::npos,
            "places in a complaint about finite points: " + what);
    return std::nullopt;
  }
}

// the area to the left of boundary segments
inline double area(const Domain& domain)
{
  const CGAL::Anisotropic_mesh_2::internal::Domain_preparation<Kernel>
    prepared(domain.pieces(), domain.rule(), domain.holes());
  double doubled = 0;
  for(const auto& piece : prepared.pieces())
    if(piece.role == CGAL::Anisotropic_mesh_2::internal::Piece_role::BOUNDARY) {
      const auto &p = piece.curve.source(), &q = piece.curve.target();
      doubled += p.x()*q.y() - p.y()*q.x();
    }
  return doubled / 2;
}

inline double area(const Graph& mesh)
{
  double sum = 0;
  for(const auto& t : mesh.triangles)
    sum += CGAL::area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  return sum;
}

// the mesh of some large triangles, written and read again
inline Graph coarse_mesh(const Domain& domain, double size)
{
  namespace parameters = CGAL::Anisotropic_mesh_2::parameters;
  const CGAL::Constant_metric_field_2<Kernel> field(CGAL::Metric_tensor_2<Kernel>::from_size(size));
  const std::string file = Input_files::directory() / "coarse.mesh";
  CGAL::IO::write_MEDIT(file, CGAL::make_anisotropic_mesh_2(domain, field, parameters::keep_boundary_points(true)));
  return CGAL::IO::read_MEDIT<Kernel>(file);
}

// Meshes the domain if it is small enough to be fast, and its size one that a
// mesher has to do with: the mesh covers the domain, and is a domain itself.
inline void mesh_coarsely(const Domain& domain)
{
  CGAL::Bbox_2 box;
  for(const auto& piece : domain.pieces())
    box += piece.curve.source().bbox() + piece.curve.target().bbox();
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  const double farthest = (std::max)({-box.xmin(), box.xmax(), -box.ymin(), box.ymax()});
  if(domain.number_of_pieces() > 40 || !(size > 1e-9 && farthest < 1e9))
    return;
  const Graph mesh = coarse_mesh(domain, size);
  require(std::abs(area(mesh) - area(domain)) <= 1e-9 * farthest*farthest, "a mesh of the area of the domain");
  require(valid_domain(mesh, Domain_rule::EVEN_ODD).has_value(), "a mesh that is a domain");
}

// all that happens to a file that was read
inline void use_as_domain(const Graph& graph, Domain_rule rule)
{
  if(const std::optional<Domain> domain = valid_domain(graph, rule))
    mesh_coarsely(*domain);
}

#endif // ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H

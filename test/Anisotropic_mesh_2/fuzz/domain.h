// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

// A graph that was read, as the domain of a mesh.

#ifndef ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H
#define ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H

#include "reader.h"

#include <CGAL/Anisotropic_mesh_2/Domain_rule.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Invalid_domain_exception.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <algorithm>
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
  catch(const CGAL::Invalid_domain_exception& e) {
    require_readable(e.what());
    const std::string what = e.what();
    require(what.find("inf)") == std::string::npos && what.find("nan") == std::string::npos,
            "places in a complaint about finite points: " + what);
    return std::nullopt;
  }
}

// A mesh of some large triangles, if the domain is small enough for a fast one
// and its size one that a mesher has to do with. It gives the regions their faces.
inline void mesh_coarsely(const Domain& domain)
{
  CGAL::Bbox_2 box;
  for(const auto& piece : domain.pieces())
    box += piece.curve.source().bbox() + piece.curve.target().bbox();
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  const double farthest = (std::max)({-box.xmin(), box.xmax(), -box.ymin(), box.ymax()});
  if(domain.number_of_pieces() > 40 || !(size > 1e-9 && farthest < 1e9))
    return;
  const CGAL::Constant_metric_field_2<Kernel> field(CGAL::Metric_tensor_2<Kernel>::from_size(size));
  const auto mesh = CGAL::make_anisotropic_mesh_2(domain, field,
                                                  CGAL::Anisotropic_mesh_2::parameters::keep_boundary_points(true));
  require(mesh.number_of_faces_in_domain() > 0, "a mesh of a valid domain");
}

// all that happens to a file that was read
inline void use_as_domain(const Graph& graph, Domain_rule rule)
{
  if(const std::optional<Domain> domain = valid_domain(graph, rule))
    mesh_coarsely(*domain);
}

#endif // ANISOTROPIC_MESH_2_TEST_FUZZ_DOMAIN_H

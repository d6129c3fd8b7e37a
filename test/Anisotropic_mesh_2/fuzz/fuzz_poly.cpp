// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// .poly files, with the .node file of the same name behind a line "---".

#include "domain.h"
#include "../include/equal_graphs.h"

#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Input_files files(data, size, {"input.poly", "input.node"});
  const auto graph = read_or_refuse(files, [&] { return CGAL::IO::read_POLY<Kernel>(files[0]); });
  if(!graph)
    return 0;
  const std::string again = Input_files::directory() / "again.poly";
  CGAL::IO::write_POLY(again, *graph);
  require(are_equal(*graph, CGAL::IO::read_POLY<Kernel>(again)), "the same graph, written and read again");
  use_as_domain(*graph, Domain_rule::FLOOD_FROM_SEEDS);
  return 0;
}

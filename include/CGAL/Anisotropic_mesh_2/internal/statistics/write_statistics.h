// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_WRITE_STATISTICS_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_WRITE_STATISTICS_H

#include <ostream>

namespace CGAL::Anisotropic_mesh_2::internal {

// one line per value that `statistics.for_each()` visits
template <class Statistics>
std::ostream& write_statistics(std::ostream& os, const Statistics& statistics)
{
  statistics.for_each([&](const char* name, const auto& value) { os << name << ": " << value << '\n'; });
  return os;
}

// a flat JSON object
template <class Statistics>
void write_statistics_as_json(std::ostream& os, const Statistics& statistics)
{
  const char* separator = "{\n  ";
  statistics.for_each([&](const char* name, const auto& value) {
    os << separator << '"' << name << "\": " << value;
    separator = ",\n  ";
  });
  os << "\n}\n";
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_STATISTICS_WRITE_STATISTICS_H

// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_WRITE_FIGURES_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_WRITE_FIGURES_H

#include <ostream>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// one line per figure that `statistics.for_each()` visits
template <class Statistics>
std::ostream& write_figures(std::ostream& os, const Statistics& statistics)
{
  statistics.for_each([&](const char* name, const auto& value) { os << name << ": " << value << '\n'; });
  return os;
}

// a flat JSON object
template <class Statistics>
void write_figures_as_json(std::ostream& os, const Statistics& statistics)
{
  const char* separator = "{\n  ";
  statistics.for_each([&](const char* name, const auto& value) {
    os << separator << '"' << name << "\": " << value;
    separator = ",\n  ";
  });
  os << "\n}\n";
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_WRITE_FIGURES_H

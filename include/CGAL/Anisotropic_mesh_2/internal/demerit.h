// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_DEMERIT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_DEMERIT_H

#include <limits>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// What a face of quality q adds to the demerit of a patch. Of good faces it is
// a multiple of what their qualities lack of 1, of bad ones much more: so neither
// the mean nor the least quality is bought too dearly with the other.
inline double demerit_of_quality(double q)
{
  return q > 0 ? 1 / ((q*q*q) * (q*q*q)) - 1 : std::numeric_limits<double>::infinity();
}

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_DEMERIT_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_REFUSE_METRIC_TENSOR_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_REFUSE_METRIC_TENSOR_H

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/exceptions.h>

#include <CGAL/number_utils.h>

#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

inline std::string text_of_part(const char* words) { return words; }

template <class Number>
std::string text_of_part(const Number& x) { return describe(CGAL::to_double(x)); }

inline bool is_part_finite(const char*) { return true; }

template <class Number>
bool is_part_finite(const Number& x) { return CGAL::is_finite(x); }

// Throws the complaint that begins with the given words and numbers, and ends by what is wrong with these.
template <class... Parts>
[[noreturn]] void refuse_metric_tensor(const Parts&... parts)
{
  throw Invalid_metric_tensor_exception((text_of_part(parts) + ...)
    + ((is_part_finite(parts) && ...) ? " is not positive definite" : " is not finite"));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_REFUSE_METRIC_TENSOR_H

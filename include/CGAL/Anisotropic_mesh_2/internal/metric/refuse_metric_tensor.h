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

#include <cmath>
#include <initializer_list>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// a number with the words before it
struct Part_of_complaint
{
  template <class Number>
  Part_of_complaint(const char* words, const Number& x) : words(words), number(CGAL::to_double(x)) {}

  const char* words;
  double      number;
};

// Throws the complaint that begins with these words and numbers, and ends by what is wrong with the numbers.
[[noreturn]] inline void refuse_metric_tensor(std::initializer_list<Part_of_complaint> parts)
{
  std::string text;
  bool are_finite = true;
  for(const Part_of_complaint& part : parts) {
    text += part.words + describe(part.number);
    are_finite = are_finite && std::isfinite(part.number);
  }
  throw Invalid_metric_tensor_exception(text + (are_finite ? " is not positive definite" : " is not finite"));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_REFUSE_METRIC_TENSOR_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_FORMULA_METRIC_FIELD_H
#define ANISOTROPIC_MESH_2_PROGRAM_FORMULA_METRIC_FIELD_H

#include "Metric_field.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

// A formula in x and y, and the option that gave it.
struct Formula
{
  std::string option;
  std::string text;
};

// thrown for a formula that does not parse; the message names option and position
class Formula_error
  : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// A metric given by one to three formulas. Copies are cheap and share their
// parsers; evaluation is safe from any number of threads.
class Formula_metric_field
{
public:
  static constexpr std::size_t maximum_number_of_formulas = 3;
  typedef std::array<double, maximum_number_of_formulas> Values;

  // throws Formula_error
  static Formula_metric_field from_sizes(const Formula& h1, const Formula& h2, const Formula& theta);
  static Formula_metric_field from_entries(const Formula& m11, const Formula& m12, const Formula& m22);
  static Formula_metric_field from_size(const Formula& h);

  // throws CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception
  Metric_tensor_2 operator()(const Point_2& p) const;

private:
  typedef Metric_tensor_2 (*Construct_tensor)(const Values&);
  class Parsers;
  class Pool_of_parsers;

  Formula_metric_field(const std::vector<Formula>& formulas, Construct_tensor tensor);

  std::shared_ptr<Pool_of_parsers> m_pool;
  Construct_tensor                 m_tensor;
};

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_FORMULA_METRIC_FIELD_H

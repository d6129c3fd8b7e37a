// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_RANDOM_NUMBERS_H
#define ANISOTROPIC_MESH_2_TEST_RANDOM_NUMBERS_H

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

// Random numbers that are the same with every standard library.
class Random_numbers
{
public:
  explicit Random_numbers(unsigned seed) : m_engine(seed) {}

  // in [0, n)
  int integer(int n) { return int(m_engine() % unsigned(n)); }

  // in [low, high), a multiple of (high - low) / 2^32
  double real(double low, double high)
  {
    return low + (high - low) * std::ldexp(double(m_engine()), -32);
  }

  // 10^x with x in [low, high)
  double power_of_ten(double low, double high) { return std::pow(10., real(low, high)); }

  template <class Range>
  void shuffle(Range& range)
  {
    for(std::size_t i = range.size(); i > 1; --i)
      std::swap(range[i - 1], range[std::size_t(integer(int(i)))]);
  }

private:
  std::mt19937 m_engine;
};

#endif // ANISOTROPIC_MESH_2_TEST_RANDOM_NUMBERS_H

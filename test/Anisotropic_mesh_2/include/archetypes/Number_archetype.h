// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_NUMBER_ARCHETYPE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_NUMBER_ARCHETYPE_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/double.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <limits>
#include <type_traits>
#include <utility>

// The `FT` of a kernel and of `RiemannianMetricTraits_2`: a field number type
// that mixes with `int`, but with no other type. A `double` is converted by
// name only, both ways.
class Number_archetype
{
  template <class T, class Wanted>
  using If = std::enable_if_t<std::is_same<T, Wanted>::value, int>;

public:
  Number_archetype() : m_value(std::numeric_limits<double>::quiet_NaN()) {}

  // templates, because else a double would come in by way of int
  template <class Int, If<Int, int> = 0>
  Number_archetype(Int i) : m_value(i) {}
  template <class Double, If<Double, double> = 0>
  explicit Number_archetype(Double d) : m_value(d) {}

  Number_archetype operator-() const { return Number_archetype(-m_value); }

  Number_archetype& operator+=(const Number_archetype& n) { m_value += n.m_value; return *this; }
  Number_archetype& operator-=(const Number_archetype& n) { m_value -= n.m_value; return *this; }
  Number_archetype& operator*=(const Number_archetype& n) { m_value *= n.m_value; return *this; }
  Number_archetype& operator/=(const Number_archetype& n) { m_value /= n.m_value; return *this; }

  friend Number_archetype operator+(Number_archetype a, const Number_archetype& b) { return a += b; }
  friend Number_archetype operator-(Number_archetype a, const Number_archetype& b) { return a -= b; }
  friend Number_archetype operator*(Number_archetype a, const Number_archetype& b) { return a *= b; }
  friend Number_archetype operator/(Number_archetype a, const Number_archetype& b) { return a /= b; }

  friend bool operator==(const Number_archetype& a, const Number_archetype& b) { return a.m_value == b.m_value; }
  friend bool operator!=(const Number_archetype& a, const Number_archetype& b) { return a.m_value != b.m_value; }
  friend bool operator<(const Number_archetype& a, const Number_archetype& b) { return a.m_value < b.m_value; }
  friend bool operator>(const Number_archetype& a, const Number_archetype& b) { return a.m_value > b.m_value; }
  friend bool operator<=(const Number_archetype& a, const Number_archetype& b) { return a.m_value <= b.m_value; }
  friend bool operator>=(const Number_archetype& a, const Number_archetype& b) { return a.m_value >= b.m_value; }

private:
  friend class CGAL::Real_embeddable_traits<Number_archetype>;

  double m_value;
};

namespace CGAL {

template <>
class Algebraic_structure_traits<Number_archetype>
  : public Algebraic_structure_traits_base<Number_archetype, Field_tag>
{
public:
  typedef Tag_false Is_exact;
  typedef Tag_true  Is_numerical_sensitive;
};

template <>
class Real_embeddable_traits<Number_archetype>
  : public INTERN_RET::Real_embeddable_traits_base<Number_archetype, Tag_true>
{
public:
  struct To_double
  {
    typedef double result_type;
    double operator()(const Number_archetype& n) const { return n.m_value; }
  };
  struct To_interval
  {
    typedef std::pair<double, double> result_type;
    result_type operator()(const Number_archetype& n) const { return result_type(n.m_value, n.m_value); }
  };
  struct Is_finite
  {
    typedef bool result_type;
    bool operator()(const Number_archetype& n) const { return CGAL::is_finite(n.m_value); }
  };
};

} // namespace CGAL

static_assert(std::is_convertible<int, Number_archetype>::value, "");
static_assert(std::is_constructible<Number_archetype, double>::value, "");
static_assert(!std::is_convertible<double, Number_archetype>::value, "");
static_assert(!std::is_convertible<Number_archetype, double>::value, "");

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_NUMBER_ARCHETYPE_H

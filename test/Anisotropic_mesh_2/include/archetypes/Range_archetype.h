// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RANGE_ARCHETYPE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RANGE_ARCHETYPE_H

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// An input iterator: it goes once, forward, and gives values.
template <class T>
class Input_iterator_archetype
{
  struct Holder // of the value before an increment
  {
    T value;
    T operator*() const { return value; }
  };

public:
  typedef std::input_iterator_tag  iterator_category;
  typedef T                        value_type;
  typedef T                        reference;
  typedef const T*                 pointer;
  typedef std::ptrdiff_t           difference_type;

  T operator*() const { return *m_place; }
  pointer operator->() const { return m_place; }
  Input_iterator_archetype& operator++() { ++m_place; return *this; }
  Holder operator++(int) { return Holder{*m_place++}; }

  friend bool operator==(const Input_iterator_archetype& i, const Input_iterator_archetype& j)
  { return i.m_place == j.m_place; }
  friend bool operator!=(const Input_iterator_archetype& i, const Input_iterator_archetype& j)
  { return i.m_place != j.m_place; }

private:
  template <class> friend class Range_archetype;
  explicit Input_iterator_archetype(const T* place) : m_place(place) {}

  const T* m_place;
};

// A range of points or curve pieces: it has a beginning and an end.
template <class T>
class Range_archetype
{
public:
  typedef Input_iterator_archetype<T> const_iterator;

  static Range_archetype make(std::vector<T> values) { return Range_archetype(std::move(values)); }
  Range_archetype(const Range_archetype&) = delete;
  Range_archetype& operator=(const Range_archetype&) = delete;

  const_iterator begin() const { return const_iterator(m_values.data()); }
  const_iterator end() const { return const_iterator(m_values.data() + m_values.size()); }

private:
  explicit Range_archetype(std::vector<T> values) : m_values(std::move(values)) {}

  const std::vector<T> m_values;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RANGE_ARCHETYPE_H

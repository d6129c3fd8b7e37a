// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_PARALLEL_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_PARALLEL_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// Loops that give the same bits with any number of threads: the work is cut into
// pieces that depend on its size only, and what they sum up is added in their order.

template <class ConcurrencyTag>
constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;

// Calls f(i) for the tasks i in [0, n), in any order and at the same time with
// `Parallel_tag`. Of several exceptions that of the first task is thrown.
template <class ConcurrencyTag, class Function>
void for_each_task(std::size_t n, const Function& f)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel<ConcurrencyTag>, "Parallel_tag is enabled but TBB is unavailable.");
#else
  if constexpr(is_parallel<ConcurrencyTag>) {
    std::vector<std::exception_ptr> errors(n);
    tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) {
      try {
        f(i);
      }
      catch(...) {
        errors[i] = std::current_exception();
      }
    });
    for(const std::exception_ptr& e : errors)
      if(e)
        std::rethrow_exception(e);
    return;
  }
#endif
  for(std::size_t i = 0; i < n; ++i)
    f(i);
}

constexpr std::size_t size_of_chunk = 2048; // of cheap tasks
inline std::size_t number_of_chunks(std::size_t n, std::size_t size = size_of_chunk) { return (n + size - 1) / size; }

// Calls f(chunk, begin, end) for the chunks of [0, n).
template <class ConcurrencyTag, class Function>
void for_each_chunk(std::size_t n, const Function& f, std::size_t size = size_of_chunk)
{
  for_each_task<ConcurrencyTag>(number_of_chunks(n, size), [&](std::size_t chunk) {
    f(chunk, chunk * size, (std::min)(n, (chunk + 1) * size));
  });
}

// Calls f(i) for i in [0, n).
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t n, const Function& f)
{
  for_each_chunk<ConcurrencyTag>(n, [&](std::size_t, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      f(i);
  });
}

// What f(i, sum) has added to sums for i in [0, n).
template <class ConcurrencyTag, class Sum, class Function>
Sum sum_of_chunks(std::size_t n, const Function& f)
{
  std::vector<Sum> sums(number_of_chunks(n), Sum());
  for_each_chunk<ConcurrencyTag>(n, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      f(i, sums[chunk]);
  });
  Sum sum = Sum();
  for(const Sum& s : sums)
    sum += s;
  return sum;
}

// The sum of f(i) for i in [0, n).
template <class ConcurrencyTag, class Function>
double sum_over(std::size_t n, const Function& f)
{
  return sum_of_chunks<ConcurrencyTag, double>(n, [&](std::size_t i, double& sum) { sum += f(i); });
}

// What chunks have collected, in their order.
template <class Item>
std::vector<Item> joined(std::vector<std::vector<Item> > of_chunk)
{
  std::size_t size = 0;
  for(const std::vector<Item>& items : of_chunk)
    size += items.size();
  std::vector<Item> result;
  result.reserve(size);
  for(std::vector<Item>& items : of_chunk)
    result.insert(result.end(), std::make_move_iterator(items.begin()), std::make_move_iterator(items.end()));
  return result;
}

// What f(i, selected) has appended for i in [0, n), in their order.
template <class ConcurrencyTag, class Item, class Function>
std::vector<Item> selected_of_chunks(std::size_t n, const Function& f)
{
  std::vector<std::vector<Item> > of_chunk(number_of_chunks(n));
  for_each_chunk<ConcurrencyTag>(n, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      f(i, of_chunk[chunk]);
  });
  return joined(std::move(of_chunk));
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_PARALLEL_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Side_of_metric_circle_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Side_of_metric_circle_estimate.h>

#include <CGAL/Filtered_predicate.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_arithmetic.h>

#include <type_traits>

namespace CGAL::Anisotropic_mesh_2::internal {

// Converts what the kernel's converter converts, and metric tensors.
template <class Kernel_converter, class Source, class Target>
struct Metric_tensor_converter
  : public Kernel_converter
{
  using Kernel_converter::operator();

  Metric_tensor_2<Target> operator()(const Metric_tensor_2<Source>& m) const
  {
    return Metric_tensor_2<Target>(m, static_cast<const Kernel_converter&>(*this));
  }
};

// Where a kernel with filtered predicates decides exactly. Kernels with double
// coordinates have an exact kernel for predicates with ring operations only.
template <class K, bool has_doubles = std::is_floating_point<typename K::FT>::value>
struct Exact_side_of
{
  typedef typename K::Exact_kernel       Kernel;
  typedef typename K::C2E                Converter;
};

template <class K>
struct Exact_side_of<K, true>
{
  typedef typename K::Exact_kernel_rt    Kernel;
  typedef typename K::C2E_rt             Converter;
};

// The cavity criterion for kernels with filtered predicates: an estimate first
// if the coordinates are doubles, then intervals, then exact numbers.
template <class K>
class Filtered_side_of_metric_circle_2
{
  typedef typename K::Approximate_kernel      AK;
  typedef typename Exact_side_of<K>::Kernel   EK;
  typedef Filtered_predicate<Side_of_metric_circle_2<EK>, Side_of_metric_circle_2<AK>,
                             Metric_tensor_converter<typename Exact_side_of<K>::Converter, K, EK>,
                             Metric_tensor_converter<typename K::C2F, K, AK> >  Intervals_then_exact;

  typedef typename K::Point_2   Point_2;
  typedef Metric_tensor_2<K>    Tensor;

  static constexpr bool has_doubles = std::is_floating_point<typename K::FT>::value;

public:
  typedef Oriented_side result_type;

  result_type operator()(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                         const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
  {
    if constexpr(has_doubles) {
      const Uncertain<Oriented_side> side = by_doubles(a, b, c, p, ma, mb, mc, mp);
      if(is_certain(side))
        return get_certain(side);
    }
    return Intervals_then_exact()(a, b, c, p, ma, mb, mc, mp);
  }

  // the stages of the filter, one by one

  Uncertain<Oriented_side> by_doubles(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                      const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
  {
    static_assert(has_doubles, "the coordinates are not doubles");
    return estimate_side_of_metric_circle(a, b, c, p, ma, mb, mc, mp);
  }

  Uncertain<Oriented_side> by_intervals(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                        const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
  {
    const typename Intervals_then_exact::To_approximate_converter convert{};
    const Protect_FPU_rounding<true> protection;
    try {
      return typename Intervals_then_exact::Approximate_predicate()(
               convert(a), convert(b), convert(c), convert(p), convert(ma), convert(mb), convert(mc), convert(mp));
    }
    catch(const Uncertain_conversion_exception&) {
      return Uncertain<Oriented_side>::indeterminate();
    }
  }

  Oriented_side exactly(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                        const Tensor& ma, const Tensor& mb, const Tensor& mc, const Tensor& mp) const
  {
    const typename Intervals_then_exact::To_exact_converter convert{};
    return typename Intervals_then_exact::Exact_predicate()(
             convert(a), convert(b), convert(c), convert(p), convert(ma), convert(mb), convert(mc), convert(mp));
  }
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_FILTERED_SIDE_OF_METRIC_CIRCLE_2_H

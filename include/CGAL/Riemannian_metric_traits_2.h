// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RIEMANNIAN_METRIC_TRAITS_2_H
#define CGAL_RIEMANNIAN_METRIC_TRAITS_2_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Filtered_side_of_metric_circle_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Side_of_metric_circle_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/metric_at.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Segment_length.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include <functional>
#include <memory>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// The geometry of the plane under a metric field: the functors of a \cgal
/// kernel together with those that measure and decide in the metric.
///
/// The metric field is state of the traits. Copies of the traits share it, and
/// the functors that evaluate the field are valid as long as one copy lives.
///
/// The cavity criterion is decided exactly whenever the predicates of `K` are
/// exact: with `Exact_predicates_inexact_constructions_kernel` by an estimate
/// in `double`, interval arithmetic and exact arithmetic in this order, with
/// `Exact_predicates_exact_constructions_kernel` by intervals and exact
/// arithmetic, with an exact kernel in its own arithmetic. All of them give the
/// same answer, also for ties. With `Simple_cartesian<double>` it is decided
/// in rounded arithmetic.
///
/// \tparam K a model of `Kernel`.
/// \tparam MetricField_ a model of `MetricField_2`. The default holds any function
/// object from `K::Point_2` to `Metric_tensor_2<K>`, so that meshes under all fields are of one type.
///
/// \cgalModels{RiemannianMetricTraits_2}
template <class K, class MetricField_ = std::function<Metric_tensor_2<K>(const typename K::Point_2&)> >
class Riemannian_metric_traits_2
  : public K
{
  template <class K2, bool is_filtered>
  struct Select_side { typedef Anisotropic_mesh_2::internal::Side_of_metric_circle_2<K2> type; };
  template <class K2>
  struct Select_side<K2, true>
  { typedef Anisotropic_mesh_2::internal::Filtered_side_of_metric_circle_2<K2> type; };

public:
  /// \name Types
  /// @{
  typedef K                              Kernel;          ///< the kernel
  typedef MetricField_                   Metric_field;    ///< the type of the field
  typedef typename K::FT                 FT;              ///< the number type
  typedef typename K::Point_2            Point_2;         ///< a point
  typedef CGAL::Metric_tensor_2<K>       Metric_tensor_2; ///< a tensor

  /// whether orientation and the cavity criterion are decided without rounding errors.
  static constexpr bool has_exact_predicates
    = K::Has_filtered_predicates || Algebraic_structure_traits<FT>::Is_exact::value;

  /// the cavity criterion, `operator()(a, b, c, p, ma, mb, mc, mp)`: positive if
  /// \f$ \alpha_{M(p)} \alpha_{M(a)} \alpha_{M(b)} \alpha_{M(c)} < 1 \f$ for the
  /// counterclockwise triangle `abc`, that is, if `p` conflicts with it
  /// (section 3.1 of \cgalCite{dw-acvt-05}).
  ///
  /// For kernels with filtered predicates the stages of the filter are members
  /// with the same arguments, for experiments: `by_doubles()` (if the coordinates
  /// are doubles) and `by_intervals()` return an `Uncertain<Oriented_side>`,
  /// `exactly()` an `Oriented_side`.
#ifdef DOXYGEN_RUNNING
  typedef unspecified_type Side_of_metric_circle_2;
#else
  typedef typename Select_side<K, K::Has_filtered_predicates>::type  Side_of_metric_circle_2;
#endif

  /// evaluates the field.
  class Construct_metric_tensor_2
  {
  public:
    typedef CGAL::Metric_tensor_2<K> result_type; ///< a tensor

    /// the functor of `field`, which is not copied.
    explicit Construct_metric_tensor_2(const Metric_field* field) : m_field(field) {}

    /// returns the value of the field at `p`.
    /// \pre the traits hold a field.
    /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception naming `p`, if the field throws it.
    result_type operator()(const Point_2& p) const
    {
      CGAL_precondition_msg(m_field != nullptr, "the traits hold no metric field");
      return Anisotropic_mesh_2::internal::metric_at(*m_field, p);
    }

  private:
    const Metric_field* m_field;
  };

  /// the Riemannian length of the segment from `p` to `q`, by adaptive
  /// quadrature with a relative error of about 10<sup>-6</sup> where the field is smooth
  /// (section 2.2 of \cgalCite{dw-acvt-05}).
  class Compute_riemannian_length_2
  {
  public:
    typedef double result_type; ///< a length

    /// the functor that takes tensors from `tensor`.
    explicit Compute_riemannian_length_2(const Construct_metric_tensor_2& tensor) : m_tensor(tensor) {}

    /// returns the length.
    /// \throw Anisotropic_mesh_2::Invalid_metric_tensor_exception if the field fails at a point of the segment.
    double operator()(const Point_2& p, const Point_2& q) const
    {
      return Anisotropic_mesh_2::internal::segment_length(p, q, m_tensor);
    }

  private:
    Construct_metric_tensor_2 m_tensor;
  };

  /// @}

  /// \name Creation
  /// @{

  /// traits without a field, which are only usable as the target of an assignment.
  Riemannian_metric_traits_2() {}

  /// traits that hold a copy of `field`, which their copies share.
  explicit Riemannian_metric_traits_2(const Metric_field& field, const K& kernel = K())
    : K(kernel), m_field(std::make_shared<const Metric_field>(field))
  {}
  /// @}

  /// \name Access
  /// @{

  /// the metric field.
  /// \pre the traits were built from a field.
  const Metric_field& metric_field() const
  {
    CGAL_precondition(m_field != nullptr);
    return *m_field;
  }

  /// returns the functor that evaluates the field.
  Construct_metric_tensor_2 construct_metric_tensor_2_object() const
  { return Construct_metric_tensor_2(m_field.get()); }

  /// returns the cavity criterion.
  Side_of_metric_circle_2 side_of_metric_circle_2_object() const
  { return Side_of_metric_circle_2(); }

  /// returns the functor of lengths.
  Compute_riemannian_length_2 compute_riemannian_length_2_object() const
  { return Compute_riemannian_length_2(construct_metric_tensor_2_object()); }
  /// @}

private:
  std::shared_ptr<const Metric_field> m_field;
};

/// \cond SKIP_IN_MANUAL
// Point location is as fast as in triangulations over the kernel itself.
template <class K, class MetricField_>
struct Triangulation_structural_filtering_traits<Riemannian_metric_traits_2<K, MetricField_> >
  : public Triangulation_structural_filtering_traits<K>
{};
/// \endcond

} // namespace CGAL

#endif // CGAL_RIEMANNIAN_METRIC_TRAITS_2_H

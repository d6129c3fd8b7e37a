// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RIEMANNIAN_METRIC_TRAITS_ARCHETYPE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RIEMANNIAN_METRIC_TRAITS_ARCHETYPE_H

#include "Metric_field_archetype.h"
#include "Number_archetype.h"
#include "Only_copyable.h"

#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <memory>
#include <stdexcept>

// A point: it is built from two numbers, and gives them back.
class Point_archetype
{
public:
  Point_archetype() {}
  explicit Point_archetype(const Number_archetype& x, const Number_archetype& y) : m_x(x), m_y(y) {}

  Number_archetype x() const { return m_x; }
  Number_archetype y() const { return m_y; }

private:
  Number_archetype m_x, m_y;
};

inline Point_archetype point_archetype(double x, double y)
{
  return Point_archetype(Number_archetype(x), Number_archetype(y));
}

// The types that `RiemannianMetricTraits_2::Kernel` has to have; not a kernel.
struct Kernel_archetype
{
  typedef Number_archetype FT;
  typedef Point_archetype  Point_2;
  struct Vector_2;
};

// The concept `RiemannianMetricTraits_2`.
//
// \tparam Backend a kernel of CGAL that decides, so that the archetype has exact
// predicates if this has
//
// Traits that are default constructed hold no field, and complain when they are
// asked for anything.
template <class Backend>
class Riemannian_metric_traits_archetype
{
  typedef CGAL::Constant_metric_field_2<Backend>                        Any_field;
  typedef CGAL::Riemannian_metric_traits_2<Backend, Any_field>          Backend_traits;
  typedef CGAL::Metric_tensor_2<Backend>                                Backend_tensor;
  typedef Metric_field_archetype<Kernel_archetype>                      Field;

  // A function object: only traits that hold a field make one.
  class Functor
    : public Only_copyable
  {
  public:
    explicit Functor(const Riemannian_metric_traits_archetype& traits)
      : Only_copyable(Made_on_purpose()), m_field(traits.m_field.get())
    {
      if(m_field == nullptr)
        throw std::logic_error("default constructed traits are used");
    }

  protected:
    static double x(const Point_archetype& p) { return CGAL::to_double(p.x()); }
    static double y(const Point_archetype& p) { return CGAL::to_double(p.y()); }
    static typename Backend::Point_2 point(const Point_archetype& p)
    {
      return typename Backend::Point_2(x(p), y(p));
    }

    const Field* m_field;
  };

public:
  typedef Kernel_archetype                              Kernel;
  typedef Number_archetype                              FT;
  typedef Point_archetype                               Point_2;
  typedef CGAL::Metric_tensor_2<Kernel_archetype>       Metric_tensor_2;

  static constexpr bool has_exact_predicates = Backend_traits::has_exact_predicates;

  // ---------------------------------------------------------------- of the metric

  class Side_of_metric_circle_2
    : public Functor
  {
  public:
    using Functor::Functor;

    CGAL::Oriented_side operator()(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& p,
                                   const Metric_tensor_2& ma, const Metric_tensor_2& mb,
                                   const Metric_tensor_2& mc, const Metric_tensor_2& mp) const
    {
      return Backend_traits(Any_field()).side_of_metric_circle_2_object()
               (this->point(a), this->point(b), this->point(c), this->point(p),
                tensor(ma), tensor(mb), tensor(mc), tensor(mp));
    }

  private:
    static Backend_tensor tensor(const Metric_tensor_2& m)
    {
      return Backend_tensor(m, [](const FT& entry) { return CGAL::to_double(entry); });
    }
  };

  class Construct_metric_tensor_2
    : public Functor
  {
  public:
    using Functor::Functor;

    Metric_tensor_2 operator()(const Point_2& p) const { return (*this->m_field)(p); }
  };

  class Compute_riemannian_length_2
    : public Functor
  {
  public:
    using Functor::Functor;

    double operator()(const Point_2& p, const Point_2& q) const
    {
      const Point_2 middle((p.x() + q.x()) / 2, (p.y() + q.y()) / 2);
      const FT square = (*this->m_field)(middle).squared_length(q.x() - p.x(), q.y() - p.y());
      return std::sqrt(CGAL::to_double(square));
    }
  };

  Side_of_metric_circle_2 side_of_metric_circle_2_object() const
  { return Side_of_metric_circle_2(*this); }
  Construct_metric_tensor_2 construct_metric_tensor_2_object() const
  { return Construct_metric_tensor_2(*this); }
  Compute_riemannian_length_2 compute_riemannian_length_2_object() const
  { return Compute_riemannian_length_2(*this); }

  // ---------------------------------------------------------------- of `TriangulationTraits_2`

  class Segment_2
  {
    friend class Riemannian_metric_traits_archetype;
    Segment_2() {}
  };
  class Triangle_2
  {
    friend class Riemannian_metric_traits_archetype;
    Triangle_2() {}
  };

  class Construct_point_2
    : public Functor
  {
  public:
    using Functor::Functor;

    const Point_2& operator()(const Point_2& p) const { return p; }
  };

  class Construct_segment_2
    : public Functor
  {
  public:
    using Functor::Functor;

    Segment_2 operator()(const Point_2&, const Point_2&) const { return Segment_2(); }
  };

  class Construct_triangle_2
    : public Functor
  {
  public:
    using Functor::Functor;

    Triangle_2 operator()(const Point_2&, const Point_2&, const Point_2&) const { return Triangle_2(); }
  };

  class Compare_x_2
    : public Functor
  {
  public:
    using Functor::Functor;

    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const
    { return CGAL::compare(this->x(p), this->x(q)); }
  };

  class Compare_y_2
    : public Functor
  {
  public:
    using Functor::Functor;

    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const
    { return CGAL::compare(this->y(p), this->y(q)); }
  };

  class Orientation_2
    : public Functor
  {
  public:
    using Functor::Functor;

    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    { return Backend().orientation_2_object()(this->point(p), this->point(q), this->point(r)); }
  };

  Construct_point_2 construct_point_2_object() const { return Construct_point_2(*this); }
  Construct_segment_2 construct_segment_2_object() const { return Construct_segment_2(*this); }
  Construct_triangle_2 construct_triangle_2_object() const { return Construct_triangle_2(*this); }
  Compare_x_2 compare_x_2_object() const { return Compare_x_2(*this); }
  Compare_y_2 compare_y_2_object() const { return Compare_y_2(*this); }
  Orientation_2 orientation_2_object() const { return Orientation_2(*this); }

  // ---------------------------------------------------------------- of `SpatialSortingTraits_2`

  class Compute_x_2
    : public Functor
  {
  public:
    using Functor::Functor;

    FT operator()(const Point_2& p) const { return p.x(); }
  };

  class Compute_y_2
    : public Functor
  {
  public:
    using Functor::Functor;

    FT operator()(const Point_2& p) const { return p.y(); }
  };

  class Less_x_2
    : public Functor
  {
  public:
    using Functor::Functor;

    bool operator()(const Point_2& p, const Point_2& q) const { return p.x() < q.x(); }
  };

  class Less_y_2
    : public Functor
  {
  public:
    using Functor::Functor;

    bool operator()(const Point_2& p, const Point_2& q) const { return p.y() < q.y(); }
  };

  Compute_x_2 compute_x_2_object() const { return Compute_x_2(*this); }
  Compute_y_2 compute_y_2_object() const { return Compute_y_2(*this); }
  Less_x_2 less_x_2_object() const { return Less_x_2(*this); }
  Less_y_2 less_y_2_object() const { return Less_y_2(*this); }

  // ---------------------------------------------------------------- creation

  Riemannian_metric_traits_archetype() {}

  static Riemannian_metric_traits_archetype make()
  {
    Riemannian_metric_traits_archetype traits;
    traits.m_field = std::make_shared<const Field>(Field::make());
    return traits;
  }

private:
  std::shared_ptr<const Field> m_field;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_RIEMANNIAN_METRIC_TRAITS_ARCHETYPE_H

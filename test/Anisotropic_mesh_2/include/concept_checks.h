// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the concepts of the package promise, as assertions at compile time: both
// the models of the package and the archetypes must have it.

#ifndef ANISOTROPIC_MESH_2_TEST_CONCEPT_CHECKS_H
#define ANISOTROPIC_MESH_2_TEST_CONCEPT_CHECKS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/enum.h>

#include <type_traits>
#include <utility>

// a lvalue to which nothing but what is const can be done
template <class T>
const T& a_const() noexcept;

#define SAME_TYPE(expression, ...) \
  static_assert(std::is_same<std::decay_t<decltype(expression)>, __VA_ARGS__>::value, #expression)

template <class F>
constexpr bool models_functor()
{
  static_assert(std::is_copy_constructible<F>::value, "");
  return true;
}

template <class Field, class K>
constexpr bool models_metric_field()
{
  static_assert(models_functor<Field>(), "");
  SAME_TYPE(a_const<Field>()(a_const<typename K::Point_2>()), CGAL::Metric_tensor_2<K>);
  return true;
}

// ---------------------------------------------------------------- RiemannianMetricTraits_2

template <class FT>
constexpr bool models_number()
{
  static_assert(std::is_default_constructible<FT>::value && std::is_copy_constructible<FT>::value, "");
  static_assert(std::is_copy_assignable<FT>::value, "");
  static_assert(std::is_constructible<FT, double>::value && std::is_convertible<int, FT>::value, "");
  static_assert(std::is_convertible<typename CGAL::Algebraic_structure_traits<FT>::Algebraic_category,
                                    CGAL::Field_tag>::value, "");
  static_assert(CGAL::Real_embeddable_traits<FT>::Is_real_embeddable::value, "");
  return true;
}

template <class Point, class FT>
constexpr bool models_point()
{
  static_assert(std::is_default_constructible<Point>::value && std::is_copy_constructible<Point>::value, "");
  static_assert(std::is_copy_assignable<Point>::value && std::is_constructible<Point, FT, FT>::value, "");
  SAME_TYPE(a_const<Point>().x(), FT);
  SAME_TYPE(a_const<Point>().y(), FT);
  return true;
}

// what the concept adds to those that it refines
template <class Gt>
constexpr bool models_metric_of_traits()
{
  typedef typename Gt::Point_2           Point;
  typedef typename Gt::Metric_tensor_2   Tensor;
  static_assert(std::is_same<Tensor, CGAL::Metric_tensor_2<typename Gt::Kernel> >::value, "");
  static_assert(std::is_same<typename Gt::Kernel::FT, typename Gt::FT>::value, "");
  static_assert(std::is_same<typename Gt::Kernel::Point_2, Point>::value, "");
  static_assert(std::is_pointer<typename Gt::Kernel::Vector_2*>::value, "");
  static_assert(Gt::has_exact_predicates || !Gt::has_exact_predicates, "known at compile time");

  typedef typename Gt::Side_of_metric_circle_2     Side;
  typedef typename Gt::Construct_metric_tensor_2   Construct;
  typedef typename Gt::Compute_riemannian_length_2 Length;
  static_assert(models_functor<Side>() && models_functor<Construct>() && models_functor<Length>(), "");
  SAME_TYPE(a_const<Gt>().side_of_metric_circle_2_object(), Side);
  SAME_TYPE(a_const<Gt>().construct_metric_tensor_2_object(), Construct);
  SAME_TYPE(a_const<Gt>().compute_riemannian_length_2_object(), Length);
  SAME_TYPE(a_const<Side>()(a_const<Point>(), a_const<Point>(), a_const<Point>(), a_const<Point>(),
                            a_const<Tensor>(), a_const<Tensor>(), a_const<Tensor>(), a_const<Tensor>()),
            CGAL::Oriented_side);
  SAME_TYPE(a_const<Construct>()(a_const<Point>()), Tensor);
  SAME_TYPE(a_const<Length>()(a_const<Point>(), a_const<Point>()), double);
  return true;
}

// what of `TriangulationTraits_2` every triangulation uses
template <class Gt>
constexpr bool models_triangulation_traits()
{
  typedef typename Gt::Point_2 Point;
  static_assert(std::is_default_constructible<Gt>::value && std::is_copy_constructible<Gt>::value, "");
  static_assert(std::is_copy_assignable<Gt>::value, "");
  SAME_TYPE(a_const<Gt>().construct_point_2_object(), typename Gt::Construct_point_2);
  SAME_TYPE(a_const<Gt>().construct_segment_2_object()(a_const<Point>(), a_const<Point>()),
            typename Gt::Segment_2);
  SAME_TYPE(a_const<Gt>().construct_triangle_2_object()(a_const<Point>(), a_const<Point>(), a_const<Point>()),
            typename Gt::Triangle_2);
  SAME_TYPE(a_const<Gt>().compare_x_2_object()(a_const<Point>(), a_const<Point>()), CGAL::Comparison_result);
  SAME_TYPE(a_const<Gt>().compare_y_2_object()(a_const<Point>(), a_const<Point>()), CGAL::Comparison_result);
  SAME_TYPE(a_const<Gt>().orientation_2_object()(a_const<Point>(), a_const<Point>(), a_const<Point>()),
            CGAL::Orientation);
  return true;
}

template <class Gt>
constexpr bool models_spatial_sorting_traits()
{
  typedef typename Gt::Point_2 Point;
  SAME_TYPE(a_const<Gt>().compute_x_2_object()(a_const<Point>()), typename Gt::FT);
  SAME_TYPE(a_const<Gt>().compute_y_2_object()(a_const<Point>()), typename Gt::FT);
  SAME_TYPE(a_const<Gt>().less_x_2_object()(a_const<Point>(), a_const<Point>()), bool);
  SAME_TYPE(a_const<Gt>().less_y_2_object()(a_const<Point>(), a_const<Point>()), bool);
  return true;
}

template <class Gt>
constexpr bool models_riemannian_metric_traits()
{
  return models_number<typename Gt::FT>() && models_point<typename Gt::Point_2, typename Gt::FT>()
      && models_metric_of_traits<Gt>() && models_triangulation_traits<Gt>() && models_spatial_sorting_traits<Gt>();
}

// ---------------------------------------------------------------- vertex and face bases

// for the vertices of a triangulation data structure
template <class Vertex, class Gt>
constexpr bool models_vertex_base()
{
  typedef typename Gt::Point_2         Point;
  typedef typename Gt::Metric_tensor_2 Tensor;
  static_assert(std::is_same<typename Vertex::Point, Point>::value, "");
  static_assert(std::is_default_constructible<Vertex>::value && std::is_constructible<Vertex, Point>::value, "");
  SAME_TYPE(a_const<Vertex>().point(), Point);
  SAME_TYPE(std::declval<Vertex&>().set_point(a_const<Point>()), void);
  static_assert(std::is_same<decltype(a_const<Vertex>().metric_tensor()), const Tensor&>::value, "");
  SAME_TYPE(std::declval<Vertex&>().set_metric_tensor(a_const<Tensor>()), void);
  SAME_TYPE(a_const<Vertex>().index(), int);
  SAME_TYPE(std::declval<Vertex&>().set_index(1), void);
  SAME_TYPE(a_const<Vertex>().is_required(), bool);
  SAME_TYPE(std::declval<Vertex&>().set_required(true), void);
  return true;
}

// for the faces of a triangulation data structure, `ConstrainedTriangulationFaceBase_2` included
template <class Face>
constexpr bool models_face_base()
{
  SAME_TYPE(a_const<Face>().is_constrained(0), bool);
  SAME_TYPE(std::declval<Face&>().set_constraint(0, true), void);
  SAME_TYPE(std::declval<Face&>().set_constraints(true, true, true), void);
  SAME_TYPE(a_const<Face>().is_in_domain(), bool);
  SAME_TYPE(std::declval<Face&>().set_in_domain(true), void);
  SAME_TYPE(a_const<Face>().subdomain_index(), int);
  SAME_TYPE(std::declval<Face&>().set_subdomain_index(-1), void);
  SAME_TYPE(a_const<Face>().edge_reference(2), int);
  SAME_TYPE(std::declval<Face&>().set_edge_reference(2, -1), void);
  SAME_TYPE(a_const<Face>().is_boundary(2), bool);
  SAME_TYPE(std::declval<Face&>().set_boundary(2, true), void);
  return true;
}

#undef SAME_TYPE

#endif // ANISOTROPIC_MESH_2_TEST_CONCEPT_CHECKS_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FUNCTOR_ARCHETYPES_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FUNCTOR_ARCHETYPES_H

#include "Only_copyable.h"

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>

#include <cstddef>
#include <string>

// the `Size` of `Isotropic_metric_field_2`
template <class K>
class Size_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  static Size_archetype make() { return Size_archetype(Made_on_purpose()); }

  typename K::FT operator()(const typename K::Point_2& p) const { return p.x() / 4 + 1; }
};

// the `Sizes` of `Oriented_sizes_metric_field_2`, which gives numbers of three types
template <class K>
class Sizes_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  class Three_sizes
  {
  public:
    const int             h1;
    const typename K::FT  h2;
    const double          angle;

    Three_sizes(const Three_sizes&) = default;
    Three_sizes& operator=(const Three_sizes&) = delete;

  private:
    friend class Sizes_archetype;
    Three_sizes(const typename K::FT& h2, double angle) : h1(1), h2(h2), angle(angle) {}
  };

  static Sizes_archetype make() { return Sizes_archetype(Made_on_purpose()); }

  Three_sizes operator()(const typename K::Point_2& p) const { return Three_sizes(p.y() / 4 + 1, 0.5); }
};

// the `Curve` of `Curve_piece_2::parametrized()`: a parabola from (0, 0) to (4, 0)
template <class K>
class Curve_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  static Curve_archetype make() { return Curve_archetype(Made_on_purpose()); }

  typename K::Point_2 operator()(double t) const
  {
    typedef typename K::FT FT;
    return typename K::Point_2(FT(4*t), FT(2*t*(1 - t)));
  }
};

// the visitor of optimizers, which counts its calls elsewhere
class Visitor_archetype
  : public Only_copyable
{
public:
  static Visitor_archetype make(int& calls) { return Visitor_archetype(calls); }

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state&) { return ++*m_calls < 5; }

private:
  explicit Visitor_archetype(int& calls) : Only_copyable(Made_on_purpose()), m_calls(&calls) {}

  int* m_calls;
};

// the predicate on edges of `flip_edges()`
template <class Triangulation>
class Edge_predicate_archetype
  : public Only_copyable
{
public:
  static Edge_predicate_archetype make(const Triangulation& t) { return Edge_predicate_archetype(t); }

  bool operator()(const typename Triangulation::Edge& e) const
  {
    return !m_triangulation.is_locally_Delaunay(e.first, e.second);
  }

private:
  explicit Edge_predicate_archetype(const Triangulation& t)
    : Only_copyable(Made_on_purpose()), m_triangulation(t)
  {}

  const Triangulation& m_triangulation;
};

// the `EdgeReference` of `write_MEDIT()`
template <class Triangulation>
class Edge_reference_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  static Edge_reference_archetype make() { return Edge_reference_archetype(Made_on_purpose()); }

  int operator()(const typename Triangulation::Edge&) const { return 77; }
};

// the `Quality` of `write_SVG()`
template <class Triangulation>
class Quality_archetype
  : public Only_copyable
{
  using Only_copyable::Only_copyable;

public:
  static Quality_archetype make() { return Quality_archetype(Made_on_purpose()); }

  double operator()(typename Triangulation::Face_handle) const { return 0.5; }
};

// the `Visit` of `Mesh_statistics::for_each()`, which adds the names elsewhere
class Figure_visitor_archetype
  : public Only_copyable
{
public:
  static Figure_visitor_archetype make(std::string& names) { return Figure_visitor_archetype(names); }

  void operator()(const char* name, std::size_t) const { m_names += name; }
  void operator()(const char* name, double) const { m_names += name; }

private:
  explicit Figure_visitor_archetype(std::string& names) : Only_copyable(Made_on_purpose()), m_names(names) {}

  std::string& m_names;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_FUNCTOR_ARCHETYPES_H

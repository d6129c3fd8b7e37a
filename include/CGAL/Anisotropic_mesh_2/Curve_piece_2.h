// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_CURVE_PIECE_2_H
#define CGAL_ANISOTROPIC_MESH_2_CURVE_PIECE_2_H

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// A piece of a curve in the plane: a segment, an arc of a circle, or any
/// parametrized curve, with an integer reference (a curved segment in section 3.2 of \cgalCite{dw-acvt-05}).
///
/// The piece is followed by a parameter that runs from 0 at the source to 1 at
/// the target. The two end points are stored, so that consecutive pieces can
/// share them exactly. Corners belong between pieces: inside, a curve should
/// have a continuous tangent. Copies share the curve; a piece can be used by
/// several threads if the given curve can.
///
/// No coordinate that is not finite leaves a piece: `point()` throws
/// `Invalid_domain_exception` naming the parameter.
///
/// \tparam K a model of `Kernel`
/// \sa `Anisotropic_mesh_domain_2`
template <class K>
class Curve_piece_2
{
public:
  typedef K                    Kernel;  ///< the kernel
  typedef typename K::FT       FT;      ///< its number type
  typedef typename K::Point_2  Point_2; ///< its points

  /// \name Creation
  /// @{

  /// the segment from `p` to `q`.
  /// \throw Invalid_domain_exception if a coordinate is not finite.
  static Curve_piece_2 segment(const Point_2& p, const Point_2& q, int reference = 1)
  {
    return Curve_piece_2(nullptr, 0, 1, finite(p), finite(q), reference);
  }

  /// the arc of the circle with the given center and radius between two angles
  /// in radians, counterclockwise if `angle0 < angle1`.
  ///
  /// Angles that are a multiple of \f$ \pi/2 \f$ up to rounding give the exact
  /// points of the circle, and a full turn ends exactly where it starts.
  /// \throw Invalid_domain_exception if an argument is not finite, the radius
  /// is not positive, or the angles are equal or differ by more than a full turn.
  /// \param center the center of the circle
  /// \param radius the radius, in units of the coordinates
  /// \param angle0,angle1 the angles of the source and of the target, in radians
  /// \param reference the reference
  static Curve_piece_2 arc(const Point_2& center, const FT& radius,
                           double angle0, double angle1, int reference = 1)
  {
    check_arc(finite(center), CGAL::to_double(radius), angle0, angle1);
    const auto curve = [center, radius](double angle) {
      const std::pair<double, double> u = unit_vector(angle);
      return Point_2(center.x() + radius*FT(u.first), center.y() + radius*FT(u.second));
    };
    Curve_piece_2 piece = parametrized(curve, angle0, angle1, reference);
    if(std::abs(std::abs(angle1 - angle0) - full_turn()) <= angle_tolerance(full_turn()))
      piece.m_target = piece.m_source;
    return piece;
  }

  /// the curve `f(t)` for `t` from `t0` to `t1`, which may be smaller.
  /// \tparam Curve a callable `Point_2 (double)`; it is copied once.
  /// \param f the curve
  /// \param t0,t1 the arguments of `f` at the source and at the target
  /// \param reference the reference
  /// \throw Invalid_domain_exception if an end point is not finite, or `t0`
  /// and `t1` are equal or not finite.
  template <class Curve>
  static Curve_piece_2 parametrized(Curve f, double t0, double t1, int reference = 1)
  {
    if(!(std::isfinite(t0) && std::isfinite(t1)) || t0 == t1)
      refuse("the curve from the parameter " + describe(t0) + " to " + describe(t1) + " has no length");
    const auto curve = std::make_shared<const Function>(std::move(f));
    return Curve_piece_2(curve, t0, t1, evaluated(*curve, t0), evaluated(*curve, t1), reference);
  }

  /// the same curve with its end points moved to `p` and `q`, to make them
  /// equal to those of the neighbors where rounding has made a difference.
  /// \throw Invalid_domain_exception if an end would move by more than
  /// 10<sup>-6</sup> of the size of the piece.
  Curve_piece_2 with_end_points(const Point_2& p, const Point_2& q) const
  {
    const double allowed = 1e-6 * extent();
    if(!(distance(finite(p), m_source) <= allowed && distance(finite(q), m_target) <= allowed))
      refuse("the end points " + describe(p) + " and " + describe(q) + " are not on the curve from "
             + describe(m_source) + " to " + describe(m_target));
    return Curve_piece_2(m_curve, m_t0, m_t1, p, q, m_reference);
  }

  /// the same piece followed from its target to its source.
  Curve_piece_2 reversed() const
  {
    return Curve_piece_2(m_curve, m_t1, m_t0, m_target, m_source, m_reference);
  }

  /// the part between the parameters `s0` and `s1`, with the given end points,
  /// which must be those of the part up to rounding.
  /// \param s0,s1 parameters in [0, 1]; with `s0 > s1` the part is followed backwards
  /// \param p,q the points at `s0` and `s1`; that they are is not checked
  Curve_piece_2 part(double s0, double s1, const Point_2& p, const Point_2& q) const
  {
    return Curve_piece_2(m_curve, original_parameter(s0), original_parameter(s1), p, q, m_reference);
  }
  /// @}

  /// \name Access
  /// @{

  /// the point at the parameter 0.
  const Point_2& source() const { return m_source; }

  /// the point at the parameter 1.
  const Point_2& target() const { return m_target; }

  /// the reference, which the edges of a mesh along the piece get.
  int reference() const { return m_reference; }

  /// returns whether the piece is a segment.
  bool is_straight() const { return m_curve == nullptr; }

  /// returns whether the piece ends where it starts.
  bool is_closed() const { return m_source == m_target; }

  /// the point at the parameter `s` in [0, 1].
  ///
  /// Points of a segment that is parallel to an axis lie exactly on it.
  /// \throw Invalid_domain_exception if the curve is not finite there.
  Point_2 point(double s) const
  {
    if(s <= 0)
      return m_source;
    if(s >= 1)
      return m_target;
    return is_straight() ? point_of_segment(s) : evaluated(*m_curve, original_parameter(s));
  }
  /// @}

private:
  typedef std::function<Point_2(double)> Function;

  Curve_piece_2(std::shared_ptr<const Function> curve, double t0, double t1,
                const Point_2& source, const Point_2& target, int reference)
    : m_curve(std::move(curve)), m_t0(t0), m_t1(t1)
    , m_source(source), m_target(target), m_reference(reference)
  {}

  static std::string describe(double x) { return Anisotropic_mesh_2::internal::describe(x); }
  static std::string describe(const Point_2& p) { return Anisotropic_mesh_2::internal::describe(p); }

  [[noreturn]] static void refuse(const std::string& what) { throw Invalid_domain_exception(what); }

  static bool is_finite_point(const Point_2& p) { return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()); }

  static const Point_2& finite(const Point_2& p)
  {
    if(!is_finite_point(p))
      refuse("the point " + describe(p) + " is not finite");
    return p;
  }

  static Point_2 evaluated(const Function& f, double t)
  {
    const Point_2 p = f(t);
    if(!is_finite_point(p))
      refuse("the curve is not finite at the parameter " + describe(t) + ": " + describe(p));
    return p;
  }

  static double full_turn() { return 6.283185307179586; }
  static double angle_tolerance(double angle)
  {
    return 4 * std::numeric_limits<double>::epsilon() * std::abs(angle);
  }

  static void check_arc(const Point_2& center, double radius, double angle0, double angle1)
  {
    const double turn = std::abs(angle1 - angle0);
    if(!(std::isfinite(radius) && radius > 0))
      refuse("the arc around " + describe(center) + " has the radius " + describe(radius));
    if(!(turn > 0 && turn <= full_turn() + angle_tolerance(full_turn())))
      refuse("the arc around " + describe(center) + " from the angle " + describe(angle0) + " to "
             + describe(angle1) + " is empty or more than a full turn");
  }

  static std::pair<double, double> unit_vector(double angle)
  {
    const double quarter = full_turn() / 4, turns = std::round(angle / quarter);
    if(std::abs(angle - turns*quarter) > angle_tolerance(angle))
      return std::make_pair(std::cos(angle), std::sin(angle));
    const int k = static_cast<int>(std::fmod(std::fmod(turns, 4) + 4, 4));
    return std::make_pair(k == 0 ? 1. : k == 2 ? -1. : 0., k == 1 ? 1. : k == 3 ? -1. : 0.);
  }

  double original_parameter(double s) const
  {
    return s < 0.5 ? m_t0 + s*(m_t1 - m_t0) : m_t1 - (1 - s)*(m_t1 - m_t0);
  }

  // from the nearer end, so that a reversed segment has the same points
  Point_2 point_of_segment(double s) const
  {
    const bool near_source = s < 0.5;
    const Point_2& p = near_source ? m_source : m_target;
    const Point_2& q = near_source ? m_target : m_source;
    const FT r(near_source ? s : 1 - s);
    return Point_2(p.x() + r*(q.x() - p.x()), p.y() + r*(q.y() - p.y()));
  }

  static double distance(const Point_2& p, const Point_2& q)
  {
    return std::hypot(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()));
  }

  double extent() const
  {
    double farthest = 0;
    for(int i = 1; i <= 8; ++i)
      farthest = (std::max)(farthest, distance(m_source, point(i / 8.)));
    return farthest;
  }

  std::shared_ptr<const Function> m_curve; // none for a segment
  double  m_t0, m_t1;
  Point_2 m_source, m_target;
  int     m_reference;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_CURVE_PIECE_2_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Metric_sample.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Sampling.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Tensor_exponential.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_walk.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// A metric field sampled once, over triangles that fill the domain. The matrix
// logarithm is interpolated from the corners and the middles of the edges by
// quadratic functions, so that values are positive definite and have derivatives.
// Where the sample at a barycentre disagrees, a triangle is quartered, as long as
// the number of samples stays bounded; where that does not help, as at a jump,
// the interpolation is linear in each quarter.
class Control_space
{
public:
  typedef Triangle_walk::Indices Indices;

  // The mean of a function, and how far the rule of trapezoids is from it.
  struct Mean
  {
    double value, error;
  };

  // `logarithms` belong to the points; `logarithm_at(x)` evaluates the field.
  template <class ConcurrencyTag, class Logarithm_at>
  Control_space(ConcurrencyTag, const Sampling& sampling, const Vectors& points, const std::vector<Indices>& corners,
                const std::vector<Symmetric_form>& logarithms, const Logarithm_at& logarithm_at)
    : m_walk(points, corners), m_areas(corners.size()), m_patches(corners.size()), m_variation(corners.size()),
      m_is_resolved(corners.size(), true), m_is_accurate(corners.size(), true)
  {
    const auto triangle = [&](std::size_t i) -> Triangle_of_doubles {
      return {{points[corners[i][0]], points[corners[i][1]], points[corners[i][2]]}};
    };
    const std::size_t n = corners.size();
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      for(int k = 0; k < 3; ++k)
        m_patches[i].corner[k] = logarithms[corners[i][k]];
      sample_own_edges(int(i), triangle(i), logarithm_at);
    });
    std::vector<double> errors(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      copy_other_edges(int(i));
      m_areas[i] = area(triangle(i));
      m_patches[i].centre = logarithm_at(barycentre(triangle(i)));
      errors[i] = error(m_patches[i]);
      m_variation[i] = variation(m_patches[i]) + errors[i];
    });
    std::vector<Piece> bad;
    for(std::size_t i = 0; i < n; ++i)
      if(errors[i] > sampling.tolerance)
        bad.push_back({int(i), int(i), errors[i], triangle(i)});
      else
        m_settled_error += errors[i];
    for(int depth = 0; !bad.empty(); ++depth)
      bad = quarters<ConcurrencyTag>(std::move(bad), depth, sampling, logarithm_at);
  }

  // The tensor at x. The search begins in `triangle`, which becomes the one that holds
  // x, or the last one before the border if x lies outside.
  Metric_sample operator()(const Vector_of_doubles& x, int& triangle) const
  {
    double factor = 1;
    Barycentric l;
    const Patch& p = patch_at(x, triangle, l, factor);
    const Forms by_coordinate = p.is_linear ? linear(p, l, factor) : quadratic_derivatives(p, l);
    const Triangle_walk::Frame& frame = m_walk.frame(triangle);
    const auto derivative = [&](double of_second, double of_third) {
      return (factor * of_second) * (by_coordinate[1] + (-1.) * by_coordinate[0])
           + (factor * of_third) * (by_coordinate[2] + (-1.) * by_coordinate[0]);
    };
    const Tensor_exponential e(p.is_linear ? combination(by_coordinate, l) : quadratic(p, l));
    return {e.value(), e.derivative(derivative(frame.second.x, frame.third.x)),
            e.derivative(derivative(frame.second.y, frame.third.y)), e.root_of_determinant()};
  }

  // the same for its logarithm alone
  Symmetric_form logarithm(const Vector_of_doubles& x, int& triangle) const
  {
    double factor = 1;
    Barycentric l;
    const Patch& p = patch_at(x, triangle, l, factor);
    return p.is_linear ? combination(linear(p, l, factor), l) : quadratic(p, l);
  }

  // the logarithm as it was sampled at the barycentre of a triangle
  const Symmetric_form& at_barycentre(int triangle) const { return m_patches[triangle].centre; }

  // The mean of a function of logarithms over an edge of a triangle, by Simpson's rule for the samples on each part.
  template <class Function>
  Mean mean_over_edge(int triangle, int edge, const Function& function) const
  {
    return mean_over_edge(m_patches[triangle], edge, function);
  }

  // The integral of (det M)^exponent over a triangle, by a rule of degree three for the samples in each part of it.
  double density_integral(int triangle, double exponent) const
  {
    return m_areas[triangle] * mean_density(m_patches[triangle], exponent);
  }

  // how far the logarithm is from that at a corner, at most
  double variation(int triangle) const { return m_variation[triangle]; }

  // whether the interpolation comes near to all samples of a triangle
  bool is_resolved(int triangle) const { return m_is_resolved[triangle]; }

  // whether a triangle was quartered as often as it should be, or all were
  bool is_accurate(int triangle) const { return m_is_accurate[triangle]; }
  bool is_accurate() const { return m_is_accurate_everywhere; }

private:
  typedef std::array<Symmetric_form, 3> Forms;

  // the logarithms at the corners, at the middles of the edges opposite to them, and at the barycentre
  struct Patch
  {
    Forms          corner, middle;
    Symmetric_form centre;
    int            first_child = -1;
    bool           is_linear = false;
  };

  struct Piece // a patch that may be quartered, and where it lies
  {
    int    triangle, patch;
    double error;
    Triangle_of_doubles corner;
  };

  static constexpr int    maximum_depth = 4;
  static constexpr double error_of_linear = 0.05; // from which on the interpolation is linear
  static constexpr double error_at_jumps = 1;

  // ------------------------------------------------------------ sampling

  // The middle of an edge is sampled by the triangle of the lower number.
  bool is_own_edge(int triangle, int k) const
  {
    const int n = m_walk.neighbor(triangle, k);
    return n < 0 || triangle < n;
  }

  template <class Logarithm_at>
  void sample_own_edges(int triangle, const Triangle_of_doubles& z, const Logarithm_at& logarithm_at)
  {
    const Triangle_of_doubles m = middles(z);
    for(int k = 0; k < 3; ++k)
      if(is_own_edge(triangle, k))
        m_patches[triangle].middle[k] = logarithm_at(m[k]);
  }

  void copy_other_edges(int triangle)
  {
    for(int k = 0; k < 3; ++k)
      if(!is_own_edge(triangle, k)) {
        const int n = m_walk.neighbor(triangle, k);
        int i = 0;
        while(m_walk.neighbor(n, i) != triangle)
          ++i;
        m_patches[triangle].middle[k] = m_patches[n].middle[i];
      }
  }

  // of the interpolation at the barycentre
  static double error(const Patch& p)
  {
    Symmetric_form d = p.centre;
    for(int k = 0; k < 3; ++k)
      d += (1./9) * p.corner[k] + (-4./9) * p.middle[k];
    return d.norm();
  }

  static double variation(const Patch& p)
  {
    double largest = 0;
    for(const Symmetric_form& corner : p.corner)
      for(const Forms& others : {p.corner, p.middle})
        for(const Symmetric_form& l : others)
          largest = (std::max)(largest, (l + (-1.) * corner).norm());
    return largest;
  }

  // Quarters the worst pieces, and returns those quarters that are bad.
  template <class ConcurrencyTag, class Logarithm_at>
  std::vector<Piece> quarters(std::vector<Piece> pieces, int depth, const Sampling& sampling,
                              const Logarithm_at& logarithm_at)
  {
    std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
      return p.error != q.error ? p.error > q.error : p.patch < q.patch;
    });
    const std::size_t wanted = number_to_quarter(pieces, depth, sampling);
    const double left = (1 + 4 * sampling.quarterings) * double(m_areas.size()) - double(m_patches.size());
    const std::size_t n = depth < maximum_depth ? (std::min)(wanted, std::size_t((std::max)(0., left / 4))) : 0;
    m_is_accurate_everywhere = m_is_accurate_everywhere && n == wanted;
    for(std::size_t i = n; i < pieces.size(); ++i) {
      settle(pieces[i], depth);
      m_is_accurate[pieces[i].triangle] = m_is_accurate[pieces[i].triangle] && i >= wanted;
    }
    const std::size_t first = m_patches.size();
    m_patches.resize(first + 4*n);
    std::vector<Piece> quarters(4*n), bad;
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      quarter_piece(pieces[i], int(first + 4*i), quarters.data() + 4*i, logarithm_at);
    });
    for(const Piece& q : quarters)
      if(q.error > sampling.tolerance)
        bad.push_back(q);
      else
        m_settled_error += std::ldexp(q.error, -2 * (depth + 1));
    return bad;
  }

  // Of sorted pieces, the first ones: without quartering the others the mean error is small enough.
  std::size_t number_to_quarter(const std::vector<Piece>& pieces, int depth, const Sampling& sampling) const
  {
    double permitted = sampling.mean_error * double(m_areas.size()) - m_settled_error;
    std::size_t n = pieces.size();
    while(n > 0 && (permitted -= std::ldexp(pieces[n - 1].error, -2*depth)) >= 0)
      --n;
    return n;
  }

  void settle(const Piece& p, int depth)
  {
    m_settled_error += std::ldexp(p.error, -2*depth);
    m_patches[p.patch].is_linear = p.error > error_of_linear;
    if(p.error > error_at_jumps)
      m_is_resolved[p.triangle] = false;
  }

  template <class Logarithm_at>
  void quarter_piece(const Piece& piece, int first_child, Piece* quarters, const Logarithm_at& logarithm_at)
  {
    Patch& p = m_patches[piece.patch];
    p.first_child = first_child;
    const std::array<Triangle_of_doubles, 4> parts = internal::quarters(piece.corner);
    Patch& inner = m_patches[first_child + 3];
    inner.corner = p.middle;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      Patch& q = m_patches[first_child + i];
      q.corner[i] = p.corner[i];
      q.corner[j] = p.middle[k];
      q.corner[k] = p.middle[j];
      const Triangle_of_doubles m = middles(parts[i]);
      inner.middle[i] = q.middle[i] = logarithm_at(m[i]);
      q.middle[j] = logarithm_at(m[j]);
      q.middle[k] = logarithm_at(m[k]);
    }
    inner.centre = p.centre;
    for(int i = 0; i < 3; ++i)
      m_patches[first_child + i].centre = logarithm_at(barycentre(parts[i]));
    for(int i = 0; i < 4; ++i)
      quarters[i] = {piece.triangle, first_child + i, error(m_patches[first_child + i]), parts[i]};
  }

  // ------------------------------------------------------------ interpolation

  // The finest patch that holds x; `l` becomes the coordinates in it, whose derivatives are `factor` times those of the
  // coordinates in the triangle.
  const Patch& patch_at(const Vector_of_doubles& x, int& triangle, Barycentric& l, double& factor) const
  {
    l = m_walk.locate(x, triangle);
    const Patch* p = &m_patches[triangle];
    while(p->first_child >= 0) {
      const int q = quarter(l);
      p = &m_patches[p->first_child + q];
      factor *= descend(q, l);
    }
    return *p;
  }

  // The fourth quarter is the inner one, whose corner i is the middle opposite to corner i.
  static int quarter(const Barycentric& l)
  {
    for(int i = 0; i < 3; ++i)
      if(l[i] > 0.5)
        return i;
    return 3;
  }

  // From coordinates in the whole to those in a quarter; returns the derivative.
  static double descend(int quarter, Barycentric& l)
  {
    for(int i = 0; i < 3; ++i)
      l[i] = quarter == 3 ? 1 - 2*l[i] : 2*l[i] - (i == quarter);
    return quarter == 3 ? -2 : 2;
  }

  static Symmetric_form combination(const Forms& f, const Barycentric& l)
  {
    return l[0] * f[0] + l[1] * f[1] + l[2] * f[2];
  }

  static Symmetric_form quadratic(const Patch& p, const Barycentric& l)
  {
    return combination(p.corner, {{l[0] * (2*l[0] - 1), l[1] * (2*l[1] - 1), l[2] * (2*l[2] - 1)}})
         + combination(p.middle, {{4*l[1]*l[2], 4*l[2]*l[0], 4*l[0]*l[1]}});
  }

  // by the barycentric coordinates
  static Forms quadratic_derivatives(const Patch& p, const Barycentric& l)
  {
    Forms result;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result[i] = (4*l[i] - 1) * p.corner[i] + 4*l[k] * p.middle[j] + 4*l[j] * p.middle[k];
    }
    return result;
  }

  // the values at the corners of the quarter that holds `l`, which becomes the coordinates in that
  static Forms linear(const Patch& p, Barycentric& l, double& factor)
  {
    const int q = quarter(l);
    Forms corner = p.middle;
    if(q < 3) {
      corner[q] = p.corner[q];
      std::swap(corner[(q + 1) % 3], corner[(q + 2) % 3]);
    }
    factor *= descend(q, l);
    return corner;
  }

  // ------------------------------------------------------------ integration

  double mean_density(const Patch& p, double exponent) const
  {
    double sum = 0;
    if(p.first_child >= 0) {
      for(int i = 0; i < 4; ++i)
        sum += mean_density(m_patches[p.first_child + i], exponent) / 4;
      return sum;
    }
    const auto density = [exponent](const Symmetric_form& l) { return std::exp(exponent * (l.a + l.c)); };
    for(int k = 0; k < 3; ++k)
      sum += density(p.corner[k]) / 20 + 2 * density(p.middle[k]) / 15;
    return sum + 9 * density(p.centre) / 20;
  }

  template <class Function>
  Mean mean_over_edge(const Patch& p, int edge, const Function& function) const
  {
    const int i = (edge + 1) % 3, j = (edge + 2) % 3;
    if(p.first_child < 0) {
      const double begin = function(p.corner[i]), middle = function(p.middle[edge]), end = function(p.corner[j]);
      return {(begin + 4*middle + end) / 6, std::abs(begin - 2*middle + end) / 3};
    }
    const Mean first = mean_over_edge(m_patches[p.first_child + i], edge, function);
    const Mean second = mean_over_edge(m_patches[p.first_child + j], edge, function);
    return {(first.value + second.value) / 2, (first.error + second.error) / 2};
  }

  // by triangle, but for the quarters, which follow those of the triangles
  Triangle_walk       m_walk;
  std::vector<double> m_areas;
  std::vector<Patch>  m_patches;
  std::vector<double> m_variation;
  std::vector<bool>   m_is_resolved, m_is_accurate;
  bool                m_is_accurate_everywhere = true;
  double              m_settled_error = 0; // of pieces that are not quartered, in triangles
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H

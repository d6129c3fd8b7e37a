// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H

#include <CGAL/Anisotropic_mesh_2/internal/metric/Metric_sample.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Tensor_exponential.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Triangle_of_doubles.h>
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
  struct Triangle
  {
    std::array<int, 3> corner, neighbor; // the neighbor opposite to a corner, or -1
  };

  // `logarithms` belong to the points; `logarithm_at(x)` evaluates the field.
  template <class ConcurrencyTag, class Logarithm_at>
  Control_space(ConcurrencyTag, Vectors points, std::vector<Triangle> triangles,
                const std::vector<Symmetric_form>& logarithms, const Logarithm_at& logarithm_at)
    : m_points(std::move(points)), m_triangles(std::move(triangles)), m_patches(m_triangles.size()),
      m_variation(m_triangles.size()), m_is_resolved(m_triangles.size(), true)
  {
    sample_edges<ConcurrencyTag>(logarithms, logarithm_at);
    std::vector<Piece> pieces;
    for(std::size_t i = 0; i < m_triangles.size(); ++i)
      pieces.push_back({int(i), int(i), corners(m_triangles[i]), 0});
    for(int depth = 0; !pieces.empty(); ++depth)
      pieces = refined<ConcurrencyTag>(std::move(pieces), depth, logarithm_at);
  }

  // The tensor at x. The search begins in `triangle`, which becomes the one that holds
  // x, or the last one before the border if x lies outside.
  Metric_sample operator()(const Vector_of_doubles& x, int& triangle) const
  {
    const Interpolation i = interpolation(x, triangle);
    const Tensor_exponential e(i.logarithm);
    const Triangle_of_doubles z = corners(m_triangles[triangle]);
    const double unit = i.factor / (2 * area(z));
    Symmetric_form by_x, by_y;
    for(int k = 0; k < 3; ++k) {
      const Vector_of_doubles &p = z[(k + 1) % 3], &q = z[(k + 2) % 3];
      by_x += (unit * (p.y - q.y)) * i.by_coordinate[k];
      by_y += (unit * (q.x - p.x)) * i.by_coordinate[k];
    }
    return {e.value(), e.derivative(by_x), e.derivative(by_y), e.root_of_determinant()};
  }

  // the same for its logarithm alone
  Symmetric_form logarithm(const Vector_of_doubles& x, int& triangle) const
  {
    return interpolation(x, triangle).logarithm;
  }

  // how far the logarithm is from that at a corner, at most
  double variation(int triangle) const { return m_variation[triangle]; }

  // whether the interpolation comes near to all samples
  bool is_resolved(int triangle) const { return m_is_resolved[triangle]; }

private:
  typedef std::array<Symmetric_form, 3> Forms;

  // the logarithms at the corners and at the middles of the edges opposite to them
  struct Patch
  {
    Forms corner, middle;
    int   first_child = -1;
    bool  is_linear = false;
  };

  struct Piece // a patch that may be quartered, and where it lies
  {
    int     triangle, patch;
    Triangle_of_doubles corner;
    double  error;
  };

  static constexpr int    maximum_depth = 4;
  static constexpr double tolerance = 0.05; // of logarithms: five percent of the entries
  static constexpr double error_at_jumps = 1;
  static constexpr std::size_t quarterings_of_triangle = 2; // on an average
  // of searches
  static constexpr int         maximum_steps = 1000;
  static constexpr std::size_t maximum_search = 100;
  static constexpr double      rounding = 1e-9;

  Triangle_of_doubles corners(const Triangle& t) const
  {
    return {{m_points[t.corner[0]], m_points[t.corner[1]], m_points[t.corner[2]]}};
  }

  static int place_of(int corner_or_neighbor, const std::array<int, 3>& all)
  {
    return int(std::find(all.begin(), all.end(), corner_or_neighbor) - all.begin());
  }

  // The middle of an edge is sampled by the triangle of the lower number.
  template <class ConcurrencyTag, class Logarithm_at>
  void sample_edges(const std::vector<Symmetric_form>& logarithms, const Logarithm_at& logarithm_at)
  {
    for_each_index<ConcurrencyTag>(m_triangles.size(), [&](std::size_t i) {
      const Triangle& t = m_triangles[i];
      const Triangle_of_doubles m = middles(corners(t));
      for(int k = 0; k < 3; ++k) {
        m_patches[i].corner[k] = logarithms[t.corner[k]];
        if(t.neighbor[k] < 0 || int(i) < t.neighbor[k])
          m_patches[i].middle[k] = logarithm_at(m[k]);
      }
    });
    for_each_index<ConcurrencyTag>(m_triangles.size(), [&](std::size_t i) {
      for(int k = 0; k < 3; ++k)
        if(const int n = m_triangles[i].neighbor[k]; n >= 0 && n < int(i))
          m_patches[i].middle[k] = m_patches[n].middle[place_of(int(i), m_triangles[n].neighbor)];
    });
  }

  // Quarters those pieces where the interpolation errs most, and returns the quarters.
  template <class ConcurrencyTag, class Logarithm_at>
  std::vector<Piece> refined(std::vector<Piece> pieces, int depth, const Logarithm_at& logarithm_at)
  {
    for_each_index<ConcurrencyTag>(pieces.size(), [&](std::size_t i) {
      pieces[i].error = error(m_patches[pieces[i].patch], logarithm_at(barycentre(pieces[i].corner)));
      if(depth == 0)
        m_variation[i] = variation(m_patches[i]) + pieces[i].error;
    });
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [](const Piece& p) { return !(p.error > tolerance); }),
                 pieces.end());
    std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
      return p.error != q.error ? p.error > q.error : p.patch < q.patch;
    });
    const std::size_t left = (1 + 4 * quarterings_of_triangle) * m_triangles.size() - m_patches.size();
    const std::size_t n = depth < maximum_depth ? (std::min)(pieces.size(), left / 4) : 0;
    for(std::size_t i = n; i < pieces.size(); ++i) {
      m_patches[pieces[i].patch].is_linear = true;
      if(pieces[i].error > error_at_jumps)
        m_is_resolved[pieces[i].triangle] = false;
    }
    const std::size_t first = m_patches.size();
    m_patches.resize(first + 4*n);
    std::vector<Piece> quarters(4*n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      quarter_piece(pieces[i], int(first + 4*i), quarters.data() + 4*i, logarithm_at);
    });
    return quarters;
  }

  static double error(const Patch& p, const Symmetric_form& sample)
  {
    Symmetric_form d = sample;
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

  template <class Logarithm_at>
  void quarter_piece(const Piece& piece, int first_child, Piece* quarters, const Logarithm_at& logarithm_at)
  {
    Patch& p = m_patches[piece.patch];
    p.first_child = first_child;
    const std::array<Triangle_of_doubles, 4> parts = internal::quarters(piece.corner);
    for(int i = 0; i < 4; ++i)
      quarters[i] = {piece.triangle, first_child + i, parts[i], 0};
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
  }

  Barycentric locate(const Vector_of_doubles& x, int& triangle) const
  {
    const int start = triangle;
    Barycentric l = walk(x, triangle);
    if(least(l) < -rounding) { // a hole or a notch is in the way
      triangle = search_around(x, start);
      l = coordinates(x, triangle);
    }
    return least(l) >= 0 ? l : drawn_inside(l);
  }

  // Walks towards x, at each step over the edge that is farthest behind.
  Barycentric walk(const Vector_of_doubles& x, int& triangle) const
  {
    Barycentric l = coordinates(x, triangle);
    for(int steps = 0; steps < maximum_steps; ++steps) {
      int next = -1;
      double farthest = 0;
      for(int k = 0; k < 3; ++k)
        if(l[k] < farthest && m_triangles[triangle].neighbor[k] >= 0) {
          farthest = l[k];
          next = m_triangles[triangle].neighbor[k];
        }
      if(next < 0)
        break;
      triangle = next;
      l = coordinates(x, triangle);
    }
    return l;
  }

  // the triangle that holds x or comes closest to it, among some near the start
  int search_around(const Vector_of_doubles& x, int start) const
  {
    std::vector<int> queue(1, start);
    int best = start;
    double largest = least(coordinates(x, start));
    for(std::size_t i = 0; i < queue.size() && queue.size() < maximum_search && largest < -rounding; ++i)
      for(int n : m_triangles[queue[i]].neighbor)
        if(n >= 0 && std::find(queue.begin(), queue.end(), n) == queue.end()) {
          queue.push_back(n);
          if(const double l = least(coordinates(x, n)); l > largest) {
            largest = l;
            best = n;
          }
        }
    return best;
  }

  static double least(const Barycentric& l) { return (std::min)({l[0], l[1], l[2]}); }

  static Barycentric drawn_inside(Barycentric l)
  {
    double sum = 0;
    for(double& t : l)
      sum += t = (std::max)(0., t);
    for(double& t : l)
      t /= sum;
    return l;
  }

  Barycentric coordinates(const Vector_of_doubles& x, int triangle) const
  {
    const Triangle_of_doubles z = corners(m_triangles[triangle]);
    const double whole = area(z), l1 = area({z[0], x, z[2]}) / whole, l2 = area({z[0], z[1], x}) / whole;
    return {{1 - l1 - l2, l1, l2}};
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

  // the derivatives are those by barycentric coordinates in a patch, which are `factor` times those in a triangle
  struct Interpolation
  {
    Symmetric_form logarithm;
    Forms          by_coordinate;
    double         factor;
  };

  Interpolation interpolation(const Vector_of_doubles& x, int& triangle) const
  {
    Barycentric l = locate(x, triangle);
    double factor = 1;
    int i = triangle;
    while(m_patches[i].first_child >= 0) {
      const int q = quarter(l);
      i = m_patches[i].first_child + q;
      factor *= descend(q, l);
    }
    return m_patches[i].is_linear ? linear(m_patches[i], l, factor) : quadratic(m_patches[i], l, factor);
  }

  static Interpolation quadratic(const Patch& p, const Barycentric& l, double factor)
  {
    Interpolation result;
    result.factor = factor;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      Symmetric_form& d = result.by_coordinate[i];
      d = (4*l[i] - 1) * p.corner[i] + 4*l[k] * p.middle[j] + 4*l[j] * p.middle[k];
      result.logarithm += (l[i] / 2) * (d + (-1.) * p.corner[i]);
    }
    return result;
  }

  static Interpolation linear(const Patch& p, Barycentric l, double factor)
  {
    const int q = quarter(l);
    Forms corner = p.middle;
    if(q < 3) {
      corner[q] = p.corner[q];
      std::swap(corner[(q + 1) % 3], corner[(q + 2) % 3]);
    }
    factor *= descend(q, l);
    return {l[0] * corner[0] + l[1] * corner[1] + l[2] * corner[2], corner, factor};
  }

  Vectors               m_points;
  std::vector<Triangle> m_triangles;
  std::vector<Patch>    m_patches; // first those of the triangles
  std::vector<double>   m_variation;
  std::vector<bool>     m_is_resolved;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_METRIC_CONTROL_SPACE_H

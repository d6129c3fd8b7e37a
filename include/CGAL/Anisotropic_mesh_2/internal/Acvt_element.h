// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ELEMENT_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ELEMENT_H

#include <CGAL/Anisotropic_mesh_2/internal/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vector_of_doubles.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Anisotropic_mesh_2 {
namespace internal {

// A tensor with its determinant, and weighted by the density of the measure.
struct Weighted_tensor
{
  Symmetric_form m;
  Symmetric_form weighted;
  double determinant = 1;
  double weighted_area_density = 1; // the root of the determinant of the weighted tensor

  Weighted_tensor() {}
  Weighted_tensor(const Symmetric_form& m, bool riemannian)
    : m(m), determinant(m.determinant())
  {
    const double root = std::sqrt(determinant);
    weighted = riemannian ? root * m : m;
    weighted_area_density = riemannian ? determinant : root;
  }

  // The root of the sum of (e - 1)^2 over the two eigenvalues e of m^-1 n: how
  // far n is from this tensor, seen from it.
  double distance_to(const Weighted_tensor& n) const
  {
    const double trace = (m.c*n.m.a - 2*m.b*n.m.b + m.a*n.m.c) / determinant;
    const double product = n.determinant / determinant;
    return std::sqrt(std::max(0., trace*trace - 2*product - 2*trace + 2));
  }
};

// A triangle, or a part of one, over which the metric is taken as known: the
// weighted tensor is interpolated between the corners and the barycentre, and
// the bisectors are those of the tensor at the barycentre.
struct Acvt_element
{
  std::array<Vector_of_doubles, 3> corner;
  std::array<Weighted_tensor, 3>   tensor;
  Weighted_tensor                  middle;
  std::array<Symmetric_form, 3>    across;  // weighted, at the middle of the edge opposite to the corner
  Symmetric_form                   bubble;  // what lacks at the barycentre

  Vector_of_doubles barycentre() const
  {
    return {(corner[0].x + corner[1].x + corner[2].x) / 3, (corner[0].y + corner[1].y + corner[2].y) / 3};
  }

  double area() const
  {
    return ((corner[1].x - corner[0].x) * (corner[2].y - corner[0].y)
          - (corner[1].y - corner[0].y) * (corner[2].x - corner[0].x)) / 2;
  }

  // how much the metric varies, as the largest distance of a corner's tensor from the middle one
  double variation() const
  {
    return std::max(middle.distance_to(tensor[0]),
                    std::max(middle.distance_to(tensor[1]), middle.distance_to(tensor[2])));
  }

  // To be called when corners, tensors and middle are known. Sizes vary rather
  // linearly than the tensors, which are their inverse powers: the mean of two
  // tensors is scaled so that its determinant is the geometric mean of theirs.
  void prepare_interpolation()
  {
    bubble = middle.weighted;
    for(int i = 0; i < 3; ++i) {
      const Weighted_tensor &p = tensor[(i + 1) % 3], &q = tensor[(i + 2) % 3];
      const Symmetric_form sum = p.weighted + q.weighted;
      across[i] = std::sqrt(p.weighted_area_density * q.weighted_area_density / sum.determinant()) * sum;
      bubble += (1./9) * tensor[i].weighted;
      bubble += (-4./9) * across[i];
    }
    bubble = 27 * bubble;
  }

  // quadratic, with a cubic bubble for the middle
  Symmetric_form weighted_tensor(double l0, double l1, double l2) const
  {
    const double k0 = l0 * (2*l0 - 1), k1 = l1 * (2*l1 - 1), k2 = l2 * (2*l2 - 1);
    const double k12 = 4*l1*l2, k20 = 4*l2*l0, k01 = 4*l0*l1, k = l0*l1*l2;
    const Symmetric_form &s0 = tensor[0].weighted, &s1 = tensor[1].weighted, &s2 = tensor[2].weighted;
    return Symmetric_form(
      k0*s0.a + k1*s1.a + k2*s2.a + k12*across[0].a + k20*across[1].a + k01*across[2].a + k*bubble.a,
      k0*s0.b + k1*s1.b + k2*s2.b + k12*across[0].b + k20*across[1].b + k01*across[2].b + k*bubble.b,
      k0*s0.c + k1*s1.c + k2*s2.c + k12*across[0].c + k20*across[1].c + k01*across[2].c + k*bubble.c);
  }

  Vector_of_doubles at(double l0, double l1, double l2) const
  {
    return {l0*corner[0].x + l1*corner[1].x + l2*corner[2].x,
            l0*corner[0].y + l1*corner[1].y + l2*corner[2].y};
  }
};

// Splits an element that has the generators as its corners, and is acute in
// its middle tensor, by the perpendicular bisectors that meet at its
// circumcentre. The integrals are taken by the midpoint rule on the six
// triangles that these and the circumradii cut out, exact where the tensor is constant.
class Acute_element_integrator
{
public:
  // whether the element is acute; prepares the integration if so
  bool prepare(const Acvt_element& e)
  {
    std::array<double, 3> square;
    for(int i = 0; i < 3; ++i) {
      const Vector_of_doubles &p = e.corner[(i + 1) % 3], &q = e.corner[(i + 2) % 3];
      square[i] = e.middle.m(q.x - p.x, q.y - p.y);
    }
    double sum = 0;
    for(int i = 0; i < 3; ++i) {
      const double cosine = square[(i + 1) % 3] + square[(i + 2) % 3] - square[i];
      if(!(cosine > 0))
        return false;
      m_centre[i] = square[i] * cosine;
      sum += m_centre[i];
    }
    for(double& l : m_centre)
      l /= sum;
    return true;
  }

  double operator()(const Acvt_element& e, const std::array<Region_moments*, 3>& moments) const
  {
    const double third_of_area = e.area() / 3;
    double energy = 0;
    for(int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      // the two triangles at the bisector of the corners i and j
      const double weight = third_of_area * m_centre[k] / 2;
      energy += add_at_edge(e, i, j, k, weight, *moments[i]);
      energy += add_at_edge(e, j, i, k, weight, *moments[j]);
      energy += add_at_bisector(e, i, j, k, weight, *moments[i], *moments[j]);
      energy += add_at_radius(e, k, third_of_area * (m_centre[i] + m_centre[j]) / 2, *moments[k]);
    }
    return energy;
  }

private:
  typedef std::array<double, 3> Coordinates;

  static double add(const Acvt_element& e, const Coordinates& l, double weight, int corner, Region_moments& m)
  {
    const Vector_of_doubles x = e.at(l[0], l[1], l[2]);
    return m.add(weight * e.weighted_tensor(l[0], l[1], l[2]), x.x - e.corner[corner].x, x.y - e.corner[corner].y);
  }

  // between the corner i and the midpoint of the edge ij
  static double add_at_edge(const Acvt_element& e, int i, int j, int k, double weight, Region_moments& m)
  {
    Coordinates l;
    l[i] = 0.75; l[j] = 0.25; l[k] = 0;
    return add(e, l, weight, i, m);
  }

  // between the midpoint of the edge ij and the circumcentre
  double add_at_bisector(const Acvt_element& e, int i, int j, int k, double weight,
                         Region_moments& mi, Region_moments& mj) const
  {
    Coordinates l;
    l[i] = 0.25 + m_centre[i] / 2; l[j] = 0.25 + m_centre[j] / 2; l[k] = m_centre[k] / 2;
    const Vector_of_doubles x = e.at(l[0], l[1], l[2]);
    const Symmetric_form s = weight * e.weighted_tensor(l[0], l[1], l[2]);
    return mi.add(s, x.x - e.corner[i].x, x.y - e.corner[i].y)
         + mj.add(s, x.x - e.corner[j].x, x.y - e.corner[j].y);
  }

  // between the corner k and the circumcentre
  double add_at_radius(const Acvt_element& e, int k, double weight, Region_moments& m) const
  {
    Coordinates l = {m_centre[0] / 2, m_centre[1] / 2, m_centre[2] / 2};
    l[k] += 0.5;
    return add(e, l, weight, k, m);
  }

  Coordinates m_centre; // barycentric coordinates of the circumcentre
};

// Splits an element among any generators by clipping it with their bisectors
// in its middle tensor.
class Clipped_element_integrator
{
public:
  struct Generator
  {
    Vector_of_doubles position;
    Region_moments*   moments;
    std::array<double, 3> squared_distance; // to the corners of the element
  };
  typedef boost::container::static_vector<Generator, 12> Generators;

  double operator()(const Acvt_element& e, const Generators& all) const
  {
    const Generators generators = relevant(e, all);
    double energy = 0;
    for(const Generator& g : generators)
      energy += integrate(e, clipped(g, generators), g);
    return energy;
  }

private:
  struct Coordinates { double l1, l2; }; // barycentric, the first being 1 - l1 - l2
  typedef boost::container::static_vector<Coordinates, 16> Polygon;

  static double at(const std::array<double, 3>& linear, const Coordinates& c)
  {
    return linear[0] + c.l1 * (linear[1] - linear[0]) + c.l2 * (linear[2] - linear[0]);
  }

  // The differences of squared distances are linear, so that a generator which
  // is farther than another one at all corners is farther everywhere.
  static Generators relevant(const Acvt_element& e, Generators all)
  {
    for(Generator& g : all)
      for(int k = 0; k < 3; ++k)
        g.squared_distance[k] = e.middle.m(e.corner[k].x - g.position.x, e.corner[k].y - g.position.y);
    const std::size_t nearest = nearest_to_corner(all, 0);
    if(nearest_to_corner(all, 1) == nearest && nearest_to_corner(all, 2) == nearest)
      return Generators(1, all[nearest]);
    Generators kept;
    for(std::size_t i = 0; i < all.size(); ++i) {
      bool is_beaten = false;
      for(std::size_t j = 0; j < all.size() && !is_beaten; ++j)
        is_beaten = j != i && beats(all[j], all[i]) && !(i < j && beats(all[i], all[j]));
      if(!is_beaten)
        kept.push_back(all[i]);
    }
    return kept;
  }

  static std::size_t nearest_to_corner(const Generators& all, int k)
  {
    std::size_t nearest = 0;
    for(std::size_t i = 1; i < all.size(); ++i)
      if(all[i].squared_distance[k] < all[nearest].squared_distance[k])
        nearest = i;
    return nearest;
  }

  static bool beats(const Generator& g, const Generator& h)
  {
    return g.squared_distance[0] <= h.squared_distance[0] && g.squared_distance[1] <= h.squared_distance[1]
        && g.squared_distance[2] <= h.squared_distance[2];
  }

  static Polygon clipped(const Generator& g, const Generators& generators)
  {
    Polygon polygon = {{0, 0}, {1, 0}, {0, 1}};
    for(const Generator& h : generators) {
      if(&h == &g)
        continue;
      std::array<double, 3> excess;
      for(int k = 0; k < 3; ++k)
        excess[k] = g.squared_distance[k] - h.squared_distance[k];
      polygon = clip(polygon, excess);
    }
    return polygon;
  }

  // the part of the polygon where the linear function is not positive
  static Polygon clip(const Polygon& polygon, const std::array<double, 3>& linear)
  {
    Polygon result;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Coordinates &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double vp = at(linear, p), vq = at(linear, q);
      if(vp <= 0)
        result.push_back(p);
      if((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
        const double t = vp / (vp - vq);
        result.push_back({p.l1 + t * (q.l1 - p.l1), p.l2 + t * (q.l2 - p.l2)});
      }
    }
    return result;
  }

  static double integrate(const Acvt_element& e, const Polygon& polygon, const Generator& g)
  {
    double energy = 0;
    const double area = e.area();
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      const Coordinates &p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
      const double part = (q.l1 - p.l1) * (r.l2 - p.l2) - (q.l2 - p.l2) * (r.l1 - p.l1);
      const double weight = part * area / 3;
      energy += add(e, p, q, weight, g) + add(e, q, r, weight, g) + add(e, r, p, weight, g);
    }
    return energy;
  }

  static double add(const Acvt_element& e, const Coordinates& p, const Coordinates& q, double weight,
                    const Generator& g)
  {
    const double l1 = (p.l1 + q.l1) / 2, l2 = (p.l2 + q.l2) / 2, l0 = 1 - l1 - l2;
    const Vector_of_doubles x = e.at(l0, l1, l2);
    return g.moments->add(weight * e.weighted_tensor(l0, l1, l2), x.x - g.position.x, x.y - g.position.y);
  }
};

} // namespace internal
} // namespace Anisotropic_mesh_2
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ACVT_ELEMENT_H

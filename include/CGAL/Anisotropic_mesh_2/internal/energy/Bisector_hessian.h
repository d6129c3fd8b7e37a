// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_HESSIAN_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_HESSIAN_H

#include <CGAL/Anisotropic_mesh_2/internal/energy/Region_response.h>
#include <CGAL/Anisotropic_mesh_2/internal/metric/Symmetric_form.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Vector_of_doubles.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

// How the mass centres of the regions depend on each other, in single precision: the
// part R of the Hessian 2 A - R of the energy that the motion of the bisectors
// makes, A being the matrices of the regions. R is not negative, and moves that
// are alike everywhere are nearly in the kernel of 2 A - R, which is why Lloyd's
// iteration is slow.
//
// The mixed blocks are stored by blocks of faces, each with its vertices
// numbered on its own. Units, which are powers of two, keep all within the range of
// floats, whatever the size of the domain.
class Bisector_hessian
{
public:
  struct Vector_of_floats { float x = 0, y = 0; };
  typedef std::vector<Vector_of_floats> Vectors_of_floats;

  class Face_block
  {
  public:
    void set_unit(double unit) { m_scale = 1 / unit; }

    void clear(const std::vector<int>& vertices)
    {
      m_vertices = vertices;
      m_faces.clear();
    }

    void add(const std::array<std::uint16_t, 3>& corners, const Face_couplings& c)
    {
      Face face;
      face.corner = corners;
      for(int k = 0; k < 3; ++k)
        face.block[k] = {float(m_scale * c.block[k].xx), float(m_scale * c.block[k].xy),
                         float(m_scale * c.block[k].yx), float(m_scale * c.block[k].yy)};
      m_faces.push_back(face);
    }

    // the product with its own part of the vector, kept until it is added
    void multiply(const Vectors_of_floats& v)
    {
      m_product.assign(m_vertices.size(), {});
      for(const Face& f : m_faces)
        for(int k = 0; k < 3; ++k) {
          const int i = f.corner[(k + 1) % 3], j = f.corner[(k + 2) % 3];
          const std::array<float, 4>& b = f.block[k];
          const Vector_of_floats vi = v[m_vertices[i]], vj = v[m_vertices[j]];
          m_product[i].x += b[0]*vj.x + b[1]*vj.y;
          m_product[i].y += b[2]*vj.x + b[3]*vj.y;
          m_product[j].x += b[0]*vi.x + b[2]*vi.y;
          m_product[j].y += b[1]*vi.x + b[3]*vi.y;
        }
    }

    void subtract_product(Vectors_of_floats& y) const
    {
      for(std::size_t i = 0; i < m_vertices.size(); ++i) {
        y[m_vertices[i]].x -= m_product[i].x;
        y[m_vertices[i]].y -= m_product[i].y;
      }
    }

  private:
    struct Face
    {
      std::array<std::uint16_t, 3>        corner;
      std::array<std::array<float, 4>, 3> block; // xx, xy, yx, yy by the opposite corner
    };

    double            m_scale = 1;
    std::vector<int>  m_vertices;
    std::vector<Face> m_faces;
    Vectors_of_floats m_product;
  };

  // For these numbers of blocks of faces and of vertices; the blocks are then to be filled.
  // `length` and `stiffness` are typical values of vectors and of R.
  void resize(std::size_t number_of_blocks, std::size_t number_of_vertices, double length, double stiffness)
  {
    m_blocks.resize(number_of_blocks);
    m_responses.assign(number_of_vertices, {});
    m_unit_of_length = power_of_two(length);
    m_unit_of_stiffness = power_of_two(stiffness);
    for(Face_block& b : m_blocks)
      b.set_unit(m_unit_of_stiffness);
  }

  Face_block& block(std::size_t b) { return m_blocks[b]; }

  double unit_of_length() const { return m_unit_of_length; }
  double unit_of_stiffness() const { return m_unit_of_stiffness; }

  void add_response(int vertex, const Symmetric_form& r)
  {
    std::array<float, 3>& sum = m_responses[vertex];
    sum[0] += float(r.a / m_unit_of_stiffness);
    sum[1] += float(r.b / m_unit_of_stiffness);
    sum[2] += float(r.c / m_unit_of_stiffness);
  }

  // y = R v, by the indices of the vertices and in the unit of stiffness
  template <class ConcurrencyTag>
  void multiply(const Vectors_of_floats& v, Vectors_of_floats& y)
  {
    for_each_task<ConcurrencyTag>(m_blocks.size(), [&](std::size_t b) { m_blocks[b].multiply(v); });
    y.resize(v.size());
    for_each_index<ConcurrencyTag>(v.size(), [&](std::size_t i) {
      const std::array<float, 3>& r = m_responses[i];
      y[i] = {r[0]*v[i].x + r[1]*v[i].y, r[1]*v[i].x + r[2]*v[i].y};
    });
    for(const Face_block& b : m_blocks)
      b.subtract_product(y);
  }

private:
  static double power_of_two(double x)
  {
    int exponent;
    std::frexp(x, &exponent);
    return std::ldexp(1., exponent);
  }

  double m_unit_of_length = 1, m_unit_of_stiffness = 1;
  std::vector<Face_block>            m_blocks;
  std::vector<std::array<float, 3> > m_responses; // a, b, c
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_ENERGY_BISECTOR_HESSIAN_H

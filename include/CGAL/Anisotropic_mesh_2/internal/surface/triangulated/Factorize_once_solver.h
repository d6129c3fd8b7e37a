// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_FACTORIZE_ONCE_SOLVER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_FACTORIZE_ONCE_SOLVER_H

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/SparseLU>

#include <memory>

namespace CGAL::Anisotropic_mesh_2::internal {

// A model of `SparseLinearAlgebraTraits_d` for a sequence of systems with the
// matrix of the first, which alone is factorized.
class Factorize_once_solver
{
public:
  typedef double                        NT;
  typedef Eigen_sparse_matrix<double>   Matrix;
  typedef Eigen_vector<double>          Vector;

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d)
  {
    d = 1;
    if(!m_factors) {
      m_factors = std::make_shared<Factors>();
      m_factors->compute(a.eigen_object());
    }
    if(m_factors->info() != Eigen::Success)
      return false;
    x = m_factors->solve(b);
    return m_factors->info() == Eigen::Success;
  }

private:
  typedef Eigen::SparseLU<Matrix::EigenType> Factors;

  std::shared_ptr<Factors> m_factors; // copyable, which the factors are not
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_SURFACE_TRIANGULATED_FACTORIZE_ONCE_SOLVER_H

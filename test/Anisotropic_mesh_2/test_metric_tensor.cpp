// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Metric tensors against Eigen, and which of them are refused.

#include "include/check.h"

#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/difference_of_products.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/Time_budget.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Isotropic_metric_field_2.h>
#include <CGAL/Metric_tensor_2.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Exact_predicates_exact_constructions_kernel     Exact;
typedef CGAL::Metric_tensor_2<Kernel>                         Tensor;
typedef CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception                 Invalid;
typedef Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>        Solver;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Eigen::Matrix2d matrix(double a, double b, double c)
{
  Eigen::Matrix2d m;
  m << a, b, b, c;
  return m;
}
Eigen::Matrix2d matrix(const Tensor& m) { return matrix(m.m11(), m.m12(), m.m22()); }

bool is_close(double x, double y, double tolerance) { return std::abs(x - y) <= tolerance * std::abs(y); }
bool is_close(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b, double tolerance)
{
  return (a - b).norm() <= tolerance * b.norm();
}

// R^T diag(1/h1^2, 1/h2^2) R
Eigen::Matrix2d from_definition(double h1, double h2, double angle)
{
  const Eigen::Matrix2d r = Eigen::Rotation2Dd(-angle).toRotationMatrix();
  return r.transpose() * Eigen::Vector2d(1 / (h1*h1), 1 / (h2*h2)).asDiagonal() * r;
}

void test_against_eigen()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-6, 6), angle(-7, 7), ratio(0, 4);
  for(int i = 0; i < 2000; ++i) {
    const double h1 = std::pow(10, exponent(random)), h2 = h1 * std::pow(10, ratio(random)), t = angle(random);
    const Tensor m = Tensor::from_sizes(h1, h2, t);
    CHECK(is_close(matrix(m), from_definition(h1, h2, t), 1e-14));
    const Solver solver(matrix(m));
    const double condition = (h2 / h1) * (h2 / h1);
    const Tensor::Sizes s = m.sizes();
    CHECK(s.h1 <= s.h2);
    CHECK(is_close(s.h1, 1 / std::sqrt(solver.eigenvalues()[1]), 1e-14));
    CHECK(is_close(s.h2, 1 / std::sqrt(solver.eigenvalues()[0]), 1e-15 * condition + 1e-14));
    CHECK(is_close(s.h2, h2, 1e-15 * condition + 1e-14));
    const Eigen::Vector2d axis = solver.eigenvectors().col(1);
    if(condition > 1.1)
      CHECK(std::abs(std::cos(s.angle) * axis.y() - std::sin(s.angle) * axis.x()) < 1e-13);
    CHECK(is_close(m.determinant(), 1 / (h1*h1*h2*h2), 1e-15 * condition + 1e-13));
    CHECK(is_close(m.area_density(), 1 / (h1*h2), 1e-15 * condition + 1e-13));

    const std::array<double, 3> l = m.logarithm();
    const Eigen::Matrix2d log_of_eigen = solver.eigenvectors()
      * solver.eigenvalues().array().log().matrix().asDiagonal() * solver.eigenvectors().transpose();
    CHECK(is_close(matrix(l[0], l[1], l[2]), log_of_eigen, 1e-15 * condition + 1e-12));
    CHECK(is_close(matrix(Tensor::from_logarithm(l)), matrix(m), 1e-12));
  }
}

void test_measuring()
{
  const Tensor m = Tensor::from_entries(4, 1, 3);
  CHECK(m.squared_length(2, -1) == 4*4 - 4 + 3);
  CHECK(m.squared_length(Kernel::Vector_2(2, -1)) == 15);
  CHECK(m.scalar_product(Kernel::Vector_2(1, 0), Kernel::Vector_2(0, 1)) == 1);
  CHECK(m.scaled(2) == Tensor::from_entries(1, 0.25, 0.75));
  CHECK(Tensor() == Tensor::from_size(1));
  CHECK(Tensor::from_sizes(0.5, 2) == Tensor::from_entries(4, 0, 0.25));
  CHECK(Tensor::from_sizes(0.5, 2) != Tensor::from_sizes(2, 0.5));
  CHECK(CGAL::Metric_tensor_2<Exact>::from_entries(4, 1, 3).determinant() == 11);
}

// nearly singular tensors are neither refused nor wrong
void test_large_ratios()
{
  for(double ratio : {1e3, 1e5, 1e7})
    for(double angle = 0; angle < 3.2; angle += 0.1) {
      const Tensor m = Tensor::from_sizes(1, ratio, angle);
      CHECK(m.determinant() > 0);
      CHECK(is_close(m.sizes().h1, 1, 1e-12));
    }
  const double s = std::sqrt(0.5); // a determinant that a plain difference would get wrong
  const Tensor m = Tensor::from_entries(1 + 1e-12, 1, 1);
  CHECK(is_close(m.determinant(), (1 + 1e-12) - 1, 1e-15));
  CHECK(std::abs(std::cos(m.sizes().angle) - s) < 1e-6);
}

void test_refusals()
{
  CHECK_THROWS(Tensor::from_entries(not_a_number, 0, 1), Invalid, "m11 = nan, m12 = 0, m22 = 1 is not finite");
  CHECK_THROWS(Tensor::from_entries(1, not_a_number, 1), Invalid, "m12 = nan");
  CHECK_THROWS(Tensor::from_entries(1, 0, infinity), Invalid, "m22 = inf");
  CHECK_THROWS(Tensor::from_entries(1, -infinity, 1), Invalid, "m12 = -inf");
  CHECK_THROWS(Tensor::from_entries(-1, 0, -2), Invalid, "m11 = -1, m12 = 0, m22 = -2");
  CHECK_THROWS(Tensor::from_entries(1, 2, 1), Invalid, "m11 = 1, m12 = 2, m22 = 1"); // indefinite
  CHECK_THROWS(Tensor::from_entries(1, 1, 1), Invalid, "m12 = 1");                   // singular
  CHECK_THROWS(Tensor::from_entries(0, 0, 0), Invalid, "m11 = 0");
  CHECK_THROWS(Tensor::from_entries(0.1, 2, 1), Invalid, "m11 = 0.1");
  CHECK_THROWS(Tensor::from_sizes(0, 1), Invalid, "h1 = 0, h2 = 1, theta = 0");
  CHECK_THROWS(Tensor::from_sizes(1, -2, 0.5), Invalid, "h2 = -2, theta = 0.5");
  CHECK_THROWS(Tensor::from_sizes(infinity, 1), Invalid, "h1 = inf");
  CHECK_THROWS(Tensor::from_sizes(1, 1, not_a_number), Invalid, "theta = nan");
  CHECK_THROWS(Tensor::from_sizes(1, not_a_number, 1), Invalid, "h2 = nan");
  CHECK_THROWS(Tensor::from_size(1e-200), Invalid, "not finite"); // overflows
  CHECK_THROWS(Tensor().scaled(0), Invalid, "scaled by 0");
  CHECK_THROWS(Tensor().scaled(not_a_number), Invalid, "scaled by nan");
  CHECK_THROWS(CGAL::Metric_tensor_2<Exact>::from_entries(1, 1, 1), Invalid, "m11 = 1, m12 = 1, m22 = 1");
}

// with the point, once
void test_refusals_at_points()
{
  CHECK_THROWS(throw Invalid("the tensor").at(0.5, -2), Invalid, "the tensor at the point (0.5, -2)");
  const auto field = CGAL::make_isotropic_metric_field_2<Kernel>([](const Kernel::Point_2& p) { return p.x(); });
  CHECK_THROWS(field(Kernel::Point_2(-3, 4)), Invalid, "the metric of size -3 is not positive definite at the point (-3, 4)");
  const auto outer = CGAL::make_isotropic_metric_field_2<Kernel>([&](const Kernel::Point_2& p) {
    return field(p).sizes().h1;
  });
  std::string message;
  try {
    outer(Kernel::Point_2(0, 7));
  }
  catch(const Invalid& e) {
    message = e.what();
  }
  CHECK(message.find("at the point (0, 7)") != std::string::npos);
  CHECK(message.find(" at ") == message.rfind(" at "));
}

// What tensors rest on: products that nearly cancel, numbers in messages, which read back as the same, and sums.
void test_numbers()
{
  using namespace CGAL::Anisotropic_mesh_2::internal;
  const double tiny = std::ldexp(1., -30);
  CHECK(difference_of_products(1 + tiny, 1 - tiny, 1., 1.) == -tiny * tiny);
  CHECK(difference_of_products(3., 5., 2., 4.) == 7);
  CHECK(describe(0.1) == "0.1" && describe(0.1 + 0.2) == "0.30000000000000004" && describe(1e22) == "1e+22");
  CHECK(sum_over<CGAL::Sequential_tag>(5000, [](std::size_t i) { return double(i); }) == 4999 * 2500);
}

// What is left of a limit that has passed is not 0, which would stand for no limit.
void test_time_budget()
{
  typedef CGAL::Anisotropic_mesh_2::internal::Time_budget Budget;
  const Budget none(0), past(1e-6), ample(1000);
  while(none.spent() < 1e-4) {}
  CHECK(!none.is_spent() && none.remaining() == 0);
  CHECK(past.is_spent() && past.remaining() > 0 && past.remaining() < 1e-6);
  CHECK(!ample.is_spent() && ample.remaining() < 1000 && ample.remaining() > 900);
}

int main()
{
  test_numbers();
  test_time_budget();
  test_against_eigen();
  test_measuring();
  test_large_ratios();
  test_refusals();
  test_refusals_at_points();
  return finish();
}

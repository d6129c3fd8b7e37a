// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TIME_BUDGET_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TIME_BUDGET_H

#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL::Anisotropic_mesh_2::internal {

// The seconds that are left of a limit, where 0 stands for none, as in the named parameter.
class Time_budget
{
public:
  explicit Time_budget(double limit) : m_limit(limit)
  {
    CGAL_precondition(limit >= 0);
    m_timer.start();
  }

  double spent() const { return m_timer.time(); }
  bool is_spent() const { return m_limit > 0 && spent() >= m_limit; }
  double remaining() const { return m_limit > 0 ? (std::max)(m_limit - spent(), 1e-9) : 0; }

private:
  double     m_limit;
  Real_timer m_timer;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_TIME_BUDGET_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_RECORDING_VISITOR_H
#define ANISOTROPIC_MESH_2_TEST_RECORDING_VISITOR_H

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>

#include <vector>

// Writes down the states that an optimizer reports.
class Recording_visitor
{
public:
  explicit Recording_visitor(std::vector<CGAL::Anisotropic_mesh_2::Optimization_state>& states) : m_states(&states) {}

  bool iteration(const CGAL::Anisotropic_mesh_2::Optimization_state& s)
  {
    m_states->push_back(s);
    return true;
  }

private:
  std::vector<CGAL::Anisotropic_mesh_2::Optimization_state>* m_states;
};

#endif // ANISOTROPIC_MESH_2_TEST_RECORDING_VISITOR_H

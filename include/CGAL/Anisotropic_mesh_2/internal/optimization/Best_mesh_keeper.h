// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_BEST_MESH_KEEPER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_BEST_MESH_KEEPER_H

#include <CGAL/Anisotropic_mesh_2/Optimization_state.h>

namespace CGAL::Anisotropic_mesh_2::internal {

// A visitor that looks at the merit of the mesh in some of the iterations before
// it passes the state on, and has the best mesh kept.
template <class Merit, class Mover, class Visitor>
class Best_mesh_keeper
{
public:
  Best_mesh_keeper(const Merit& merit, Mover& mover, Visitor& visitor)
    : m_merit(merit), m_mover(mover), m_visitor(visitor)
  {}

  bool iteration(const Optimization_state& s)
  {
    if(s.evaluations == 1)
      m_given = m_best = {m_merit(s), s};
    else if(s.iteration % iterations_between == 0)
      if(const double merit = m_merit(s); merit > m_best.merit) {
        m_best = {merit, s};
        m_mover.keep();
      }
    return m_visitor.iteration(s);
  }

  // Called at the end: sets back the mesh if it is worse than that of the beginning or
  // clearly worse than the best one. Returns the state of the mesh that remains.
  Optimization_state choose(const Optimization_state& last)
  {
    const double merit = m_merit(last);
    if(merit >= m_given.merit && merit >= m_best.merit - slack)
      return last;
    if(m_best.merit > m_given.merit) {
      m_mover.restore_kept();
      m_mover.finish();
      if(m_merit(m_best.state) >= m_given.merit) // also in the field itself, and after flips
        return m_best.state;
    }
    m_mover.restore_given();
    m_is_better = false;
    return m_given.state;
  }

  // whether what remains is not the mesh of the beginning
  bool is_better() const { return m_is_better; }

private:
  static constexpr int    iterations_between = 5;
  static constexpr double slack = 0.002; // of merit: so much the energy is worth

  struct Judged
  {
    double             merit = 0;
    Optimization_state state;
  };

  const Merit& m_merit;
  Mover&       m_mover;
  Visitor&     m_visitor;
  Judged       m_given, m_best;
  bool         m_is_better = true;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_BEST_MESH_KEEPER_H

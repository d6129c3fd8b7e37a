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
// it passes the state on, and has the best mesh kept. A judge, who is told the merit and may look closer, decides
// whether what remains is better than the mesh of the beginning.
template <class Merit, class Judge, class Mover, class Visitor>
class Best_mesh_keeper
{
public:
  Best_mesh_keeper(const Merit& merit, const Judge& judge, Mover& mover, Visitor& visitor)
    : m_merit(merit), m_judge(judge), m_mover(mover), m_visitor(visitor)
  {}

  bool iteration(const Optimization_state& s)
  {
    if(s.evaluations == 1) {
      const double merit = m_merit(s);
      m_given = m_best = {merit, m_judge(merit), s};
    }
    else if(s.iteration % iterations_between == 0)
      if(const double merit = m_merit(s); merit > m_best.merit) {
        m_best = {merit, 0, s};
        m_mover.keep();
      }
    return m_visitor.iteration(s);
  }

  // Called at the end: sets back the mesh if it is worse than that of the beginning or
  // clearly worse than the best one. Returns the state of the mesh that remains.
  Optimization_state choose(const Optimization_state& last)
  {
    if(const double merit = m_merit(last); merit >= m_best.merit - slack && m_judge(merit) >= m_given.judged)
      return last;
    if(m_best.merit > m_given.merit) {
      m_mover.restore_kept();
      m_mover.finish();
      if(m_judge(m_merit(m_best.state)) >= m_given.judged)
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
    double             merit = 0, judged = 0;
    Optimization_state state;
  };

  const Merit& m_merit;
  const Judge& m_judge;
  Mover&       m_mover;
  Visitor&     m_visitor;
  Judged       m_given, m_best;
  bool         m_is_better = true;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_OPTIMIZATION_BEST_MESH_KEEPER_H

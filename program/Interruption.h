// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_INTERRUPTION_H
#define ANISOTROPIC_MESH_2_PROGRAM_INTERRUPTION_H

#include <csignal>

namespace program {

// While it lives, the first interrupt from the keyboard only sets a flag, so that
// the work can be ended in good order; the second one ends the program.
class Interruption
{
public:
  Interruption()
  {
    is_wanted() = 0;
    m_former = std::signal(SIGINT, note);
  }

  ~Interruption() { std::signal(SIGINT, m_former); }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static volatile std::sig_atomic_t& is_wanted()
  {
    static volatile std::sig_atomic_t flag = 0; // signal handlers reach nothing else
    return flag;
  }

private:
  static void note(int)
  {
    is_wanted() = 1;
    std::signal(SIGINT, SIG_DFL);
  }

  void (*m_former)(int);
};

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_INTERRUPTION_H

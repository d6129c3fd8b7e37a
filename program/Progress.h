// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_PROGRESS_H
#define ANISOTROPIC_MESH_2_PROGRAM_PROGRESS_H

#include "Options.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace program {

// Reports progress on standard error: always if asked, never if asked to
// be quiet, else if somebody is there to read. A terminal keeps one line for
// all iterations.
class Progress
{
public:
  explicit Progress(Verbosity verbosity)
    : m_is_terminal(isatty(STDERR_FILENO) == 1)
    , m_is_on(verbosity == Verbosity::VERBOSE || (verbosity == Verbosity::NORMAL && m_is_terminal))
    , m_overwrites(m_is_terminal && verbosity != Verbosity::VERBOSE)
  {}

  ~Progress() { end_line(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // a stage of the work
  void say(const std::string& text)
  {
    if(!m_is_on)
      return;
    end_line();
    std::fprintf(stderr, "%s\n", text.c_str());
  }

  // something that the user must know, however quiet the program is
  void warn(const std::string& text)
  {
    end_line();
    std::fprintf(stderr, "anisotropic_mesh_2: %s\n", text.c_str());
  }

  // one of many similar lines
  void update(const std::string& text)
  {
    if(!m_is_on)
      return;
    if(!m_overwrites)
      return say(text);
    std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
    std::fflush(stderr);
    m_is_in_line = true;
  }

  // to be called before anything else is written to standard error
  void end_line()
  {
    if(m_is_in_line)
      std::fprintf(stderr, "\n");
    m_is_in_line = false;
  }

private:
  bool m_is_terminal, m_is_on, m_overwrites;
  bool m_is_in_line = false;
};

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_PROGRESS_H

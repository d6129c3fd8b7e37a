// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the fuzz targets of the file readers share: the input as files, and what
// a reader may do with them.

#ifndef ANISOTROPIC_MESH_2_TEST_FUZZ_READER_H
#define ANISOTROPIC_MESH_2_TEST_FUZZ_READER_H

#include "require.h"
#include "../include/scratch_directory.h"

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel  Kernel;

// The files of one input. A line "---" in the input begins the second file; without it there is none.
class Input_files
{
public:
  // `names` are those of the two files
  Input_files(const std::uint8_t* data, std::size_t size, const std::array<std::string, 2>& names)
  {
    const std::string text(data, data + size), separator = "\n---\n";
    const std::size_t end = text.find(separator);
    m_texts[0] = text.substr(0, end);
    if(end != std::string::npos)
      m_texts[1] = text.substr(end + separator.size());
    for(int i = 0; i < 2; ++i)
      m_files[i] = directory().file(names[i], m_texts[i]);
    if(end == std::string::npos)
      std::filesystem::remove(m_files[1]);
  }

  const std::string& operator[](int i) const { return m_files[i]; }

  static const Scratch_directory& directory()
  {
    static const Scratch_directory scratch;
    return scratch;
  }

  // names one of the files and, if any, a line that it has
  void check(const CGAL::Mesh_io_exception& e) const
  {
    require_readable(e.what());
    const auto place = std::find(m_files.begin(), m_files.end(), e.file());
    require(place != m_files.end(), "a complaint about a file that was given: " + e.file());
    const std::string& text = m_texts[place - m_files.begin()];
    const std::string start = e.file() + ':' + (e.line() > 0 ? std::to_string(e.line()) + ':' : "");
    require(std::string(e.what()).find(start) == 0, "file and line first: " + std::string(e.what()));
    const auto newlines = std::count(text.begin(), text.end(), '\n');
    require(e.line() <= static_cast<std::size_t>(newlines) + 1, "a line of the file: " + std::string(e.what()));
  }

private:
  std::array<std::string, 2> m_texts, m_files;
};

// the result of `read()`, or nothing if it refuses the files as documented
template <class Read>
auto read_or_refuse(const Input_files& files, const Read& read) -> std::optional<decltype(read())>
{
  try {
    return read();
  }
  catch(const CGAL::Mesh_io_exception& e) {
    files.check(e);
    return std::nullopt;
  }
}

#endif // ANISOTROPIC_MESH_2_TEST_FUZZ_READER_H

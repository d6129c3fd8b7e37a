// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_SCRATCH_DIRECTORY_H
#define ANISOTROPIC_MESH_2_TEST_SCRATCH_DIRECTORY_H

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

// A directory of its own for the files of a test, removed at the end.
class Scratch_directory
{
public:
  Scratch_directory()
    : m_path(std::filesystem::temp_directory_path() / ("anisotropic_mesh_2_" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(m_path);
  }
  ~Scratch_directory() { std::filesystem::remove_all(m_path); }

  std::string operator/(const std::string& name) const { return (m_path / name).string(); }

  // writes the text to a file and returns its name
  std::string file(const std::string& name, const std::string& text) const
  {
    std::ofstream(*this / name, std::ios::binary) << text;
    return *this / name;
  }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(m_path),
                                                  std::filesystem::directory_iterator()));
  }

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

inline std::string content_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

#endif // ANISOTROPIC_MESH_2_TEST_SCRATCH_DIRECTORY_H

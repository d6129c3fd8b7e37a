// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_PROGRAM_SAFE_OUTPUT_FILE_H
#define ANISOTROPIC_MESH_2_PROGRAM_SAFE_OUTPUT_FILE_H

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>

#include <CGAL/assertions.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

namespace program {

// An output file that appears under its name only when it is complete.
//
// What is written goes to a temporary file in the same directory. commit()
// gives it its name and replaces a file of that name; a destruction without
// commit() removes it and leaves the old file untouched. Links are followed.
// What is no regular file (/dev/stdout, a pipe) is written directly.
//
// All failures are reported by Mesh_io_exception, with the name of the file.
class Safe_output_file
{
public:
  explicit Safe_output_file(const std::string& file)
    : m_name(file), m_target(followed(file)), m_is_direct(is_special(m_target))
  {
    refuse_unwritable_target();
    if(!m_is_direct)
      create_temporary();
    errno = 0;
    m_stream.open(m_is_direct ? m_target : m_temporary, std::ios::out | std::ios::binary);
    if(!m_stream) {
      const std::string reason = last_error();
      discard();
      fail("cannot be opened for writing", reason);
    }
  }

  Safe_output_file(const Safe_output_file&) = delete;
  Safe_output_file& operator=(const Safe_output_file&) = delete;

  ~Safe_output_file() { discard(); }

  std::ostream& stream() { return m_stream; }

  // to be called once, at the end
  void commit()
  {
    CGAL_precondition(!m_is_committed);
    if(m_stream) // else the reason is an earlier one
      errno = 0;
    m_stream.close(); // sets failbit when the last bytes do not get through
    if(!m_stream) {
      const std::string reason = last_error();
      discard();
      fail("could not be written completely", reason);
    }
    if(!m_is_direct)
      rename_temporary();
    m_is_committed = true;
  }

private:
  typedef std::filesystem::path Path;

  static Path followed(const std::string& file)
  {
    std::error_code error;
    const Path target = std::filesystem::canonical(file, error);
    return error ? Path(file) : target;
  }

  static bool is_special(const Path& target)
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  }

  // Renaming would replace a write-protected file without a word.
  void refuse_unwritable_target() const
  {
    std::error_code error;
    if(m_name.empty())
      throw CGAL::Mesh_io_exception("''", "cannot be opened for writing: the name is empty");
    if(std::filesystem::is_directory(m_target, error))
      fail("cannot be opened for writing", "it is a directory");
    if(m_is_direct || !std::filesystem::exists(m_target, error))
      return;
    errno = 0;
    if(!std::ofstream(m_target, std::ios::app))
      fail("cannot be opened for writing", last_error());
  }

  // mode "x" refuses names that exist, so no other file is ever overwritten
  void create_temporary()
  {
    std::random_device random;
    for(int attempt = 0; attempt < 100; ++attempt) {
      m_temporary = m_target;
      m_temporary += ".tmp" + std::to_string(random() % 1000000000u);
      errno = 0;
      if(std::FILE* f = std::fopen(m_temporary.string().c_str(), "wx")) {
        std::fclose(f);
        keep_permissions();
        return;
      }
      if(errno != EEXIST)
        break;
    }
    const std::string reason = last_error();
    m_temporary.clear();
    fail("cannot be opened for writing", reason);
  }

  void keep_permissions() const
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(m_target, error);
    if(std::filesystem::exists(status))
      std::filesystem::permissions(m_temporary, status.permissions(), error);
  }

  void rename_temporary()
  {
    std::error_code error;
    std::filesystem::rename(m_temporary, m_target, error);
    if(error) {
      discard();
      fail("could not be renamed from its temporary name", error.message());
    }
    m_temporary.clear();
  }

  void discard() noexcept
  {
    if(m_temporary.empty())
      return;
    std::error_code error;
    m_stream.close();
    std::filesystem::remove(m_temporary, error);
    m_temporary.clear();
  }

  static std::string last_error()
  {
    return errno == 0 ? "unknown reason" : std::generic_category().message(errno);
  }

  [[noreturn]] void fail(const std::string& what, const std::string& reason) const
  {
    throw CGAL::Mesh_io_exception(m_name, what + ": " + reason);
  }

  std::string   m_name;
  Path          m_target, m_temporary;
  bool          m_is_direct, m_is_committed = false;
  std::ofstream m_stream;
};

// lets `write` fill the file, which appears only when that is done
template <class Write>
void write_safely(const std::string& file, const Write& write)
{
  Safe_output_file out(file);
  write(out.stream());
  out.commit();
}

} // namespace program

#endif // ANISOTROPIC_MESH_2_PROGRAM_SAFE_OUTPUT_FILE_H

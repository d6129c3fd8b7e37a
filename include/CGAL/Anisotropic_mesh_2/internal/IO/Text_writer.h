// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_WRITER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_WRITER_H

#include <charconv>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Anisotropic_mesh_2::internal {

// Text in large blocks, the last of which `flush()` writes. Numbers have the fewest digits that give the same
// double back, whatever the stream's precision and locale are.
class Text_writer
{
public:
  explicit Text_writer(std::ostream& os) : m_os(os) {}
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;

  Text_writer& operator<<(std::string_view s)
  {
    m_buffer += s;
    if(m_buffer.size() > (1 << 16))
      flush();
    return *this;
  }

  Text_writer& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Text_writer& operator<<(Number x)
  {
    char digits[32];
    const std::to_chars_result result = std::to_chars(digits, digits + sizeof digits, x);
    return *this << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
  }

  void flush()
  {
    m_os << m_buffer;
    m_buffer.clear();
  }

private:
  std::ostream& m_os;
  std::string   m_buffer;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_WRITER_H

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_SCANNER_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_SCANNER_H

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL::Anisotropic_mesh_2::internal {

// The words of a text file. Words are separated by white space, and '#' begins
// a comment that ends with its line. Every complaint names the file, the line,
// the item that was being read, what was expected and what was found.
class Text_scanner
{
public:
  explicit Text_scanner(const std::string& file) : m_file(file), m_text(content(file)) {}

  const std::string& file() const { return m_file; }
  std::string_view text() const { return m_text; }
  bool ends_with_newline() const { return !m_text.empty() && m_text.back() == '\n'; }

  // the item that complaints are to name: `kind` `index` of `total`
  void set_item(const char* kind, std::size_t index = 0, std::size_t total = 0)
  {
    m_kind = kind;
    m_index = index;
    m_total = total;
  }

  // calls `read(i)` for each of `n` items
  template <class Read>
  void read_items(const char* kind, std::size_t n, const Read& read)
  {
    for(std::size_t i = 0; i < n; ++i) {
      set_item(kind, i + 1, n);
      read(i);
    }
  }

  std::size_t position() const { return m_position; }
  void move_to(std::size_t position) { m_position = m_word = position; }

  // how many items of that many words the rest of the text can hold at most
  std::size_t at_most(std::size_t count, std::size_t words) const
  {
    return (std::min)(count, (m_text.size() - m_position) / (2 * words) + 1);
  }

  bool is_at_end()
  {
    skip_blanks(false);
    return m_position == m_text.size();
  }

  bool is_at_end_of_line()
  {
    skip_blanks(true);
    return m_position == m_text.size() || m_text[m_position] == '\n';
  }

  void expect_end_of_line(const char* why)
  {
    if(!is_at_end_of_line())
      mismatch("the end of the line", next_word(), why);
  }

  // the next word of the text, empty at its end
  std::string_view next_word()
  {
    skip_blanks(false);
    return cut_word();
  }

  // From here on, words are to be found on the current line.
  void begin_line()
  {
    skip_blanks(false);
    m_one_line = true;
  }

  std::string_view word(const char* expected)
  {
    skip_blanks(m_one_line);
    const std::string_view w = cut_word();
    if(w.empty())
      mismatch(expected, w);
    return w;
  }

  void skip_string(const char* expected)
  {
    skip_blanks(m_one_line);
    const std::size_t end = m_position < m_text.size() && m_text[m_position] == '"'
                          ? m_text.find('"', m_position + 1) : std::string::npos;
    if(end == std::string::npos)
      mismatch(expected, word(expected));
    m_position = end + 1;
  }

  double number(const char* expected)
  {
    const std::string_view w = word(expected);
    double x = 0;
    if(!convert(w, x))
      mismatch(expected, w);
    if(!std::isfinite(x))
      mismatch(expected, w, "which is not finite");
    return x;
  }

  template <class Integer>
  Integer integer(const char* expected)
  {
    const std::string_view w = word(expected);
    const char* const end = w.data() + w.size();
    Integer n = 0;
    const std::from_chars_result result = std::from_chars(without_plus(w), end, n);
    if(result.ptr != end || result.ec == std::errc::invalid_argument)
      mismatch(expected, w, "which is not an integer");
    if(result.ec == std::errc::result_out_of_range)
      mismatch(expected, w, "which is out of range");
    return n;
  }

  // a number of items
  std::size_t count(const char* expected)
  {
    const long long n = integer<long long>(expected);
    if(n < 0)
      mismatch(expected, last_word(), "which is negative");
    return static_cast<std::size_t>(n);
  }

  // an index between `first` and `last`; the result starts at 0
  std::size_t index(const char* expected, long long first, long long last)
  {
    const long long n = integer<long long>(expected);
    if(n < first || n > last)
      mismatch(expected, last_word(), out_of_range(first, last));
    return static_cast<std::size_t>(n - first);
  }

  static std::string out_of_range(long long first, long long last)
  {
    return last < first ? "but there is none"
                        : "which is not between " + std::to_string(first) + " and " + std::to_string(last);
  }

  // the word as messages show it, however long and strange it is
  static std::string printable(std::string_view w)
  {
    std::string shown;
    for(char c : w.substr(0, 40))
      shown += c >= 0x20 && c < 0x7f ? c : '?';
    return w.size() > 40 ? shown + "..." : shown;
  }

  std::string_view last_word() const { return std::string_view(m_text).substr(m_word, m_position - m_word); }

  [[noreturn]] void mismatch(const std::string& expected, std::string_view found,
                             const std::string& comment = std::string()) const
  {
    fail("expected " + expected + ", found " + quoted(found) + (comment.empty() ? "" : ", ") + comment);
  }

  // complains about the word that was read last
  [[noreturn]] void fail(const std::string& what) const
  {
    std::string item;
    if(m_kind != nullptr)
      item = m_kind + (m_total == 0 ? "" : ' ' + std::to_string(m_index) + " of " + std::to_string(m_total)) + ": ";
    throw Mesh_io_exception(m_file, line(), item + what);
  }

private:
  static std::string content(const std::string& file)
  {
    std::error_code error;
    if(std::filesystem::is_directory(file, error))
      throw Mesh_io_exception(file, "cannot be read: it is a directory");
    std::ifstream in(file, std::ios::binary);
    if(!in)
      throw Mesh_io_exception(file, std::filesystem::exists(file, error)
                                    ? "cannot be opened for reading" : "there is no such file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::string text;
    if(!error)
      text.reserve(static_cast<std::size_t>(size));
    std::string block(1 << 16, '\0');
    while(in.read(&block[0], static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
      text.append(block, 0, static_cast<std::size_t>(in.gcount()));
    if(in.bad())
      throw Mesh_io_exception(file, "cannot be read to its end");
    return text;
  }

  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_blanks(bool stay_on_line)
  {
    const std::size_t size = m_text.size();
    while(m_position < size) {
      const char c = m_text[m_position];
      if(c == '#')
        m_position = (std::min)(m_text.find('\n', m_position), size);
      else if(is_blank(c) && !(stay_on_line && c == '\n'))
        ++m_position;
      else
        return;
    }
  }

  std::string_view cut_word()
  {
    m_word = m_position;
    while(m_position < m_text.size() && !is_blank(m_text[m_position]) && m_text[m_position] != '#')
      ++m_position;
    return last_word();
  }

  // Returns whether the word is a number, whatever the locale of the program is; infinity if it is too large.
  static bool convert(std::string_view w, double& x)
  {
#ifdef __cpp_lib_to_chars // streams are slower, but some standard libraries have nothing else for double
    const char* const end = w.data() + w.size();
    const std::from_chars_result result = std::from_chars(without_plus(w), end, x);
    if(result.ec != std::errc::result_out_of_range)
      return result.ec == std::errc() && result.ptr == end;
#endif
    std::istringstream in{std::string(w)};
    in.imbue(std::locale::classic());
    in >> x;
    if(in.fail() && std::abs(x) > 1)
      x = std::numeric_limits<double>::infinity();
    return in.eof() && (!in.fail() || std::isinf(x));
  }

  static const char* without_plus(std::string_view w)
  {
    return w.size() > 1 && w[0] == '+' && w[1] != '-' ? w.data() + 1 : w.data();
  }

  std::size_t line() const
  {
    const std::size_t at = (std::min)(m_word, m_text.size());
    const auto begin = m_text.begin();
    std::size_t lines = 1 + std::count(begin, begin + at, '\n');
    const bool behind_the_last_line = at > 0 && at == m_text.size() && m_text[at - 1] == '\n';
    return behind_the_last_line ? lines - 1 : lines;
  }

  std::string quoted(std::string_view w) const
  {
    if(w.empty())
      return m_position < m_text.size() ? "the end of the line" : "the end of the file";
    return '\'' + printable(w) + '\'';
  }

  std::string m_file, m_text;
  std::size_t m_position = 0, m_word = 0;
  const char* m_kind = nullptr;
  std::size_t m_index = 0, m_total = 0;
  bool        m_one_line = false;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_TEXT_SCANNER_H

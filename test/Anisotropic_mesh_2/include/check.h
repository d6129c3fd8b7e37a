// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_CHECK_H
#define ANISOTROPIC_MESH_2_TEST_CHECK_H

#include <exception>
#include <iostream>
#include <string>

// Checks that hold in Release too, and that are counted: a test program that
// checks nothing fails.
class Checks
{
public:
  static Checks& all()
  {
    static Checks checks;
    return checks;
  }

  bool check(bool ok, const std::string& what, const char* file, int line)
  {
    ++m_done;
    if(!ok) {
      ++m_failed;
      std::cerr << file << ':' << line << ": failed: " << what << std::endl;
    }
    return ok;
  }

  int finish() const
  {
    std::cout << m_done << " checks, " << m_failed << " failed" << std::endl;
    return m_done > 0 && m_failed == 0 ? 0 : 1;
  }

private:
  long m_done = 0, m_failed = 0;
};

#define CHECK(condition) Checks::all().check(bool(condition), #condition, __FILE__, __LINE__)

// the condition, with numbers or names that help when it fails
#define CHECK_MSG(condition, message) \
  Checks::all().check(bool(condition), std::string(#condition) + " -- " + (message), __FILE__, __LINE__)

// The expression throws the type, and the message holds the given words.
#define CHECK_THROWS(expression, Exception, words)                                         \
  do {                                                                                     \
    std::string caught = "nothing";                                                        \
    bool right = false;                                                                    \
    try { expression; }                                                                    \
    catch(const Exception& e) { caught = e.what(); right = caught.find(words) != std::string::npos; } \
    catch(const std::exception& e) { caught = std::string("another type: ") + e.what(); }  \
    Checks::all().check(right, #expression " throws " #Exception " with '" + std::string(words) + \
                        "', got: " + caught, __FILE__, __LINE__);                          \
  } while(false)

inline int finish() { return Checks::all().finish(); }

#endif // ANISOTROPIC_MESH_2_TEST_CHECK_H

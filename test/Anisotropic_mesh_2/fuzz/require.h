// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a fuzz target demands of the reader that it runs.

#ifndef ANISOTROPIC_MESH_2_TEST_FUZZ_REQUIRE_H
#define ANISOTROPIC_MESH_2_TEST_FUZZ_REQUIRE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

// the entry point that libFuzzer looks for; replay.cpp calls it too
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Ends the program, which libFuzzer and CTest count as a failure.
inline void require(bool ok, const std::string& what)
{
  if(ok)
    return;
  std::cerr << "failed: " << what << std::endl;
  std::abort();
}

// One line for people: nothing of a broken file may spoil the terminal or fill it.
inline void require_readable(const std::string& message)
{
  require(!message.empty() && message.size() < 600, "a message of a line or two: " + message.substr(0, 600));
  require(std::all_of(message.begin(), message.end(), [](char c) { return c >= 0x20 && c < 0x7f; }),
          "a message of printable characters: " + message);
}

#endif // ANISOTROPIC_MESH_2_TEST_FUZZ_REQUIRE_H

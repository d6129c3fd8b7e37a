// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The main program of a fuzz target without libFuzzer: it runs the target on
// the files, or all files of the folders, that are given.

#include "require.h"
#include "../include/scratch_directory.h"

#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

std::set<std::string> files_of(int argc, char* argv[])
{
  std::set<std::string> files;
  for(int i = 1; i < argc; ++i)
    if(std::filesystem::is_directory(argv[i]))
      for(const auto& entry : std::filesystem::directory_iterator(argv[i]))
        files.insert(entry.path().string());
    else
      files.insert(argv[i]);
  return files;
}

int main(int argc, char* argv[])
{
  std::string file;
  try {
    const std::set<std::string> files = files_of(argc, argv);
    for(const std::string& name : files) {
      file = name;
      std::cout << file << std::endl; // so that it is known when the target aborts
      const std::string text = content_of(file);
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
    std::cout << files.size() << " inputs" << std::endl;
    return files.empty() ? 1 : 0;
  }
  catch(const std::exception& e) {
    std::cerr << file << ": " << e.what() << std::endl;
    return 1;
  }
}

// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_WRITE_FILE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_WRITE_FILE_H

#include <CGAL/Anisotropic_mesh_2/IO/Mesh_io_exception.h>

#include <fstream>
#include <string>

namespace CGAL::Anisotropic_mesh_2::internal {

// calls `write` with a stream to the file
template <class Write>
void write_file(const std::string& file, const Write& write)
{
  std::ofstream os(file, std::ios::binary);
  if(!os)
    throw Mesh_io_exception(file, "cannot be opened for writing");
  write(os);
  os.close(); // sets failbit when the last bytes do not get through
  if(!os)
    throw Mesh_io_exception(file, "could not be written completely");
}

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_IO_WRITE_FILE_H

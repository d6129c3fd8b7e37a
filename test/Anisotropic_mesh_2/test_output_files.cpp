// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Output files of the program appear complete or not at all; OFF and VTU.

#include "include/check.h"
#include "include/marked_triangulation.h"
#include "include/scratch_directory.h"
#include "../../program/Safe_output_file.h"

#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/PLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/IO/VTU.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

// also with these, which have functions of the same names (see test_writers_beside_cgal.cpp)
#include <CGAL/IO/File_medit.h>
#include <CGAL/IO/write_VTU.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <ios>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <type_traits>
#include <vector>

namespace fs = std::filesystem;

using program::Safe_output_file;
typedef CGAL::Mesh_io_exception  Bad;

void test_commit(const Scratch_directory& scratch)
{
  const std::string name = scratch.file("a.txt", "old");
  {
    Safe_output_file file(name);
    file.stream() << "new";
    CHECK(content_of(name) == "old");
    CHECK(scratch.number_of_files() == 2);
    file.commit();
    CHECK(content_of(name) == "new");
  }
  CHECK(content_of(name) == "new" && scratch.number_of_files() == 1);
  {
    Safe_output_file file(name), other(name); // temporary names differ
    file.stream() << "not kept";
    other.stream() << "not kept either";
  }
  CHECK(content_of(name) == "new" && scratch.number_of_files() == 1);
  fs::remove(name);
  { Safe_output_file file(name); }
  CHECK(scratch.number_of_files() == 0);
  static_assert(!std::is_copy_constructible<Safe_output_file>::value, "a file has one owner");
}

void test_links_and_permissions(const Scratch_directory& scratch)
{
  const std::string target = scratch.file("target.txt", "old"), link = scratch / "link.txt";
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, link);
  Safe_output_file file(link);
  file.stream() << "through the link";
  file.commit();
  CHECK(fs::is_symlink(link));
  CHECK(content_of(target) == "through the link");
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(scratch.number_of_files() == 2);
  fs::remove(target);
  fs::remove(link);
}

void test_failures(const Scratch_directory& scratch)
{
  CHECK_THROWS(Safe_output_file(scratch / "no_such_directory/a.txt"), Bad,
               "no_such_directory/a.txt: cannot be opened for writing: No such file or directory");
  CHECK_THROWS(Safe_output_file(scratch.path().string()), Bad, "it is a directory");
  CHECK_THROWS(Safe_output_file(""), Bad, "the name is empty");
  CHECK_THROWS(CGAL::IO::write_OFF(scratch / "no/a.off", marked_rectangle()), Bad, "no/a.off");
  CHECK_THROWS(CGAL::IO::write_VTU(scratch / "no/a.vtu", marked_rectangle()), Bad, "no/a.vtu");
  CHECK_THROWS(CGAL::IO::write_MEDIT(scratch / "no/a.mesh", marked_rectangle()), Bad, "no/a.mesh");
  if(fs::exists("/dev/full"))
    CHECK_THROWS(CGAL::IO::write_OFF("/dev/full", marked_rectangle()), Bad, "/dev/full: could not be written completely");
  CHECK(scratch.number_of_files() == 0);
}

// Streams that nothing gets through to tell so, by their state or, if the user wants, by an exception.
void test_full_streams()
{
  struct : std::streambuf {} full; // overflows at the first character
  const auto mesh = marked_rectangle();
  const CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<CGAL::Exact_predicates_exact_constructions_kernel> graph;
  const std::vector<std::function<void(std::ostream&)>> writers = {
    [&](std::ostream& os) { CGAL::IO::write_OFF(os, mesh); }, [&](std::ostream& os) { CGAL::IO::write_PLY(os, mesh); },
    [&](std::ostream& os) { CGAL::IO::write_VTU(os, mesh); }, [&](std::ostream& os) { CGAL::IO::write_MEDIT(os, mesh); },
    [&](std::ostream& os) { CGAL::IO::write_POLY(os, graph); }, [&](std::ostream& os) { CGAL::IO::write_SVG(os, mesh); }};
  for(const auto& write : writers) {
    std::ostream silent(&full), loud(&full);
    write(silent);
    CHECK(silent.bad());
    loud.exceptions(std::ios::badbit);
    CHECK_THROWS(write(loud), std::ios_base::failure, "");
  }
}

void write_much_to(const std::string& name)
{
  Safe_output_file file(name);
  file.stream() << std::string(100000, 'x');
  file.commit();
}

void test_special_files(const Scratch_directory& scratch)
{
  if(fs::exists("/dev/null")) {
    write_much_to("/dev/null");
    CHECK(fs::is_character_file("/dev/null"));
  }
  if(fs::exists("/dev/full"))
    CHECK_THROWS(write_much_to("/dev/full"), Bad, "/dev/full: could not be written completely: No space left on device");
  CHECK(scratch.number_of_files() == 0);
}

void test_off(const Scratch_directory& scratch)
{
  std::ostringstream os;
  CGAL::IO::write_OFF(os, marked_rectangle());
  std::istringstream is(os.str());
  std::string word;
  std::size_t vertices, faces, edges;
  is >> word >> vertices >> faces >> edges;
  CHECK(word == "OFF" && vertices == 5 && faces == 4 && edges == 0);
  std::vector<double> xyz(15);
  for(double& x : xyz)
    is >> x;
  CHECK(is && *std::max_element(xyz.begin(), xyz.end()) == 4);
  double area = 0;
  for(std::size_t i = 0; i < faces; ++i) {
    std::size_t n, a, b, c;
    CHECK(is >> n >> a >> b >> c && n == 3 && a < 5 && b < 5 && c < 5);
    area += ((xyz[3*b] - xyz[3*a]) * (xyz[3*c + 1] - xyz[3*a + 1])
           - (xyz[3*b + 1] - xyz[3*a + 1]) * (xyz[3*c] - xyz[3*a])) / 2;
  }
  CHECK(area == 12);
  CHECK(!(is >> word));
  CGAL::IO::write_OFF(scratch / "a.off", marked_rectangle());
  CHECK(content_of(scratch / "a.off") == os.str());
}

// the numbers of a data array
std::vector<double> array_of(const std::string& vtu, const std::string& name)
{
  const std::size_t begin = vtu.find('>', vtu.find(name)) + 1;
  std::istringstream is(vtu.substr(begin, vtu.find('<', begin) - begin));
  std::vector<double> numbers;
  for(double x; is >> x;)
    numbers.push_back(x);
  return numbers;
}

void test_vtu(const Scratch_directory& scratch)
{
  std::ostringstream os;
  CGAL::IO::write_VTU(os, marked_rectangle(), CGAL::IO::ASCII);
  const std::string vtu = os.str();
  CHECK(vtu.find("NumberOfPoints=\"5\" NumberOfCells=\"9\"") != std::string::npos);
  const std::vector<double> xyz = array_of(vtu, "NumberOfComponents"), types = array_of(vtu, "types"),
                            connectivity = array_of(vtu, "connectivity"), offsets = array_of(vtu, "offsets");
  CHECK(types == std::vector<double>({5, 5, 5, 5, 3, 3, 3, 3, 3}));
  CHECK(xyz.size() == 15 && connectivity.size() == 22);
  CHECK(offsets == std::vector<double>({3, 6, 9, 12, 14, 16, 18, 20, 22}));
  double area = 0;
  for(std::size_t i = 0; i < 12; i += 3) {
    const std::size_t a = 3 * std::size_t(connectivity[i]), b = 3 * std::size_t(connectivity[i + 1]),
                      c = 3 * std::size_t(connectivity[i + 2]);
    area += ((xyz[b] - xyz[a]) * (xyz[c + 1] - xyz[a + 1]) - (xyz[b + 1] - xyz[a + 1]) * (xyz[c] - xyz[a])) / 2;
  }
  CHECK(area == 12); // counterclockwise
  CGAL::IO::write_VTU(scratch / "a.vtu", marked_rectangle());
  const std::string binary = content_of(scratch / "a.vtu"), begin = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t at = binary.find(begin) + begin.size();
  std::uint64_t bytes = 0;
  std::vector<double> same_xyz(xyz.size());
  std::memcpy(&bytes, binary.data() + at, sizeof bytes);
  std::memcpy(same_xyz.data(), binary.data() + at + sizeof bytes, sizeof(double) * xyz.size());
  CHECK(bytes == sizeof(double) * xyz.size() && same_xyz == xyz);
  CHECK(binary.find("format=\"appended\" offset=\"" + std::to_string(bytes + 8) + "\"") != std::string::npos);
}

// Other number types are written as doubles.
void test_exact_kernel()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel  Exact;
  typedef CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Exact>,
                                               CGAL::Delaunay_mesh_face_base_2<Exact> > Tds;
  CGAL::Constrained_Delaunay_triangulation_2<Exact, Tds> cdt;
  cdt.insert(Exact::Point_2(0, 0));
  cdt.insert(Exact::Point_2(Exact::FT(1) / 4, 0));
  cdt.insert(Exact::Point_2(0, 1));
  cdt.finite_faces_begin()->set_in_domain(true);
  std::ostringstream vtu, off;
  CGAL::IO::write_VTU(vtu, cdt, CGAL::IO::ASCII);
  CGAL::IO::write_OFF(off, cdt);
  CHECK(vtu.str().find("Float64") != std::string::npos && vtu.str().find("0.25 0 0") != std::string::npos);
  CHECK(off.str().find("0.25 0 0") != std::string::npos);
}

int main()
{
  const Scratch_directory scratch;
  test_commit(scratch);
  test_links_and_permissions(scratch);
  test_failures(scratch);
  test_special_files(scratch);
  test_full_streams();
  test_off(scratch);
  test_vtu(scratch);
  test_exact_kernel();
  return finish();
}

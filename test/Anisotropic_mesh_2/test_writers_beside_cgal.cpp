// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writers have the names of CGAL's own: with both included, ours are chosen for our meshes and CGAL's for CGAL's.
// Here CGAL's headers come first, in test_output_files.cpp they come last.

#include <CGAL/IO/File_medit.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/write_VTU.h>
#include <CGAL/IO/write_off_points.h>
#include <CGAL/IO/write_ply_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>

#include "include/check.h"
#include "include/marked_triangulation.h"
#include "include/scratch_directory.h"

#include <CGAL/Anisotropic_Delaunay_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/IO/OFF.h>
#include <CGAL/Anisotropic_mesh_2/IO/PLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/POLY.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>
#include <CGAL/Anisotropic_mesh_2/IO/VTU.h>
#include <CGAL/Anisotropic_surface_mesh_3.h>
#include <CGAL/Constant_metric_field_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Riemannian_metric_traits_2.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Riemannian_metric_traits_2<Kernel, CGAL::Constant_metric_field_2<Kernel> >  Traits;
typedef CGAL::Anisotropic_Delaunay_mesh_2<Traits>                                         Mesh;

// the triangle with the corners (0,0), (1,0), (0,1) in a convex hull with one vertex more
Mesh planar_mesh()
{
  Mesh mesh{Traits(CGAL::Constant_metric_field_2<Kernel>(CGAL::Metric_tensor_2<Kernel>()))};
  Mesh::Boundary_graph triangle;
  triangle.points = {Kernel::Point_2(0, 0), Kernel::Point_2(1, 0), Kernel::Point_2(0, 1)};
  for(std::size_t i = 0; i < 3; ++i)
    triangle.segments.push_back({i, (i + 1) % 3, static_cast<int>(i) + 7, true});
  mesh.insert_boundary(triangle);
  mesh.insert(Kernel::Point_2(1, 1));
  return mesh;
}

struct Plane_field
{
  struct Surface
  {
    typedef ::Kernel Kernel;
    Kernel::Point_3 point(const Kernel::Point_2& p) const { return {p.x(), p.y(), 5}; }
  };
  Surface surface() const { return {}; }
};
typedef CGAL::Anisotropic_surface_mesh_3<Plane_field> Surface_mesh;

Surface_mesh surface_mesh()
{
  Surface_mesh mesh{Plane_field()};
  for(const auto& p : {Kernel::Point_2(0, 0), Kernel::Point_2(1, 0), Kernel::Point_2(0, 1)})
    mesh.add_vertex(p);
  mesh.add_face({0, 1, 2});
  return mesh;
}

class Own_mesh
  : public Mesh
{
public:
  explicit Own_mesh(const Mesh& mesh) : Mesh(mesh) {}
};

template <class Base>
class Own_triangulation
  : public Base
{
public:
  explicit Own_triangulation(const Base& base) : Base(base) {}
  int edge_reference(const typename Base::Edge&) const { return 77; }
};

// the file that `write` leaves is what it writes to a stream
template <class Write>
std::string written(const Write& write)
{
  const Scratch_directory scratch;
  std::ostringstream os;
  write(static_cast<std::ostream&>(os));
  write(scratch / "file");
  CHECK(content_of(scratch / "file") == os.str());
  return os.str();
}

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

template <class Tr>
void test_planar(const Tr& tr, const std::string& counts)
{
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_OFF(to, tr); }), "OFF\n" + counts + " 0\n"));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_PLY(to, tr); }), "property list uchar int vertex_indices"));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_MEDIT(to, tr); }), "Dimension 2"));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_MEDIT(to, tr, [](const typename Tr::Edge&) { return 55; }); }),
                 " 55\n"));
  const std::string points = "NumberOfPoints=\"" + counts.substr(0, counts.find(' ')) + '"';
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_VTU(to, tr); }), points));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_VTU(to, tr, CGAL::IO::ASCII); }), points));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_SVG(to, tr); }), "<title>Mesh</title>"));
}

void test_ours()
{
  const Mesh mesh = planar_mesh();
  test_planar(mesh, "3 1");
  const Own_mesh own(planar_mesh());
  test_planar(static_cast<const Mesh&>(own), "3 1");
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_MEDIT(to, mesh); }), " 7\n"));

  const Surface_mesh surface = surface_mesh();
  CHECK(written([&](auto&& to) { CGAL::IO::write_OFF(to, surface); })
        == "OFF\n3 1 0\n\n0 0 5\n1 0 5\n0 1 5\n3 0 1 2\n");
  const std::string ply = written([&](auto&& to) { CGAL::IO::write_PLY(to, surface); });
  CHECK(contains(ply, "element vertex 3\n") && contains(ply, "end_header\n0 0 5\n1 0 5\n0 1 5\n3 0 1 2\n"));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_SVG(to, surface); }), "1 triangles"));

  CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel> graph;
  graph.points = {Kernel::Point_2(0, 0), Kernel::Point_2(1, 0)};
  graph.edges.push_back({0, 1, 3});
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_MEDIT(to, graph); }), "1 2 3\n"));
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_POLY(to, graph); }), "1 1 2 3\n"));
}

void test_triangulations_of_cgal()
{
  const Marked_cdt cdt = marked_rectangle();
  test_planar(cdt, "5 4");
  const Own_triangulation<Marked_cdt> own(cdt);
  test_planar(own, "5 4");
  CHECK(contains(written([&](auto&& to) { CGAL::IO::write_MEDIT(to, own); }), " 77\n"));
  CGAL::Constrained_triangulation_plus_2<Marked_cdt> plus;
  plus.insert_constraint(Kernel::Point_2(0, 0), Kernel::Point_2(1, 0));
  plus.insert(Kernel::Point_2(0, 1));
  plus.finite_faces_begin()->set_in_domain(true);
  test_planar(plus, "3 1");
}

// what CGAL writes of its own meshes and points
void test_others()
{
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  mesh.add_face(mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1, 0, 0}), mesh.add_vertex({0, 1, 0}));
  const std::vector<Kernel::Point_3> points(2, Kernel::Point_3(1, 2, 3));
  std::ostringstream os;
  CHECK(CGAL::IO::write_OFF(os, mesh) && CGAL::IO::write_PLY(os, mesh));
  CHECK(CGAL::IO::write_OFF(os, points) && CGAL::IO::write_PLY(os, points));
}

int main()
{
  test_ours();
  test_triangulations_of_cgal();
  test_others();
  return finish();
}

// The package's own statistics of a triangle mesh that anybody made, so that
// meshes of other programs are judged as those of this one.
//
// usage: judge_mesh MESH.mesh DOMAIN [options]
//
// What follows MESH.mesh is the command line of the program anisotropic_mesh_2,
// from which the metric and the measure are taken. Prints the statistics and
// the area of the mesh as JSON. Fails if the triangles are not a mesh: a
// triangle without area or turned over, overlaps, coinciding points, or a
// vertex in the middle of an edge.

#include "Options.h"
#include "input.h"
#include "mesh_job.h"

#include <CGAL/Anisotropic_mesh_2/IO/MEDIT.h>
#include <CGAL/Anisotropic_mesh_2/Planar_straight_line_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/Boundary_graph_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/describe.h>
#include <CGAL/assertions_behaviour.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using program::Kernel;
using program::Mesh;
using program::Point_2;

typedef CGAL::Anisotropic_mesh_2::Planar_straight_line_graph_2<Kernel>    Graph;
typedef CGAL::Anisotropic_mesh_2::internal::Boundary_graph_2<Kernel>       Edge_graph;
typedef std::pair<std::size_t, std::size_t>                               Edge;

// thrown if the triangles are not a mesh
class Not_a_mesh
  : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

double doubled_area(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
}

// Files may have all triangles clockwise, but not some of them.
double area_of(const Graph& graph)
{
  double sum = 0;
  int sign = 0;
  for(const auto& t : graph.triangles) {
    const Point_2 &a = graph.points[t[0]], &b = graph.points[t[1]], &c = graph.points[t[2]];
    const int turn = CGAL::orientation(a, b, c);
    if(turn == 0 || turn == -sign)
      throw Not_a_mesh("the triangle at " + CGAL::Anisotropic_mesh_2::internal::describe(a)
                       + (turn == 0 ? " has no area" : " is turned over"));
    sign = turn;
    sum += std::abs(doubled_area(a, b, c)) / 2;
  }
  return sum;
}

// the edges of all triangles in order, those of two triangles twice
std::vector<Edge> edges_of(const Graph& graph)
{
  std::vector<Edge> edges;
  for(const auto& t : graph.triangles)
    for(int i = 0; i < 3; ++i)
      edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Points that no triangle uses are left out, as they would divide triangles.
Edge_graph edge_graph_of(const Graph& graph)
{
  Edge_graph result;
  const std::size_t unused = graph.points.size();
  std::vector<std::size_t> number(graph.points.size(), unused);
  const auto number_of = [&](std::size_t v) {
    if(number[v] == unused) {
      number[v] = result.points.size();
      result.points.push_back(graph.points[v]);
    }
    return number[v];
  };
  const std::vector<Edge> edges = edges_of(graph);
  for(auto e = edges.begin(); e != edges.end(); ) {
    const auto end = std::upper_bound(e, edges.end(), *e);
    if(end - e > 2)
      throw Not_a_mesh("the edge at " + CGAL::Anisotropic_mesh_2::internal::describe(graph.points[e->first])
                       + " belongs to more than two triangles");
    result.segments.push_back({number_of(e->first), number_of(e->second), 1, end - e == 1});
    e = end;
  }
  return result;
}

double area_of(const Mesh& mesh)
{
  double sum = 0;
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    if(f->is_in_domain())
      sum += doubled_area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) / 2;
  return sum;
}

// Where edges meet in vertices only and no triangle is counted twice, both the
// number and the area of the triangles come back.
void check_same(const Mesh& mesh, const Graph& graph, const Edge_graph& edges, double area)
{
  if(mesh.number_of_vertices() != edges.points.size())
    throw Not_a_mesh("different vertices are at the same point");
  if(mesh.number_of_faces_in_domain() != graph.triangles.size())
    throw Not_a_mesh(std::to_string(graph.triangles.size()) + " triangles overlap or have vertices in edges: "
                     "their edges bound " + std::to_string(mesh.number_of_faces_in_domain()));
  if(!(std::abs(area_of(mesh) - area) <= 1e-9 * area))
    throw Not_a_mesh("triangles overlap: their areas sum up to " + std::to_string(area) + ", but they cover "
                     + std::to_string(area_of(mesh)));
}

// Every edge becomes a constraint, so that the triangles stay as they are.
Mesh mesh_of(const Graph& graph, double area, const program::Metric_field& metric)
{
  const Edge_graph edges = edge_graph_of(graph);
  Mesh mesh{program::Traits(metric)};
  try {
    mesh.insert_boundary(edges);
  }
  catch(const Mesh::Intersection_of_constraints_exception&) {
    throw Not_a_mesh("edges cross");
  }
  check_same(mesh, graph, edges, area);
  return mesh;
}

nlohmann::ordered_json judge(const std::string& file, const program::Options& options)
{
  const program::Metric_field metric = program::read_input(options).metric;
  const Graph graph = CGAL::IO::read_MEDIT<Kernel>(file);
  if(graph.triangles.empty())
    throw Not_a_mesh("no triangles");
  const double area = area_of(graph);
  nlohmann::ordered_json json;
  program::statistics(mesh_of(graph, area, metric), options).for_each([&](const char* name, const auto& value) {
    json[name] = value;
  });
  json.erase("gradient_norm"); // of the free vertices, and here are none
  json["area"] = area;
  return json;
}

void ignore_violation(const char*, const char*, const char*, int, const char*) {}

} // namespace

int main(int argc, char** argv)
{
  CGAL::set_error_handler(ignore_violation); // the exception that follows says the same in one line
  if(argc < 3) {
    std::cerr << "usage: judge_mesh MESH.mesh DOMAIN [options of anisotropic_mesh_2 for metric and measure]\n";
    return 2;
  }
  try {
    const program::Options options = program::parse_options(argc - 1, argv + 1);
    std::cout << (options.answer.empty() ? judge(argv[1], options).dump(2) + "\n" : options.answer);
    return 0;
  }
  catch(const program::Unusable_input& e) {
    std::cerr << "judge_mesh: " << e.what() << '\n';
    return 2;
  }
  catch(const Not_a_mesh& e) {
    std::cerr << "judge_mesh: " << argv[1] << ": " << e.what() << '\n';
  }
  catch(const std::exception& e) {
    std::cerr << "judge_mesh: " << e.what() << '\n';
  }
  return 1;
}

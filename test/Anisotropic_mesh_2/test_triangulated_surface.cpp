// Triangulated surfaces: curvature and derivatives against closed forms, meshes that
// stay on the triangles and on the border, metrics given at vertices, refusals.

#include <CGAL/Anisotropic_mesh_2/exceptions.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Anisotropic_mesh_2/Curvature_metric_3.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Anisotropic_mesh_2/Triangulated_surface_3.h>
#include <CGAL/Anisotropic_mesh_2/Vertex_metric_3.h>
#include <CGAL/anisotropic_surface_mesh_statistics_3.h>
#include <CGAL/make_anisotropic_surface_mesh_3.h>
#include <CGAL/Anisotropic_mesh_2/principal_curvatures_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_traits_3.h>
#endif

#include "check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using CGAL::Anisotropic_mesh_2::Invalid_triangle_mesh_exception;
using K       = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;
using Graph   = CGAL::Surface_mesh<Point_3>;
using Surface = CGAL::Anisotropic_mesh_2::Triangulated_surface_3<K>;

void check_close(double value, double expected, double tolerance)
{
  CHECK_MSG(std::abs(value - expected) < tolerance, std::to_string(value) + " for " + std::to_string(expected));
}

// the images of random points in the unit disc, and of regular ones on its border
template <class Place>
Graph disc(int n, const Place& place)
{
  CGAL::Delaunay_triangulation_2<K> triangulation;
  CGAL::Random random(7);
  const auto insert = [&](double r, double angle) { triangulation.insert(Point_2(r * std::cos(angle), r * std::sin(angle))); };
  for(int i = 0; i < n; ++i) {
    const double r = 0.97 * std::sqrt(random.get_double()); // evaluated before the angle
    insert(r, random.get_double(0, 2 * CGAL_PI));
  }
  const int m = int(3 * std::sqrt(n));
  for(int i = 0; i < m; ++i)
    insert(1, 2 * CGAL_PI * i / m);
  Graph graph;
  std::map<CGAL::Delaunay_triangulation_2<K>::Vertex_handle, Graph::Vertex_index> vertices;
  for(auto v : triangulation.finite_vertex_handles())
    vertices[v] = graph.add_vertex(place(v->point().x(), v->point().y()));
  for(auto f : triangulation.finite_face_handles())
    graph.add_face(vertices[f->vertex(0)], vertices[f->vertex(1)], vertices[f->vertex(2)]);
  return graph;
}

Point_3 on_bump(double x, double y) { return Point_3(x, y, 0.6 * (1 - x*x - y*y) + 0.2 * std::exp(-8 * ((x - 0.3)*(x - 0.3) + y*y))); }
Point_3 on_sphere(double x, double y) { return Point_3(2 * x, 2 * y, 2 * std::sqrt(4 - x*x - y*y)); } // of radius 4
Point_3 on_plane(double x, double y) { return Point_3(0.6 * x, y, 0.8 * x); }

Point_2 parameters_of_centroid(const Surface& s, const Graph& graph, Graph::Face_index f)
{
  double u = 0, v = 0;
  for(auto w : vertices_around_face(graph.halfedge(f), graph)) {
    u += s.vertex_parameters(w).x() / 3;
    v += s.vertex_parameters(w).y() / 3;
  }
  return Point_2(u, v);
}

void test_plane()
{
  const Graph graph = disc(500, on_plane);
  const Surface s(graph);
  for(auto f : graph.faces()) {
    const auto d = s.first_derivatives(parameters_of_centroid(s, graph, f));
    check_close(d[0] * d[0], 1, 1e-4);
    check_close(d[1] * d[1], 1, 1e-4);
    check_close(d[0] * d[1], 0, 1e-4);
    const K::Vector_3 n = cross_product(d[0], d[1]);
    check_close(n * K::Vector_3(-0.8, 0, 0.6), 1, 1e-4);
  }
  for(auto v : graph.vertices()) {
    CHECK(CGAL::squared_distance(s.point(s.vertex_parameters(v)), graph.point(v)) < 1e-24);
    check_close(CGAL::Anisotropic_mesh_2::principal_curvatures_3(s, s.vertex_parameters(v)).k_max, 0, 1e-9);
  }
}

// bent away from the normal, by 1/4 in all directions
void test_curvature()
{
  const Graph graph = disc(3000, on_sphere);
  const Surface s(graph);
  for(auto v : graph.vertices())
    if(CGAL::squared_distance(graph.point(v), Point_3(0, 0, 4)) < 2.5) {
      const auto k = CGAL::Anisotropic_mesh_2::principal_curvatures_3(s, s.vertex_parameters(v));
      check_close(k.k_min, -0.25, 0.02);
      check_close(k.k_max, -0.25, 0.02);
    }
}

std::vector<K::Segment_3> border_of(const Graph& graph)
{
  std::vector<K::Segment_3> border;
  for(auto h : graph.halfedges())
    if(graph.is_border(h))
      border.push_back(K::Segment_3(graph.point(graph.source(h)), graph.point(graph.target(h))));
  return border;
}

// The vertices lie on the triangles of `input`, those of the border on its border.
void check_stays(const Graph& input, const Graph& output, const std::string& what)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Graph> Primitive;
#if CGAL_VERSION_NR < 1060000000
  typedef CGAL::AABB_traits<K, Primitive>   Tree_traits;
#else
  typedef CGAL::AABB_traits_3<K, Primitive> Tree_traits;
#endif
  const CGAL::AABB_tree<Tree_traits> tree(faces(input).first, faces(input).second, input);
  double farthest = 0, farthest_on_border = 0;
  for(auto v : output.vertices())
    farthest = (std::max)(farthest, tree.squared_distance(output.point(v)));
  CHECK_MSG(farthest < 1e-24, what + ": " + std::to_string(std::sqrt(farthest)));
  const std::vector<K::Segment_3> border = border_of(input);
  for(const K::Segment_3& edge : border_of(output)) {
    double nearest = 1;
    for(const K::Segment_3& t : border)
      nearest = (std::min)(nearest, CGAL::squared_distance(edge.source(), t));
    farthest_on_border = (std::max)(farthest_on_border, nearest);
  }
  CHECK_MSG(farthest_on_border < 1e-20, what + ": " + std::to_string(std::sqrt(farthest_on_border)));
  CHECK(output.number_of_vertices() + output.number_of_faces() == output.number_of_edges() + 1);
}

template <class Metric>
Graph check_mesh(const Graph& input, const Surface& s, double corner_angle, const Metric& metric,
                 double least_mean, double least, const std::string& what)
{
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(s.domain(corner_angle), CGAL::make_surface_metric_field_2(s, metric));
  Graph output;
  mesh.add_to(output);
  check_stays(input, output, what);
  const auto statistics = CGAL::anisotropic_surface_mesh_statistics_3(mesh);
  CHECK_MSG(statistics.quality_mean > least_mean, what + ": " + std::to_string(statistics.quality_mean));
  CHECK_MSG(statistics.quality_min > least, what + ": " + std::to_string(statistics.quality_min));
  return output;
}

void test_meshes()
{
  const Graph bump = disc(2000, on_bump);
  const Surface s(bump);
  const auto uniform = [](const Point_3&) { return 0.18; };
  const Graph by_size = check_mesh(bump, s, 0.5, uniform, 0.975, 0.7, "uniform");
  const Graph by_vertices = check_mesh(bump, s, 0.5,
    CGAL::Anisotropic_mesh_2::Vertex_metric_3<K>(s, std::vector<CGAL::Metric_tensor_3<K> >
                                  (bump.number_of_vertices(), CGAL::Metric_tensor_3<K>::from_size(0.18))),
    0.975, 0.7, "the same at vertices");
  CHECK(std::abs(double(by_size.number_of_vertices()) / double(by_vertices.number_of_vertices()) - 1) < 0.01);
  std::vector<CGAL::Metric_tensor_3<K> > tensors;
  for(auto v : bump.vertices())
    tensors.push_back(CGAL::Metric_tensor_3<K>::from_sizes(0.1 + 0.05 * std::abs(bump.point(v).x()), 0.3, 0.3));
  check_mesh(bump, s, 0.5, CGAL::Anisotropic_mesh_2::Vertex_metric_3<K>(s, tensors), 0.96, 0.5, "anisotropic at vertices");
  check_mesh(bump, s, 0.5, CGAL::Anisotropic_mesh_2::Curvature_metric_3<Surface>(0.01, 0.1, 0.4, 4), 0.95, 0.4, "curvature");
}

void test_kept_border()
{
  const Graph bump = disc(800, on_bump);
  const Surface s(bump);
  const Graph output = check_mesh(bump, s, 0, [](const Point_3&) { return 0.12; }, 0.95, 0.4, "border kept");
  std::set<Point_3> border;
  for(const K::Segment_3& edge : border_of(output))
    border.insert(edge.source());
  for(const K::Segment_3& edge : border_of(bump)) {
    double nearest = 1;
    for(const Point_3& p : border)
      nearest = (std::min)(nearest, CGAL::squared_distance(p, edge.source()));
    CHECK(nearest < 1e-24);
  }
}

// Without a domain the whole surface is meant, not its bounding box.
void test_default_domain()
{
  const Surface s(disc(800, on_bump));
  const auto field = CGAL::make_surface_metric_field_2(s, [](const Point_3&) { return 0.15; });
  const auto mesh = CGAL::make_anisotropic_surface_mesh_3(field);
  CHECK(mesh.faces() == CGAL::make_anisotropic_surface_mesh_3(s.domain(), field).faces());
}

void refuse(const Graph& graph, const std::string& words)
{
  try {
    Surface s(graph);
    CHECK_MSG(false, "not refused: " + words);
  }
  catch(const Invalid_triangle_mesh_exception& e) {
    CHECK_MSG(std::string(e.what()).find(words) != std::string::npos, e.what());
  }
}

void test_refusals()
{
  const std::vector<Point_3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {2, 0, 0}};
  const auto graph = [&](int n, const std::vector<std::vector<int> >& faces) {
    Graph g;
    for(int i = 0; i < n; ++i)
      g.add_vertex(p[i]);
    for(const auto& f : faces) {
      std::vector<Graph::Vertex_index> v;
      for(int i : f)
        v.push_back(Graph::Vertex_index(i));
      g.add_face(v);
    }
    return g;
  };
  refuse(Graph(), "no triangles");
  refuse(graph(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), "closed");
  refuse(graph(7, {{0, 1, 2}, {4, 5, 6}}), "not connected");
  refuse(graph(5, {{0, 1, 2}, {0, 3, 4}}), "not a manifold at the vertex 0");
  refuse(graph(4, {{0, 1, 3, 2}}), "not a triangle");
  refuse(graph(8, {{0, 1, 2}, {1, 0, 7}}), "has no area");
  Graph holed = disc(100, on_bump);
  for(auto f : holed.faces())
    if(CGAL::squared_distance(CGAL::centroid(holed.point(holed.source(holed.halfedge(f))), holed.point(holed.target(holed.halfedge(f))),
                                             holed.point(holed.target(holed.next(holed.halfedge(f))))), on_bump(0, 0)) < 0.02) {
      CGAL::Euler::remove_face(holed.halfedge(f), holed);
      break;
    }
  refuse(holed, "2 borders");
  const Surface s(graph(3, {{0, 1, 2}}));
  CHECK_THROWS(CGAL::Anisotropic_mesh_2::Vertex_metric_3<K>(s, {}), Invalid_triangle_mesh_exception, "0 metric tensors");
}

int main()
{
  test_plane();
  test_curvature();
  test_meshes();
  test_kept_border();
  test_default_domain();
  test_refusals();
  return finish();
}

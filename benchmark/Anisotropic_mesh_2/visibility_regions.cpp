// How the error of visibility regions depends on the numbers of poly-segments
// and of steps, with crossings at the first step or searched for, and what they
// cost. Prints tables in Markdown; the reference is a much finer sampling.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Facewise_energy.h>
#include <CGAL/Anisotropic_mesh_2/internal/tessellation/Region_moments.h>
#include <CGAL/Anisotropic_mesh_2/internal/optimization/Vertex_mover.h>
#include <CGAL/Anisotropic_mesh_2/internal/energy/Visibility_energy.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Real_timer.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_visibility_region_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel  K;
typedef K::Point_2                                           Point;
typedef CGAL::Metric_tensor_2<K>                             Tensor;
typedef CGAL::Anisotropic_mesh_2::Visibility_sampling        Sampling;
namespace internal = CGAL::Anisotropic_mesh_2::internal;

const auto measure = CGAL::Anisotropic_mesh_2::Measure::RIEMANNIAN;

// What is compared, of each free vertex.
struct Region
{
  double x, y; // from the vertex to its mass centre
  double area;
};

template <class Mesh>
std::vector<Region> regions(const Mesh& mesh, const Sampling& sampling)
{
  const internal::Visibility_energy<Mesh> energy(mesh, measure, sampling);
  std::vector<Region> result;
  for(const auto v : internal::free_vertices(mesh)) {
    Region r = {0, 0, 0};
    internal::Region_moments moments;
    energy.add_region(v, moments);
    const internal::Vector_of_doubles d = moments.lloyd_move();
    r.x = d.x;
    r.y = d.y;
    const auto polygon = CGAL::anisotropic_visibility_region_2(mesh, v, sampling).front();
    for(std::size_t i = 0; i < polygon.size(); ++i)
      r.area += CGAL::area(v->point(), polygon[i], polygon[(i + 1) % polygon.size()]);
    result.push_back(r);
  }
  return result;
}

template <class Energy, class Mesh>
double microseconds_per_vertex(Energy&& energy, const Mesh& mesh)
{
  std::vector<internal::Region_moments> moments;
  CGAL::Real_timer timer;
  timer.start();
  int times = 0;
  while(times < 3 || timer.time() < 0.1) {
    energy(moments);
    ++times;
  }
  return 1e6 * timer.time() / times / double(mesh.number_of_vertices());
}

template <class Mesh>
void print_row(const Mesh& mesh, const std::vector<Region>& reference, const Sampling& sampling)
{
  const std::vector<Region> found = regions(mesh, sampling);
  const auto vertices = internal::free_vertices(mesh);
  double mean = 0, largest = 0, area = 0;
  for(std::size_t i = 0; i < found.size(); ++i) {
    const double error = std::sqrt(vertices[i]->metric_tensor().squared_length(found[i].x - reference[i].x,
                                                                               found[i].y - reference[i].y));
    mean += error / double(found.size());
    largest = (std::max)(largest, error);
    area += std::abs(found[i].area / reference[i].area - 1) / double(found.size());
  }
  std::cout << "| " << sampling.subdivisions_of_edges << " | " << sampling.steps << " | "
            << (sampling.refines_crossings ? "refined" : "raw") << " | " << std::setprecision(2) << mean << " | "
            << largest << " | " << area << " | " << std::setprecision(3)
            << microseconds_per_vertex(internal::Visibility_energy<Mesh>(mesh, measure, sampling), mesh) << " |"
            << std::endl;
}

template <class Field>
void print_table(const std::string& name, double side, const Field& field)
{
  CGAL::Anisotropic_mesh_domain_2<K> square;
  square.add_polygon(std::vector<Point>{{0, 0}, {side, 0}, {side, side}, {0, side}});
  auto mesh = CGAL::make_anisotropic_mesh_2(square, field);
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(50));

  Sampling finest;
  finest.subdivisions_of_edges = 200;
  finest.steps = 40;
  finest.parts_of_radius = 32;
  const std::vector<Region> reference = regions(mesh, finest);
  const internal::Field_metric<decltype(mesh)> metric(mesh);
  internal::Facewise_energy<decltype(mesh)> by_faces(mesh, metric, measure, internal::accurate_tolerance);
  std::cout << "\n" << name << ", " << mesh.number_of_vertices() << " vertices; by faces: " << std::setprecision(3)
            << microseconds_per_vertex(by_faces, mesh)
            << " us per vertex\n\n"
            << "| N_D | M_D | crossings | error of mass centres, mean | largest | error of areas, mean "
            << "| us per vertex |\n"
            << "| --- | --- | --- | --- | --- | --- | --- |" << std::endl;
  for(bool refines : {false, true})
    for(int n : {3, 5, 10, 20, 40})
      for(int steps : {3, 5, 10, 20, 40}) {
        Sampling sampling;
        sampling.subdivisions_of_edges = n;
        sampling.steps = steps;
        sampling.refines_crossings = refines;
        print_row(mesh, reference, sampling);
      }
}

} // namespace

int main()
{
  std::cout << "Errors of mass centres are metric lengths, errors of areas are parts of the area." << std::endl;
  print_table("square4", 4, [](const Point& p) { return Tensor::from_sizes(0.031 + p.x() / 4, 0.031 + p.y() / 4); });
  print_table("layer10", 10, [](const Point& p) {
    const double d = std::abs(p.y() - 5), h = d/5 + 0.04;
    return Tensor::from_sizes(std::abs(5 - 4*d/5) * h, h);
  });
  return 0;
}

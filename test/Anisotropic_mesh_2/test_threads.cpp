// The same bits with any number of threads.

#include "check.h"
#include "meshes.h"

#include <CGAL/acvt_optimize_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/lloyd_optimize_anisotropic_mesh_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/parallel.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

using namespace CGAL::Anisotropic_mesh_2::internal;
namespace np = CGAL::Anisotropic_mesh_2::parameters;

// the points by index, and the vertices of the faces
std::vector<double> fingerprint(const Mesh& mesh)
{
  std::vector<double> result;
  for(auto v = mesh.finite_vertices_begin(); v != mesh.finite_vertices_end(); ++v)
    for(double x : {double(v->index()), v->point().x(), v->point().y()})
      result.push_back(x);
  for(auto f = mesh.finite_faces_begin(); f != mesh.finite_faces_end(); ++f)
    for(int i = 0; i < 3; ++i)
      result.push_back(f->vertex(i)->index());
  return result;
}

template <class Optimize>
void test_same_bits(const std::string& name, const Mesh& start, const Optimize& optimize)
{
  Mesh mesh = start;
  const double energy = optimize(mesh, CGAL::Sequential_tag());
  const std::vector<double> expected = fingerprint(mesh);
  CHECK_MSG(expected != fingerprint(start), name);
  for(int threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    mesh = start;
    CHECK_MSG(optimize(mesh, CGAL::Parallel_tag()) == energy, name + ", threads: " + std::to_string(threads));
    CHECK_MSG(fingerprint(mesh) == expected, name + ", threads: " + std::to_string(threads));
  }
}

void test_optimizers(const Case& c)
{
  const Mesh start = CGAL::make_anisotropic_mesh_2
    (c.domain, c.field, np::point_placement(CGAL::Anisotropic_mesh_2::Point_placement::EDGE_SUBDIVISION));
  test_same_bits(c.name + " by the quasi-Newton method", start, [](Mesh& mesh, auto tag) {
    CGAL::acvt_optimize_mesh_2<decltype(tag)>(mesh, CGAL::parameters::number_of_iterations(12));
    return CGAL::anisotropic_mesh_statistics_2<decltype(tag)>(mesh).energy;
  });
  test_same_bits(c.name + " by Lloyd's iteration", start, [](Mesh& mesh, auto tag) {
    CGAL::lloyd_optimize_anisotropic_mesh_2<decltype(tag)>(mesh, CGAL::parameters::number_of_iterations(3));
    return CGAL::anisotropic_mesh_statistics_2<decltype(tag)>(mesh).energy;
  });
}

// Of several failures the one of the first task is reported.
void test_exceptions()
{
  for(int threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK_THROWS(for_each_index<CGAL::Parallel_tag>(100000, [](std::size_t i) {
      if(i % 1000 == 777)
        throw std::runtime_error("at " + std::to_string(i));
    }), std::runtime_error, "at 777");
  }
}

void test_sums()
{
  const auto f = [](std::size_t i) { return std::sin(double(i)) / double(i + 1); };
  const double expected = sum_over<CGAL::Sequential_tag>(100001, f);
  double plain = 0;
  for(std::size_t i = 0; i < 100001; ++i)
    plain += f(i);
  CHECK(std::abs(expected - plain) < 1e-12);
  for(int threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(sum_over<CGAL::Parallel_tag>(100001, f) == expected);
  }
}

int main()
{
  Case fine = paper_cases()[1];
  fine.name = "square4 with 5000 vertices";
  fine.field = [](const Point& p) { return Tensor::from_sizes(0.22 * (0.031 + p.x() / 4), 0.22 * (0.031 + p.y() / 4)); };
  test_optimizers(fine);
  test_optimizers(unit_square_cases()[2]);
  test_exceptions();
  test_sums();
  return finish();
}

#else

int main()
{
  CHECK_MSG(true, "without TBB there is one thread");
  return finish();
}

#endif

// The same bits with any number of threads.

#include "check.h"
#include "meshes.h"
#include "voronoi_diagrams.h"

#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/anisotropic_mesh_statistics_2.h>
#include <CGAL/Anisotropic_mesh_2/internal/base/parallel.h>
#include <CGAL/Anisotropic_mesh_2/IO/SVG.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
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
    CGAL::optimize_anisotropic_mesh_2<decltype(tag)>(mesh, CGAL::parameters::number_of_iterations(12));
    return CGAL::anisotropic_mesh_statistics_2<decltype(tag)>(mesh).energy;
  });
  test_same_bits(c.name + " by Lloyd's iteration", start, [](Mesh& mesh, auto tag) {
    CGAL::optimize_anisotropic_mesh_2<decltype(tag)>(mesh, lloyd_method.number_of_iterations(3));
    return CGAL::anisotropic_mesh_statistics_2<decltype(tag)>(mesh).energy;
  });
}

void test_full_regions(const Case& c)
{
  test_same_bits(c.name + " by full regions", CGAL::make_anisotropic_mesh_2(c.domain, c.field), [](Mesh& mesh, auto tag) {
    const auto evaluation = CGAL::Anisotropic_mesh_2::Region_evaluation::FULL_REGIONS;
    CGAL::optimize_anisotropic_mesh_2<decltype(tag)>
      (mesh, lloyd_method.region_evaluation(evaluation).number_of_iterations(2));
    return CGAL::anisotropic_mesh_statistics_2<decltype(tag)>(mesh).energy;
  });
}

void add(const std::vector<Point>& points, std::vector<double>& result)
{
  result.push_back(double(points.size()));
  for(const Point& p : points)
    for(double x : {p.x(), p.y()})
      result.push_back(x);
}

template <class Diagram>
std::vector<double> fingerprint_of_regions(const Diagram& diagram)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < diagram.number_of_regions(); ++i) {
    const auto& r = diagram.region(i);
    const auto integrals = diagram.integrals(i);
    for(double x : {r.area, double(r.number_of_orphans()), integrals.area, integrals.energy})
      result.push_back(x);
    add({integrals.mass_centre}, result);
    for(const auto& piece : r.pieces) {
      result.push_back(piece.area);
      for(const auto& boundary : piece.boundaries)
        add(boundary, result);
    }
    for(const auto& tile : r.tiles)
      add({tile[0], tile[1], tile[2]}, result);
    result.insert(result.end(), diagram.neighbors(i).begin(), diagram.neighbors(i).end());
  }
  return result;
}

template <class Diagram>
std::vector<double> fingerprint_of_bisectors(const Diagram& diagram)
{
  std::vector<double> result;
  for(const auto& b : diagram.bisectors()) {
    for(std::size_t x : {b.regions[0], b.regions[1], std::size_t(b.is_closed), std::size_t(b.is_between_main_pieces)})
      result.push_back(double(x));
    add(b.points, result);
  }
  return result;
}

template <class Diagram>
std::string picture_of(const Diagram& diagram)
{
  CGAL::Anisotropic_mesh_2::Voronoi_drawing drawing;
  drawing.dual_edges = drawing.mass_centres = drawing.generators = true;
  std::ostringstream os;
  CGAL::IO::write_SVG(os, diagram, "threads", drawing);
  return os.str();
}

struct Fingerprints
{
  std::vector<double> regions, bisectors;
  std::string         picture;

  template <class Diagram>
  explicit Fingerprints(const Diagram& diagram)
    : regions(fingerprint_of_regions(diagram)), bisectors(fingerprint_of_bisectors(diagram)), picture(picture_of(diagram))
  {}
};

template <class Distance>
void test_diagram(const Mesh& mesh, const std::string& name)
{
  const Fingerprints expected(CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Distance, CGAL::Sequential_tag>{mesh});
  for(int threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Fingerprints f(CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Distance, CGAL::Parallel_tag>{mesh});
    CHECK_MSG(f.regions == expected.regions, name + ", threads: " + std::to_string(threads));
    CHECK_MSG(f.bisectors == expected.bisectors, name + ", threads: " + std::to_string(threads));
    CHECK_MSG(f.picture == expected.picture, name + ", threads: " + std::to_string(threads));
  }
}

// random generators have many orphans
void test_diagrams(const Case& graded)
{
  const Mesh mesh = CGAL::make_anisotropic_mesh_2(graded.domain, graded.field);
  test_diagram<Directional>(mesh, graded.name);
  test_diagram<Labelle_Shewchuk>(mesh, graded.name + " at generators");
  const Mesh random = mesh_of(square(), random_points(1000, 5), layer_field);
  const Diagram diagram(random);
  std::size_t orphans = 0;
  for(const auto& r : diagram.regions())
    orphans += r.number_of_orphans();
  CHECK_MSG(orphans > 0, "orphans: " + std::to_string(orphans));
  test_diagram<Directional>(random, "random generators");
}

// a field that notes whether a thread other than that of its construction has called it
class Watchful_field
{
public:
  Tensor operator()(const Point& p) const
  {
    if(std::this_thread::get_id() != m_owner)
      *m_is_shared = true;
    return Tensor::from_sizes(0.01 + p.x() / 50, 0.02, p.y());
  }

  bool is_shared() const { return *m_is_shared; }

private:
  std::thread::id                     m_owner = std::this_thread::get_id();
  std::shared_ptr<std::atomic<bool> > m_is_shared = std::make_shared<std::atomic<bool> >(false);
};

// Who links TBB for another reason has his field called by one thread, unless he asks for more.
void test_one_thread_by_default()
{
  const Watchful_field field;
  auto mesh = CGAL::make_anisotropic_mesh_2(box(0, 1), field);
  const auto start = mesh;
  typedef decltype(mesh) Watched_mesh;
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(3));
  CGAL::optimize_anisotropic_mesh_2(mesh, lloyd_method.number_of_iterations(1));
  CGAL::anisotropic_mesh_statistics_2(mesh);
  CGAL::Anisotropic_Voronoi_diagram_2<Watched_mesh>{mesh};
  CHECK(!field.is_shared());
  mesh = start;
  CGAL::optimize_anisotropic_mesh_2<CGAL::Parallel_tag>(mesh, CGAL::parameters::number_of_iterations(3));
  CHECK(std::thread::hardware_concurrency() < 2 || field.is_shared());
}

// a field that fails in a corner of the domain, after the vertices have their tensors
void test_failing_field()
{
  bool fails = false;
  const Mesh mesh = mesh_of(square(), random_points(1000, 6), [&](const Point& p) {
    if(fails && p.x() + p.y() > 1.5)
      throw std::runtime_error("no tensor here");
    return turning(p);
  });
  fails = true;
  for(int threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK_THROWS((CGAL::Anisotropic_Voronoi_diagram_2<Mesh, Directional, CGAL::Parallel_tag>{mesh}), std::runtime_error, "no tensor here");
  }
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
  test_full_regions(paper_cases()[2]);
  test_diagrams(fine);
  test_one_thread_by_default();
  test_failing_field();
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

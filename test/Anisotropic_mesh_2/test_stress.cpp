// Random domains under random metrics: whatever they are, every step leaves a
// strictly valid mesh that keeps its area, its constraints and its vertices.
//
//   test_stress [DATA_DIRECTORY [SEED [SECONDS]]]
//
// Without SECONDS it takes a fixed number of rounds.
// A failure prints the seed of its round; with that seed it is the first round.

#include "check.h"
#include "meshes.h"

#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/acvt_optimize_mesh_2.h>
#include <CGAL/lloyd_optimize_anisotropic_mesh_2.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace np = CGAL::Anisotropic_mesh_2::parameters;

const double pi = std::acos(-1.);

// A domain in coordinates x = offset + scale * u, with u of the order of 1.
class Random_case
{
public:
  explicit Random_case(unsigned int seed) : m_random(seed)
  {
    m_scale = m_random.get_int(0, 3) == 0 ? std::pow(10., m_random.get_int(-30, 31)) : 1.;
    m_offset = m_random.get_int(0, 4) == 0 ? 1000 * m_scale : 0.;
    make_domain();
    make_field();
  }

  const CGAL::Anisotropic_mesh_domain_2<K>& domain() const { return m_domain; }
  const Field& field() const { return m_field; }
  std::string description() const { return m_description.str(); }

private:
  Point at(double u, double v) const { return Point(m_offset + m_scale*u, m_offset + m_scale*v); }

  double exponential(double lower, double upper)
  {
    return std::exp(m_random.get_double(std::log(lower), std::log(upper)));
  }

  // a star-shaped polygon around (u, v)
  std::vector<Point> star(double u, double v, double smallest, double largest, int corners)
  {
    std::vector<Point> polygon;
    for(int i = 0; i < corners; ++i) {
      const double angle = 2*pi * (i + 0.9 * m_random.get_double()) / corners;
      const double r = m_random.get_double(smallest, largest);
      polygon.push_back(at(u + r * std::cos(angle), v + r * std::sin(angle)));
    }
    return polygon;
  }

  void make_domain()
  {
    // with nine corners at least, what lies within 0.5 of the centre is inside
    m_domain.add_polygon(star(0, 0, 0.75, 1.5, m_random.get_int(9, 18)), 1);
    const int kind = m_random.get_int(0, 5);
    m_description << "scale " << m_scale << ", offset " << m_offset << ", domain " << kind;
    if(kind == 1)
      m_domain.add_circle(at(0, 0), 0.3 * m_scale, 2);
    else if(kind == 2) // two holes that nearly touch
      for(double side : {-1., 1.})
        m_domain.add_circle(at(side * 0.2, 0), (0.2 - exponential(1e-6, 1e-2)) * m_scale, 2);
    else if(kind == 3) // a slit
      m_domain.add_polygon(std::vector<Point>{at(-0.3, 0), at(0.3, 0), at(0, exponential(1e-6, 1e-2))}, 2);
    else if(kind == 4) { // inner curves
      m_domain.add_constraint(CGAL::Curve_piece_2<K>::segment(at(-0.3, -0.2), at(0.3, 0.1), 3));
      m_domain.add_constraint(CGAL::Curve_piece_2<K>::arc(at(0, 0.2), 0.15 * m_scale, 0.1, 3, 4));
    }
  }

  void make_field()
  {
    const int kind = m_random.get_int(0, 6);
    const double h = exponential(0.04, 0.3), ratio = exponential(1, kind == 0 ? 1e8 : 100);
    const double angle = m_random.get_double(0, pi), turn = exponential(0.1, 10), jump = exponential(1, 20);
    const double s = m_scale, o = m_offset;
    m_description << ", metric " << kind << " h " << h << " ratio " << ratio << " turn " << turn << " jump " << jump;
    m_field = [=](const Point& p) {
      const double u = (p.x() - o) / s, v = (p.y() - o) / s;
      switch(kind) {
      case 0:  return Tensor::from_sizes(s*h, s*h*ratio, angle);                               // constant
      case 1:  return Tensor::from_sizes(s*h/ratio, s*h, turn * (u + 0.3*v));                  // turning
      case 2:  return Tensor::from_size(u + 0.2*v < 0.1 ? s*h/jump : s*h);                     // discontinuous
      case 3:  return Tensor::from_size(s * (h/jump + 0.3 * std::hypot(u - 0.2, v)));          // graded
      case 4:  return Tensor::from_sizes(s * (h/jump + 0.3*std::abs(std::hypot(u, v) - 0.5)), s*h,
                                         std::atan2(v, u));                                    // a layer around a circle
      default: return Tensor::from_sizes(s * h * std::exp(std::sin(turn*u)), s * h * std::exp(std::cos(turn*v)), u*v);
      }
    };
  }

  CGAL::Random m_random;
  double m_scale, m_offset;
  CGAL::Anisotropic_mesh_domain_2<K> m_domain;
  Field m_field;
  std::ostringstream m_description;
};

std::size_t number_of_constraints(const Mesh& mesh)
{
  std::size_t n = 0;
  for(const Mesh::Edge& e : mesh.edges_in_domain())
    n += mesh.is_constrained(e);
  return n;
}

void check_against(const Mesh& mesh, const Mesh& start, const std::string& what)
{
  CHECK_MSG(mesh.is_valid(true), what);
  CHECK_MSG(mesh.number_of_vertices() == start.number_of_vertices(), what);
  CHECK_MSG(number_of_constraints(mesh) == number_of_constraints(start), what);
  CHECK_MSG(std::abs(area_of(mesh) / area_of(start) - 1) < 1e-11, what);
}

// Returns whether a mesh was made: a metric may ask for too many vertices.
bool run(unsigned int seed)
{
  const Random_case c(seed);
  const std::string what = "seed " + std::to_string(seed) + ": " + c.description();
  try {
    const Mesh start = CGAL::make_anisotropic_mesh_2(c.domain(), c.field(), np::maximum_number_of_vertices(8000));
    const Mesh empty = start.empty_mesh();
    CHECK_MSG(start.is_valid(true), what);
    CHECK_MSG(number_of_constraints(empty) == number_of_constraints(start), what);
    CHECK_MSG(std::abs(area_of(empty) / area_of(start) - 1) < 1e-11, what);
    Mesh mesh = start;
    CGAL::acvt_optimize_mesh_2(mesh, CGAL::parameters::number_of_iterations(6));
    check_against(mesh, start, what + ", after the quasi-Newton method");
    CGAL::lloyd_optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(2));
    check_against(mesh, start, what + ", after Lloyd's iteration");
    return true;
  }
  catch(const CGAL::Too_many_vertices_exception&) {
    return false;
  }
  catch(const std::exception& e) {
    CHECK_MSG(false, what + ": " + e.what());
    return false;
  }
}

int main(int argc, char* argv[])
{
  const unsigned int first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const double seconds = argc > 3 ? std::atof(argv[3]) : 0;
  const unsigned int rounds = 250;
  CGAL::Real_timer timer;
  timer.start();
  unsigned int meshes = 0, seed = first;
  meshes += run(203298); // found squared lengths that rounding made negative
  for(; argc > 3 ? timer.time() < seconds : seed < first + rounds; ++seed)
    meshes += run(seed);
  std::cout << "seeds " << first << " to " << seed - 1 << ", " << meshes << " meshes" << std::endl;
  CHECK(meshes > 0);
  return finish();
}

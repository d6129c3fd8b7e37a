// Random domains under random metrics, and random sequences of what one can do
// with them: whatever they are, every step leaves a strictly valid triangulation
// that keeps its area, its constraints and its vertices.
//
//   test_stress [DATA_DIRECTORY [SEED [SECONDS]]]
//
// Without SECONDS it takes a fixed number of rounds.
// A failure prints the seed of its round; with that seed it is the first round.

#include "check.h"
#include "meshes.h"

#include <CGAL/Constrained_anisotropic_Delaunay_triangulation_2.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
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

  // Where sizes jump, the vertices at one moment may all have the same tensor,
  // while those before them had another: edges need not be Delaunay then.
  int strictest_level() const { return m_metric_kind == 7 ? 1 : 2; }

  // a point in the domain or near to it, or of a grid
  Point random_point()
  {
    if(m_random.get_int(0, 4) == 0)
      return at(m_random.get_int(-8, 9) / 8., m_random.get_int(-8, 9) / 8.);
    const double u = m_random.get_double(-1, 1);
    return at(u, m_random.get_double(-1, 1));
  }

  int random_number(std::size_t n) { return n == 0 ? 0 : m_random.get_int(0, int(n)); }

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
    const int kind = m_random.get_int(0, 7);
    std::vector<Point> outer = star(0, 0, 0.75, 1.5, m_random.get_int(9, 18));
    if(kind == 5) // a needle, of an angle down to 1e-8
      outer[0] = at(m_random.get_double(10, 100), exponential(1e-6, 1e-1));
    m_domain.add_polygon(outer, 1);
    m_description << "scale " << m_scale << ", offset " << m_offset << ", domain " << kind;
    if(kind == 1)
      m_domain.add_circle(at(0, 0), 0.3 * m_scale, 2);
    else if(kind == 2) // two holes that nearly touch
      for(double side : {-1., 1.})
        m_domain.add_circle(at(side * 0.2, 0), (0.2 - exponential(1e-6, 1e-2)) * m_scale, 2);
    else if(kind == 3) // a slit
      m_domain.add_polygon(std::vector<Point>{at(-0.3, 0), at(0.3, 0), at(0, exponential(1e-6, 1e-2))}, 2);
    else if(kind == 4) { // inner curves
      m_domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::segment(at(-0.3, -0.2), at(0.3, 0.1), 3));
      m_domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::arc(at(0, 0.2), 0.15 * m_scale, 0.1, 3, 4));
    }
    else if(kind == 6) { // slits: inner curves that meet, and end near to another one
      for(int i = 0; i < 5; ++i)
        m_domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::segment(at(0, 0), at(0.4 * std::cos(i), 0.4 * std::sin(i)), i));
      m_domain.add_constraint(CGAL::Anisotropic_mesh_2::Curve_piece_2<K>::segment(at(0.1, exponential(1e-6, 1e-2)), at(0.3, 0.1), 9));
    }
  }

  void make_field()
  {
    const int kind = m_metric_kind = m_random.get_int(0, 8);
    const double h = exponential(0.04, 0.3), ratio = exponential(1, kind == 0 || kind >= 6 ? 1e8 : 100);
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
      case 5:  return Tensor::from_sizes(s * h * std::exp(std::sin(turn*u)), s * h * std::exp(std::cos(turn*v)), u*v);
      case 6:  return Tensor::from_sizes(s*h, s*h*ratio, turn * (u + 0.3*v));                  // thin as can be, turning
      default: return Tensor::from_sizes(u + 0.2*v < 0.1 ? s*h*1e6 : s*h, s*h*ratio, angle);   // sizes that jump
      }
    };
  }

  CGAL::Random m_random;
  double m_scale, m_offset;
  int m_metric_kind;
  CGAL::Anisotropic_mesh_domain_2<K> m_domain;
  Field m_field;
  std::ostringstream m_description;
};

// ---------------------------------------------------------------- the kernel alone

typedef CGAL::Constrained_anisotropic_Delaunay_triangulation_2<CGAL::Riemannian_metric_traits_2<K, Field> > Kernel;

long operations = 0;

// Points and constraints that come, go and move; the constraints are known by their ends.
class Kernel_trial
{
public:
  Kernel_trial(Random_case& c, const std::string& what) : m_case(c), m_what(what), m_t(Kernel::Geom_traits(c.field())) {}

  void run(int steps)
  {
    for(int i = 0; i < steps; ++i, ++operations) {
      step();
      CHECK_MSG(m_t.is_valid(true, m_case.strictest_level()) && m_t.number_of_vertices() == m_vertices.size(), m_what);
      for(const auto& c : m_constraints)
        CHECK_MSG(is_there(c.first, c.second), m_what);
    }
  }

private:
  typedef Kernel::Vertex_handle Vertex_handle;

  void step()
  {
    const int kind = m_case.random_number(10);
    if(kind < 5 || m_vertices.size() < 3)
      insert(m_case.random_point());
    else if(kind == 5)
      insert_constraint(random_vertex(), random_vertex());
    else {
      const Vertex_handle v = random_vertex();
      if(m_t.are_there_incident_constraints(v))
        return;
      if(kind == 6) {
        CHECK_MSG(m_t.remove(v), m_what);
        m_vertices.erase(std::find(m_vertices.begin(), m_vertices.end(), v));
      }
      else {
        const Point p = m_case.random_point();
        CHECK_MSG(m_t.move_if_no_collision(v, p)->point() == p, m_what);
      }
    }
  }

  void insert(const Point& p)
  {
    const auto before = m_t.number_of_vertices();
    const Vertex_handle v = m_t.insert(p);
    if(m_t.number_of_vertices() > before)
      m_vertices.push_back(v);
  }

  void insert_constraint(Vertex_handle v, Vertex_handle w)
  {
    if(v == w)
      return;
    try {
      m_t.insert_constraint(v, w);
      m_constraints.emplace_back(v, w);
    }
    catch(const Kernel::Intersection_of_constraints_exception&) {}
  }

  // along constrained edges, for other vertices may lie on the constraint
  bool is_there(Vertex_handle v, Vertex_handle w) const
  {
    while(v != w) {
      Vertex_handle next;
      Kernel::Face_handle f;
      int i;
      if(!m_t.includes_edge(v, w, next, f, i) || !f->is_constrained(i))
        return false;
      v = next;
    }
    return true;
  }

  Vertex_handle random_vertex() { return m_vertices[std::size_t(m_case.random_number(m_vertices.size()))]; }

  Random_case& m_case;
  const std::string& m_what;
  Kernel m_t;
  std::vector<Vertex_handle> m_vertices;
  std::vector<std::pair<Vertex_handle, Vertex_handle> > m_constraints;
};

// ---------------------------------------------------------------- meshes

std::size_t number_of_constraints(const Mesh& mesh)
{
  std::size_t n = 0;
  for(const Mesh::Edge& e : mesh.edges_in_domain())
    n += mesh.is_constrained(e);
  return n;
}

// A mesh that is optimized and changed; its domain stays.
class Mesh_trial
{
public:
  Mesh_trial(Random_case& c, const std::string& what)
    : m_case(c), m_what(what),
      m_mesh(CGAL::make_anisotropic_mesh_2(c.domain(), c.field(), np::maximum_number_of_vertices(8000))),
      m_area(area_of(m_mesh)), m_constraints(number_of_constraints(m_mesh)), m_vertices(m_mesh.number_of_vertices())
  {
    check(m_mesh, "as made");
    m_vertices = m_mesh.empty_mesh().number_of_vertices();
    check(m_mesh.empty_mesh(), "empty");
    m_vertices = m_mesh.number_of_vertices();
  }

  void run()
  {
    optimize(5);
    check(m_mesh, "after the quasi-Newton method");
    change(30);
    CGAL::optimize_anisotropic_mesh_2(m_mesh, lloyd_method.number_of_iterations(2));
    check(m_mesh, "after Lloyd's iteration");
    change(10);
    optimize(2);
    check(m_mesh, "at the end");
  }

private:
  // quality moves may insert and remove
  void optimize(int iterations)
  {
    CGAL::optimize_anisotropic_mesh_2(m_mesh, CGAL::parameters::number_of_iterations(iterations));
    m_vertices = m_mesh.number_of_vertices();
  }

  void check(const Mesh& mesh, const char* when) const
  {
    const std::string what = m_what + ", " + when;
    CHECK_MSG(mesh.is_valid(true, m_case.strictest_level()), what);
    CHECK_MSG(mesh.number_of_vertices() == m_vertices, what);
    CHECK_MSG(number_of_constraints(mesh) == m_constraints, what);
    CHECK_MSG(std::abs(area_of(mesh) / m_area - 1) < 1e-11, what);
    ++operations;
  }

  // inserts, removes and moves vertices that are free
  void change(int steps)
  {
    std::vector<Mesh::Vertex_handle> free;
    for(auto v = m_mesh.finite_vertices_begin(); v != m_mesh.finite_vertices_end(); ++v)
      if(!m_mesh.is_fixed(v))
        free.push_back(v);
    for(int i = 0; i < steps; ++i) {
      const int kind = m_case.random_number(3), which = m_case.random_number(free.size());
      const Point p = m_case.random_point();
      Mesh::Locate_type lt;
      int li;
      const auto f = m_mesh.locate(p, lt, li);
      if(free.empty() || (kind == 0 && m_mesh.is_field_point(lt, f, li))) {
        if(!m_mesh.is_field_point(lt, f, li))
          continue;
        free.push_back(m_mesh.insert(p));
        ++m_vertices;
      }
      else if(kind == 1) {
        CHECK_MSG(m_mesh.remove(free[std::size_t(which)]), m_what);
        free.erase(free.begin() + which);
        --m_vertices;
      }
      else if(kind == 2 && m_mesh.is_field_point(lt, f, li))
        m_mesh.move_if_no_collision(free[std::size_t(which)], p);
      check(m_mesh, "after changes");
    }
  }

  Random_case& m_case;
  const std::string& m_what;
  Mesh m_mesh;
  const double m_area;
  const std::size_t m_constraints;
  std::size_t m_vertices;
};

// Returns whether a mesh was made: a metric may ask for too many vertices.
bool run(unsigned int seed)
{
  Random_case c(seed);
  const std::string what = "seed " + std::to_string(seed) + ": " + c.description();
  try {
    Kernel_trial(c, what).run(60);
    Mesh_trial(c, what).run();
    return true;
  }
  catch(const CGAL::Anisotropic_mesh_2::Too_many_vertices_exception&) {
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
  meshes += run(100932); // found flips that rounding made rise in quality in a circle
  for(; argc > 3 ? timer.time() < seconds : seed < first + rounds; ++seed)
    meshes += run(seed);
  std::cout << "seeds " << first << " to " << seed - 1 << ", " << meshes << " meshes, " << operations << " operations"
            << std::endl;
  CHECK(meshes > 0);
  return finish();
}

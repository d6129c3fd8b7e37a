// Poisson's equation -Laplace u = f by linear finite elements, on a square with a
// round hole; f and the boundary values are those of a solution with a thin layer
// around the hole. Table: the errors on uniform, graded, and anisotropic meshes.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Anisotropic_mesh_domain_2.h>
#include <CGAL/Hessian_metric_field_2.h>
#include <CGAL/optimize_anisotropic_mesh_2.h>
#include <CGAL/make_anisotropic_mesh_2.h>

#include <Eigen/Eigen>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

using K        = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vector   = Eigen::Vector2d;
using Point    = Eigen::Vector3d; // (x, y, 1)
using Triangle = Eigen::Matrix3d; // a column per corner; the inverse makes of points barycentric coordinates

const double radius = 0.5, width = 0.02; // of the hole and of the layer

struct Jet { double value; Vector gradient; Eigen::Matrix2d hessian; };

// u = exp((radius - r) / width) + x y
Jet solution(double x, double y)
{
  const double r = std::hypot(x, y), e = std::exp((radius - r) / width);
  const Vector n(x / r, y / r), t(-n.y(), n.x());
  return {e + x*y, -e/width * n + Vector(y, x),
          e/width * (n*n.transpose() / width - t*t.transpose() / r) + Eigen::Matrix2d{{0, 1}, {1, 0}}};
}

using Entries = std::array<double, 3>; // those of a Hessian: xx, xy, yy
using Hessian = Entries (*)(const K::Point_2&);
using Field   = CGAL::Hessian_metric_field_2<K, Hessian>;
using Mesh    = CGAL::Anisotropic_Delaunay_mesh_2<CGAL::Riemannian_metric_traits_2<K> >;

Entries uniform(const K::Point_2&) { return {1, 0, 1}; }
// the larger curvature, which gives the smaller size, in all directions
Entries graded(const K::Point_2& p)
{
  const double largest = solution(p.x(), p.y()).hessian.selfadjointView<Eigen::Lower>().operatorNorm();
  return {largest, 0, largest};
}

Entries anisotropic(const K::Point_2& p)
{
  const Eigen::Matrix2d h = solution(p.x(), p.y()).hessian;
  return {h(0, 0), h(0, 1), h(1, 1)};
}

Mesh unit_mesh(Hessian hessian, double size)
{
  CGAL::Anisotropic_mesh_domain_2<K> domain;
  domain.add_polygon(std::vector<K::Point_2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  domain.add_circle({0, 0}, radius);
  return CGAL::make_anisotropic_mesh_2(domain, Field(hessian, size*size, 1e-5, 0.5, 2)); // 2: L2 norm
}

// The number of vertices is, but for the boundary, proportional to 1/size^2.
Mesh mesh_of_size(double n, Hessian hessian)
{
  double size = 4 / std::sqrt(n); // rather too coarse, since coarse meshes are cheap
  Mesh mesh = unit_mesh(hessian, size);
  for(int i = 0; i < 2; ++i)
    mesh = unit_mesh(hessian, size *= std::sqrt(double(mesh.number_of_vertices()) / n));
  CGAL::optimize_anisotropic_mesh_2(mesh, CGAL::parameters::number_of_iterations(15));
  return mesh;
}

// the mean of f over a triangle, by a rule of seven points that is exact for polynomials of degree 5
template <class F>
auto mean_by_rule(const Triangle& t, const F& f)
{
  auto sum = (9/40. * f(t.rowwise().mean())).eval();
  for(double root : {-std::sqrt(15.), std::sqrt(15.)})
    for(int i = 0; i < 3; ++i)
      sum += (155 + root) / 1200 * f((6 + root) / 21 * t.rowwise().sum() + (1 - root) / 7 * t.col(i));
  return sum;
}

// Triangles are quartered until they are no longer than the layer is wide, or than they are far from it.
template <class F>
auto mean(const Triangle& t, const F& f) -> decltype(mean_by_rule(t, f))
{
  Triangle middles;
  middles << (t.col(0) + t.col(1)) / 2, (t.col(1) + t.col(2)) / 2, (t.col(2) + t.col(0)) / 2;
  const double distance = t.topRows<2>().colwise().norm().minCoeff() - radius;
  if(2 * (middles - t).colwise().norm().maxCoeff() <= (std::max)(width, distance))
    return mean_by_rule(t, f);
  auto sum = mean(middles, f);
  for(int i = 0; i < 3; ++i)
    sum += mean((Triangle() << t.col(i), middles.col(i), middles.col((i + 2) % 3)).finished(), f);
  return sum / 4;
}

struct Element { std::array<int, 3> vertices; Triangle triangle; double area; };

std::vector<Element> elements_of(const Mesh& mesh)
{
  std::vector<Element> elements;
  for(auto f : mesh.finite_face_handles()) {
    const auto u = f->vertex(0), v = f->vertex(1), w = f->vertex(2);
    const Triangle t{{u->point().x(), v->point().x(), w->point().x()},
                     {u->point().y(), v->point().y(), w->point().y()}, {1, 1, 1}};
    if(f->is_in_domain())
      elements.push_back({{u->index(), v->index(), w->index()}, t, t.determinant() / 2});
  }
  return elements;
}

// the values of the discrete solution at the vertices, in the order of their indices
Eigen::VectorXd solve(const Mesh& mesh, const std::vector<Element>& elements)
{
  const int n = int(mesh.vertex_index_bound());
  Eigen::VectorXd given = Eigen::VectorXd::Zero(n), load = given;
  std::vector<Eigen::Triplet<double> > choice, stiffness; // `choice`: of the free vertices
  for(auto v : mesh.finite_vertex_handles())
    if(mesh.is_fixed(v))
      given[v->index()] = solution(v->point().x(), v->point().y()).value;
    else
      choice.emplace_back(v->index(), int(choice.size()), 1);
  for(const Element& e : elements) {
    const Eigen::Matrix3d hats = e.triangle.inverse();
    load(e.vertices) += e.area * mean(e.triangle, [&](const Point& p) -> Eigen::Vector3d
                                      { return -solution(p.x(), p.y()).hessian.trace() * hats * p; });
    const Eigen::Matrix3d entries = e.area * hats.leftCols<2>() * hats.leftCols<2>().transpose();
    for(int i = 0; i < 9; ++i)
      stiffness.emplace_back(e.vertices[i / 3], e.vertices[i % 3], entries(i / 3, i % 3));
  }
  Eigen::SparseMatrix<double> c(n, int(choice.size())), a(n, n);
  c.setFromTriplets(choice.begin(), choice.end());
  a.setFromTriplets(stiffness.begin(), stiffness.end());
  const Eigen::SimplicialLDLT<decltype(a)> solver(c.transpose() * a * c);
  return given + c * solver.solve(c.transpose() * (load - a * given));
}

// the L2 norms of the error and of its gradient
Vector errors(const std::vector<Element>& elements, const Eigen::VectorXd& values)
{
  Vector squares(0, 0);
  for(const Element& e : elements) {
    const Eigen::RowVector3d u = values(e.vertices).transpose() * e.triangle.inverse(); // u * p: value at p
    squares += e.area * mean(e.triangle, [&](const Point& p) -> Vector {
      const Jet exact = solution(p.x(), p.y());
      return {std::pow(exact.value - u*p, 2), (exact.gradient - u.head<2>().transpose()).squaredNorm()};
    });
  }
  return squares.cwiseSqrt();
}

// prints and returns the number of vertices and both errors
Eigen::Array3d solve_on_mesh(const char* kind, double n, Hessian hessian)
{
  const Mesh mesh = mesh_of_size(n, hessian);
  const std::vector<Element> elements = elements_of(mesh);
  const Vector e = errors(elements, solve(mesh, elements));
  std::cout << kind << '\t' << mesh.number_of_vertices() << '\t' << e[0] << '\t' << e[1] << std::endl;
  return {double(mesh.number_of_vertices()), e[0], e[1]};
}

int main()
{
  std::cout << "mesh\tvertices\tL2 error\tH1 error\n";
  bool is_best = true;
  std::vector<Eigen::Array3d> series;
  for(double n : {200, 640, 2000, 6400, 20000}) {
    const Eigen::Array3d a = solve_on_mesh("uniform", n, uniform), b = solve_on_mesh("graded", n, graded);
    series.push_back(solve_on_mesh("anisotropic", n, anisotropic));
    is_best = is_best && (series.back() < a.min(b)).tail<2>().all();
  }
  const Eigen::Array3d ratios = (series[4] / series[2]).log(); // the first ones do not resolve the layer yet
  const double order = -2 * ratios[1] / ratios[0];
  std::cout << "\norder of the L2 errors on anisotropic meshes: " << order << '\n';
  return is_best && std::abs(order - 2) < 0.2 ? 0 : 1;
}

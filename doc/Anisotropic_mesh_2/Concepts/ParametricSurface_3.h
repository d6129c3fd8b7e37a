/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `ParametricSurface_3` describes a surface in space as the image of
/// a rectangle of parameters (section 5.2 of \cgalCite{dw-acvt-05}).
///
/// \cgalRefines{CopyConstructible}
///
/// All functions may be called from several threads at the same time. Outside of the rectangle they need be
/// defined in periodic directions only. The first derivatives must not be parallel,
/// but for the poles; the side to which \f$ \sigma_u \times \sigma_v \f$ points is the
/// outer one of a closed surface. The second derivatives are used by metrics of curvature only.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Callable_surface_3<K, Function>}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Parametric_ellipsoid_3<K>}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Parametric_torus_3<K>}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Quadratic_graph_surface_3<K>}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Triangulated_surface_3<K>}
/// \cgalHasModelsEnd
class ParametricSurface_3
{
public:
  /// a model of `Kernel`.
  typedef unspecified_type Kernel;

  /// the rectangle of parameters, which is valid.
  CGAL::Anisotropic_mesh_2::Parameter_rectangle parameters() const;

  /// the point with the parameters `uv`.
  Kernel::Point_3 point(const Kernel::Point_2& uv) const;

  /// the derivatives by u and by v.
  std::array<Kernel::Vector_3, 2> first_derivatives(const Kernel::Point_2& uv) const;

  /// the derivatives twice by u, by u and v, and twice by v.
  std::array<Kernel::Vector_3, 3> second_derivatives(const Kernel::Point_2& uv) const;
};

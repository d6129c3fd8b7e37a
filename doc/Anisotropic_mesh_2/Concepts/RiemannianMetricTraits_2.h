/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `RiemannianMetricTraits_2` describes the requirements of the
/// geometric traits of `CGAL::Constrained_anisotropic_Delaunay_triangulation_2`
/// and of all that builds on it: the plane under a metric field. The field is
/// state of the traits, shared by their copies.
///
/// Default constructed traits need not hold a field; they are only assigned to.
/// Function objects are copied and called, and used as long as a copy of the
/// traits that made them lives.
///
/// Where constraints may intersect, that is, with a tag other than
/// `CGAL::No_constraint_intersection_requiring_constructions_tag`, traits must
/// also model `ConstrainedTriangulationTraits_2`.
///
/// \cgalRefines{TriangulationTraits_2,SpatialSortingTraits_2}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Riemannian_metric_traits_2<K, MetricField>}
/// \cgalHasModelsEnd
class RiemannianMetricTraits_2
{
public:
  /// \name Types
  /// @{

  /// the number type of coordinates and tensors, a model of `FieldNumberType`
  /// that mixes with `int` and can be constructed from `double`. Other
  /// conversions are explicit, by `FT(double)` and `CGAL::to_double()`.
  typedef unspecified_type FT;

  /// the type of points: default and copy constructible, assignable, constructible
  /// from two coordinates `(FT, FT)`, which its members `x()` and `y()` return.
  typedef unspecified_type Point_2;

  /// a class whose types `FT` and `Point_2` are those of the traits, and whose
  /// type `Vector_2` may be incomplete; for example a kernel of \cgal.
  typedef unspecified_type Kernel;

  /// `CGAL::Metric_tensor_2<Kernel>`.
  typedef unspecified_type Metric_tensor_2;

  /// whether the orientation test and `Side_of_metric_circle_2` are free of
  /// rounding errors. If so, cavities are taken to be star-shaped without a test.
  static constexpr bool has_exact_predicates;
  /// @}

  /// \name Predicates
  /// @{

  /// provides `CGAL::Oriented_side operator()(a, b, c, p, ma, mb, mc, mp)` of four `Point_2` and four
  /// `Metric_tensor_2`. For the counterclockwise triangle `abc` it returns `ON_POSITIVE_SIDE`,
  /// `ON_ORIENTED_BOUNDARY` or `ON_NEGATIVE_SIDE` as the product
  /// \f$ \alpha_{M(p)} \alpha_{M(a)} \alpha_{M(b)} \alpha_{M(c)} \f$ of the Delaunay
  /// measures is less than, equal to or greater than 1 (section 3.1 of \cgalCite{dw-acvt-05}).
  typedef unspecified_type Side_of_metric_circle_2;
  /// @}

  /// \name Constructions
  /// @{

  /// provides `Metric_tensor_2 operator()(Point_2 p)`, the value of the field at `p`;
  /// throws `CGAL::Anisotropic_mesh_2::Invalid_metric_tensor_exception` where it has none.
  typedef unspecified_type Construct_metric_tensor_2;

  /// provides `double operator()(Point_2 p, Point_2 q)`, the Riemannian length of
  /// the segment from `p` to `q` (section 2.2 of \cgalCite{dw-acvt-05}).
  typedef unspecified_type Compute_riemannian_length_2;
  /// @}

  /// \name Operations
  /// @{

  /// returns the cavity criterion.
  Side_of_metric_circle_2 side_of_metric_circle_2_object() const;

  /// returns the functor that evaluates the field.
  Construct_metric_tensor_2 construct_metric_tensor_2_object() const;

  /// returns the functor of lengths.
  Compute_riemannian_length_2 compute_riemannian_length_2_object() const;
  /// @}
};

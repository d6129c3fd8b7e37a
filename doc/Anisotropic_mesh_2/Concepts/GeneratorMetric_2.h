/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `GeneratorMetric_2` says by which tensor the distance from a
/// point of the plane to a generator is measured: the squared distance is the
/// squared length of the vector between both in that tensor (section 2.3 of \cgalCite{dw-acvt-05}).
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Directional_distance_2}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Labelle_Shewchuk_distance_2}
/// \cgalHasModels{CGAL::Anisotropic_mesh_2::Multiplicative_weight_distance_2<Weight>}
/// \cgalHasModelsEnd
class GeneratorMetric_2
{
public:
  /// whether the tensor belongs to the generator. Otherwise it is that of the
  /// metric field at the point, and nothing else is required.
  static constexpr bool is_measured_at_generators;

  /// the tensor of the generator `v`, a vertex of a mesh; required if
  /// `is_measured_at_generators` only. Called once for each generator.
  template <class Vertex_handle>
  CGAL::Metric_tensor_2<K> operator()(Vertex_handle v) const;
};

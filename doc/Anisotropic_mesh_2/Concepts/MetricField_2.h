/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `MetricField_2` describes a Riemannian metric of the plane: a
/// function from points to metric tensors (section 2.2 of \cgalCite{dw-acvt-05}).
///
/// \cgalRefines{CopyConstructible}
///
/// The function may be called for any point of the domain and of its boundary, and
/// for what lies between a curve of the boundary and its chords; with
/// `CGAL::Parallel_tag`, from several threads at the same time, so that it must then not change any state that calls
/// share. It need not be continuous. A point at which it has
/// no valid tensor is reported by the exception that the construction of
/// `CGAL::Metric_tensor_2` throws.
///
/// Any function object of the right signature is a model, in particular a lambda.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Constant_metric_field_2<K>}
/// \cgalHasModels{CGAL::Isotropic_metric_field_2<K, Size>}
/// \cgalHasModels{CGAL::Oriented_sizes_metric_field_2<K, Sizes>}
/// \cgalHasModels{CGAL::Discrete_metric_field_2<K>}
/// \cgalHasModels{CGAL::Gradient_metric_field_2<K, Gradient>}
/// \cgalHasModels{CGAL::Hessian_metric_field_2<K, Hessian>}
/// \cgalHasModels{CGAL::Surface_metric_field_2<Surface, Metric>}
/// \cgalHasModelsEnd
class MetricField_2
{
public:
  /// the tensor at `p`, where `K` is the kernel of the traits; it may also be
  /// returned by reference.
  CGAL::Metric_tensor_2<K> operator()(const K::Point_2& p) const;
};

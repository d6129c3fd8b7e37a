/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `AnisotropicMeshVertexBase_2` describes the vertices of
/// anisotropic triangulations, which keep the metric tensor of their position.
///
/// `Metric_tensor_2` is the type of the traits. Tensors and indices are not
/// asked for before they are set; a new vertex is not required.
///
/// \cgalRefines{TriangulationVertexBase_2}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Anisotropic_mesh_vertex_base_2<Gt, Vb>}
/// \cgalHasModelsEnd
class AnisotropicMeshVertexBase_2
{
public:
  /// the tensor of the field at the position of the vertex.
  const Metric_tensor_2& metric_tensor() const;
  /// sets the tensor; the triangulation does so when it inserts or moves the vertex.
  void set_metric_tensor(const Metric_tensor_2& m);

  /// the number of the vertex: its rank in the order of insertion, unless quality moves have given it that of a
  /// removed one.
  int index() const;
  /// sets the index; the triangulation does so when it inserts the vertex.
  void set_index(int i);

  /// whether algorithms must neither move nor remove the vertex.
  bool is_required() const;
  /// sets whether the vertex is required.
  void set_required(bool b);
};

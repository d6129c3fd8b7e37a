/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `AnisotropicMeshFaceBase_2` describes the faces of anisotropic
/// meshes, which know whether they belong to the domain, the references of
/// their edges, and which of these bound the domain. A new face does not belong to
/// the domain, and its edges have no reference and bound nothing. `reorient()`, `ccw_permute()` and
/// `cw_permute()` take what is stored for edges along with the constraints.
///
/// \cgalRefines{ConstrainedTriangulationFaceBase_2}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Anisotropic_mesh_face_base_2<Gt, Fb>}
/// \cgalHasModelsEnd
class AnisotropicMeshFaceBase_2
{
public:
  /// whether the face belongs to the domain.
  bool is_in_domain() const;
  /// sets whether the face belongs to the domain.
  void set_in_domain(bool b);

  /// the reference of the subdomain of the face, any number, meaningful in the domain.
  int subdomain_index() const;
  /// sets the reference of the subdomain.
  void set_subdomain_index(int i);

  /// the reference of the curve that the `i`-th edge comes from; 0 if there is none.
  int edge_reference(int i) const;
  /// sets the reference of the `i`-th edge.
  void set_edge_reference(int i, int reference);

  /// whether inside and outside of the domain change at the `i`-th edge.
  bool is_boundary(int i) const;
  /// sets whether inside and outside of the domain change at the `i`-th edge.
  void set_boundary(int i, bool b);
};

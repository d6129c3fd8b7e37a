/// \ingroup PkgAnisotropicMesh2Concepts
/// \cgalConcept
///
/// The concept `AnisotropicMeshFaceBase_2` describes the faces of anisotropic
/// meshes, which know whether they belong to the domain. What they know is not
/// asked for before it is set.
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
};

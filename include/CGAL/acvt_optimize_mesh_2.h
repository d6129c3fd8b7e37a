// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Anisotropic_mesh_2 developers

#ifndef CGAL_ACVT_OPTIMIZE_MESH_2_H
#define CGAL_ACVT_OPTIMIZE_MESH_2_H

#include <CGAL/Anisotropic_mesh_2/internal/optimize_acvt.h>
#include <CGAL/Anisotropic_mesh_2/internal/Vertex_mover.h>

namespace CGAL {

/// \ingroup PkgAnisotropicMesh2Functions
///
/// minimizes the energy of the anisotropic Voronoi tessellation of the vertices
/// of a mesh by a quasi-Newton method.
///
/// The gradient of the energy and the mass centres come from the same
/// integrals, since the directional distance to a generator does not depend on
/// the tessellation to first order: Lloyd's iteration is the gradient method
/// preconditioned by the matrices of the mass centres. Here these precondition
/// the L-BFGS method. Steps that do not lower the energy are shortened, and so
/// are moves that would invert a face. The triangulation is updated in place by
/// flips; handles to vertices stay valid.
///
/// Vertices on constrained edges stay where they are.
///
/// \tparam Mesh an instance of `Anisotropic_Delaunay_mesh_2`.
/// \tparam NamedParameters a sequence of named parameters
/// \param mesh the mesh, with its domain marked.
/// \param np an optional sequence of named parameters, those of
/// `lloyd_optimize_anisotropic_mesh_2()`, with the same defaults
///
/// \return why it stopped, as `lloyd_optimize_anisotropic_mesh_2()`, and
/// `CANT_IMPROVE_ANYMORE` if no step lowers the energy within the accuracy to
/// which it is evaluated. The mesh is valid in each case.
/// \throw Invalid_metric_tensor_exception if the field fails at a point of the domain.
template <class ConcurrencyTag = Parallel_if_available_tag, class Mesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_optimization_return_code
acvt_optimize_mesh_2(Mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal = Anisotropic_mesh_2::internal;
  return internal::optimize_acvt<ConcurrencyTag, internal::Vertex_mover<Mesh, ConcurrencyTag> >
    (mesh, 1e-6, [](auto& optimizer) { return optimizer.quasi_newton(); }, np);
}

} // namespace CGAL

#endif // CGAL_ACVT_OPTIMIZE_MESH_2_H

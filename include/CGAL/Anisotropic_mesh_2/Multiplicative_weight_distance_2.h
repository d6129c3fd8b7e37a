// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_MULTIPLICATIVE_WEIGHT_DISTANCE_2_H
#define CGAL_ANISOTROPIC_MESH_2_MULTIPLICATIVE_WEIGHT_DISTANCE_2_H

#include <CGAL/assertions.h>

#include <type_traits>
#include <utility>

namespace CGAL::Anisotropic_mesh_2 {

/// \ingroup PkgAnisotropicMesh2Classes
///
/// the Euclidean distance times a weight of the generator, for comparison
/// (\cgalCite{obsc-st-00}, section 2.3 of \cgalCite{dw-acvt-05}). Bisectors are circles and lines.
///
/// \tparam Weight a functor from vertex handles to positive numbers
///
/// \cgalModels{GeneratorMetric_2}
template <class Weight>
class Multiplicative_weight_distance_2
{
public:
  /// distances are measured at generators.
  static constexpr bool is_measured_at_generators = true;

  /// the distance with the weights that `weight` gives.
  explicit Multiplicative_weight_distance_2(Weight weight) : m_weight(std::move(weight)) {}

  /// the tensor by which distances to `v` are measured: the squared weight times the identity.
  /// \pre the weight is positive.
  /// \throw Invalid_metric_tensor_exception if the weight is not finite.
  template <class Vertex_handle>
  auto operator()(Vertex_handle v) const
  {
    typedef std::decay_t<decltype(v->metric_tensor())> Tensor;
    const typename Tensor::FT weight(m_weight(v));
    CGAL_precondition(weight > 0);
    return Tensor::from_entries(weight*weight, typename Tensor::FT(0), weight*weight);
  }

private:
  Weight m_weight;
};

} // namespace CGAL::Anisotropic_mesh_2

#endif // CGAL_ANISOTROPIC_MESH_2_MULTIPLICATIVE_WEIGHT_DISTANCE_2_H

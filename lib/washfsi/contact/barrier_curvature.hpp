// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/block_places.hpp"

namespace washfsi {

/// Adds the indefinite part of the barrier's stiffness [N/m]: with the force p along the normal n, the negative part k
/// of the stiffness along n, and the distance d of two parts with the shares s_i, the blocks
///   s_i s_j k n n^T - p d2d/dX_i dX_j                              (contact/distance_curvature.hpp)
/// at these places of all known markers, of all that touches there except parallel edges.
template <int Dim>
void add_curvatures(const std::vector<Touch<Dim>>& touches, const Points<Dim>& all, const NearMarkers<Dim>& known,
                    BlockPlaces<Dim>& places, std::vector<StiffnessBlock<Dim>>& blocks);

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier_curvature.hpp"

#include "washfsi/contact/distance_curvature.hpp"

namespace washfsi {

template <int Dim>
void add_curvatures(const std::vector<Touch<Dim>>& touches, const Points<Dim>& all, const NearMarkers<Dim>& known,
                    BlockPlaces<Dim>& places, std::vector<StiffnessBlock<Dim>>& blocks) {
  for (const Touch<Dim>& touch : touches) {
    const DistanceCurvature<Dim> curvature(touch.facing, all, touch.is_guard);
    if (!curvature.is_regular()) continue;
    const StiffnessBlock<Dim> along = touch.taken_off * touch.facing.normal * touch.facing.normal.transpose();
    const auto block = [&](std::size_t i, std::size_t j) -> StiffnessBlock<Dim> {
      return touch.facing.shares[i] * touch.facing.shares[j] * along - touch.push * curvature.block(i, j);
    };
    places.add(touch.facing, known, block, blocks);
  }
}

template void add_curvatures<2>(const std::vector<Touch<2>>&, const Points<2>&, const NearMarkers<2>&, BlockPlaces<2>&,
                                std::vector<StiffnessBlock<2>>&);
template void add_curvatures<3>(const std::vector<Touch<3>>&, const Points<3>&, const NearMarkers<3>&, BlockPlaces<3>&,
                                std::vector<StiffnessBlock<3>>&);

}  // namespace washfsi

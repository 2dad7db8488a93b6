// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/edge_nearness.hpp"

namespace washfsi {

template <int Dim>
void find_edge_nearness(const Grid<Dim>& grid, const Transfer<Dim>& transfer, const std::vector<bool>& at_edges,
                        Vec nearness) {
  constexpr double whole = 0.05;  // sum of the deltas from which on the nearness is 1
  Points<Dim> weights;
  for (const bool at_edge : at_edges) weights.push_back(Point<Dim>::Constant(at_edge ? grid.cell_volume() / whole : 0));
  WASH_PETSC(VecZeroEntries(nearness));
  transfer.spread(weights, nearness);
  const petsc::GlobalVector ones(grid.face_dm());
  WASH_PETSC(VecSet(ones, 1));
  WASH_PETSC(VecPointwiseMin(nearness, nearness, ones));
}

template void find_edge_nearness<2>(const Grid<2>&, const Transfer<2>&, const std::vector<bool>&, Vec);
template void find_edge_nearness<3>(const Grid<3>&, const Transfer<3>&, const std::vector<bool>&, Vec);

}  // namespace washfsi

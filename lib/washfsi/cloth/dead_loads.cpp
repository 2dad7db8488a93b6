// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/dead_loads.hpp"

namespace washfsi {

namespace {

// A force at the very edge, half a spacing beyond the first or last row: the share of the row so many places from
// there, with the right force and torque.
double end_force_share(PetscInt from_end) {
  return from_end == 0 ? 1.5 : from_end == 1 ? -0.5 : 0;
}

}  // namespace

template <int Dim>
DeadLoads<Dim>::DeadLoads(const Cloths<Dim>& cloths, const Point<Dim>& gravity) {
  for (const Patch& patch : cloths.patches()) {
    const ClothGroup<Dim>& group = cloths.group_of(patch);
    const double area = group.sheet.marker_area(), of_row = 1 / static_cast<double>(group.sheet.width);
    for (std::size_t i = patch.own_begin; i < patch.own_end; ++i) {
      const PetscInt along = patch.markers[i] - cloths.pieces()[patch.piece].first;
      const PetscInt row = along / static_cast<PetscInt>(group.sheet.width), rows = group.markers[0];
      const Point<Dim> load = area * group.load + of_row * end_force_share(row) * group.end_force_first +
                              of_row * end_force_share(rows - 1 - row) * group.end_force_last;
      loads_.push_back(group.excess_mass * area * gravity + load);
    }
  }
}

template <int Dim>
void DeadLoads<Dim>::add_force(const Points<Dim>&, const Points<Dim>&, Points<Dim>& forces) const {
  forces += loads_;
}

template class DeadLoads<2>;
template class DeadLoads<3>;

}  // namespace washfsi

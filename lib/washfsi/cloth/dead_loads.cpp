// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/dead_loads.hpp"

namespace washfsi {

namespace {

// A force at the very edge, a spacing's overhang beyond the first or last row: the share of the row `from_end` places
// from there, so that force and torque are right.
double end_force_share(const MarkerRow& row, PetscInt from_end) {
  return from_end == 0 ? 1 + row.overhang() : from_end == 1 ? -row.overhang() : 0;
}

// The load on a marker with this undeformed area.
template <int Dim>
Point<Dim> load_on(const ClothGroup<Dim>& group, PetscInt marker, double area) {
  const PetscInt row = marker / group.markers[1], rows = group.markers[0];
  const MarkerRow along = group.row(0), across = group.row(1);
  const double of_row = across.share(static_cast<std::size_t>(marker % group.markers[1])) / across.parts();
  return area * group.load + of_row * end_force_share(along, row) * group.end_force_first +
         of_row * end_force_share(along, rows - 1 - row) * group.end_force_last;
}

}  // namespace

template <int Dim>
DeadLoads<Dim>::DeadLoads(const Cloths<Dim>& cloths, const Point<Dim>& gravity) {
  for (const LatticePart& part : cloths.lattices().parts()) {
    const ClothGroup<Dim>& group = cloths.group_of(part);
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) {
      const std::size_t m = loads_.size();
      const PetscInt marker = part.markers[i] - cloths.pieces()[part.piece].first;
      loads_.push_back(cloths.marker_masses()[m] * gravity + load_on(group, marker, cloths.marker_areas()[m]));
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

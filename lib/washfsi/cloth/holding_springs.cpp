// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/holding_springs.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
HoldingSprings<Dim>::HoldingSprings(const Cloths<Dim>& cloths, const Points<Dim>& positions) : cloths_(cloths) {
  for (const LatticePart& part : cloths.lattices().parts()) {
    const ClothGroup<Dim>& group = cloths.group_of(part);
    const std::vector<PetscInt> held = group.held_markers();
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) {
      const std::size_t marker = part.own_first + i - part.own_begin;
      if (std::binary_search(held.begin(), held.end(), part.markers[i] - cloths.pieces()[part.piece].first))
        springs_.push_back({marker, group.hold_stiffness, positions[marker]});
    }
  }
}

template <int Dim>
void HoldingSprings<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Spring& spring : springs_)
    forces[spring.marker] -= spring.stiffness * (positions[spring.marker] - spring.anchor);
}

template <int Dim>
void HoldingSprings<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  for (const Spring& spring : springs_)
    of_groups[cloths_.group_number(spring.marker)] +=
        0.5 * spring.stiffness * (positions[spring.marker] - spring.anchor).squaredNorm();
}

template <int Dim>
void HoldingSprings<Dim>::add_force_rates(const Points<Dim>&, const Points<Dim>& direction, Points<Dim>& rates) const {
  for (const Spring& spring : springs_) rates[spring.marker] -= spring.stiffness * direction[spring.marker];
}

template <int Dim>
void HoldingSprings<Dim>::visit_stiffness(const Points<Dim>&, GeometricStiffness,
                                          const AddMarkerBlock<Dim>& add) const {
  for (const Spring& spring : springs_) {
    const PetscInt marker = cloths_.number_of(spring.marker);
    add(marker, marker, spring.stiffness * StiffnessBlock<Dim>::Identity());
  }
}

template <int Dim>
void HoldingSprings<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (const Spring& spring : springs_) sizes[spring.marker] += spring.stiffness * positions[spring.marker].norm();
}

// All markers of a held cloth may take part in the oscillation of the held ones, of which the smallest counts.
template <int Dim>
void HoldingSprings<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  std::vector<double> of_groups;
  for (const ClothGroup<Dim>& group : cloths_.groups()) {
    double least_share = 1;
    const std::vector<PetscInt> held = group.held_markers();
    for (const PetscInt marker : held) least_share = std::min(least_share, group.marker_share(marker));
    of_groups.push_back(held.empty() ? 0 : 0.25 * group.hold_stiffness / (least_share * group.sheet.part_area()));
  }
  for (std::size_t m = 0; m < bounds.size(); ++m) bounds[m].stiffness += of_groups[cloths_.group_number(m)];
}

template class HoldingSprings<2>;
template class HoldingSprings<3>;

}  // namespace washfsi

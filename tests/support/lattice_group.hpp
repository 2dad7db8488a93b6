// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi::test {

/// A group of so many cloths with rows x width markers that lie 2 cm apart.
template <int Dim>
ClothGroup<Dim> lattice_group(const std::string& name, PetscInt count, std::array<PetscInt, 2> markers,
                              MarkerLattice lattice = MarkerLattice::centred) {
  ClothGroup<Dim> group;
  group.name = name;
  group.count = count;
  group.markers = markers;
  group.sheet = {.width = static_cast<std::size_t>(markers[1]), .ds = 0.02, .dr = 0.02, .lattice = lattice};
  return group;
}

}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::vector<Piece> pieces_of(const std::vector<ClothGroup<Dim>>& groups) {
  std::vector<Piece> pieces;
  PetscInt total = 0;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (PetscInt c = 0; c < groups[g].count; ++c) {
      pieces.push_back({g, total, groups[g].marker_count()});
      total += groups[g].marker_count();
    }
  return pieces;
}

}  // namespace

template <int Dim>
Cloths<Dim>::Cloths(MPI_Comm comm, std::vector<ClothGroup<Dim>> groups)
    : MarkerNumbering(comm, pieces_of(groups)), groups_(std::move(groups)), lattices_(*this, groups_) {
  for (std::size_t m = 0; m < owned(); ++m) {
    const ClothGroup<Dim>& group = group_of(m);
    const double share = group.marker_share(number_of(m) - pieces()[piece_of_marker()[m]].first);
    marker_shares_.push_back(share);
    marker_areas_.push_back(share * group.sheet.part_area());
    marker_masses_.push_back(group.excess_mass * marker_areas_.back());
  }
}

template <int Dim>
std::string Cloths<Dim>::name_of(std::size_t piece) const {
  const std::size_t group = pieces()[piece].group;
  std::size_t number = 1;
  for (std::size_t p = 0; p < piece; ++p) number += pieces()[p].group == group ? 1 : 0;
  return groups_[group].name + " " + std::to_string(number);
}

template <int Dim>
std::vector<std::array<PetscInt, 4>> Cloths<Dim>::quads(const Piece& piece) const {
  const PetscInt width = groups_[piece.group].markers[1];
  std::vector<std::array<PetscInt, 4>> quads;
  for (PetscInt k = piece.first; k + width < piece.first + piece.count; ++k)
    if ((k - piece.first) % width + 1 < width) quads.push_back({k, k + 1, k + width + 1, k + width});
  return quads;
}

template class Cloths<2>;
template class Cloths<3>;

}  // namespace washfsi

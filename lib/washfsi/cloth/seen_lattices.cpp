// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/seen_lattices.hpp"

#include <algorithm>

#include "washfsi/support/broadcast.hpp"

namespace washfsi {

namespace {

// The part of a cloth that a rank sees that has its markers from own_first to own_end - 1.
LatticePart part_of(const Sheet& sheet, const Piece& piece, PetscInt own_first, PetscInt own_end) {
  const auto width = static_cast<PetscInt>(sheet.width);
  const PetscInt first_row = (own_first - piece.first) / width - sheet_reach;
  const PetscInt end_row = (own_end - piece.first + width - 1) / width + sheet_reach, rows = piece.count / width;
  LatticePart part{};
  for (PetscInt row = first_row; row < end_row; ++row) {
    if (!sheet.closed && (row < 0 || row >= rows)) continue;
    for (PetscInt marker = piece.first + row * width; marker < piece.first + (row + 1) * width; ++marker) {
      if (marker == own_first) part.own_begin = part.markers.size();
      part.markers.push_back(piece.first + (marker - piece.first + sheet_reach * piece.count) % piece.count);
    }
  }
  part.own_end = part.own_begin + static_cast<std::size_t>(own_end - own_first);
  return part;
}

}  // namespace

template <int Dim>
SeenLattices<Dim>::SeenLattices(const MarkerNumbering& numbering, const std::vector<ClothGroup<Dim>>& groups) {
  std::vector<PetscInt> markers;
  for (std::size_t p = 0; p < numbering.pieces().size(); ++p) {
    const Piece& piece = numbering.pieces()[p];
    const PetscInt own_first = std::max(piece.first, numbering.begin()),
                   own_end = std::min(piece.first + piece.count, numbering.end());
    if (own_first >= own_end) continue;
    LatticePart& part = parts_.emplace_back(part_of(groups[piece.group].sheet, piece, own_first, own_end));
    part.piece = p;
    part.first_in_halo = markers.size();
    part.own_first = static_cast<std::size_t>(own_first - numbering.begin());
    markers.insert(markers.end(), part.markers.begin(), part.markers.end());
  }
  halo_count_ = markers.size();
  WASH_PETSC(PetscSFCreate(numbering.comm(), halo_.put()));
  WASH_PETSC(PetscSFSetGraphLayout(halo_, numbering.layout(), static_cast<PetscInt>(markers.size()), nullptr,
                                   PETSC_COPY_VALUES, markers.data()));
  WASH_PETSC(PetscSFSetUp(halo_));
}

template <int Dim>
Points<Dim> SeenLattices<Dim>::with_halo(const Points<Dim>& values) const {
  return petsc::broadcast(halo_, point_type_, values, halo_count_);
}

template <int Dim>
std::vector<double> SeenLattices<Dim>::with_halo(const std::vector<double>& values) const {
  return petsc::broadcast(halo_, MPI_DOUBLE, values, halo_count_);
}

template class SeenLattices<2>;
template class SeenLattices<3>;

}  // namespace washfsi

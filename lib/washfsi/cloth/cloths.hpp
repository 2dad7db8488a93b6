// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/cloth/marker_numbering.hpp"
#include "washfsi/cloth/options.hpp"
#include "washfsi/cloth/seen_lattices.hpp"

namespace washfsi {

/// All cloths of a run, and the numbering of their markers. Independent of the grid.
template <int Dim>
class Cloths : public MarkerNumbering {
 public:
  /// Collective.
  Cloths(MPI_Comm comm, std::vector<ClothGroup<Dim>> groups);

  const std::vector<ClothGroup<Dim>>& groups() const { return groups_; }
  /// The group of a piece; of a part of one; of one of this rank's markers.
  const ClothGroup<Dim>& group_of_piece(std::size_t piece) const { return groups_[pieces()[piece].group]; }
  const ClothGroup<Dim>& group_of(const LatticePart& part) const { return group_of_piece(part.piece); }
  const ClothGroup<Dim>& group_of(std::size_t marker) const { return groups_[group_number(marker)]; }

  /// The name of a piece: its group's, and its number in that, from 1.
  std::string name_of(std::size_t piece) const;
  /// The quads of a piece, each as its four markers in the order round it; a fibre has none.
  std::vector<std::array<PetscInt, 4>> quads(const Piece& piece) const;

  /// Undeformed area of each of this rank's markers [m2; m in the plane].
  const std::vector<double>& marker_areas() const { return marker_areas_; }
  /// Area of each marker over that of a marker inside its cloth: below 1 on the edges of a nodal lattice.
  const std::vector<double>& marker_shares() const { return marker_shares_; }
  /// Excess mass of each of this rank's markers [kg; per unit depth in the plane].
  const std::vector<double>& marker_masses() const { return marker_masses_; }

  /// The parts of the cloths that this rank sees, and the exchange of their values.
  const SeenLattices<Dim>& lattices() const { return lattices_; }

 private:
  std::vector<ClothGroup<Dim>> groups_;
  std::vector<double> marker_shares_, marker_areas_, marker_masses_;
  SeenLattices<Dim> lattices_;
};

extern template class Cloths<2>;
extern template class Cloths<3>;

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/slab.hpp"

namespace washfsi {

/// One cloth: its group and its markers, contiguous in the numbering of all markers.
struct Piece {
  std::size_t group = 0;
  PetscInt first = 0, count = 0;
};

/// The numbering of the markers of all cloths: cloth by cloth. Each rank has a contiguous range of them, whatever
/// cloths they belong to. Arrays of marker data cover this range.
class MarkerNumbering {
 public:
  /// The pieces are in the order of their markers, without gaps. Collective.
  MarkerNumbering(MPI_Comm comm, std::vector<Piece> pieces);

  MPI_Comm comm() const { return comm_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  PetscInt marker_count() const { return total_; }
  PetscInt begin() const { return begin_; }  ///< first marker of this rank
  PetscInt end() const { return end_; }
  std::size_t owned() const { return static_cast<std::size_t>(end_ - begin_); }
  /// The ranges of all ranks.
  PetscLayout layout() const { return layout_; }
  /// This rank's part of an array over all markers with `components` values each.
  Slab slab(int components) const {
    return row_slab(static_cast<std::size_t>(total_), static_cast<std::size_t>(begin_), static_cast<std::size_t>(end_),
                    components);
  }

  /// Piece and group of each of this rank's markers, and its number among those of all ranks.
  const std::vector<std::size_t>& piece_of_marker() const { return piece_of_marker_; }
  std::size_t group_number(std::size_t marker) const { return pieces_[piece_of_marker_[marker]].group; }
  PetscInt number_of(std::size_t marker) const { return begin_ + static_cast<PetscInt>(marker); }

 private:
  MPI_Comm comm_;
  std::vector<Piece> pieces_;
  PetscInt total_, begin_ = 0, end_ = 0;
  petsc::Layout layout_;
  std::vector<std::size_t> piece_of_marker_;
};

}  // namespace washfsi

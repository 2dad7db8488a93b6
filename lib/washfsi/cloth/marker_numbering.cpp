// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/marker_numbering.hpp"

#include <algorithm>

namespace washfsi {

MarkerNumbering::MarkerNumbering(MPI_Comm comm, std::vector<Piece> pieces)
    : comm_(comm),
      pieces_(std::move(pieces)),
      total_(pieces_.empty() ? 0 : pieces_.back().first + pieces_.back().count) {
  WASH_PETSC(PetscLayoutCreateFromSizes(comm_, PETSC_DECIDE, total_, 1, layout_.put()));
  WASH_PETSC(PetscLayoutGetRange(layout_, &begin_, &end_));
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const PetscInt own_first = std::max(piece.first, begin_), own_end = std::min(piece.first + piece.count, end_);
    for (PetscInt marker = own_first; marker < own_end; ++marker) piece_of_marker_.push_back(p);
  }
}

}  // namespace washfsi

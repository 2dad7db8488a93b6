// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// Which blocks of a matrix of all markers have values, row by row, in the rows of this rank's markers; and which of
/// them each block belongs to that is added, of which many have the same place.
template <int Dim>
class StiffnessRows {
 public:
  /// Two markers, by their numbers among those of all ranks.
  struct Place {
    PetscInt row, column;
  };

  StiffnessRows() = default;
  /// Of the rows from `begin` on, `rows` of them, with the blocks to be added in this order.
  StiffnessRows(PetscInt begin, std::size_t rows, const std::vector<Place>& added);

  std::size_t count() const { return columns_.size(); }
  /// The number of the block to which the n-th one is added.
  std::size_t number_of(std::size_t n) const { return numbers_[n]; }

  /// Makes a matrix with these places, all zero. Collective.
  void create(MPI_Comm comm, petsc::Matrix& matrix) const;
  /// Sets a matrix that was made so to these blocks. Collective.
  void set(const std::vector<StiffnessBlock<Dim>>& blocks, Mat matrix) const;

 private:
  std::size_t rows() const { return starts_.size() - 1; }

  PetscInt begin_ = 0;
  std::vector<std::size_t> starts_{0};  ///< of each row's blocks, and their end
  std::vector<PetscInt> columns_;       ///< ascending in each row
  std::vector<std::size_t> numbers_;
};

extern template class StiffnessRows<2>;
extern template class StiffnessRows<3>;

}  // namespace washfsi

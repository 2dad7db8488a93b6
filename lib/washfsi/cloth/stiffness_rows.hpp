// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The nonzero blocks of a matrix over all markers, in the rows of this rank's markers; and the block to which each
/// contribution is added, many of which have the same place.
template <int Dim>
class StiffnessRows {
 public:
  /// The place of a block: two markers, by their numbers among those of all ranks.
  struct Place {
    PetscInt row, column;
  };

  StiffnessRows() = default;
  /// Finds the blocks of `rows` rows from `begin` on; contributions will be added in the order of `added`.
  StiffnessRows(PetscInt begin, std::size_t rows, const std::vector<Place>& added);

  std::size_t count() const { return columns_.size(); }
  /// The number of the block to which the n-th contribution is added.
  std::size_t number_of(std::size_t n) const { return numbers_[n]; }

  /// Creates a matrix with these blocks, all zero. Collective.
  void create(MPI_Comm comm, petsc::Matrix& matrix) const;
  /// Sets a matrix created by `create` to these blocks. Collective.
  void set(const std::vector<StiffnessBlock<Dim>>& blocks, Mat matrix) const;

 private:
  std::size_t rows() const { return starts_.size() - 1; }

  PetscInt begin_ = 0;
  std::vector<std::size_t> starts_{0};  ///< first block of each row, and the end
  std::vector<PetscInt> columns_;       ///< columns of the blocks, ascending in each row
  std::vector<std::size_t> numbers_;
};

extern template class StiffnessRows<2>;
extern template class StiffnessRows<3>;

}  // namespace washfsi

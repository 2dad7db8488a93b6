// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/stiffness_rows.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
StiffnessRows<Dim>::StiffnessRows(PetscInt begin, std::size_t rows, const std::vector<Place>& added) : begin_(begin) {
  std::vector<std::vector<PetscInt>> columns(rows);
  for (const Place& place : added) columns[static_cast<std::size_t>(place.row - begin)].push_back(place.column);
  for (auto& row : columns) {
    std::sort(row.begin(), row.end());
    columns_.insert(columns_.end(), row.begin(), std::unique(row.begin(), row.end()));
    starts_.push_back(columns_.size());
  }
  numbers_.reserve(added.size());
  for (const Place& place : added) {
    const auto row = static_cast<std::size_t>(place.row - begin);
    const auto first = columns_.begin() + static_cast<long>(starts_[row]),
               end = columns_.begin() + static_cast<long>(starts_[row + 1]);
    numbers_.push_back(static_cast<std::size_t>(std::lower_bound(first, end, place.column) - columns_.begin()));
  }
}

template <int Dim>
void StiffnessRows<Dim>::create(MPI_Comm comm, petsc::Matrix& matrix) const {
  const auto count = static_cast<PetscInt>(rows());
  std::vector<PetscInt> own(rows(), 0), others(rows(), 0);
  for (std::size_t r = 0; r < rows(); ++r)
    for (std::size_t n = starts_[r]; n < starts_[r + 1]; ++n)
      ++(columns_[n] >= begin_ && columns_[n] < begin_ + count ? own : others)[r];
  WASH_PETSC(MatCreate(comm, matrix.put()));
  WASH_PETSC(MatSetSizes(matrix, count * Dim, count * Dim, PETSC_DETERMINE, PETSC_DETERMINE));
  WASH_PETSC(MatSetBlockSize(matrix, Dim));
  WASH_PETSC(MatSetType(matrix, MATAIJ));
  WASH_PETSC(MatXAIJSetPreallocation(matrix, Dim, own.data(), others.data(), nullptr, nullptr));
  WASH_PETSC(MatSetOption(matrix, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
  set(std::vector<StiffnessBlock<Dim>>(columns_.size(), StiffnessBlock<Dim>::Zero()), matrix);
}

template <int Dim>
void StiffnessRows<Dim>::set(const std::vector<StiffnessBlock<Dim>>& blocks, Mat matrix) const {
  std::vector<double> values;
  for (std::size_t r = 0; r < rows(); ++r) {
    values.clear();
    for (int a = 0; a < Dim; ++a)
      for (std::size_t n = starts_[r]; n < starts_[r + 1]; ++n)
        for (int b = 0; b < Dim; ++b) values.push_back(blocks[n](a, b));
    const PetscInt row = begin_ + static_cast<PetscInt>(r);
    WASH_PETSC(MatSetValuesBlocked(matrix, 1, &row, static_cast<PetscInt>(starts_[r + 1] - starts_[r]),
                                   columns_.data() + starts_[r], values.data(), INSERT_VALUES));
  }
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

template class StiffnessRows<2>;
template class StiffnessRows<3>;

}  // namespace washfsi

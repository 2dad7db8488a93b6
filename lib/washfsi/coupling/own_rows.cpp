// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/own_rows.hpp"

namespace washfsi {

OwnRows::OwnRows(Mat matrix) {
  WASH_PETSC(MatGetDiagonalBlock(matrix, &own_));
  PetscInt count = 0;
  PetscBool done = PETSC_FALSE;
  WASH_PETSC(MatGetRowIJ(own_, 0, PETSC_FALSE, PETSC_FALSE, &count, &starts_, &columns_, &done));
  WASH_PETSC(MatSeqAIJGetArrayRead(own_, &values_));
}

OwnRows::~OwnRows() {
  PetscInt count = 0;
  PetscBool done = PETSC_FALSE;
  (void)MatSeqAIJRestoreArrayRead(own_, &values_);
  (void)MatRestoreRowIJ(own_, 0, PETSC_FALSE, PETSC_FALSE, &count, &starts_, &columns_, &done);
}

template <int Dim>
Eigen::MatrixXd own_block(Mat matrix, const std::vector<std::size_t>& markers) {
  PetscInt count = 0;
  WASH_PETSC(MatGetLocalSize(matrix, &count, nullptr));
  std::vector<int> numbers(static_cast<std::size_t>(count), -1);
  std::vector<PetscInt> rows;
  for (const std::size_t marker : markers)
    for (std::size_t c = 0; c < Dim; ++c) {
      numbers[Dim * marker + c] = static_cast<int>(rows.size());
      rows.push_back(static_cast<PetscInt>(Dim * marker + c));
    }
  const auto size = static_cast<int>(rows.size());
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
  OwnRows(matrix).visit(rows, numbers, [&](int i, int j, double value) { block(i, j) = value; });
  return block;
}

template Eigen::MatrixXd own_block<2>(Mat, const std::vector<std::size_t>&);
template Eigen::MatrixXd own_block<3>(Mat, const std::vector<std::size_t>&);

}  // namespace washfsi

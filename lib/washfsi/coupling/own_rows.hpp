// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The rows of an AIJ matrix that are this rank's, with the columns that are; to be read only while the matrix stays as
/// it is. No communication.
class OwnRows {
 public:
  explicit OwnRows(Mat matrix);
  OwnRows(const OwnRows&) = delete;
  OwnRows& operator=(const OwnRows&) = delete;
  ~OwnRows();

  /// visit(row, column, value) of the entries in these rows and columns, as they are numbered there; others: -1.
  template <class Visit>
  void visit(const std::vector<PetscInt>& rows, const std::vector<int>& numbers, const Visit& visit) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (PetscInt k = starts_[rows[i]]; k < starts_[rows[i] + 1]; ++k) {
        const int j = numbers[static_cast<std::size_t>(columns_[k])];
        if (j >= 0) visit(static_cast<int>(i), j, values_[k]);
      }
  }

 private:
  Mat own_ = nullptr;
  const PetscInt *starts_ = nullptr, *columns_ = nullptr;
  const double* values_ = nullptr;
};

/// The entries between the coordinates of some of this rank's markers, numbered as on this rank, of an AIJ matrix with
/// a row for each coordinate of each marker. No communication.
template <int Dim>
Eigen::MatrixXd own_block(Mat matrix, const std::vector<std::size_t>& markers);

}  // namespace washfsi

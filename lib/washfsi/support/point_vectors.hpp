// SPDX-License-Identifier: BSD-3-Clause
//
// One value per marker as PETSc sees it: vectors and matrices with a row for each coordinate of each marker.
#pragma once

#include <vector>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

template <int Dim>
void to_vector(const Points<Dim>& points, Vec vector);

/// The values of this rank's part of a vector.
template <int Dim>
Points<Dim> to_points(Vec vector);

/// Products of matrices of the cloths' lattice, all of the same layout, with one value per marker. Stores the vectors,
/// whose creation is collective and takes as long as a product.
template <int Dim>
class MatrixProduct {
 public:
  /// Collective.
  Points<Dim> operator()(Mat matrix, const Points<Dim>& values) const;

 private:
  mutable petsc::Vector values_, result_;  ///< null before the first product
};

/// Replaces a matrix M of the cloths' lattice by  diag(row_factors) M + diag(diagonal), with one value per marker.
/// Collective.
template <int Dim>
void scale_and_shift(const std::vector<double>& row_factors, const std::vector<double>& diagonal, Mat matrix);

/// Replaces it by  B M + diagonal 1, with a block of B for the rows of each marker, whose nonzero pattern must be the
/// same. Collective.
template <int Dim>
void scale_by_blocks_and_shift(const std::vector<Block<Dim>>& blocks, double diagonal, Mat matrix);

/// Replaces it by  M diag(column_factors) + diagonal 1. Collective.
template <int Dim>
void scale_columns_and_shift(const std::vector<double>& column_factors, double diagonal, Mat matrix);

extern template class MatrixProduct<2>;
extern template class MatrixProduct<3>;

}  // namespace washfsi

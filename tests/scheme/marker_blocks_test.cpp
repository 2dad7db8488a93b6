// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/marker_blocks.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/coupling/marker_vectors.hpp"
#include "washfsi/coupling/own_rows.hpp"

namespace washfsi::test {
namespace {

// A matrix over the coordinates of all markers with entries near its diagonal, on every rank its own part.
template <int Dim>
petsc::Matrix band_matrix(PetscInt own_markers, double diagonal) {
  petsc::Matrix matrix;
  const PetscInt rows = own_markers * Dim;
  WASH_PETSC(MatCreateAIJ(PETSC_COMM_WORLD, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, 5, nullptr, 5, nullptr,
                          matrix.put()));
  PetscInt begin = 0, end = 0, all = 0;
  WASH_PETSC(MatGetOwnershipRange(matrix, &begin, &end));
  WASH_PETSC(MatGetSize(matrix, &all, nullptr));
  for (PetscInt i = begin; i < end; ++i)
    for (PetscInt j = std::max<PetscInt>(begin, i - 2); j <= std::min(end - 1, i + 2); ++j)
      WASH_PETSC(
          MatSetValue(matrix, i, j, i == j ? diagonal : 1.0 / static_cast<double>(3 + i % 5 + j % 5), INSERT_VALUES));
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  return matrix;
}

auto block_of(const petsc::Matrix& matrix) {
  return [&](const std::vector<std::size_t>& markers) { return own_block<3>(matrix, markers); };
}

// What one block solves is exact: the product gives the right side again.
TEST(MarkerBlocks, SolveTheEquationsOfNearMarkersExactly) {
  constexpr std::size_t markers = 20;
  constexpr double s = 0.7;
  const petsc::Matrix k = band_matrix<3>(markers, 3), m = band_matrix<3>(markers, 2);
  MarkerBlocks<3> blocks;
  blocks.factorise(random_points<3>(markers, 3), k, block_of(m), s);
  const MatrixProduct<3> product;
  const Points<3> right = random_points<3>(markers, 4), solved = blocks.solve(right);
  const Points<3> again = solved + s * product(m, product(k, solved));
  for (std::size_t i = 0; i < markers; ++i) EXPECT_LE((again[i] - right[i]).norm(), 1e-5);  // in single precision
}

// More markers than a block holds: each is in one of them, and those that do not touch others are exact all the same.
TEST(MarkerBlocks, TakeEachMarkerOnce) {
  constexpr std::size_t markers = 500;
  const petsc::Matrix k = band_matrix<3>(markers, 0), m = band_matrix<3>(markers, 2);
  MarkerBlocks<3> blocks;
  blocks.factorise(random_points<3>(markers, 3), k, block_of(m), 0);
  const Points<3> right = random_points<3>(markers, 4), solved = blocks.solve(right);
  for (std::size_t i = 0; i < markers; ++i) EXPECT_LE((solved[i] - right[i]).norm(), 1e-6);
}

}  // namespace
}  // namespace washfsi::test

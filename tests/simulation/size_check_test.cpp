// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/size_check.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

/// A box of 10 x 10 x 10 cells, with so many towels of n x n markers, 1 cm wide: all near each other.
CaseOptions<3> small_towels(PetscInt count, PetscInt n) {
  CaseOptions<3> options;
  options.model.grid.shape.cells = {10, 10, 10};
  ClothGroup<3> group;
  group.name = "towel";
  group.count = count;
  group.markers = {n, n};
  group.size = {0.01, 0.01};
  options.model.cloths = {group};
  return options;
}

void expect_too_large(const CaseOptions<3>& options, const std::string& words) {
  expect_refusal<InputError>([&] { refuse_what_cannot_fit<3>(PETSC_COMM_WORLD, options); }, words);
}

TEST(SizeCheck, PassesWhatIsSmall) {
  EXPECT_NO_THROW(refuse_what_cannot_fit<3>(PETSC_COMM_WORLD, small_towels(10, 20)));
}

TEST(SizeCheck, RefusesAGridWithTheOptionThatGivesIt) {
  CaseOptions<3> options;
  options.model.grid.shape.cells = {100000, 100000, 100000};
  expect_too_large(options, "-grid_cells 100000,100000,100000: ");
}

TEST(SizeCheck, RefusesMoreMarkersThanCanBeCounted) {
  expect_too_large(small_towels(1000000000, 1000), "-towel_markers 1000,1000 of -towel_count 1000000000: ");
}

// 700 x 700 markers fit into a gigabyte or two; the 2.4e11 pairs of them into no machine.
TEST(SizeCheck, RefusesAMobilityMatrixThatIsTooLargeWhereOneIsMade) {
  CaseOptions<3> options = small_towels(1, 700);
  expect_too_large(options, "-towel_markers 700,700 of -towel_count 1: needs at least");
  options.coupling.mobility = Mobility::row_sums;
  EXPECT_NO_THROW(refuse_what_cannot_fit<3>(PETSC_COMM_WORLD, options));
  options.coupling.mobility = Mobility::matrix;
  options.coupling.scheme = "explicit";
  EXPECT_NO_THROW(refuse_what_cannot_fit<3>(PETSC_COMM_WORLD, options));
}

}  // namespace
}  // namespace washfsi::test

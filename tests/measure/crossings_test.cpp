// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/crossings.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/lattice_group.hpp"

namespace washfsi::test {
namespace {

/// Two sheets of 4 x 4 markers 2 cm apart: one at rest in the plane z = 0, the other over it at a height, shifted so
/// that no marker is over an edge; then 3 x 3 markers of each are over the other one.
struct SheetOverSheet {
  explicit SheetOverSheet(const ClothGroup<3>& group = lattice_group<3>("towel", 2, {4, 4}))
      : cloths(PETSC_COMM_WORLD, {group}) {}

  /// The places of this rank's markers.
  Points<3> places(double height) const {
    Points<3> mine;
    for (std::size_t m = 0; m < cloths.owned(); ++m) {
      const PetscInt number = cloths.number_of(m), row = number % 16 / 4, column = number % 4;
      const bool upper = number >= 16;
      const Point<3> shift = upper ? Point<3>(0.004, 0.007, height) : Point<3>::Zero();
      mine.push_back(0.02 * Point<3>(static_cast<double>(row), static_cast<double>(column), 0) + shift);
    }
    return mine;
  }

  Cloths<3> cloths;
};

TEST(ClothCrossings, CountEachMarkerOfSheetsThatJumpThroughEachOther) {
  const SheetOverSheet sheets;
  ClothCrossings crossings(sheets.cloths);
  crossings.observe(sheets.places(0.05));  // beyond their reach
  EXPECT_EQ(crossings.least_distance(), crossings.reach());
  crossings.observe(sheets.places(-0.05));
  EXPECT_EQ(crossings.crossings(), 18);
  crossings.observe(sheets.places(0.004));
  EXPECT_EQ(crossings.crossings(), 36);
  EXPECT_NEAR(crossings.least_distance(), 0.004, 1e-15);
}

TEST(ClothCrossings, GoOnFromTheNumberThatARestartKeeps) {
  const SheetOverSheet sheets;
  ClothCrossings first(sheets.cloths), second(sheets.cloths);
  first.observe(sheets.places(0.004));
  first.observe(sheets.places(-0.004));
  std::ranges::copy(first.state(), second.state().begin());
  second.observe(sheets.places(-0.004));  // as a restart begins: this is no step
  EXPECT_EQ(second.crossings(), 18);
  second.observe(sheets.places(0.004));
  EXPECT_EQ(second.crossings(), 36);
}

TEST(ClothCrossings, AreNotThoseOfAClothWithItself) {
  const SheetOverSheet sheets(lattice_group<3>("towel", 1, {8, 4}));  // the same markers as one cloth
  ClothCrossings crossings(sheets.cloths);
  crossings.observe(sheets.places(0.004));
  crossings.observe(sheets.places(-0.004));
  EXPECT_EQ(crossings.crossings(), 0);
  EXPECT_EQ(crossings.least_distance(), crossings.reach());
}

}  // namespace
}  // namespace washfsi::test

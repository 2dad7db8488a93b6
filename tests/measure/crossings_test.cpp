// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/crossings.hpp"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

/// Two sheets of 4 x 4 markers 2 cm apart: one at rest in the plane z = 0, the other over it at a height, shifted so
/// that no marker is over an edge; then 3 x 3 markers of each are over the other one.
struct SheetOverSheet {
  SheetOverSheet() {
    groups[0].name = "towel";
    groups[0].count = 2;
    groups[0].markers = {4, 4};
    groups[0].sheet = {.width = 4, .ds = 0.02, .dr = 0.02};
    cloths.emplace(PETSC_COMM_WORLD, groups);
  }

  /// The places of this rank's markers.
  Points<3> places(double height) const {
    Points<3> mine;
    for (std::size_t m = 0; m < cloths->owned(); ++m) {
      const PetscInt number = cloths->number_of(m), row = number % 16 / 4, column = number % 4;
      const bool upper = number >= 16;
      const Point<3> shift = upper ? Point<3>(0.004, 0.007, height) : Point<3>::Zero();
      mine.push_back(0.02 * Point<3>(static_cast<double>(row), static_cast<double>(column), 0) + shift);
    }
    return mine;
  }

  std::vector<ClothGroup<3>> groups{1};
  std::optional<Cloths<3>> cloths;
};

TEST(ClothCrossings, CountEachMarkerOfSheetsThatJumpThroughEachOther) {
  const SheetOverSheet sheets;
  ClothCrossings crossings(*sheets.cloths);
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
  ClothCrossings first(*sheets.cloths), second(*sheets.cloths);
  first.observe(sheets.places(0.004));
  first.observe(sheets.places(-0.004));
  std::ranges::copy(first.state(), second.state().begin());
  second.observe(sheets.places(-0.004));  // as a restart begins: this is no step
  EXPECT_EQ(second.crossings(), 18);
  second.observe(sheets.places(0.004));
  EXPECT_EQ(second.crossings(), 36);
}

TEST(ClothCrossings, AreNotThoseOfAClothWithItself) {
  SheetOverSheet sheets;
  sheets.groups[0].count = 1;
  sheets.groups[0].markers = {8, 4};  // the same markers as one cloth
  sheets.cloths.emplace(PETSC_COMM_WORLD, sheets.groups);
  ClothCrossings crossings(*sheets.cloths);
  crossings.observe(sheets.places(0.004));
  crossings.observe(sheets.places(-0.004));
  EXPECT_EQ(crossings.crossings(), 0);
  EXPECT_EQ(crossings.least_distance(), crossings.reach());
}

}  // namespace
}  // namespace washfsi::test

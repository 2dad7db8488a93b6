// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/tumbling.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "washfsi/measure/crossings.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

// A cloth at this angle of an orbit of 5 cm round r = 0.2 m, z = 0.1 m, at the angle `around` about the axis.
Point<3> on_orbit(double angle, double around) {
  const double r = 0.2 + 0.05 * std::cos(angle), z = 0.1 + 0.05 * std::sin(angle);
  return {0.3 + r * std::cos(around), -0.1 + r * std::sin(around), z};
}

TEST(TumbleCounter, CountsTurnsInThePlaneOfRadiusAndHeight) {
  TumbleCounter counter({0.3, -0.1}, {0.2, 0.1}, 2);
  for (int n = 0; n <= 100; ++n)  // one goes round two and a half times, the other back once
    counter.observe({on_orbit(0.3 + 2.5 * 2 * std::numbers::pi * n / 100, 0.07 * n),
                     on_orbit(1 - 2 * std::numbers::pi * n / 100, -0.2 * n)});
  EXPECT_NEAR(counter.turns()[0], 2.5, 1e-12);
  EXPECT_NEAR(counter.turns()[1], -1, 1e-12);
}

TEST(TumbleCounter, GoesOnFromItsState) {
  TumbleCounter straight({0, 0}, {0.2, 0.1}, 1), half({0, 0}, {0.2, 0.1}, 1), restarted({0, 0}, {0.2, 0.1}, 1);
  for (int n = 0; n < 20; ++n) {
    straight.observe({on_orbit(0.5 * n, 0)});
    if (n < 10) half.observe({on_orbit(0.5 * n, 0)});
  }
  std::ranges::copy(half.angles(), restarted.angles().begin());
  std::ranges::copy(half.turned(), restarted.turned().begin());
  for (int n = 10; n < 20; ++n) restarted.observe({on_orbit(0.5 * n, 0)});
  EXPECT_EQ(restarted.turns(), straight.turns());
}

// Two sheets of 4 x 4 markers 1 cm apart in height, the upper one shifted by half a spacing.
struct TwoSheets {
  std::vector<ClothGroup<3>> groups{1};
  Points<3> places;
  TwoSheets() {
    groups[0].name = "towel";
    groups[0].count = 2;
    groups[0].markers = {4, 4};
    groups[0].sheet = {.width = 4, .ds = 0.02, .dr = 0.02};
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          places.emplace_back(0.02 * i + 0.004 * sheet, 0.02 * j + 0.007 * sheet, 0.01 * sheet);
  }
  void observe_by(ClothCrossings& crossings, const Cloths<3>& cloths) const {
    crossings.observe(Points<3>(places.begin() + cloths.begin(), places.begin() + cloths.end()));
  }
};

TEST(ClothCrossings, CountsMarkersThatGoThroughAnotherCloth) {
  TwoSheets sheets;
  const Cloths<3> cloths(PETSC_COMM_WORLD, sheets.groups);
  ClothCrossings crossings(cloths);
  sheets.observe_by(crossings, cloths);
  EXPECT_NEAR(crossings.least_distance(), 0.01, 1e-12);
  sheets.places[16 + 5][2] = -0.002;  // one marker of the upper sheet, in the middle
  sheets.observe_by(crossings, cloths);
  EXPECT_EQ(crossings.crossings(), 1);
  EXPECT_NEAR(crossings.least_distance(), 0.002, 2e-4);  // the upper sheet, bent, is near to others
  sheets.places[16 + 5][2] = -0.004;                     // it goes on, on the other side
  sheets.observe_by(crossings, cloths);
  EXPECT_EQ(crossings.crossings(), 1);
  sheets.places[16 + 5][2] = 0.01;  // and comes back
  sheets.observe_by(crossings, cloths);
  EXPECT_EQ(crossings.crossings(), 2);
}

TEST(ClothCrossings, DoesNotCountWhatPassesBeside) {
  TwoSheets sheets;
  const Cloths<3> cloths(PETSC_COMM_WORLD, sheets.groups);
  ClothCrossings crossings(cloths);
  for (std::size_t k = 16; k < 32; ++k) sheets.places[k][0] += 0.1;
  sheets.observe_by(crossings, cloths);
  for (std::size_t k = 16; k < 32; ++k) sheets.places[k][2] -= 0.02;
  sheets.observe_by(crossings, cloths);
  EXPECT_EQ(crossings.crossings(), 0);
  EXPECT_EQ(crossings.least_distance(), crossings.reach());
}

}  // namespace
}  // namespace washfsi::test

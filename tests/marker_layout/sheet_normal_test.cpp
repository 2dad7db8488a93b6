// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/sheet_normal.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

const Point<3> flat(0.3, 0.3, 0.1);  // cells

/// A plate a metre wide and high, turned about z; so many cells thick where they are wide.
class TurnedPlate {
 public:
  TurnedPlate(double thickness, double degrees)
      : pose_(Pose<3>::at(Point<3>::Zero(), degrees * std::acos(-1) / 180)),
        plate_(std::make_unique<Cuboid<3>>(Point<3>(thickness * flat[0], 3, 3)), pose_) {}

  /// How far the normal found beside a place in the plate's frame is from its own.
  double error_at(const Point<3>& place) const {
    const Point<3> expected = pose_.in_space(Point<3>::UnitX());
    const Point<3> found = sheet_normal<3>(plate_, pose_.in_space(place), flat);
    return std::min((found - expected).norm(), (found + expected).norm());
  }

 private:
  Pose<3> pose_;
  Placed<3> plate_;
};

TEST(SheetNormal, IsFoundInFlatCellsHoweverASheetStands) {
  for (const double thickness : {0.1, 0.6, 1.2})
    for (const double degrees : {0.0, 10.0, 22.5, 45.0, 77.0})
      EXPECT_LT(TurnedPlate(thickness, degrees).error_at(Point<3>::Zero()), 1e-6) << thickness << ", " << degrees;
}

TEST(SheetNormal, IsFoundBesideEdgesAndBesideTheMiddle) {
  const TurnedPlate plate(1.0, 20);
  EXPECT_LT(plate.error_at(Point<3>(0, 0, 1.5 - 0.7 * flat[2])), 1e-6);
  EXPECT_LT(plate.error_at(Point<3>(0, 1.5 - 0.7 * flat[1], 0)), 1e-6);
  EXPECT_LT(plate.error_at(Point<3>(0.4 * flat[0], 0, 0)), 1e-6);
}

TEST(SheetNormal, IsThatOfALineInThePlane) {
  const Cuboid<2> line(Point<2>(2, 0.09));
  const Point<2> found = sheet_normal<2>(line, Point<2>(0.3, 0.01), Point<2>(0.3, 0.1));
  EXPECT_NEAR(std::abs(found[1]), 1, 1e-9);
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/speed_programme.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

constexpr Strokes wash{.speed = 4, .ramp = 0.3, .stroke = 1.5, .pause = 0.4};

std::vector<SpeedProgramme> programmes() {
  Strokes twice = wash, start = wash, abrupt = wash;
  twice.cycles = 2;
  start.stroke = start.pause = 0;
  start.speed = -3;
  abrupt.ramp = 0;
  return {SpeedProgramme(wash),
          SpeedProgramme(twice),
          SpeedProgramme(start),
          SpeedProgramme(abrupt),
          SpeedProgramme({0.2, 0.5, 1.1, 2}, {0, 3, -1, 0}, 0),
          SpeedProgramme({-0.5, 0.5, 1.1, 2}, {1, 3, -1, 2}, 1)};
}

/// The rate's integral by the trapezoidal rule over many intervals.
double integral(const SpeedProgramme& programme, double end) {
  constexpr int intervals = 200000;
  double sum = 0;
  for (int k = 0; k < intervals; ++k) sum += programme.at((k + 0.5) * end / intervals).rate;
  return sum * end / intervals;
}

TEST(SpeedProgramme, AngleIsTheIntegralOfTheRateAndAccelerationItsDerivative) {
  for (const auto& programme : programmes()) {
    EXPECT_EQ(programme.at(0).angle, 0);
    for (const double t : {0.11, 0.37, 1.43, 3.05, 9.21}) {
      constexpr double dt = 1e-4;
      EXPECT_NEAR(programme.at(t).angle, integral(programme, t), 1e-4);
      const double rate = programme.at(t).rate, before = programme.at(t - dt).rate, after = programme.at(t + dt).rate;
      EXPECT_NEAR((programme.at(t + dt).angle - programme.at(t - dt).angle) / (2 * dt), rate, 1e-6);
      EXPECT_NEAR((after - before) / (2 * dt), programme.at(t).acceleration, 1e-5);
      EXPECT_LE(std::abs(rate), programme.largest_rate());
    }
  }
}

TEST(SpeedProgramme, WithRampsNeitherSpeedNorAccelerationJumps) {
  const SpeedProgramme programme(wash);
  constexpr double little = 1e-9;
  double joint = -(wash.stroke + wash.pause);
  for (const double part : {0.0, 0.3, 0.9, 0.3, 0.4, 0.3, 0.9, 0.3, 0.4, 0.3, 0.9}) {
    const auto before = programme.at(joint + part - little), after = programme.at(joint + part + little);
    EXPECT_NEAR(before.angle, after.angle, 1e-7);
    EXPECT_NEAR(before.rate, after.rate, 1e-6);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-5);
    joint += part;
  }
}

TEST(SpeedProgramme, TurnsAsFarEachWayAndRests) {
  const SpeedProgramme programme(wash);
  const double far = wash.speed * (wash.stroke - wash.ramp);
  EXPECT_NEAR(programme.at(wash.stroke).angle, far, 1e-14);
  EXPECT_NEAR(programme.at(wash.stroke + 0.5 * wash.pause).angle, far, 1e-14);
  EXPECT_EQ(programme.at(wash.stroke + 0.5 * wash.pause).rate, 0);
  EXPECT_EQ(programme.at(wash.stroke / 2).rate, wash.speed);
  EXPECT_EQ(programme.at(wash.stroke + wash.pause + wash.stroke / 2).rate, -wash.speed);
  EXPECT_NEAR(programme.at(programme.period()).angle, 0, 1e-14);
  EXPECT_EQ(programme.largest_rate(), wash.speed);
}

TEST(SpeedProgramme, Repeats) {
  for (const auto& programme : programmes()) {
    const double period = programme.period();
    if (period == 0) continue;
    const double turned = programme.at(0.6 + period).angle - programme.at(0.6).angle;
    for (const double t : {0.25, 0.37, 1.43, 1.87}) {
      const auto now = programme.at(t), later = programme.at(t + period);
      EXPECT_NEAR(later.angle - now.angle, turned, 1e-13);
      EXPECT_NEAR(later.rate, now.rate, 1e-13);
      EXPECT_NEAR(later.acceleration, now.acceleration, 1e-11);
    }
  }
  EXPECT_NEAR(programmes()[0].period(), 2 * (wash.stroke + wash.pause), 1e-14);
  EXPECT_EQ(programmes()[2].period(), 0);
  EXPECT_NEAR(programmes()[4].period(), 1.8, 1e-14);
  EXPECT_EQ(programmes()[5].period(), 0);
}

TEST(SpeedProgramme, EndsAfterItsCycles) {
  Strokes strokes = wash;
  strokes.cycles = 2;
  const SpeedProgramme ends(strokes), goes_on(wash);
  const double end = 2 * goes_on.period();
  for (const double t : {0.1, 3.9, end - 0.5}) EXPECT_EQ(ends.at(t).rate, goes_on.at(t).rate);
  EXPECT_NE(goes_on.at(end + 0.5).rate, 0);
  EXPECT_EQ(ends.at(end + 0.5).rate, 0);
  EXPECT_NEAR(ends.at(end + 7).angle, 0, 1e-13);
}

TEST(SpeedProgramme, KeepsItsSpeedBeforeAndAfterATable) {
  const SpeedProgramme table({0.5, 1, 2}, {1, 3, 2}, 1);
  EXPECT_EQ(table.at(0.2).rate, 1);
  EXPECT_NEAR(table.at(0.2).angle, 0.2, 1e-15);
  EXPECT_EQ(table.at(0.75).rate, 2);
  EXPECT_EQ(table.at(0.75).acceleration, 4);
  EXPECT_EQ(table.at(5).rate, 2);
  EXPECT_NEAR(table.at(5).angle, 0.5 + 1 + 2.5 + 6, 1e-14);
}

TEST(SpeedProgramme, TellsTheShortestTimeThatStepsMustSee) {
  EXPECT_EQ(SpeedProgramme(wash).shortest_span().duration, wash.ramp);
  EXPECT_EQ(programmes()[3].shortest_span().duration, wash.stroke);
  EXPECT_EQ(programmes()[3].shortest_span().option, "stroke 1.5");
}

}  // namespace
}  // namespace washfsi::test

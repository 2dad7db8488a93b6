// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/progress.hpp"

#include <gtest/gtest.h>

namespace washfsi {
namespace {

// Steps of equal length and cost, from a step on.
void advance(Pace& pace, double& wall, long& step, double& time, int steps, double seconds, double dt) {
  for (int n = 0; n < steps; ++n) pace.advance(wall += seconds, ++step, time += dt);
}

TEST(Pace, SettingUpIsNoStep) {
  Pace pace;
  double wall = 64, time = 0;  // a minute of setting up
  long step = 0;
  pace.begin(wall, step, time);
  advance(pace, wall, step, time, 1, 0.1, 1e-3);
  EXPECT_NEAR(pace.seconds_per_step(), 0.1, 1e-9);
  EXPECT_NEAR(pace.seconds_left(1.0), 99.9, 1e-6);
}

TEST(Pace, TheFirstStepCountsWhileItIsAlone) {
  Pace pace;
  double wall = 0, time = 0;
  long step = 0;
  pace.begin(wall, step, time);
  advance(pace, wall, step, time, 1, 10, 1e-3);
  EXPECT_NEAR(pace.seconds_per_step(), 10, 1e-9);
  EXPECT_FALSE(pace.is_known());
  advance(pace, wall, step, time, 5, 1, 1e-3);
  EXPECT_NEAR(pace.seconds_per_step(), 1, 1e-9);
  EXPECT_TRUE(pace.is_known());
}

TEST(Pace, GoesOnFromACheckpoint) {
  Pace pace;
  double wall = 3, time = 5;
  long step = 40000;
  pace.begin(wall, step, time);
  advance(pace, wall, step, time, 4, 0.5, 0.01);
  EXPECT_NEAR(pace.seconds_per_step(), 0.5, 1e-9);
  EXPECT_NEAR(pace.seconds_left(6.0), 0.5 * 96, 1e-6);
}

// Steps of a start are short and expensive: they are forgotten, and what is left is in steps as long as the last.
TEST(Pace, FollowsTheLatestSteps) {
  Pace pace;
  double wall = 0, time = 0;
  long step = 0;
  pace.begin(wall, step, time);
  advance(pace, wall, step, time, 100, 1.0, 1e-4);
  EXPECT_NEAR(pace.seconds_left(1.01), 1e4, 1);
  advance(pace, wall, step, time, 1, 1.0, 1e-2);
  EXPECT_NEAR(pace.seconds_left(1.01), 99, 1.01);
  advance(pace, wall, step, time, 60, 0.5, 1e-2);
  EXPECT_LT(pace.seconds_per_step(), 0.75);
  advance(pace, wall, step, time, 30, 0.5, 1e-2);
  EXPECT_NEAR(pace.seconds_per_step(), 0.5, 0.02);
}

TEST(Pace, NothingIsLeftBehindTheEnd) {
  Pace pace;
  EXPECT_EQ(pace.seconds_left(1.0), 0.0);
  pace.begin(0, 0, 0);
  pace.advance(1, 1, 1.2);
  EXPECT_EQ(pace.seconds_left(1.0), 0.0);
}

}  // namespace
}  // namespace washfsi

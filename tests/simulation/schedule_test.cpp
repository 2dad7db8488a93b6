// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/schedule.hpp"

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

/// The schedule of a run of a second in steps of 0.1 s.
struct TenSteps {
  TenSteps() {
    options.time_end = 1;
    state.dt = 0.1;
  }
  RunOptions options;
  RunState state;
  Schedule schedule{options, state};
};

TEST(Schedule, EndsWithTheTimeInSpiteOfRoundOff) {
  TenSteps run;
  Clock clock;
  int steps = 0;
  for (; !run.schedule.finished(clock) && steps < 100; ++steps) clock.advance(run.state.dt);
  EXPECT_EQ(steps, 10);  // ten times 0.1 is less than 1
}

TEST(Schedule, CountsStepsFromWhereItGoesOn) {
  TenSteps run;
  run.options.max_steps = 3;
  run.schedule.begin(5);
  EXPECT_EQ(run.schedule.steps_taken({0.7, 7}), 2);
  EXPECT_FALSE(run.schedule.finished({0.7, 7}));
  EXPECT_TRUE(run.schedule.finished({0.8, 8}));
}

TEST(Schedule, EndsWhenTheClothsAreAtRest) {
  TenSteps run;
  run.state.steps_at_rest = 9;
  EXPECT_FALSE(run.schedule.finished({0.5, 5}));
  run.state.steps_at_rest = 10;
  EXPECT_TRUE(run.schedule.finished({0.5, 5}));
}

// In each interval one step is due: that in which a multiple of the interval lies.
TEST(Schedule, IsDueOnceInEachInterval) {
  for (const double interval : {0.1, 0.25, 0.3}) {
    TenSteps run;
    Clock clock;
    int due = 0;
    while (clock.step < 12) {
      clock.advance(run.state.dt);
      due += run.schedule.due(interval, clock.time) ? 1 : 0;
    }
    EXPECT_EQ(due, static_cast<int>(1.2 / interval + 1e-9)) << interval;
  }
}

// All is measured where a row is due, and after a step that may be the last one, also if only since all is at rest.
TEST(Schedule, MeasuresAllWhereARowIsDueAndAtTheEnd) {
  TenSteps run;
  EXPECT_TRUE(run.schedule.measures_all({0.1, 1}));  // without an interval always
  run.options.history_interval = 0.5;
  EXPECT_FALSE(run.schedule.measures_all({0.4, 4}));
  EXPECT_TRUE(run.schedule.measures_all({0.5, 5}));
  EXPECT_TRUE(run.schedule.measures_all({1.0, 10}));
  run.state.steps_at_rest = 9;
  EXPECT_TRUE(run.schedule.measures_all({0.7, 7}));
}

}  // namespace
}  // namespace washfsi::test

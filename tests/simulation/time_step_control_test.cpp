// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/time_step_control.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "support/refusal.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

/// Water alone in a periodic box with cells of 1 cm, flowing evenly along x: the CFL number of a step of dt is
/// dt times speed over 1 cm, now and later.
struct EvenFlow {
  explicit EvenFlow(double speed) {
    CaseOptions<2> options = fibre_in_water(0, 0);
    options.model.cloths.clear();
    options.placements.clear();
    options.initial_flow.kind = speed > 0 ? "uniform" : "rest";
    options.initial_flow.velocity = {speed, 0};
    system = start_system<2>(PETSC_COMM_WORLD, options, {});
    scheme = make_coupling_scheme<2>(coupling, *system);
  }
  /// The length of the first step.
  double begun() {
    TimeStepControl<2>(run, coupling, *system, *scheme).begin(state);
    return state.dt;
  }
  /// The length of the step after one of 8 ms with this CFL number.
  double adapted(double courant) {
    state.dt = 0.008;
    TimeStepControl<2>(run, coupling, *system, *scheme).adapt(state, courant);
    return state.dt;
  }

  RunOptions run;
  CouplingOptions coupling;
  RunState state;
  std::unique_ptr<System<2>> system;
  std::unique_ptr<CouplingScheme<2>> scheme;
};

TEST(TimeStepControl, TakesTheUsersStep) {
  EvenFlow flow(0.5);
  flow.run.time_step = 0.0123;
  EXPECT_EQ(flow.begun(), 0.0123);
}

TEST(TimeStepControl, ChoosesTheFirstStepForTheCflNumberWithoutTakingIt) {
  EvenFlow flow(0.5);
  flow.run.time_cfl = 0.4;
  EXPECT_NEAR(flow.begun(), 0.4 * 0.01 / 0.5, 1e-9);
  EXPECT_EQ(flow.system->state.clock.step, 0);
  EXPECT_EQ(flow.system->state.clock.time, 0);
  EvenFlow limited(0.5);
  limited.run.time_cfl = 0.4;
  limited.run.time_step = 0.003;  // the longest
  EXPECT_EQ(limited.begun(), 0.003);
}

TEST(TimeStepControl, GoesOnWithTheStepOfACheckpoint) {
  EvenFlow flow(0.5);
  flow.run.time_cfl = 0.4;
  flow.state.dt = 0.0042;
  EXPECT_EQ(flow.begun(), 0.0042);
}

TEST(TimeStepControl, AsksForAStepWhereNothingMoves) {
  EvenFlow flow(0);
  expect_refusal<InputError>([&] { (void)flow.begun(); }, "-time_step is missing: nothing moves");
}

TEST(TimeStepControl, ShortensStepsAtOnceAndLengthensThemSlowly) {
  EvenFlow flow(0.5);
  flow.state.cloth_bound = std::numeric_limits<double>::infinity();
  flow.run.time_cfl = 0.4;
  EXPECT_NEAR(flow.adapted(0.8), 0.004, 1e-15);
  EXPECT_NEAR(flow.adapted(0.39), 0.008 * 0.4 / 0.39, 1e-15);
  EXPECT_NEAR(flow.adapted(0.1), 1.05 * 0.008, 1e-15);
  EXPECT_NEAR(flow.adapted(0), 1.05 * 0.008, 1e-15);  // at rest
}

TEST(TimeStepControl, LimitsStepsByTheUsersAndByHalfOfTheClothsBound) {
  EvenFlow flow(0.5);
  flow.run.time_cfl = 0.4;
  flow.state.cloth_bound = 0.01;
  EXPECT_NEAR(flow.adapted(0.1), 0.005, 1e-15);
  flow.run.time_step = 0.0082;
  EXPECT_EQ(flow.adapted(0.1), 0.0082);
}

TEST(TimeStepControl, LeavesStepsOfEqualLengthAlone) {
  EvenFlow flow(0.5);
  flow.run.time_step = 0.008;
  EXPECT_EQ(flow.adapted(0.9), 0.008);
}

// The first steps of a run are repeated, shorter, where their CFL number is a quarter above the aim; later ones not.
TEST(TimeStepControl, RepeatsAFirstStepThatIsTooLong) {
  EvenFlow flow(0.5);
  flow.run.time_cfl = 0.4;
  const TimeStepControl<2> control(flow.run, flow.coupling, *flow.system, *flow.scheme);
  EXPECT_TRUE(control.may_shorten());
  flow.state.dt = 0.032;
  control.advance(flow.state);
  EXPECT_LE(flow.state.dt, 1.25 * 0.008);
  EXPECT_GE(flow.state.dt, 0.5 * 0.008);
  EXPECT_EQ(flow.system->state.clock.step, 1);
  EXPECT_EQ(flow.system->state.clock.time, flow.state.dt);
  flow.system->state.clock.step = 20;
  EXPECT_FALSE(control.may_shorten());
  flow.state.dt = 0.018;
  control.advance(flow.state);
  EXPECT_EQ(flow.state.dt, 0.018);
}

TEST(TimeStepControl, CannotMeasureTheErrorOfTheSchemeThatItComparesWith) {
  EvenFlow flow(0.5);
  flow.run.time_tolerance = 0.1;
  flow.coupling.scheme = "implicit";
  expect_refusal<InputError>([&] { (void)flow.begun(); }, "-time_tolerance 0.1: not with -coupling_scheme implicit");
  flow.coupling.time_scheme = TimeScheme::backward_euler;
  EXPECT_NO_THROW((void)flow.begun());
}

}  // namespace
}  // namespace washfsi::test

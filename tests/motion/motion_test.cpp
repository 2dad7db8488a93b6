// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/motion.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

/// The path of a material point, whose rates must be the motion's velocity and acceleration.
template <int Dim>
void expect_consistent(const RigidMotion<Dim>& motion) {
  const Point<Dim> in_body = 0.3 * Point<Dim>::Ones();
  const auto place = [&](double t) {
    const auto pose = motion.pose(t);
    Point<Dim> arm = in_body;
    arm.template head<2>() << pose.cosine * in_body[0] - pose.sine * in_body[1],
        pose.sine * in_body[0] + pose.cosine * in_body[1];
    return Point<Dim>(pose.center + arm);
  };
  constexpr double dt = 1e-4;
  for (const double t : {0.05, 0.31, 0.77, 1.4}) {
    const Point<Dim> before = place(t - dt), now = place(t), after = place(t + dt);
    EXPECT_LE((motion.in_body_frame(now, t) - in_body).norm(), 1e-14);
    EXPECT_LE(((after - before) / (2 * dt) - motion.velocity(now, t)).norm(), 1e-5);
    EXPECT_LE(((after - 2 * now + before) / (dt * dt) - motion.acceleration(now, t)).norm(), 1e-4);
    EXPECT_LE(motion.velocity(now, t).norm(), motion.largest_speed(in_body.norm()) + 1e-14);
    EXPECT_EQ(motion.center_at(t), motion.pose(t).center);
  }
  EXPECT_FALSE(motion.at_rest());
}

template <int Dim>
std::vector<RigidMotion<Dim>> motions() {
  using Table = MotionTable<Dim>;
  std::vector<RigidMotion<Dim>> list(8);
  list[0].angular_speed = 3;
  list[1].angular_speed = 3;
  list[1].frequency = 0.7;
  list[2].translation = Point<Dim>::Constant(0.4);
  list[3].translation = Point<Dim>::Unit(1);
  list[3].frequency = 0.7;
  list[4].translation = Point<Dim>::Unit(Dim - 1);
  list[4].angular_speed = -2;
  list[4].frequency = 0.7;
  std::vector<typename Table::Row> rows(4, Table::Row::Zero());
  rows[1].setConstant(0.5);
  rows[2] = Table::Row::Unit(1);
  rows[3] = 2 * Table::Row::Unit(Dim);
  list[5].table = std::make_shared<const Table>(std::vector{0.0, 0.5, 0.9, 2.0}, rows);
  list[6].programme =
      std::make_shared<const SpeedProgramme>(Strokes{.speed = 3, .ramp = 0.2, .stroke = 0.65, .pause = 0.2});
  list[7].programme =
      std::make_shared<const SpeedProgramme>(std::vector{0.1, 0.5, 1.5}, std::vector{1.0, -2.0, 3.0}, 1);
  for (auto& motion : list) motion.center = Point<Dim>::Constant(0.2);
  return list;
}

TEST(RigidMotion, PoseVelocityAndAccelerationAgree) {
  for (const auto& motion : motions<2>()) expect_consistent<2>(motion);
  for (const auto& motion : motions<3>()) expect_consistent<3>(motion);
}

TEST(RigidMotion, TheWashTurnsOneRevolutionEachWay) {
  RigidMotion<2> motion;
  motion.angular_speed = 4 * std::numbers::pi;
  motion.frequency = 2 / std::numbers::pi;
  EXPECT_NEAR(motion.angle(0.5 / motion.frequency), 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(motion.angle(1 / motion.frequency), 0, 1e-12);
}

TEST(RigidMotion, TellsItsPeriod) {
  RigidMotion<2> motion;
  motion.frequency = 0.5;
  EXPECT_EQ(motion.period(), 0);  // at rest
  motion.angular_speed = 3;
  EXPECT_EQ(motion.period(), 2);
  motion.frequency = 0;
  EXPECT_EQ(motion.period(), 0);
  motion.programme = std::make_shared<const SpeedProgramme>(Strokes{.speed = 3, .stroke = 0.75, .pause = 0.25});
  EXPECT_EQ(motion.period(), 2);
  EXPECT_FALSE(motion.turns_steadily());
  EXPECT_TRUE(motion.only_turns());
}

/// The motion of a body `drum` with these options.
RigidMotion<2> motion_of(const std::string& text) {
  WASH_PETSC(PetscOptionsClear(nullptr));
  WASH_PETSC(PetscOptionsInsertString(nullptr, text.c_str()));
  Options options(PETSC_COMM_WORLD);
  return RigidMotion<2>::from_options(options, "drum");
}

TEST(RigidMotion, RevolutionsPerMinuteAreASpeed) {
  const double of_radians = motion_of("-drum_angular_speed 4.71238898038469").angular_velocity(1);
  EXPECT_NEAR(motion_of("-drum_rpm 45").angular_velocity(1), of_radians, 1e-15 * of_radians);
  EXPECT_TRUE(motion_of("-drum_rpm 45").turns_steadily());
  EXPECT_NEAR(motion_of("-drum_rpm 45 -drum_ramp 2").angular_velocity(3), of_radians, 1e-15 * of_radians);
  EXPECT_TRUE(motion_of("-drum_stroke 2 -drum_ramp 1").at_rest());
}

TEST(RigidMotion, RefusesWhatMeansNothing) {
  for (const char* text : {"-drum_rpm 3 -drum_angular_speed 1", "-drum_rpm 3 -drum_stroke 1 -drum_ramp 0.6",
                           "-drum_rpm 3 -drum_pause 1", "-drum_rpm 3 -drum_cycles 2", "-drum_angle_unit deg",
                           "-drum_rpm 3 -drum_ramp 1 -drum_frequency 1", "-drum_stroke 1 -drum_velocity 1,0",
                           "-drum_speed_file a.csv -drum_motion_file b.csv", "-drum_speed_file a.csv -drum_rpm 3"})
    EXPECT_THROW(motion_of(text), InputError) << text;
}

TEST(RigidMotion, RestsOnlyIfNothingEverMoves) {
  using Table = MotionTable<2>;
  EXPECT_TRUE(RigidMotion<2>{}.at_rest());
  RigidMotion<2> motion;
  motion.table = std::make_shared<const Table>(std::vector{0.0, 1.0}, std::vector<Table::Row>(2, {1, 2, 3}));
  EXPECT_TRUE(motion.at_rest());
  EXPECT_EQ(motion.center_at(5), Point<2>(1, 2));
  motion.table = std::make_shared<const Table>(std::vector{0.0, 1.0}, std::vector<Table::Row>{{1, 2, 3}, {1, 2, 4}});
  EXPECT_FALSE(motion.at_rest());
}

TEST(MotionTable, MeetsItsRowsAndIsSmooth) {
  const std::vector<double> times{0.5, 1, 1.7, 2, 3};
  const std::vector<MotionTable<2>::Row> rows{{0, 0, 0}, {1, 0, 0.5}, {0.5, 0.2, 1}, {0, 0, 2}, {0, 1, 0}};
  const MotionTable<2> table(times, rows);
  for (std::size_t k = 0; k < times.size(); ++k) {
    constexpr double little = 1e-9;
    EXPECT_LE((table.at(times[k]).value - rows[k]).norm(), 1e-14);
    const auto before = table.at(times[k] - little), after = table.at(times[k] + little);
    EXPECT_LE((after.rate - before.rate).norm(), 1e-6);
    if (k > 0 && k + 1 < times.size()) {
      EXPECT_LE((after.acceleration - before.acceleration).norm(), 1e-6);
    }
  }
  for (const double outside : {-1.0, 4.0}) {
    EXPECT_EQ(table.at(outside).value, outside < 0 ? rows.front() : rows.back());
    EXPECT_TRUE(table.at(outside).rate.isZero(0));
  }
  double largest = 0;
  for (int k = 0; k <= 5000; ++k) largest = std::max(largest, std::abs(table.at(k * 1e-3).rate[0]));
  EXPECT_NEAR(table.largest_rate()[0], largest, 1e-5);
}

}  // namespace
}  // namespace washfsi::test

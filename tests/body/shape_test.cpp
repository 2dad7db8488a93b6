// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/shape.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/body/motion.hpp"

namespace washfsi::test {
namespace {

TEST(Vaned, DistanceOutsideIsThatToTheNearestPointOfTheSurface) {
  const Vaned::Dimensions d{.hub_radius = 0.07, .tip_radius = 0.19, .vane_thickness = 0.04, .vanes = 3};
  const Vaned vaned(d);
  // the surface by brute force: points of hub and vanes whose distance is zero
  Points<2> surface;
  for (int k = 0; k < 3600; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3600;
    const Point<2> ray(std::cos(angle), std::sin(angle));
    double inside = 0, outside = 0.3;  // the shape is a star: one crossing on each ray
    for (int n = 0; n < 50; ++n) {
      const double middle = 0.5 * (inside + outside);
      (vaned.distance(middle * ray) < 0 ? inside : outside) = middle;
    }
    surface.push_back(inside * ray);
  }
  for (const auto& place : random_points<2>(200, 4, 0.3)) {
    const double distance = vaned.distance(place);
    if (distance <= 0) continue;
    double nearest = 1;
    for (const auto& point : surface) nearest = std::min(nearest, (point - place).norm());
    EXPECT_NEAR(distance, nearest, 5e-4);
  }
  EXPECT_NEAR(vaned.distance({0.19, 0}), 0, 1e-15);  // the first tip lies on x
  EXPECT_LT(vaned.distance({0.15 * std::cos(2.0944), 0.15 * std::sin(2.0944)}), 0);
}

TEST(Inverted, SwapsSolidAndFluid) {
  const Inverted<3> drum(std::make_unique<Sphere<3>>(2.0));
  EXPECT_DOUBLE_EQ(drum.distance({0, 0, 0.5}), 1.5);
  EXPECT_DOUBLE_EQ(drum.distance({3, 0, 0}), -1);
}

template <int Dim>
void expect_consistent_motion() {
  RigidMotion<Dim> motion;
  motion.center = Point<Dim>::Constant(0.2);
  motion.angular_speed = 3;
  motion.frequency = 0.7;
  // a material point of the body: fixed in its frame, so its frame coordinates must not change along its path
  Point<Dim> place = Point<Dim>::Constant(0.5);
  const Point<Dim> in_frame = motion.in_body_frame(place, 0);
  constexpr double dt = 1e-4;
  double t = 0;
  for (; t < 1; t += dt) place += dt * motion.velocity(place + 0.5 * dt * motion.velocity(place, t), t + 0.5 * dt);
  EXPECT_LE((motion.in_body_frame(place, t) - in_frame).norm(), 1e-6);
  // acceleration of that point, by difference along its path
  const Point<Dim> u = motion.velocity(place, t), next = place + dt * u, before = place - dt * u;
  const Point<Dim> rate = (motion.velocity(next, t + dt) - motion.velocity(before, t - dt)) / (2 * dt);
  EXPECT_LE((rate - motion.acceleration(place, t)).norm(), 1e-3);
}

TEST(RigidMotion, FrameVelocityAndAccelerationAgree) {
  expect_consistent_motion<2>();
  expect_consistent_motion<3>();
}

TEST(RigidMotion, TheWashTurnsOneRevolutionEachWay) {
  const RigidMotion<2> motion{
      .center = Point<2>::Zero(), .angular_speed = 4 * std::numbers::pi, .frequency = 2 / std::numbers::pi};
  EXPECT_NEAR(motion.angle(0.5 / motion.frequency), 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(motion.angle(1 / motion.frequency), 0, 1e-12);
}

}  // namespace
}  // namespace washfsi::test

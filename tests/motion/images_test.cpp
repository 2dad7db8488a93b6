// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies in boxes with periodic sides: what is asked of one is asked of its nearest image.
#include "washfsi/motion/images.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "support/refusal.hpp"
#include "washfsi/motion/repeat_bodies.hpp"
#include "washfsi/shapes/agitator.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/sweeps.hpp"
#include "washfsi/shapes/vaned.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
Grid<Dim> periodic_box(std::array<bool, Dim> periodic) {
  GridShape<Dim> shape;
  shape.cells.fill(24);
  shape.lower.setConstant(-0.3);
  shape.upper.setConstant(0.9);
  shape.periodic = periodic;
  return Grid<Dim>(PETSC_COMM_WORLD, shape);
}

template <int Dim>
std::vector<Body<Dim>> one_body(ShapePtr<Dim> shape, const Point<Dim>& center, double angular_speed = 0) {
  std::vector<Body<Dim>> bodies(1);
  bodies[0].name = "it";
  bodies[0].shape = std::move(shape);
  bodies[0].motion.center = center;
  bodies[0].motion.angular_speed = angular_speed;
  return bodies;
}

ShapePtr<2> hook() {
  ShapeList<2> parts;
  parts.push_back(std::make_unique<Cuboid<2>>(Point<2>(0.5, 0.1)));
  parts.push_back(std::make_unique<Placed<2>>(std::make_unique<Sphere<2>>(0.12), Pose<2>{{0.3, 0.2}}));
  return std::make_unique<Union<2>>(std::move(parts));
}

// The hook reaches 0.67 m, so it turns through images of itself in none of these places.
TEST(Images, AreAskedForTheNearestOfAll) {
  const Grid<2> grid = periodic_box<2>({true, true});
  const auto bodies = repeat_bodies<2>(grid, one_body<2>(hook(), {0.8, -0.25}, 1));
  for (const double time : {0.0, 0.7, 2.0}) {
    const PosedBody<2> posed = bodies[0].at(time);
    for (const auto& place : random_points<2>(200, 1, 2)) {
      double least = 1e9;
      Point<2> beside = place;
      for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j) {
          const Point<2> image = place - 1.2 * Point<2>(i, j);
          const double distance = bodies[0].shape->distance(posed.pose().in_body_frame(image));
          if (distance < least) beside = image;
          least = std::min(least, distance);
        }
      EXPECT_NEAR(posed.distance(place), least, 1e-12) << place.transpose();
      EXPECT_NEAR((posed.beside(place) - beside).norm(), 0, 1e-12);
      EXPECT_NEAR((posed.velocity(place) - posed.motion().velocity_at(beside)).norm(), 0, 1e-12);
    }
  }
}

TEST(Images, AreNoneAlongOtherAxes) {
  const Grid<2> grid = periodic_box<2>({true, false});
  const auto bodies = repeat_bodies<2>(grid, one_body<2>(std::make_unique<Sphere<2>>(0.2), {-0.3, 0.9}));
  EXPECT_NEAR(bodies[0].distance({0.8, 0.9}, 0), -0.1, 1e-12);
  EXPECT_GT(bodies[0].distance({0.8, -0.3}, 0), 0.9);
}

// A drum whose opening lies across the side: what is open in one image is open.
TEST(Images, OfADrumLeaveOpenWhatAnyLeavesOpen) {
  const Grid<2> grid = periodic_box<2>({true, true});
  auto drum = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.4));
  const auto bodies = repeat_bodies<2>(grid, one_body<2>(std::move(drum), {0.9, 0.9}));
  EXPECT_NEAR(bodies[0].distance({-0.2, -0.3}, 0), 0.3, 1e-12);
  EXPECT_NEAR(bodies[0].distance({-0.3, 0.7}, 0), 0.2, 1e-12);
  EXPECT_NEAR(bodies[0].distance({0.3, 0.9}, 0), -0.2, 1e-12);
}

// As long as a period, or longer, and the same all along it: without ends.
TEST(Images, OfWhatSpansThePeriodAreOne) {
  const Grid<3> grid = periodic_box<3>({false, false, true});
  for (const double height : {1.2, 3.0}) {
    auto post = std::make_unique<Extruded>(std::make_unique<Sphere<2>>(0.2), height);
    auto bodies = one_body<3>(std::move(post), {0.3, 0.3, 0.1});
    bodies[0].motion.translation = {0, 0, 1};
    bodies = repeat_bodies<3>(grid, std::move(bodies));
    for (const double time : {0.0, 5.0})
      for (const double z : {-0.3, 0.1, 0.7, 0.9}) {
        EXPECT_NEAR(bodies[0].distance({0.3, 0.45, z}, time), -0.05, 1e-12);
        EXPECT_LE(std::abs(bodies[0].at(time).arm({0.3, 0.45, z})[2]), 0.6 + 1e-12);
      }
  }
}

template <int Dim>
std::string refusal(const Grid<Dim>& grid, std::vector<Body<Dim>> bodies) {
  return refusal_of<InputError>([&] { (void)repeat_bodies<Dim>(grid, std::move(bodies)); });
}

TEST(Images, ThatOverlapAreRefused) {
  const Grid<2> grid = periodic_box<2>({true, false});
  const std::string ball = refusal<2>(grid, one_body<2>(std::make_unique<Sphere<2>>(0.7), {0, 0.3}));
  EXPECT_NE(ball.find("overlaps its own images along x"), std::string::npos) << ball;
  ShapeList<2> parts;  // a block with a hole, which images would fill
  parts.push_back(std::make_unique<Cuboid<2>>(Point<2>(4, 4)));
  parts.push_back(std::make_unique<Sphere<2>>(0.4));
  EXPECT_NE(refusal<2>(grid, one_body<2>(difference<2>(std::move(parts)), {0.3, 0.3})), "");
  EXPECT_EQ(refusal<2>(grid, one_body<2>(std::make_unique<Cuboid<2>>(Point<2>(4, 0.2)), {0.3, 0.3})), "");
  EXPECT_EQ(refusal<2>(grid, one_body<2>(std::make_unique<Cuboid<2>>(Point<2>(0.2, 4)), {0.3, 0.3})), "");
}

// A floor goes on behind the side; what lies aslant to it meets nothing there, unless a body lies where its image
// would.
TEST(Images, OfWhatHasNoEndMustMeetABody) {
  const Grid<2> grid = periodic_box<2>({true, false});
  EXPECT_EQ(refusal<2>(grid, one_body<2>(std::make_unique<HalfSpace<2>>(Point<2>(0, 1)), {0, 0})), "");
  const auto aslant = [](double height) {
    auto body = one_body<2>(std::make_unique<HalfSpace<2>>(Point<2>(-0.3, 1)), {0, height});
    return std::move(body.front());
  };
  std::vector<Body<2>> bodies;
  bodies.push_back(aslant(0));
  const std::string message = refusal<2>(grid, std::move(bodies));
  EXPECT_NE(message.find("goes on without end along x"), std::string::npos) << message;
}

// All places inside lie within the bounds, those outside of an opening within these.
template <int Dim>
void expect_bounds(const Shape<Dim>& shape, bool of_opening) {
  const Extent<Dim> extent = shape.extent();
  EXPECT_EQ(extent.of_opening, of_opening);
  int inside = 0;
  for (const auto& place : random_points<Dim>(4000, 2)) {
    if ((shape.distance(place) > 0) != of_opening) continue;
    ++inside;
    EXPECT_TRUE((place - extent.bounds.lower).minCoeff() >= -1e-12 &&
                (extent.bounds.upper - place).minCoeff() >= -1e-12)
        << place.transpose();
  }
  EXPECT_GT(inside, 3);
}

TEST(Extent, HoldsTheShape) {
  expect_bounds<2>(*hook(), false);
  expect_bounds<2>(Placed<2>(hook(), Pose<2>::at({0.1, -0.2}, 2)), false);
  expect_bounds<2>(Repeated<2>(std::make_unique<Placed<2>>(hook(), Pose<2>{{0.3, 0}}), 3), false);
  expect_bounds<2>(*vaned({.tip_radius = 0.5}), false);
  expect_bounds<2>(Rounded<2>(std::make_unique<Polygon>(Points<2>{{0, 0}, {0.5, 0.1}, {0.2, 0.6}}), 0.1), false);
  expect_bounds<2>(Inverted<2>(hook()), true);
  ShapeList<2> parts;
  parts.push_back(std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.5)));
  parts.push_back(hook());
  expect_bounds<2>(Union<2>(std::move(parts)), true);
  expect_bounds<2>(HalfSpace<2>({0, -1}), false);
  expect_bounds<2>(HalfSpace<2>({1, -1}), false);
  expect_bounds<3>(Capsule<3>({0.1, 0, -0.3}, {-0.2, 0.4, 0.3}, 0.1), false);
  expect_bounds<3>(Extruded(vaned({.tip_radius = 0.5}), 0.4), false);
  auto profile = std::make_unique<Polygon>(Points<2>{{0, -0.2}, {0.4, -0.2}, {0, 0.3}}, Polygon::Kind::profile);
  expect_bounds<3>(Revolved(std::move(profile)), false);
  expect_bounds<3>(*sampled_agitator(PETSC_COMM_WORLD, {}, 0.02, "agitator"), false);
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/combinations.hpp"

#include <numbers>

#include "support/surface.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/vaned.hpp"

namespace washfsi::test {
namespace {

/// Two circles of radius 0.5 about (-0.3, 0) and (0.3, 0).
ShapeList<2> two_circles() {
  ShapeList<2> parts;
  for (const double x : {-0.3, 0.3})
    parts.push_back(std::make_unique<Placed<2>>(std::make_unique<Sphere<2>>(0.5), Pose<2>::at({x, 0}, 0)));
  return parts;
}

bool in_left(const Point<2>& x) {
  return (x - Point<2>(-0.3, 0)).norm() < 0.5;
}
bool in_right(const Point<2>& x) {
  return (x - Point<2>(0.3, 0)).norm() < 0.5;
}

/// The parts of both circles' outlines that bound a combination.
Points<2> outline(const std::function<bool(const Point<2>&)>& of_left,
                  const std::function<bool(const Point<2>&)>& of_right) {
  Points<2> points;
  for (int k = 0; k < 4000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 4000;
    const Point<2> round = 0.5 * Point<2>(std::cos(angle), std::sin(angle));
    if (const Point<2> left = round - Point<2>(0.3, 0); of_left(left)) points.push_back(left);
    if (const Point<2> right = round + Point<2>(0.3, 0); of_right(right)) points.push_back(right);
  }
  return points;
}

/// Sign right everywhere, never beyond the true distance, and exact on one side (of sign `exact_side`).
void expect_bound(const Shape<2>& shape, const Points<2>& surface, const std::function<bool(const Point<2>&)>& inside,
                  int exact_side) {
  for (const auto& point : surface) ASSERT_NEAR(shape.distance(point), 0, 1e-14);
  for (const auto& place : random_points<2>(500, 11)) {
    double nearest = 10;
    for (const auto& point : surface) nearest = std::min(nearest, (point - place).norm());
    const double distance = shape.distance(place);
    EXPECT_EQ(distance < 0, inside(place));
    EXPECT_LE(std::abs(distance), nearest + 1e-12);
    if (distance * exact_side > 0) {
      EXPECT_NEAR(std::abs(distance), nearest, 1e-3);
    }
  }
}

TEST(Union, IsExactOutside) {
  expect_bound(
      Union<2>(two_circles()), outline(std::not_fn(in_right), std::not_fn(in_left)),
      [](const Point<2>& x) { return in_left(x) || in_right(x); }, 1);
}

TEST(Intersection, IsExactInside) {
  expect_bound(
      Intersection<2>(two_circles()), outline(in_right, in_left),
      [](const Point<2>& x) { return in_left(x) && in_right(x); }, -1);
}

TEST(Difference, IsTheFirstWithoutTheOthersAndExactInside) {
  expect_bound(
      *difference<2>(two_circles()), outline(std::not_fn(in_right), in_left),
      [](const Point<2>& x) { return in_left(x) && !in_right(x); }, -1);
}

TEST(Inverted, SwapsSolidAndFluid) {
  const Inverted<3> drum(std::make_unique<Sphere<3>>(2.0));
  EXPECT_DOUBLE_EQ(drum.distance({0, 0, 0.5}), 1.5);
  EXPECT_DOUBLE_EQ(drum.distance({3, 0, 0}), -1);
}

TEST(Rounded, ASegmentBoxIsACapsule) {
  const Rounded<2> rounded(std::make_unique<Cuboid<2>>(Point<2>(0.8, 1e-9)), 0.2);
  const Capsule<2> capsule({-0.4, 0}, {0.4, 0}, 0.2);
  for (const auto& place : random_points<2>(100, 5))
    EXPECT_NEAR(rounded.distance(place), capsule.distance(place), 1e-8);
}

TEST(Placed, TurnsThenMoves) {
  const double quarter = std::numbers::pi / 2;
  const Placed<3> upright(std::make_unique<Cuboid<3>>(Point<3>(2, 0.2, 0.4)), Pose<3>::at({1, 0, 3}, quarter));
  EXPECT_NEAR(upright.distance({1, 1, 3}), 0, 1e-15);  // the end of the long side
  EXPECT_NEAR(upright.distance({1.1, 0, 3}), 0, 1e-15);
  EXPECT_NEAR(upright.distance({1, 0, 4}), 0.8, 1e-15);
}

template <int Dim>
void expect_symmetry(int copies) {
  Point<Dim> arm = Point<Dim>::Zero();
  arm[0] = 0.5;
  auto box = std::make_unique<Cuboid<Dim>>(Point<Dim>(Point<Dim>::Constant(0.3)));
  const Repeated<Dim> repeated(std::make_unique<Placed<Dim>>(std::move(box), Pose<Dim>::at(arm, 0.2)), copies);
  const auto turn = Pose<Dim>::at(Point<Dim>::Zero(), 2 * std::numbers::pi / copies);
  for (const auto& place : random_points<Dim>(100, 9))
    EXPECT_NEAR(repeated.distance(place), repeated.distance(turn.in_body_frame(place)), 1e-14);
  EXPECT_LT(repeated.distance(arm), 0);
  EXPECT_GT(repeated.distance(Point<Dim>::Zero()), 0);
}

TEST(Repeated, IsSymmetricAboutZ) {
  expect_symmetry<2>(5);
  expect_symmetry<3>(4);
}

/// Two boxes and a ball less a half space: every kind of combination.
template <int Dim>
ShapePtr<Dim> tree() {
  Point<Dim> size = Point<Dim>::Constant(0.5);
  size[0] = 0.9;
  ShapeList<Dim> inner, outer;
  inner.push_back(std::make_unique<Rounded<Dim>>(std::make_unique<Cuboid<Dim>>(size), 0.05));
  inner.push_back(std::make_unique<Sphere<Dim>>(0.4));
  outer.push_back(std::make_unique<Union<Dim>>(std::move(inner)));
  outer.push_back(std::make_unique<Placed<Dim>>(std::make_unique<Cuboid<Dim>>(0.4 * size),
                                                Pose<Dim>::at(0.4 * Point<Dim>::Unit(0), 0)));
  outer.push_back(std::make_unique<HalfSpace<Dim>>(-Point<Dim>::Unit(0)));
  return difference<Dim>(std::move(outer));
}

template <int Dim>
void expect_slope_at_most_one_and_mirror_symmetry() {
  const auto shape = tree<Dim>();
  const auto places = random_points<Dim>(300, 17);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double distance = shape->distance(places[k]);
    EXPECT_LE(std::abs(distance - shape->distance(places[k - 1])), (places[k] - places[k - 1]).norm() + 1e-14);
    for (int d = 1; d < Dim; ++d) {
      Point<Dim> mirrored = places[k];
      mirrored[d] = -mirrored[d];
      EXPECT_EQ(shape->distance(mirrored), distance);
    }
  }
}

TEST(Combinations, HaveSlopesOfAtMostOneAndKeepTheSymmetryOfTheirParts) {
  expect_slope_at_most_one_and_mirror_symmetry<2>();
  expect_slope_at_most_one_and_mirror_symmetry<3>();
}

TEST(Vaned, DistanceOutsideIsThatToTheNearestPointOfTheSurface) {
  const auto agitator = vaned({.hub_radius = 0.07, .tip_radius = 0.19, .vane_thickness = 0.04, .vanes = 3});
  // the surface by brute force: points of hub and vanes whose distance is zero
  Points<2> surface;
  for (int k = 0; k < 3600; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3600;
    const Point<2> ray(std::cos(angle), std::sin(angle));
    double inside = 0, outside = 0.3;  // the shape is a star: one crossing on each ray
    for (int n = 0; n < 50; ++n) {
      const double middle = 0.5 * (inside + outside);
      (agitator->distance(middle * ray) < 0 ? inside : outside) = middle;
    }
    surface.push_back(inside * ray);
  }
  for (const auto& place : random_points<2>(200, 4, 0.3)) {
    const double distance = agitator->distance(place);
    if (distance <= 0) continue;
    double nearest = 1;
    for (const auto& point : surface) nearest = std::min(nearest, (point - place).norm());
    EXPECT_NEAR(distance, nearest, 5e-4);
  }
  EXPECT_NEAR(agitator->distance({0.19, 0}), 0, 1e-15);  // the first tip lies on x
  EXPECT_LT(agitator->distance({0.15 * std::cos(2.0944), 0.15 * std::sin(2.0944)}), 0);
}

}  // namespace
}  // namespace washfsi::test

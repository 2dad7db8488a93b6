// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/primitives.hpp"

#include <numbers>

#include "support/surface.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/sweeps.hpp"

namespace washfsi::test {
namespace {

constexpr double pi = std::numbers::pi;

Point<3> around(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Points of the surface that a curve (r, z) sweeps about z.
Points<3> turned(const Points<2>& profile, std::size_t angles) {
  Points<3> points;
  for (const auto& place : profile)
    for (std::size_t k = 0; k < angles; ++k)
      points.push_back(around(place[0], 2 * pi * static_cast<double>(k) / static_cast<double>(angles), place[1]));
  return points;
}

/// Points of a prism's sides and ends; the ends are those of a grid that are inside the outline.
Points<3> prism(const Points<2>& outline, double height, const std::function<bool(const Point<2>&)>& inside) {
  Points<3> points;
  for (const auto& place : outline)
    for (int k = 0; k <= 20; ++k) points.emplace_back(place[0], place[1], height * (k / 20.0 - 0.5));
  for (int i = -50; i <= 50; ++i)
    for (int j = -50; j <= 50; ++j)
      if (const Point<2> place(0.02 * i, 0.02 * j); inside(place))
        for (const double z : {-0.5 * height, 0.5 * height}) points.emplace_back(place[0], place[1], z);
  return points;
}

TEST(Sphere, DistanceIsExact) {
  const auto circle = along<2>(2000, [](double s) { return Point<2>(around(0.6, 2 * pi * s, 0).head<2>()); });
  expect_exact_distance<2>(Sphere<2>(0.6), circle, 2e-3, [](const Point<2>& x) { return x.norm() < 0.6; });
  const auto meridian =
      along<2>(200, [](double s) { return Point<2>(0.6 * std::sin(pi * s), 0.6 * std::cos(pi * s)); });
  expect_exact_distance<3>(Sphere<3>(0.6), turned(meridian, 400), 0.01,
                           [](const Point<3>& x) { return x.norm() < 0.6; });
}

TEST(Cuboid, DistanceIsExact) {
  const Points<2> outline = outline_of({{-0.5, -0.2}, {0.5, -0.2}, {0.5, 0.2}, {-0.5, 0.2}}, 500);
  const auto inside = [](const Point<2>& x) { return std::abs(x[0]) < 0.5 && std::abs(x[1]) < 0.2; };
  expect_exact_distance<2>(Cuboid<2>({1, 0.4}), outline, 2e-3, inside);
  const Points<2> coarse = outline_of({{-0.5, -0.2}, {0.5, -0.2}, {0.5, 0.2}, {-0.5, 0.2}}, 50);
  expect_exact_distance<3>(Cuboid<3>({1, 0.4, 0.6}), prism(coarse, 0.6, inside), 0.03,
                           [&](const Point<3>& x) { return inside(x.head<2>()) && std::abs(x[2]) < 0.3; });
}

TEST(HalfSpace, DistanceIsThatAlongTheNormal) {
  const HalfSpace<3> half({0, 3, 4});
  EXPECT_NEAR(half.distance({7, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(half.distance({7, 0.6, 0.8}), 1, 1e-15);
  EXPECT_NEAR(half.distance({7, -4, 3}), 0, 1e-15);
  EXPECT_NEAR(HalfSpace<2>({0, -2}).distance({5, 1}), -1, 1e-15);  // solid above
}

TEST(Capsule, DistanceIsExact) {
  constexpr double radius = 0.2, half = 0.4;
  Points<2> outline = along<2>(500, [=](double s) {
    return Point<2>(radius * std::sin(pi / 2 * s), half + radius * std::cos(pi / 2 * s));
  });  // a quarter circle and the upper half of the straight side
  for (const auto& place : along<2>(500, [=](double s) { return Point<2>(radius, half * s); }))
    outline.push_back(place);
  const std::size_t quarter = outline.size();
  for (std::size_t k = 0; k < quarter; ++k) outline.emplace_back(outline[k][0], -outline[k][1]);
  const std::size_t right = outline.size();
  for (std::size_t k = 0; k < right; ++k) outline.emplace_back(-outline[k][0], outline[k][1]);
  const auto inside = [](double r, double z) {
    return std::abs(z) < half ? std::abs(r) < radius : std::hypot(r, std::abs(z) - half) < radius;
  };
  expect_exact_distance<2>(Capsule<2>({0, -half}, {0, half}, radius), outline, 2e-3,
                           [&](const Point<2>& x) { return inside(x[0], x[1]); });
  Points<2> profile;
  for (std::size_t k = 0; k < right; k += 10) profile.push_back(outline[k]);
  expect_exact_distance<3>(Capsule<3>({0, 0, half}, {0, 0, -half}, radius), turned(profile, 100), 0.02,
                           [&](const Point<3>& x) { return inside(x.head<2>().norm(), x[2]); });
}

TEST(Capsule, OfNoLengthIsASphere) {
  EXPECT_NEAR(Capsule<3>({1, 1, 1}, {1, 1, 1}, 0.5).distance({1, 1, 3}), 1.5, 1e-15);
}

// An L with corners given clockwise: not convex.
const Points<2> ell{{-0.5, -0.5}, {-0.5, 0.6}, {-0.1, 0.6}, {-0.1, -0.1}, {0.7, -0.1}, {0.7, -0.5}};
bool inside_ell(const Point<2>& x) {
  return x[0] > -0.5 && x[1] > -0.5 && x[0] < 0.7 && x[1] < 0.6 && (x[0] < -0.1 || x[1] < -0.1);
}

TEST(Polygon, DistanceIsExactInEitherSenseOfRotation) {
  expect_exact_distance<2>(Polygon(ell), outline_of(ell, 500), 3e-3, inside_ell);
  const Points<2> reversed(ell.rbegin(), ell.rend());
  for (const auto& place : random_points<2>(100, 3))
    EXPECT_NEAR(Polygon(ell).distance(place), Polygon(reversed).distance(place), 1e-15);
}

TEST(Polygon, KnowsWhatIsNone) {
  EXPECT_EQ(Polygon::flaw(ell), "");
  EXPECT_EQ(Polygon::flaw({{0, 0}, {1, 0}, {0, 1}}), "");
  EXPECT_NE(Polygon::flaw({{0, 0}, {1, 0}}), "");
  EXPECT_NE(Polygon::flaw({{0, 0}, {0, 0}, {1, 0}, {0, 1}}), "");          // a corner twice
  EXPECT_NE(Polygon::flaw({{0, 0}, {1, 1}, {2, 2}}), "");                  // no area
  EXPECT_NE(Polygon::flaw({{0, 0}, {3, 0}, {0, 1}, {2, 2}}), "");          // crosses itself
  EXPECT_NE(Polygon::flaw({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), "");          // folds back
  EXPECT_NE(Polygon::flaw({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}), "");  // touches itself
  EXPECT_EQ(Polygon::flaw({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), "");  // a corner of 180 degrees is none
}

TEST(Extruded, CylinderAndPrismAreExact) {
  const auto circle = along<2>(300, [](double s) { return Point<2>(around(0.4, 2 * pi * s, 0).head<2>()); });
  const auto in_circle = [](const Point<2>& x) { return x.norm() < 0.4; };
  expect_exact_distance<3>(Extruded(std::make_unique<Sphere<2>>(0.4), 1), prism(circle, 1, in_circle), 0.04,
                           [&](const Point<3>& x) { return in_circle(x.head<2>()) && std::abs(x[2]) < 0.5; });
  expect_exact_distance<3>(Extruded(std::make_unique<Polygon>(ell), 0.8), prism(outline_of(ell, 40), 0.8, inside_ell),
                           0.04, [&](const Point<3>& x) { return inside_ell(x.head<2>()) && std::abs(x[2]) < 0.4; });
}

// A stepped shaft, whose profile has an edge on the axis.
TEST(Revolved, DistanceIsExactAlsoNearTheAxis) {
  const Points<2> profile{{0, -0.5}, {0.6, -0.5}, {0.6, 0}, {0.3, 0}, {0.3, 0.5}, {0, 0.5}};
  Points<2> surface;
  for (const auto& place : outline_of(profile, 40))
    if (place[0] > 0 || std::abs(place[1]) == 0.5) surface.push_back(place);
  const Revolved shaft(std::make_unique<Polygon>(profile, Polygon::Kind::profile));
  expect_exact_distance<3>(shaft, turned(surface, 200), 0.03, [](const Point<3>& x) {
    return std::abs(x[2]) < 0.5 && x.head<2>().norm() < (x[2] < 0 ? 0.6 : 0.3);
  });
  EXPECT_NEAR(shaft.distance({0, 0, 0.25}), -0.25, 1e-15);  // on the axis
}

TEST(Revolved, ARingLeavesItsHoleOpen) {
  const Points<2> square{{0.4, -0.1}, {0.6, -0.1}, {0.6, 0.1}, {0.4, 0.1}};
  const Revolved ring(std::make_unique<Polygon>(square, Polygon::Kind::profile));
  EXPECT_NEAR(ring.distance({0, 0, 0}), 0.4, 1e-15);
  EXPECT_NEAR(ring.distance({0, -0.5, 0}), -0.1, 1e-15);
}

}  // namespace
}  // namespace washfsi::test

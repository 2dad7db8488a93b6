// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/unit_grid.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/trust/body_survey.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi::test {
namespace {

TEST(Finding, IsJudgedByItsLimits) {
  const Limits limits{1, 3};
  EXPECT_EQ(at_most("", 1, limits, "", "").verdict, Verdict::ok);
  EXPECT_EQ(at_most("", 2, limits, "", "").verdict, Verdict::warn);
  EXPECT_EQ(at_most("", 4, limits, "", "").verdict, Verdict::fail);
  EXPECT_EQ(at_most("", 4, {1}, "", "").verdict, Verdict::warn);
  EXPECT_EQ(at_least("", 4, {3, 1}, "", "").verdict, Verdict::ok);
  EXPECT_EQ(at_least("", 2, {3, 1}, "", "").verdict, Verdict::warn);
  EXPECT_EQ(at_least("", 0, {3, 1}, "", "").verdict, Verdict::fail);
  EXPECT_EQ(at_most("", Finding::none, limits, "", "").verdict, Verdict::fail);
}

TEST(Finding, TellsLimitAndAdviceOnlyWhereItIsNotOk) {
  const Finding good = at_most("gap", 1, {2}, "1 m", "mend it"), bad = at_most("gap", 3, {2}, "3 m", "mend it");
  EXPECT_EQ(line_of(good), "  ok    gap                    1 m");
  EXPECT_EQ(line_of(bad), "  warn  gap                    3 m (limit 2): mend it");
  EXPECT_EQ(doubtful({good, bad}).size(), 1U);
}

template <int Dim>
Body<Dim> body(const std::string& name, ShapePtr<Dim> shape, const Point<Dim>& center) {
  Body<Dim> made{name, std::move(shape), {}};
  made.motion.center = center;
  return made;
}

TEST(BodySurvey, SeesTheSizeOfABall) {
  const Grid<3> grid = unit_grid<3>(40);
  std::vector<Body<3>> bodies;
  bodies.push_back(body<3>("ball", std::make_unique<Sphere<3>>(0.2), {0.507, 0.446, 0.391}));
  bodies[0].motion.angular_speed = 3;
  const BodySurvey<3> seen = survey_bodies<3>(grid, bodies, 0)[0];
  EXPECT_NEAR(seen.volume, 4 * std::numbers::pi / 3 * 0.008, 0.01 * 0.0335);
  EXPECT_NEAR(seen.upper[0], 0.707, 0.025);
  EXPECT_NEAR(seen.lower[2], 0.191, 0.025);
  EXPECT_NEAR(seen.reach, 0.2, 0.002);
  EXPECT_NEAR(seen.top_speed, 0.6, 0.006);
  EXPECT_GE(seen.thickness, 8);
}

// Wherever it lies in its cells, and however it is turned.
TEST(BodySurvey, SeesHowThinAPlateIs) {
  const Grid<3> grid = unit_grid<3>(32);
  for (const double shift : {0.0, 0.3, 0.5})
    for (const double turn : {0.0, 0.4}) {
      std::vector<Body<3>> bodies;
      bodies.push_back(
          body<3>("plate", std::make_unique<Cuboid<3>>(Point<3>(2.0 / 32, 0.6, 0.6)), {0.5 + shift / 32, 0.5, 0.5}));
      bodies[0].motion.angular_speed = turn;  // after a second
      EXPECT_NEAR(survey_bodies<3>(grid, bodies, 1)[0].thickness, 2, 0.25) << shift << " " << turn;
    }
}

// However it is turned; of thick parts nothing is said.
TEST(BodySurvey, SeesHowNarrowAPlateIs) {
  const Grid<3> grid = unit_grid<3>(32);
  for (const double shift : {0.0, 0.3, 0.5})
    for (const double turn : {0.0, 0.4}) {
      std::vector<Body<3>> bodies;
      bodies.push_back(body<3>("plate", std::make_unique<Cuboid<3>>(Point<3>(0.5, 6, 4) / 32),
                               {0.5 + shift / 32, 0.5, 0.5 + shift / 32}));
      bodies[0].motion.angular_speed = turn;  // after a second
      EXPECT_NEAR(survey_bodies<3>(grid, bodies, 1)[0].sheet_width, 4, 0.5) << shift << " " << turn;
      bodies[0].shape = std::make_unique<Cuboid<3>>(Point<3>(3, 6, 4) / 32);
      EXPECT_EQ(survey_bodies<3>(grid, bodies, 1)[0].sheet_width, 8);
    }
}

// A shell bends out of the plane that touches it, and has no edge.
TEST(BodySurvey, SeesThatAShellHasNoEdge) {
  const Grid<2> grid = unit_grid<2>(64);
  std::vector<Body<2>> bodies;
  std::vector<ShapePtr<2>> parts;
  parts.push_back(std::make_unique<Sphere<2>>(0.4));
  parts.push_back(std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.4 - 0.6 / 64)));
  bodies.push_back(body<2>("shell", std::make_unique<Intersection<2>>(std::move(parts)), {0.5, 0.5}));
  EXPECT_GT(survey_bodies<2>(grid, bodies, 0)[0].sheet_width, 6);
}

TEST(BodySurvey, CountsWhatBodiesShare) {
  const Grid<2> grid = unit_grid<2>(64);
  std::vector<Body<2>> bodies;
  bodies.push_back(body<2>("large", std::make_unique<Sphere<2>>(0.3), {0.5, 0.5}));
  bodies.push_back(body<2>("small", std::make_unique<Sphere<2>>(0.1), {0.5, 0.6}));
  bodies.push_back(body<2>("far", std::make_unique<Sphere<2>>(0.1), {5, 0.5}));
  const auto seen = survey_bodies<2>(grid, bodies, 0);
  EXPECT_EQ(seen[1].shared[0], seen[1].cells);
  EXPECT_EQ(seen[0].shared[1], seen[1].cells);
  EXPECT_EQ(seen[2].cells, 0);
  EXPECT_EQ(seen[0].shared[2], 0);
  EXPECT_NEAR(seen[2].nearest, 3.9, 0.02);
}

}  // namespace
}  // namespace washfsi::test

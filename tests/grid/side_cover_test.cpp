// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/side_cover.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

constexpr double reach = 0.1;

// 1 within a ball, 0 farther from it than `reach`.
template <int Dim>
double share_of_ball(double distance) {
  return std::clamp(1 - distance / reach, 0.0, 1.0);
}

// A half space beyond x = 0.8 at rest, and a ball that moves along the side.
template <int Dim>
typename SideCover<Dim>::Cover cover_at(double time) {
  const Point<Dim> speed = Point<Dim>::Unit(0);
  const auto to_ball = [=](const Point<Dim>& place) {
    return (place - (0.2 + time) * Point<Dim>::Unit(0) - 0.3 * Point<Dim>::Unit(Dim - 1)).norm() - 0.25;
  };
  const auto by_resting = [](const Point<Dim>& place, const Point<Dim>& own) -> Covered<Dim> {
    return {own, place[0] > 0.8 ? 1.0 : 0.0};
  };
  const auto by_all = [=](const Point<Dim>& place, const Point<Dim>& own) -> Covered<Dim> {
    Covered<Dim> resting = by_resting(place, own);
    const double share = share_of_ball<Dim>(to_ball(place));
    if (share <= resting.share) return resting;
    return {(1 - share) * own + share * speed, share};
  };
  return {by_all, by_resting, to_ball, reach};
}

// What is found where bodies move alone is what is found where all places are looked at.
template <int Dim>
void expect_as_looked_at_everywhere() {
  GridShape<Dim> shape;
  shape.cells.fill(13);
  const Grid<Dim> grid(PETSC_COMM_WORLD, shape);
  SideCover<Dim> found(grid, Dim - 1, End::lower, Point<Dim>::Zero());
  SideCover<Dim> everywhere(grid, Dim - 1, End::lower, Point<Dim>::Zero());
  for (const double time : {0.0, 0.1, 0.3, 0.3, 2.0}) {
    auto cover = cover_at<Dim>(time);
    found.set(time, cover);
    cover.to_moving = [](const Point<Dim>&) { return 0.0; };
    everywhere.set(time, cover);
    EXPECT_EQ(found.covers(), everywhere.covers());
    EXPECT_EQ(found.moves(), everywhere.moves());
    EXPECT_EQ(found.covers_all(), everywhere.covers_all());
    Box<Dim> plane = grid.local();
    plane.lower[Dim - 1] = 0;
    plane.upper[Dim - 1] = 1;
    for_each<Dim>(plane, [&](const Index<Dim>& face) {
      for (int c = 0; c < Dim; ++c) {
        ASSERT_EQ(found.shares(c, time)(face), everywhere.shares(c, time)(face));
        ASSERT_EQ(found.velocities(c, time)(face), everywhere.velocities(c, time)(face));
      }
    });
  }
}

TEST(SideCover, IsFoundWhereBodiesMoveAloneInThePlane) {
  expect_as_looked_at_everywhere<2>();
}
TEST(SideCover, IsFoundWhereBodiesMoveAloneInSpace) {
  expect_as_looked_at_everywhere<3>();
}

// Both moments are kept, and a side is covered wholly only if it is at both.
TEST(SideCover, KnowsWhenASideIsCoveredWholly) {
  GridShape<2> shape;
  shape.cells.fill(13);
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  SideCover<2> cover(grid, 1, End::lower, Point<2>::Zero());
  const auto by = [](double share) {
    return [share](const Point<2>&, const Point<2>& own) -> Covered<2> { return {own, share}; };
  };
  const auto set = [&](double time, double share) {
    cover.set(time, {by(share), by(0), [share](const Point<2>&) { return share > 0 ? -1e9 : 1e9; }, reach});
  };
  set(0, 1);
  EXPECT_TRUE(cover.covers_all());
  set(1, 0.5);
  EXPECT_FALSE(cover.covers_all());
  set(2, 1);
  EXPECT_FALSE(cover.covers_all());
  set(3, 1);
  EXPECT_TRUE(cover.covers_all());
}

}  // namespace
}  // namespace washfsi::test

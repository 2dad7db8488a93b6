// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/contact.hpp"

#include <gtest/gtest.h>

#include "washfsi/body/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

/// A box with walls from (-1, -1) to (4, 4) m.
struct Box2 {
  Grid<2> grid{PETSC_COMM_SELF, {.cells = {8, 8}, .lower = {-1, -1}, .upper = {4, 4}}};
  Boundary<2> boundary{grid, Boundary<2>::Sides{}};
};

TEST(Contact, PushesOutwardsWithinItsDistanceAndReactsOnTheBody) {
  std::vector<Body<2>> bodies(1);
  bodies[0].name = "roller";
  bodies[0].shape = std::make_unique<Sphere<2>>(0.1);
  bodies[0].motion.center = {1, 2};
  ClothGroup<2> group;
  group.name = "towel";
  group.markers = {3, 1};
  group.sheet.ds = 0.01;
  const Cloths<2> cloths(PETSC_COMM_SELF, {group});
  const ContactOptions contact{.pressure = 100, .distance = 0.02};
  const Points<2> places{{1.11, 2}, {1, 2.1}, {1.13, 2}};  // half way into the cushion, on the surface, outside
  const Box2 box;
  ContactLoads<2> reactions{Loads<2>(1), {}};

  const Points<2> forces = contact_forces<2>(contact, bodies, box.boundary, box.grid, cloths, places, 0, reactions);

  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], 100 * 0.01, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  EXPECT_LE((reactions.bodies[0].force + forces[0] + forces[1]).norm(), 1e-15);
  EXPECT_NEAR(reactions.bodies[0].torque[0], 0, 1e-9);  // all forces are radial
}

TEST(Contact, PushesAwayFromTheWallsOfTheBox) {
  ClothGroup<2> group;
  group.markers = {3, 1};
  group.sheet.ds = 0.01;
  const Box2 box;
  ContactLoads<2> reactions;
  const Points<2> places{{-0.99, 2}, {2, 3.995}, {2, 2}};
  const Points<2> forces = contact_forces<2>({.pressure = 100, .distance = 0.02}, {}, box.boundary, box.grid,
                                             Cloths<2>(PETSC_COMM_SELF, {group}), places, 0, reactions);
  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], -100 * 0.01 * 0.5625, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  EXPECT_EQ(reactions.sides[0][0].force, -forces[0]);
  EXPECT_EQ(reactions.sides[1][1].force, -forces[1]);
}

TEST(Contact, IsOffByDefault) {
  std::vector<Body<2>> bodies(1);
  bodies[0].shape = std::make_unique<Sphere<2>>(0.1);
  ClothGroup<2> group;
  group.markers = {2, 1};
  group.sheet.ds = 0.01;
  const Box2 box;
  ContactLoads<2> reactions{Loads<2>(1), {}};
  for (const auto& force : contact_forces<2>({}, bodies, box.boundary, box.grid, Cloths<2>(PETSC_COMM_SELF, {group}),
                                             {{0, 0}, {0.05, 0}}, 0, reactions))
    EXPECT_EQ(force.norm(), 0);
}

}  // namespace
}  // namespace washfsi::test

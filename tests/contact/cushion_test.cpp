// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/cushion.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/contact/barrier_options.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

constexpr double at_markers = 0.02,
                 softness = 0.1;  // where contact begins [m], and below which part of that it is soft
constexpr CushionOptions soft{.pressure = 100, .distance = 0.02};
constexpr CushionOptions hard{.pressure = 100, .distance = 0.02, .law = CushionLaw::barrier};
constexpr CushionOptions rough{.pressure = 100, .distance = 0.02, .law = CushionLaw::barrier, .friction = 0.4};

/// A box with walls from (-1, -1) to (4, 4) m, perhaps with a roller of radius 0.1 m at (1, 2), and a cloth in it.
struct Room {
  explicit Room(PetscInt markers, bool has_roller = true) : cloths(PETSC_COMM_SELF, {towel(markers)}) {
    if (!has_roller) return;
    bodies.resize(1);
    bodies[0].name = "roller";
    bodies[0].shape = std::make_unique<Sphere<2>>(0.1);
    bodies[0].motion.center = {1, 2};
  }
  static ClothGroup<2> towel(PetscInt markers) {
    ClothGroup<2> group;
    group.name = "towel";
    group.markers = {markers, 1};
    group.sheet.ds = 0.01;
    return group;
  }
  /// A cushion that has looked round at these places; the markers will move for dt.
  std::unique_ptr<Cushion<2>> cushion(const Points<2>& places, double dt = 0,
                                      const CushionOptions& options = soft) const {
    auto result = std::make_unique<Cushion<2>>(options, Surroundings<2>{grid, boundary, bodies, cloths});
    const Points<2> at_rest(places.size(), Point<2>::Zero()), far_off(places.size(), Point<2>(2.5, 3));
    result->begin_step({far_off, at_rest, 0, 0});  // what starts in contact would have a distance of its own
    result->begin_step({places, at_rest, 0, dt});
    return result;
  }

  Grid<2> grid{PETSC_COMM_SELF, {.cells = {8, 8}, .lower = {-1, -1}, .upper = {4, 4}}};
  Boundary<2> boundary{grid, Boundary<2>::Sides{}};
  std::vector<Body<2>> bodies;
  Cloths<2> cloths;
};

Points<2> forces_of(const Cushion<2>& cushion, const Points<2>& places) {
  Points<2> forces(places.size(), Point<2>::Zero());
  cushion.add_force(places, {}, forces);
  return forces;
}

TEST(Cushion, PushesOutwardsWithinItsDistanceAndReactsOnTheBody) {
  const Room room(3);
  const Points<2> places{{1.11, 2}, {1, 2.1}, {1.13, 2}};  // half way into the cushion, on the surface, outside
  const auto cushion = room.cushion(places);
  const Points<2> forces = forces_of(*cushion, places);
  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], 100 * 0.01, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  ContactLoads<2> reactions{Loads<2>(1), {}};
  cushion->add_reactions(places, reactions);
  EXPECT_LE((reactions.bodies[0].force + forces[0] + forces[1]).norm(), 1e-15);
  EXPECT_NEAR(reactions.bodies[0].torque[0], 0, 1e-9);  // all forces are radial
}

// Nearer than a cell the water beside a wall would hold the cloth; markers here are 0.01 m apart.
TEST(Cushion, OfTheBarrierBeginsFartherOffThanThatBetweenCloths) {
  const Room room(1);
  const auto pushes = [&](double gap, double body_distance, bool in_water = false) {
    const Surroundings<2> around{room.grid, room.boundary, room.bodies, room.cloths};
    const auto force = barrier_of_bodies<2>({.distance = 0.001, .body_distance = body_distance}, in_water)(around);
    const Points<2> places{{1.1 + gap, 2}}, at_rest{Point<2>::Zero()}, far_off{{2, 3}};
    force->begin_step({far_off, at_rest, 0, 0});
    force->begin_step({places, at_rest, 0, 0});
    Points<2> forces{Point<2>::Zero()};
    force->add_force(places, at_rest, forces);
    return forces[0][0] > 0;
  };
  EXPECT_TRUE(pushes(0.0039, 0));
  EXPECT_FALSE(pushes(0.0041, 0));
  EXPECT_TRUE(pushes(0.0059, 0.006));
  EXPECT_FALSE(pushes(0.0061, 0.006));
  const double cell = room.grid.spacing().minCoeff();
  EXPECT_TRUE(pushes(0.99 * cell, 0, true));
  EXPECT_FALSE(pushes(1.01 * cell, 0, true));
  EXPECT_FALSE(pushes(0.0061, 0.006, true));
}

// Then no mobilities are found either.
TEST(Cushion, WithoutFrictionLeavesExplicitStepsAlone) {
  const Room room(1);
  CushionOptions damped = hard;
  damped.damping = 1;
  const Points<2> places{{1.11, 2}}, nearer{Point<2>(-1, 0)};
  Cushion<2> cushion(damped, Surroundings<2>{room.grid, room.boundary, room.bodies, room.cloths});
  cushion.begin_step({{{2.5, 3}}, nearer, 0, 0});
  cushion.begin_step({places, nearer, 0, 0, {}, ExplicitStep{1e-3, {}}});
  const Points<2> forces = forces_of(cushion, places);
  EXPECT_EQ(forces, forces_of(*room.cushion(places, 0, hard), places));
}

TEST(Cushion, PushesAwayFromTheWallsOfTheBox) {
  const Room room(3, false);
  const Points<2> places{{-0.99, 2}, {2, 3.995}, {2, 2}};
  const auto cushion = room.cushion(places);
  const Points<2> forces = forces_of(*cushion, places);
  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], -100 * 0.01 * 0.5625, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  ContactLoads<2> reactions;
  cushion->add_reactions(places, reactions);
  EXPECT_EQ(reactions.sides[0][0].force, -forces[0]);
  EXPECT_EQ(reactions.sides[1][1].force, -forces[1]);
}

TEST(Cushion, IsNotThereByDefault) {
  const Room room(2);
  EXPECT_EQ(Cushion<2>::maker({})({room.grid, room.boundary, room.bodies, room.cloths}), nullptr);
}

/// Markers round a roller and at a wall, moved a little since the cushion looked round.
struct Touching {
  Room room{40};
  Points<2> start, places;
  Touching() {
    const Points<2> shifts = random_points<2>(40, 3, 0.01), moves = random_points<2>(40, 4, 0.004);
    for (std::size_t m = 0; m < 40; ++m) {
      const double angle = 0.2 * static_cast<double>(m);
      const Point<2> foot = m < 32 ? Point<2>(1 + 0.11 * std::cos(angle), 2 + 0.11 * std::sin(angle))
                                   : Point<2>(-0.985, 0.1 * static_cast<double>(m) - 2);
      start.push_back(foot + shifts[m]);
      places.push_back(start.back() + moves[m]);
    }
  }
};

double energy_of(const Cushion<2>& cushion, const Points<2>& places) {
  std::vector<double> energy(1, 0.0);
  cushion.add_energy(places, energy);
  return energy[0];
}

TEST(Cushion, ForceIsMinusTheGradientOfItsEnergy) {
  const Touching touching;
  for (const CushionOptions& options : {soft, hard, rough}) {
    const auto cushion = touching.room.cushion(touching.start, 1, options);
    const Points<2> forces = forces_of(*cushion, touching.places), direction = random_points<2>(40, 5);
    double slope = 0;
    for (std::size_t m = 0; m < 40; ++m) slope -= forces[m].dot(direction[m]);
    constexpr double e = 1e-6;
    const double difference =
        energy_of(*cushion, touching.places + e * direction) - energy_of(*cushion, touching.places - e * direction);
    EXPECT_GT(energy_of(*cushion, touching.places), 1e-3);
    EXPECT_NEAR(difference / (2 * e), slope, 1e-7 * std::abs(slope));
  }
}

TEST(Cushion, StiffnessIsItsJacobianAndNeverNegative) {
  const Touching touching;
  for (const CushionOptions& options : {soft, hard}) {
    const auto cushion = touching.room.cushion(touching.start, 1, options);
    const Points<2> direction = random_points<2>(40, 6);
    constexpr double e = 1e-7;
    const Points<2> more = forces_of(*cushion, touching.places + e * direction),
                    less = forces_of(*cushion, touching.places - e * direction);
    Points<2> rates(40, Point<2>::Zero()), products(40, Point<2>::Zero());
    cushion->add_force_rates(touching.places, direction, rates);
    cushion->visit_stiffness(
        touching.places, GeometricStiffness::all, [&](PetscInt row, PetscInt column, const StiffnessBlock<2>& block) {
          if (row == column) {
            EXPECT_GE(block.trace(), 0);
          }
          products[static_cast<std::size_t>(row)] -= block * direction[static_cast<std::size_t>(column)];
        });
    for (std::size_t m = 0; m < 40; ++m) {
      EXPECT_LE((rates[m] - products[m]).norm(), 1e-12);
      EXPECT_LE((rates[m] - (more[m] - less[m]) / (2 * e)).norm(), 1e-4);
    }
  }
}

// As hard as it is at a tenth of its distance, where a body has moved over a marker.
TEST(Cushion, OfTheBarrierGoesOnWithinABody) {
  double before = cushion_push(hard, -0.05, at_markers, softness).pressure;
  for (double distance = -0.05; distance < 0.021; distance += 1e-5) {
    const CushionPush push = cushion_push(hard, distance, at_markers, softness);
    EXPECT_TRUE(std::isfinite(push.energy));
    EXPECT_LE(push.pressure, before);
    EXPECT_LE(before - push.pressure, 1.01e-5 * cushion_push(hard, 0, at_markers, softness).stiffness);
    before = push.pressure;
  }
  EXPECT_EQ(before, 0);
}

// A body runs over a marker that is pressed against it with more than the soft part bears.
TEST(Cushion, IsSharpenedUntilTheSolutionLiesOutside) {
  Room room(1);
  room.bodies[0].motion.translation = {0.03, 0};
  const auto cushion = room.cushion({{1.085, 2}}, 1, hard);
  const double surface = 1 + 0.1, load = 50 * 100 * 0.01;
  const auto solution = [&] {
    double inside = surface - 0.05, outside = surface + 0.02;
    while (outside - inside > 1e-9) {
      const double middle = 0.5 * (inside + outside);
      (forces_of(*cushion, {{middle, 2}})[0][0] > load ? inside : outside) = middle;
    }
    return outside;
  };
  EXPECT_LT(solution(), surface);
  int times = 0;
  while (cushion->sharpen({{solution(), 2}})) ASSERT_LT(++times, 5);
  EXPECT_GE(times, 1);
  EXPECT_NEAR(cushion_push(hard, solution() - surface, at_markers).pressure * 0.01, load, 0.02 * load);
  EXPECT_FALSE(cushion->sharpen({{surface + 0.01, 2}}));
}

// A face that rests on the left edge of a block turns about it, down on the right one.
TEST(Cushion, SeesWhereAFaceTurnsTo) {
  Room room(2);
  room.bodies[0].shape = std::make_unique<Cuboid<2>>(Point<2>(0.2, 0.2));
  const auto sloped = [](double left, double right) {  // above the edges of the block, which are 0.2 m apart
    return Points<2>{{0.7, 2.1 + 2 * left - right}, {1.3, 2.1 + 2 * right - left}};
  };
  const auto cushion = room.cushion(sloped(0.006, 0.009), 1, hard);
  const Points<2> turned = sloped(0.006, 1e-4);
  EXPECT_FALSE(cushion->sharpen(sloped(0.006, 0.006)));
  const double before = forces_of(*cushion, turned)[1][1];
  EXPECT_TRUE(cushion->sharpen(turned));
  EXPECT_GT(forces_of(*cushion, turned)[1][1], 2 * before);
}

// A marker on the turning roller, which goes along it by some way in a step of 1 s more than the surface does.
TEST(Cushion, FrictionIsThatOfCoulombOnAMovingBody) {
  constexpr double turn = 0.02;  // [rad/s]
  Room room(1);
  room.bodies[0].motion.angular_speed = turn;
  const Points<2> start{{1.11, 2}};
  const double pressed = 0.01 * cushion_push(rough, 0.01, at_markers, softness).pressure;
  for (const double slide : {-5e-3, -2e-4, 0.0, 2e-4, 5e-3}) {
    const auto smooth = room.cushion(start, 1, hard), cushion = room.cushion(start, 1, rough);
    const Points<2> end{start[0] + Point<2>(0, 0.11 * turn + slide)};
    cushion->linearise(end);
    const Point<2> pull = forces_of(*cushion, end)[0] - forces_of(*smooth, end)[0];
    const double part = std::min(1.0, std::abs(slide) / 1e-3), share = std::copysign(part * (2 - part), slide);
    EXPECT_NEAR(pull[1], -0.4 * pressed * share, 1e-9 * pressed);
    EXPECT_NEAR(pull[0], 0, 1e-9 * pressed);
    MarkerContact contact(1);
    cushion->add_marker_contact(end, contact);
    EXPECT_NEAR(contact.friction_power[0], -pull[1] * slide, 1e-9 * pressed);
    EXPECT_EQ(contact.area[0], 0.01);
    ContactLoads<2> loads{Loads<2>(1), {}};
    cushion->add_reactions(end, loads);
    EXPECT_LE((loads.bodies[0].force + forces_of(*cushion, end)[0]).norm(), 1e-12);
  }
}

// It slides over a side that moves along itself only as far as it goes another way.
TEST(Cushion, FrictionOnASideIsOverTheWayOfThatSide) {
  Sides<2> sides;
  sides[1][0].velocity = {0.3, 0};
  const Room room(1, false);
  const Boundary<2> boundary(room.grid, sides);
  Cushion<2> cushion(rough, {room.grid, boundary, room.bodies, room.cloths});
  const Points<2> start{{1, -0.99}}, at_rest{Point<2>::Zero()}, with_it{{1.03, -0.99}}, far_off{{1, 0}};
  cushion.begin_step({far_off, at_rest, 0, 0});
  cushion.begin_step({start, at_rest, 0, 0.1});
  EXPECT_NEAR(forces_of(cushion, with_it)[0][0], 0, 1e-12);
  EXPECT_NEAR(forces_of(cushion, start)[0][0], 0.4 * 0.01 * cushion_push(rough, 0.01, at_markers, softness).pressure,
              1e-12);
}

// What a marker is pushed with does not depend on where in the step the surface was looked at, but for its curvature.
TEST(Cushion, SeesASurfaceThatTheMarkerComesNearToInTheStep) {
  const Room room(1);
  const Points<2> start{{1.13, 2}}, end{{1.105, 2}};  // from outside into the cushion
  EXPECT_EQ(forces_of(*room.cushion(start, 1), start)[0].norm(), 0);
  const Point<2> seen_from_start = forces_of(*room.cushion(start, 1), end)[0];
  const Point<2> seen_at_end = forces_of(*room.cushion(end), end)[0];
  EXPECT_LE((seen_from_start - seen_at_end).norm(), 1e-6 * seen_at_end.norm());
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/body_contact.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/contact/barrier_options.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

constexpr double at_markers = 0.02,
                 softness = 0.1;  // where contact begins [m], and below which part of that it is soft
constexpr BodyContactOptions soft{.pressure = 100, .distance = 0.02};
constexpr BodyContactOptions hard{.pressure = 100, .distance = 0.02, .law = BodyContactLaw::barrier};
constexpr BodyContactOptions rough{.pressure = 100, .distance = 0.02, .law = BodyContactLaw::barrier, .friction = 0.4};

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
  /// The contact force that has looked round at these places; the markers will move for dt.
  std::unique_ptr<BodyContact<2>> contact_force(const Points<2>& places, double dt = 0,
                                                const BodyContactOptions& options = soft) const {
    auto result = std::make_unique<BodyContact<2>>(options, Surroundings<2>{grid, boundary, bodies, cloths});
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

Points<2> forces_of(const BodyContact<2>& contact_force, const Points<2>& places) {
  Points<2> forces(places.size(), Point<2>::Zero());
  contact_force.add_force(places, {}, forces);
  return forces;
}

TEST(BodyContact, PushesOutwardsWithinItsDistanceAndReactsOnTheBody) {
  const Room room(3);
  const Points<2> places{
      {1.11, 2}, {1, 2.1}, {1.13, 2}};  // half way into the contact distance, on the surface, outside
  const auto contact_force = room.contact_force(places);
  const Points<2> forces = forces_of(*contact_force, places);
  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], 100 * 0.01, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  ContactLoads<2> reactions{Loads<2>(1), {}};
  contact_force->add_reactions(places, reactions);
  EXPECT_LE((reactions.bodies[0].force + forces[0] + forces[1]).norm(), 1e-15);
  EXPECT_NEAR(reactions.bodies[0].torque[0], 0, 1e-9);  // all forces are radial
}

// Nearer than a cell the water beside a wall would hold the cloth; markers here are 0.01 m apart.
TEST(BodyContact, OfTheBarrierBeginsFartherOffThanThatBetweenCloths) {
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
TEST(BodyContact, WithoutFrictionLeavesExplicitStepsAlone) {
  const Room room(1);
  BodyContactOptions damped = hard;
  damped.damping = 1;
  const Points<2> places{{1.11, 2}}, nearer{Point<2>(-1, 0)};
  BodyContact<2> contact_force(damped, Surroundings<2>{room.grid, room.boundary, room.bodies, room.cloths});
  contact_force.begin_step({{{2.5, 3}}, nearer, 0, 0});
  contact_force.begin_step({places, nearer, 0, 0, {}, ExplicitStep{1e-3, {}}});
  const Points<2> forces = forces_of(contact_force, places);
  EXPECT_EQ(forces, forces_of(*room.contact_force(places, 0, hard), places));
}

TEST(BodyContact, PushesAwayFromTheWallsOfTheBox) {
  const Room room(3, false);
  const Points<2> places{{-0.99, 2}, {2, 3.995}, {2, 2}};
  const auto contact_force = room.contact_force(places);
  const Points<2> forces = forces_of(*contact_force, places);
  EXPECT_NEAR(forces[0][0], 100 * 0.01 * 0.25, 1e-9);
  EXPECT_NEAR(forces[1][1], -100 * 0.01 * 0.5625, 1e-9);
  EXPECT_EQ(forces[2].norm(), 0);
  ContactLoads<2> reactions;
  contact_force->add_reactions(places, reactions);
  EXPECT_EQ(reactions.sides[0][0].force, -forces[0]);
  EXPECT_EQ(reactions.sides[1][1].force, -forces[1]);
}

TEST(BodyContact, IsNotThereByDefault) {
  const Room room(2);
  EXPECT_EQ(BodyContact<2>::maker({})({room.grid, room.boundary, room.bodies, room.cloths}), nullptr);
}

/// Markers round a roller and at a wall, moved a little since the force looked round.
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

double energy_of(const BodyContact<2>& contact_force, const Points<2>& places) {
  std::vector<double> energy(1, 0.0);
  contact_force.add_energy(places, energy);
  return energy[0];
}

TEST(BodyContact, ForceIsMinusTheGradientOfItsEnergy) {
  const Touching touching;
  for (const BodyContactOptions& options : {soft, hard, rough}) {
    const auto contact_force = touching.room.contact_force(touching.start, 1, options);
    const Points<2> forces = forces_of(*contact_force, touching.places), direction = random_points<2>(40, 5);
    double slope = 0;
    for (std::size_t m = 0; m < 40; ++m) slope -= forces[m].dot(direction[m]);
    constexpr double e = 1e-6;
    const double difference = energy_of(*contact_force, touching.places + e * direction) -
                              energy_of(*contact_force, touching.places - e * direction);
    EXPECT_GT(energy_of(*contact_force, touching.places), 1e-3);
    EXPECT_NEAR(difference / (2 * e), slope, 1e-7 * std::abs(slope));
  }
}

TEST(BodyContact, StiffnessIsItsJacobianAndNeverNegative) {
  const Touching touching;
  for (const BodyContactOptions& options : {soft, hard}) {
    const auto contact_force = touching.room.contact_force(touching.start, 1, options);
    const Points<2> direction = random_points<2>(40, 6);
    constexpr double e = 1e-7;
    const Points<2> more = forces_of(*contact_force, touching.places + e * direction),
                    less = forces_of(*contact_force, touching.places - e * direction);
    Points<2> rates(40, Point<2>::Zero()), products(40, Point<2>::Zero());
    contact_force->add_force_rates(touching.places, direction, rates);
    contact_force->visit_stiffness(
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
TEST(BodyContact, OfTheBarrierGoesOnWithinABody) {
  double before = body_push(hard, -0.05, at_markers, softness).pressure;
  for (double distance = -0.05; distance < 0.021; distance += 1e-5) {
    const BodyPush push = body_push(hard, distance, at_markers, softness);
    EXPECT_TRUE(std::isfinite(push.energy));
    EXPECT_LE(push.pressure, before);
    EXPECT_LE(before - push.pressure, 1.01e-5 * body_push(hard, 0, at_markers, softness).stiffness);
    before = push.pressure;
  }
  EXPECT_EQ(before, 0);
}

// A body runs over a marker that is pressed against it with more than the soft part bears.
TEST(BodyContact, IsSharpenedUntilTheSolutionLiesOutside) {
  Room room(1);
  room.bodies[0].motion.translation = {0.03, 0};
  const auto contact_force = room.contact_force({{1.085, 2}}, 1, hard);
  const double surface = 1 + 0.1, load = 50 * 100 * 0.01;
  const auto solution = [&] {
    double inside = surface - 0.05, outside = surface + 0.02;
    while (outside - inside > 1e-9) {
      const double middle = 0.5 * (inside + outside);
      (forces_of(*contact_force, {{middle, 2}})[0][0] > load ? inside : outside) = middle;
    }
    return outside;
  };
  EXPECT_LT(solution(), surface);
  int times = 0;
  while (contact_force->sharpen({{solution(), 2}})) ASSERT_LT(++times, 5);
  EXPECT_GE(times, 1);
  EXPECT_NEAR(body_push(hard, solution() - surface, at_markers).pressure * 0.01, load, 0.02 * load);
  EXPECT_FALSE(contact_force->sharpen({{surface + 0.01, 2}}));
}

// A face that rests on the left edge of a block turns about it, down on the right one.
TEST(BodyContact, SeesWhereAFaceTurnsTo) {
  Room room(2);
  room.bodies[0].shape = std::make_unique<Cuboid<2>>(Point<2>(0.2, 0.2));
  const auto sloped = [](double left, double right) {  // above the edges of the block, which are 0.2 m apart
    return Points<2>{{0.7, 2.1 + 2 * left - right}, {1.3, 2.1 + 2 * right - left}};
  };
  const auto contact_force = room.contact_force(sloped(0.006, 0.009), 1, hard);
  const Points<2> turned = sloped(0.006, 1e-4);
  EXPECT_FALSE(contact_force->sharpen(sloped(0.006, 0.006)));
  const double before = forces_of(*contact_force, turned)[1][1];
  EXPECT_TRUE(contact_force->sharpen(turned));
  EXPECT_GT(forces_of(*contact_force, turned)[1][1], 2 * before);
}

// A marker on the turning roller, which goes along it by some way in a step of 1 s more than the surface does.
TEST(BodyContact, FrictionIsThatOfCoulombOnAMovingBody) {
  constexpr double turn = 0.02;  // [rad/s]
  Room room(1);
  room.bodies[0].motion.angular_speed = turn;
  const Points<2> start{{1.11, 2}};
  const double pressed = 0.01 * body_push(rough, 0.01, at_markers, softness).pressure;
  for (const double slide : {-5e-3, -2e-4, 0.0, 2e-4, 5e-3}) {
    const auto smooth = room.contact_force(start, 1, hard), contact_force = room.contact_force(start, 1, rough);
    const Points<2> end{start[0] + Point<2>(0, 0.11 * turn + slide)};
    contact_force->linearise(end);
    const Point<2> pull = forces_of(*contact_force, end)[0] - forces_of(*smooth, end)[0];
    const double part = std::min(1.0, std::abs(slide) / 1e-3), share = std::copysign(part * (2 - part), slide);
    EXPECT_NEAR(pull[1], -0.4 * pressed * share, 1e-9 * pressed);
    EXPECT_NEAR(pull[0], 0, 1e-9 * pressed);
    MarkerContact contact(1);
    contact_force->add_marker_contact(end, contact);
    EXPECT_NEAR(contact.friction_power[0], -pull[1] * slide, 1e-9 * pressed);
    EXPECT_EQ(contact.area[0], 0.01);
    ContactLoads<2> loads{Loads<2>(1), {}};
    contact_force->add_reactions(end, loads);
    EXPECT_LE((loads.bodies[0].force + forces_of(*contact_force, end)[0]).norm(), 1e-12);
  }
}

// It slides over a side that moves along itself only as far as it goes another way.
TEST(BodyContact, FrictionOnASideIsOverTheWayOfThatSide) {
  Sides<2> sides;
  sides[1][0].velocity = {0.3, 0};
  const Room room(1, false);
  const Boundary<2> boundary(room.grid, sides);
  BodyContact<2> contact_force(rough, {room.grid, boundary, room.bodies, room.cloths});
  const Points<2> start{{1, -0.99}}, at_rest{Point<2>::Zero()}, with_it{{1.03, -0.99}}, far_off{{1, 0}};
  contact_force.begin_step({far_off, at_rest, 0, 0});
  contact_force.begin_step({start, at_rest, 0, 0.1});
  EXPECT_NEAR(forces_of(contact_force, with_it)[0][0], 0, 1e-12);
  EXPECT_NEAR(forces_of(contact_force, start)[0][0], 0.4 * 0.01 * body_push(rough, 0.01, at_markers, softness).pressure,
              1e-12);
}

// What a marker is pushed with does not depend on where in the step the surface was looked at, but for its curvature.
TEST(BodyContact, SeesASurfaceThatTheMarkerComesNearToInTheStep) {
  const Room room(1);
  const Points<2> start{{1.13, 2}}, end{{1.105, 2}};  // from outside into the contact distance
  EXPECT_EQ(forces_of(*room.contact_force(start, 1), start)[0].norm(), 0);
  const Point<2> seen_from_start = forces_of(*room.contact_force(start, 1), end)[0];
  const Point<2> seen_at_end = forces_of(*room.contact_force(end), end)[0];
  EXPECT_LE((seen_from_start - seen_at_end).norm(), 1e-6 * seen_at_end.norm());
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include <gtest/gtest.h>

#include "support/water.hpp"
#include "washfsi/mask/mask_loads.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/vaned.hpp"

namespace washfsi::test {
namespace {

constexpr double inner = 0.25, outer = 0.8;

std::vector<Body<2>> cylinders(double inner_speed, double frequency) {
  std::vector<Body<2>> bodies(2);
  bodies[0].name = "drum";
  bodies[0].shape = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(outer));
  bodies[1].name = "roller";
  bodies[1].shape = std::make_unique<Sphere<2>>(inner);
  bodies[1].motion.angular_speed = inner_speed;
  bodies[1].motion.frequency = frequency;
  return bodies;
}

/// Water between two cylinders on a square grid of n x n cells.
struct Couette {
  explicit Couette(PetscInt n, double speed, double frequency, double viscosity)
      : bodies(cylinders(speed, frequency)),
        grid(PETSC_COMM_WORLD, shape(n)),
        boundary(grid, {}),
        water(grid, boundary, liquid(viscosity)),
        mask(grid, bodies, {.method = BodyMethod::mapping}) {}
  static GridShape<2> shape(PetscInt n) {
    GridShape<2> shape;
    shape.cells = {n, n};
    shape.lower = {-1, -1};
    return shape;
  }
  static FluidOptions<2> liquid(double viscosity) {
    FluidOptions<2> options;
    options.density = 1;
    options.viscosity = viscosity;
    return options;
  }
  std::vector<Load<2>> step(double dt) {
    mask.update(water.clock.time + dt);
    water.advance(dt, mask.constraint());
    return constraint_loads(mask, water.fluid.constraint_force(), water.liquid.density(),
                            water.fluid.projection().pressure(), water.clock.time);
  }

  std::vector<Body<2>> bodies;
  Grid<2> grid;
  Boundary<2> boundary;
  Water<2> water;
  Mask<2> mask;
};

TEST(Loads, SteadyCouetteTorqueApproachesTheory) {
  constexpr double viscosity = 0.5, ri2 = inner * inner, ro2 = outer * outer;
  constexpr double torque = 4 * std::numbers::pi * viscosity * ri2 * ro2 / (ro2 - ri2);  // of the drum on the water
  std::array<double, 2> error{};
  for (std::size_t level = 0; level < 2; ++level) {
    Couette couette(32 << level, 1.0, 0, viscosity);
    std::vector<Load<2>> loads;
    for (int n = 0; n < 300; ++n) loads = couette.step(0.01);  // several diffusion times of the gap
    error[level] = std::abs(loads[1].torque[0] + torque) / torque;
    EXPECT_NEAR(loads[0].torque[0] + loads[1].torque[0], 0, 1e-6 * torque);
    EXPECT_LT(loads[0].force.norm() + loads[1].force.norm(), 1e-3 * torque);
  }
  EXPECT_LT(error[0], 0.2);  // the sharp mask is a staircase: first order
  EXPECT_LT(error[1], 0.65 * error[0]);
}

// dL/dt of the water between the cylinders = -(sum of the torques on the bodies), also while the roller oscillates.
TEST(Loads, BalanceTheAngularMomentumOfTheWater) {
  Couette couette(40, 2.0, 1.0, 0.05);
  const auto momentum = [&] {
    const petsc::Vector held = petsc::zeros_like(couette.water.fluid.velocity());
    WASH_PETSC(VecCopy(couette.water.fluid.velocity(), held));
    const ConstFaceView<2> u(couette.grid.face_dm(), held),
        fraction(couette.grid.face_dm(), couette.mask.fluid_fraction());
    double sum = 0;
    for (int c = 0; c < 2; ++c)
      for_each<2>(couette.grid.inner_faces(c), [&](const Index<2>& face) {
        const Point<2> place = couette.grid.face_center(face, c);
        const double arm = c == 0 ? -place[1] : place[0];
        sum += fraction(face, c) * arm * u(face, c) * couette.grid.cell_volume();
      });
    return ordered_sum(couette.grid.comm(), sum);
  };
  const double before = momentum();
  double impulse = 0, size = 0;
  constexpr double dt = 0.005;
  for (int n = 0; n < 60; ++n) {
    const auto loads = couette.step(dt);
    impulse += dt * (loads[0].torque[0] + loads[1].torque[0]);
    size += dt * std::abs(loads[1].torque[0]);
  }
  EXPECT_NEAR(momentum() - before, -impulse, 0.015 * size);
}

TEST(Mask, HoldsTheSolidVelocity) {
  Couette couette(32, 3.0, 0, 0.1);
  (void)couette.step(0.01);
  const petsc::Vector held = petsc::zeros_like(couette.water.fluid.velocity());
  WASH_PETSC(VecCopy(couette.water.fluid.velocity(), held));
  couette.mask.apply(held);
  const ConstFaceView<2> u(couette.grid.face_dm(), held);
  for_each<2>(couette.grid.owned(), [&](const Index<2>& face) {
    const Point<2> place = couette.grid.face_center(face, 0);
    const bool turning = place.norm() < inner;
    if (turning || place.norm() > outer) {
      EXPECT_NEAR(u(face, 0), turning ? -3 * place[1] : 0.0, 1e-13);
    }
  });
}

/// A turning body with vanes and a ball, named in this order, in a drum at rest; both reach into the drum.
std::vector<Body<2>> crowd() {
  std::vector<Body<2>> bodies(3);
  bodies[0].shape = vaned({0.2, 0.7, 0.1, 3});
  bodies[0].motion.angular_speed = 2;
  bodies[1].shape = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.6));
  bodies[2].shape = std::make_unique<Sphere<2>>(0.25);
  bodies[2].motion.center = {0.4, 0.1};
  bodies[2].motion.angular_speed = -1;
  return bodies;
}

// Placing bodies part by part skips no face, also where bodies overlap: the one named first holds.
TEST(Mask, EqualsADirectSearchOverAllFaces) {
  GridShape<2> shape;
  shape.cells = {45, 38};
  shape.lower = {-0.8, -0.7};
  shape.upper = {0.8, 0.7};
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  const auto bodies = crowd();
  Mask<2> mask(grid, bodies, {.method = BodyMethod::mapping});
  for (const double time : {0.0, 0.3, 1.1}) {
    mask.update(time);
    const ConstFaceView<2> fraction(grid.face_dm(), mask.fluid_fraction()),
        solid(grid.face_dm(), mask.solid_velocity());
    for (int c = 0; c < 2; ++c)
      for_each<2>(grid.owned(), [&](const Index<2>& face) {
        const Point<2> place = grid.face_center(face, c);
        std::size_t b = 0;
        while (b < bodies.size() && bodies[b].distance(place, time) > 0) ++b;
        EXPECT_EQ(fraction(face, c), b == bodies.size() ? 1 : 0);
        EXPECT_NEAR(solid(face, c), b == bodies.size() ? 0 : bodies[b].motion.velocity(place, time)[c], 1e-14);
      });
  }
}

}  // namespace
}  // namespace washfsi::test

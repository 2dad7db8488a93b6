// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/explicit_coupling.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/simulation/step_bound.hpp"

namespace washfsi::test {
namespace {

/// One fibre of 20 markers in a periodic box of water, 32 x 32 cells of 1 cm.
SystemOptions<2> fibre_in_water(double excess_mass, double damping) {
  SystemOptions<2> options;
  options.grid.shape.cells = {32, 32};
  options.grid.shape.upper = {0.32, 0.32};
  options.grid.shape.periodic = {true, true};
  for (auto& axis : options.grid.sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  options.fluid.viscosity = 0.5;
  options.fluid.momentum_tolerance = 1e-13;
  options.fluid.pressure_tolerance = 1e-12;
  ClothGroup group;
  group.name = "fibre";
  group.count = 1;
  group.markers = 20;
  group.size = 0.2;
  group.excess_mass = excess_mass;
  group.fibre = {.spacing = 0.01, .ke = 1000, .kb = 1e-4, .damping = damping, .thickness = 1e-3};
  options.cloths = {group};
  PlacementOptions<2> placement;
  placement.center = {0.16, 0.16};
  options.placements = {placement};
  return options;
}

// Bends and stretches the fibre at rest.
void disturb(System<2>& system, double size) {
  for (std::size_t m = 0; m < system.positions.size(); ++m) {
    const double s = (static_cast<double>(m) + static_cast<double>(system.cloths.begin())) / 20;
    system.positions[m] += size * Point<2>(std::sin(9 * s), std::cos(7 * s) + std::sin(17 * s));
  }
}

double total_energy(const System<2>& system) {
  const auto flow = FlowDiagnostics<2>::of(system.grid, system.boundary, system.fluid.velocity(), system.density, 0, 1);
  return flow.kinetic_energy + system.cloths.elastic_energies(system.positions)[0];
}

TEST(ExplicitCoupling, KeepsTheMomentumOfAPeriodicBox) {
  System<2> system(PETSC_COMM_WORLD, fibre_in_water(0, 0), {});
  disturb(system, 0.004);
  ExplicitCoupling<2> scheme;
  double largest_speed = 0;
  for (int n = 0; n < 50; ++n) {
    scheme.advance(system, 1e-4);
    double speed = 0;
    WASH_PETSC(VecNorm(system.fluid.velocity(), NORM_INFINITY, &speed));
    largest_speed = std::max(largest_speed, speed);
  }
  for (int c = 0; c < 2; ++c) {
    PetscScalar sum = 0;
    const petsc::Vector ones = petsc::zeros_like(system.fluid.velocity());
    {
      const FaceView<2> view(system.grid.face_dm(), ones);
      for_each<2>(system.grid.owned(), [&](const Index<2>& face) { view(face, c) = 1; });
    }
    WASH_PETSC(VecDot(ones, system.fluid.velocity(), &sum));
    EXPECT_LE(std::abs(sum) / system.grid.cell_count(), 1e-10 * largest_speed);
  }
  EXPECT_GT(largest_speed, 0.01);
}

TEST(ExplicitCoupling, IsStableAtTheBoundAndNotFarBeyond) {
  const auto growth = [](double part_of_bound) {
    System<2> system(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
    const double dt = part_of_bound * cloth_step_bound<2>(system);
    disturb(system, 1e-5);
    const double before = total_energy(system);
    ExplicitCoupling<2> scheme;
    for (int n = 0; n < 150 && total_energy(system) < 1e3 * before; ++n) scheme.advance(system, dt);
    return total_energy(system) / before;
  };
  EXPECT_LT(growth(1.0), 1.0);
  EXPECT_GT(growth(5.0), 100.0);
}

TEST(ExplicitCoupling, DampingIsWithinItsBoundToo) {
  System<2> system(PETSC_COMM_WORLD, fibre_in_water(0.093, 1e-3), {});
  const double dt = cloth_step_bound<2>(system);
  System<2> undamped(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  EXPECT_LT(dt, cloth_step_bound<2>(undamped));
  disturb(system, 1e-4);
  const double before = total_energy(system);
  ExplicitCoupling<2> scheme;
  for (int n = 0; n < 200; ++n) scheme.advance(system, dt);
  EXPECT_LT(total_energy(system), before);
}

TEST(ExplicitCoupling, HeavyClothSinks) {
  SystemOptions<2> options = fibre_in_water(2.0, 0);
  options.gravity = {0, -9.81};
  options.grid.shape.periodic = {false, false};
  for (auto& axis : options.grid.sides)
    for (auto& side : axis) side.kind = BoundaryKind::wall;
  System<2> system(PETSC_COMM_WORLD, options, {});
  ExplicitCoupling<2> scheme;
  for (int n = 0; n < 100; ++n) scheme.advance(system, 2e-4);
  for (const auto& velocity : system.velocities) EXPECT_LT(velocity[1], 0);
}

}  // namespace
}  // namespace washfsi::test

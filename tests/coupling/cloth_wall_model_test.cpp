// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/cloth_wall_model.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/simulation/case.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {
namespace {

constexpr PureLiquid tap_water{1000, 1e-3};

// On a plate so long that its laminar layer would be thicker than y.
TEST(ClothLayer, InSlowWaterIsALinearProfile) {
  constexpr double y = 0.01;
  const ClothLayer layer = cloth_layer(tap_water, y, 1e-8, 1e5);
  EXPECT_NEAR(layer.ease, y / 2e-3, 1e-4 * layer.ease);
  EXPECT_NEAR(layer.memory, std::numbers::pi / 4 * y * y / 1e-6, 1e-4 * layer.memory);
  EXPECT_EQ(cloth_layer(tap_water, y, 0, 1).ease, y / 2e-3);
}

TEST(ClothLayer, InFastWaterHasTheStressOfTheLawOnBothSides) {
  constexpr double y = 0.01, speed = 0.5;
  const ClothLayer layer = cloth_layer(tap_water, y, speed, 1e3);
  const double stress = speed / layer.ease / 2, friction_speed = std::sqrt(stress / 1000);
  EXPECT_NEAR(layer.y_plus, y * friction_speed / 1e-6, 1e-8 * layer.y_plus);
  EXPECT_NEAR(reichardt(layer.y_plus), speed / friction_speed, 1e-8);
  EXPECT_LT(layer.memory, 1e-12);
}

TEST(ClothLayer, ThinnerThanTheDistanceHasTheFrictionOfALaminarPlate) {
  constexpr double speed = 0.01, length = 0.05, reynolds = speed * length / 1e-6;
  const double drag = 2 * 1.328 / std::sqrt(reynolds) * 0.5 * 1000 * speed * speed;  // on both sides [Pa]
  EXPECT_NEAR(speed / cloth_layer(tap_water, 0.02, speed, length).ease, drag, 1e-10 * drag);
}

// Where the pressure is that of a stream against it.
TEST(EdgeFriction, HoldsSheetsAcrossAStream) {
  constexpr double pressure = 250;
  EXPECT_NEAR(edge_friction(1000, 0, pressure) * 0.005, 5 * pressure, 1e-9 * pressure);
  EXPECT_GT(edge_friction(1000, 0.1, pressure) * 0.1, 4 * pressure);
  EXPECT_LT(edge_friction(1000, 0.5, 1) * 0.5, 0.03);  // along a stream of 0.5 m/s
  EXPECT_EQ(edge_friction(1000, 0.1, 0), 0);
}

// A sheet as wide as a periodic box of 16 x 64 cells a metre high, pulled along itself by a small load, as in
// Rayleigh's problem: its speed over the exact one, load/mu sqrt(nu t/pi), when sqrt(nu t) is so many cells.
struct PulledSheet {
  WallTreatment wall_model = WallTreatment::equilibrium;
  PetscInt markers = 16;
  double height = 0.2;  ///< above the middle between two faces
  int along = 0;        ///< axis
  double length = 16;   ///< width of the box along the sheet [m]: cells are as much longer than high
};

std::vector<double> speeds_over_exact(const PulledSheet& how, const std::vector<double>& layers) {
  constexpr double load = 1e-4;
  const int across = 1 - how.along;
  CaseOptions<2> options;
  auto& [shape, sides] = options.model.grid;
  shape.cells[how.along] = 16;
  shape.cells[across] = 64;
  shape.upper[how.along] = how.length;
  shape.upper[across] = 64;
  shape.periodic[how.along] = true;
  for (auto& side : sides[how.along]) side.kind = BoundaryKind::periodic;
  for (auto& side : sides[across]) side.kind = BoundaryKind::slip;
  options.model.fluid.density = options.model.fluid.viscosity = 1;
  options.model.cloth = {.mass_carrier = MassCarrier::cloth, .wall_model = how.wall_model};
  ClothGroup<2> group;
  group.name = "sheet";
  group.markers = {how.markers, 1};
  group.size = {how.length, 1};
  group.excess_mass = 0;
  group.load[how.along] = load;
  group.sheet = {
      .ds = how.length / static_cast<double>(how.markers), .fabric = LinearFabric({.ke_s = 1000}), .thickness = 0.1};
  group.sheet.held_water = 0;
  options.model.cloths = {group};
  PlacementOptions<2> placement;
  placement.center[how.along] = 0.5 * how.length;
  placement.center[across] = 32 + how.height;
  placement.direction = Point<2>::Unit(how.along);
  options.placements = {placement};
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  CouplingOptions coupling;
  coupling.order = 2;
  const auto scheme = make_coupling_scheme<2>(coupling, *system);
  std::vector<double> speeds;
  for (const double layer : layers) {
    while (system->state.clock.time < layer * layer) scheme->advance(*system, 0.02);
    const double speed = of_all_ranks(PETSC_COMM_WORLD, system->state.velocities)[3][how.along];
    speeds.push_back(speed / (load * std::sqrt(system->state.clock.time / std::numbers::pi)));
  }
  return speeds;
}

// The kernels alone drag two cells of water along. Acceptable: 20, 6 and 2 % where the layer is one, two and four
// cells.
TEST(ClothWallModel, PulledAlongItselfASheetHasTheSpeedOfItsLayer) {
  const std::vector<double> layers{1, 2, 4}, bounds{0.2, 0.06, 0.02};
  for (const PulledSheet& how :
       {PulledSheet{}, {.markers = 10}, {.height = 0.5}, {.along = 1}, {.length = 48}, {.length = 6}}) {
    const std::vector<double> speeds = speeds_over_exact(how, layers);
    for (std::size_t n = 0; n < layers.size(); ++n) EXPECT_NEAR(speeds[n], 1, bounds[n]);
  }
  EXPECT_LT(speeds_over_exact({.wall_model = WallTreatment::none}, {1})[0], 0.6);
}

}  // namespace
}  // namespace washfsi::test

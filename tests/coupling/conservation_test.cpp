// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {
namespace {

// A crumpled fibre without mass in still water, by the explicit coupling at half its bound: the energy stays below that
// of the start, and its mean over each tenth of the run falls.
TEST(Conservation, ExplicitCouplingDoesNotGainEnergy) {
  CaseOptions<2> options = fibre_in_water(0, 0);
  options.model.fluid.momentum_tolerance = 1e-8;
  options.model.fluid.pressure_tolerance = 1e-8;
  options.model.cloths[0].shape = ClothShape::crumpled;
  options.model.cloths[0].sheet.fabric = LinearFabric({.ke_s = 1000, .kb_s = 0.01});
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  const double dt = 0.5 * cloth_step_bound<2>(system->model), before = total_energy(*system);
  const auto scheme = make_coupling_scheme<2>({.scheme = "explicit"}, *system);
  constexpr int periods = 10, steps = 1000;
  double mean_before = before;
  for (int period = 0; period < periods; ++period) {
    double mean = 0;
    for (int n = 0; n < steps; ++n) {
      scheme->advance(*system, dt);
      const double energy = total_energy(*system);
      ASSERT_LT(energy, 1.01 * before) << "step " << period * steps + n;
      mean += energy / steps;
    }
    EXPECT_LT(mean, mean_before) << "period " << period;
    mean_before = mean;
  }
}

// Width less height, and area, of a closed fibre whose markers go round once.
struct Ring {
  double eccentricity, area;
};

Ring ring(const System<2>& system) {
  const Points<2> places = of_all_ranks(PETSC_COMM_WORLD, system.state.positions);
  Ring result{0, 0};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Point<2>&here = places[k], &next = places[(k + 1) % places.size()];
    result.area += 0.5 * cross<2>(here, next)[0];
    result.eccentricity += std::abs(here[0] - 0.5) - std::abs(here[1] - 0.5);
  }
  return result;
}

// A stretched ellipse 2:1 swings about a circle: no water passes through the fibre.
TEST(Conservation, AClosedFibreKeepsItsArea) {
  CaseOptions<2> options = fibre_in_water(0, 0);
  options.model.grid.shape.cells = {64, 64};
  options.model.grid.shape.upper = {1, 1};
  options.model.fluid.viscosity = 0.6;
  options.model.fluid.momentum_tolerance = 1e-8;
  options.model.fluid.pressure_tolerance = 1e-8;
  auto& group = options.model.cloths[0];
  group.shape = ClothShape::ellipse;
  group.markers = {186, 1};  // ds = h/2 along the ellipse at the start
  group.size = {0.8 * 1.4533, 1};
  group.sheet.closed = true;
  group.sheet.ds = group.size[0] / 186;
  group.sheet.fabric = LinearFabric({.ke_s = 100});
  options.placements[0].center = {0.5, 0.5};
  options.placements[0].shape.semi_axes[0] = 0.3;
  options.placements[0].shape.semi_axes[1] = 0.15;
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  const double dt = 0.5 * cloth_step_bound<2>(system->model);
  const auto scheme = make_coupling_scheme<2>({.scheme = "explicit"}, *system);
  const Ring start = ring(*system);
  EXPECT_NEAR(start.area, 0.3 * 0.15 * std::numbers::pi, 1e-3 * start.area);
  int crossings = 0;
  double sign = 1, drift = 0;
  constexpr int enough = 20, most_steps = 20000;  // ten oscillations
  int steps = 0;
  for (; steps < most_steps && crossings < enough; ++steps) {
    scheme->advance(*system, dt);
    const Ring now = ring(*system);
    drift = std::max(drift, std::abs(now.area / start.area - 1));
    if (sign * now.eccentricity >= 0) continue;
    sign = -sign;
    ++crossings;
  }
  RecordProperty("drift", std::to_string(drift));
  EXPECT_EQ(crossings, enough);
  EXPECT_LT(drift, 0.005);
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/inertia.hpp"

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/measure/carried_mass.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

CaseOptions<2> heavy_fibre(double excess_mass) {
  CaseOptions<2> options = fibre_in_water(excess_mass, 0);
  options.model.mass_carrier = MassCarrier::cloth;
  return options;
}

CouplingOptions coupling(const std::string& name) {
  CouplingOptions options;
  options.scheme = name.starts_with("semi_implicit") ? "semi_implicit" : "implicit";
  options.mobility = name == "semi_implicit_row_sums" ? Mobility::row_sums : Mobility::matrix;
  options.time_scheme = name == "implicit_trapezoidal" ? TimeScheme::trapezoidal : TimeScheme::backward_euler;
  options.tolerance = 1e-9;
  options.sweeps = most_sweeps_with_inertia;
  return options;
}

// Of the water.
Point<2> momentum(const System<2>& system) {
  const Model<2>& model = system.model;
  Point<2> sum = Point<2>::Zero();
  const ConstFaceView<2> u(model.grid.face_dm(), model.fluid.velocity());
  const ConstFaceView<2> rho(model.grid.face_dm(), model.liquid.density());
  for_each<2>(model.grid.owned(), [&](const Index<2>& face) {
    for (int c = 0; c < 2; ++c) sum[c] += rho(face, c) * u(face, c) * model.grid.cell_volume();
  });
  for (int c = 0; c < 2; ++c) sum[c] = ordered_sum(model.grid.comm(), sum[c]);
  return sum;
}

Point<2> given(const System<2>& system) {
  Point<2> sum = Point<2>::Zero();
  for (const Point<2>& force : system.step.given) sum += force;
  for (int c = 0; c < 2; ++c) sum[c] = ordered_sum(system.model.grid.comm(), sum[c]);
  return sum;
}

class EveryCarrier : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Inertia, EveryCarrier,
                         testing::Values("semi_implicit", "semi_implicit_row_sums", "implicit_trapezoidal",
                                         "implicit_backward_euler"),
                         [](const auto& test) { return test.param; });

// Nothing but their own inertia is left of the cloths' forces in sum, by BDF2 or the trapezoidal rule, and the water
// gets it all, in steps of varying length.
TEST_P(EveryCarrier, ExchangesMomentumOfClothAndWaterExactly) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, heavy_fibre(5), {});
  disturb(*system, 0.004);
  for (auto& velocity : system->state.velocities) velocity = {0.1, 0.3};
  system->state.velocities_before = system->state.velocities;
  const auto scheme = make_coupling_scheme<2>(coupling(GetParam()), *system);
  const std::vector<double>& masses = system->model.cloths.marker_masses();
  const bool bdf2 = GetParam() != "implicit_trapezoidal";
  double scale = 0, dt_before = 0;
  for (int n = 0; n < 30; ++n) {
    const double dt = n % 3 == 0 ? 2e-4 : 3e-4;
    const Points<2> now = system->state.velocities, before = system->state.velocities_before;
    const Point<2> water = momentum(*system);
    scheme->advance(*system, dt);
    const double ratio = bdf2 && dt_before > 0 ? dt / dt_before : 0;
    Point<2> gained = Point<2>::Zero();
    for (std::size_t m = 0; m < masses.size(); ++m)
      gained += masses[m] * ((1 + 2 * ratio) / (1 + ratio) * system->state.velocities[m] - (1 + ratio) * now[m] +
                             ratio * ratio / (1 + ratio) * before[m]);
    for (int c = 0; c < 2; ++c) gained[c] = ordered_sum(PETSC_COMM_WORLD, gained[c]);
    scale = std::max(scale, gained.norm());
    EXPECT_LE((momentum(*system) - water - dt * given(*system)).norm(), 1e-10 * scale);
    EXPECT_LE((dt * given(*system) + gained).norm(), 1e-6 * scale) << "step " << n;  // the coupling's tolerance
    dt_before = dt;
  }
  EXPECT_GT(scale, 1e-4);
}

// Any mass, from none to ten times the water's in a cell, at steps far beyond what its springs would bear.
TEST(Inertia, OfAnyMassIsStableAndSlipsLittle) {
  for (const double mass : {0.0, 1.0, 100.0}) {
    CaseOptions<2> options = heavy_fibre(mass);
    options.model.fluid.momentum_tolerance = options.model.fluid.pressure_tolerance = 1e-7;
    const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
    disturb(*system, 2e-3);
    const auto scheme = make_coupling_scheme<2>(coupling("semi_implicit"), *system);
    for (int n = 0; n < 30; ++n) scheme->advance(*system, 2e-3);
    EXPECT_LE(system->step.cloth_slip, 0.02) << mass;
    for (const Point<2>& velocity : system->state.velocities) EXPECT_TRUE(velocity.allFinite());
  }
}

// At rest in a stream that moves with it, a cloth feels nothing, whatever its mass.
TEST(Inertia, OfAClothThatMovesWithTheWaterIsNotFelt) {
  CaseOptions<2> options = heavy_fibre(50);
  options.model.cloths[0].velocity = {0.2, 0.1};
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  system->model.fluid.start([](const Point<2>&, int c) { return c == 0 ? 0.2 : 0.1; });
  const Points<2> start = system->state.positions;
  const auto scheme = make_coupling_scheme<2>(coupling("semi_implicit"), *system);
  for (int n = 0; n < 20; ++n) scheme->advance(*system, 1e-3);
  for (std::size_t m = 0; m < start.size(); ++m)
    EXPECT_LE((system->state.positions[m] - start[m] - 0.02 * Point<2>(0.2, 0.1)).norm(), 1e-12);
}

// The kinetic energy of a stretched bar of mass 100 kg/m2 that springs back in nearly weightless water is that of its
// springs.
TEST(Inertia, SwingsAHeavyFibreWithItsOwnPeriod) {
  CaseOptions<2> options = heavy_fibre(100);
  options.model.fluid.density = 0.01;
  options.model.fluid.viscosity = 1e-7;
  options.model.fluid.momentum_tolerance = options.model.fluid.pressure_tolerance = 1e-7;
  options.model.cloths[0].sheet.fabric = LinearFabric({.ke_s = 1000, .kb_s = 0});
  const auto period_error = [&](int steps_in_a_period) {
    const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
    Points<2>& x = system->state.positions;
    for (Point<2>& place : x) place[0] -= 1e-4 * std::cos(std::numbers::pi * (place[0] - 0.06) / 0.2);
    // first longitudinal mode of a free bar: w = pi/L sqrt(Ke/m), with 20 markers w = 2/ds sin(pi/40) sqrt(Ke/m)
    const double w = 2 / 0.01 * std::sin(std::numbers::pi / 40) * std::sqrt(1000.0 / 100),
                 period = 2 * std::numbers::pi / w;
    const auto scheme = make_coupling_scheme<2>(coupling("semi_implicit"), *system);
    std::vector<double> stretch;
    const Cloths<2>& cloths = system->model.cloths;
    for (int n = 0; n < steps_in_a_period; ++n) {
      const Points<2> all = cloths.of_all_ranks(x);
      stretch.push_back((all.back() - all.front())[0] - 0.19);
      scheme->advance(*system, period / steps_in_a_period);
    }
    for (std::size_t n = 1; n < stretch.size(); ++n)
      if (stretch[n] < 0) {
        const double crossing = static_cast<double>(n) - stretch[n] / (stretch[n] - stretch[n - 1]);
        return std::abs(crossing / steps_in_a_period - 0.25);
      }
    return 1.0;
  };
  EXPECT_LE(period_error(100), 0.01);
}

}  // namespace
}  // namespace washfsi::test

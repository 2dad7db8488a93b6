// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/coupling/step_error.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {
namespace {

CouplingOptions coupling(const std::string& scheme, TimeScheme time_scheme = TimeScheme::trapezoidal) {
  CouplingOptions options;
  options.scheme = scheme.starts_with("semi_implicit") ? "semi_implicit" : scheme;
  if (scheme == "semi_implicit_row_sums") options.mobility = Mobility::row_sums;
  options.order = scheme == "semi_implicit_second_order" ? 2 : 1;
  options.time_scheme = time_scheme;
  options.tolerance = 1e-9;
  return options;
}

class EveryCoupling : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Couplings, EveryCoupling,
                         testing::Values("explicit", "midpoint", "semi_implicit", "semi_implicit_row_sums",
                                         "semi_implicit_second_order", "implicit"),
                         [](const auto& test) { return test.param; });

TEST_P(EveryCoupling, KeepsTheMomentumOfAPeriodicBox) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0, 0), {});
  disturb(*system, 0.004);
  const auto scheme = make_coupling_scheme<2>(coupling(GetParam()), *system);
  double largest_speed = 0;
  for (int n = 0; n < 50; ++n) {
    scheme->advance(*system, 1e-4);
    double speed = 0;
    WASH_PETSC(VecNorm(system->model.fluid.velocity(), NORM_INFINITY, &speed));
    largest_speed = std::max(largest_speed, speed);
  }
  for (int c = 0; c < 2; ++c) {
    PetscScalar sum = 0;
    const petsc::Vector ones = petsc::zeros_like(system->model.fluid.velocity());
    {
      const FaceView<2> view(system->model.grid.face_dm(), ones);
      for_each<2>(system->model.grid.owned(), [&](const Index<2>& face) { view(face, c) = 1; });
    }
    WASH_PETSC(VecDot(ones, system->model.fluid.velocity(), &sum));
    EXPECT_LE(std::abs(sum) / system->model.grid.cell_count(), 1e-10 * largest_speed);
  }
  EXPECT_GT(largest_speed, 0.01);
}

// Markers after a given time in steps of dt, all of them on every rank.
Points<2> places_after(const std::string& name, double time, int steps) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  disturb(*system, 1e-3);
  const auto scheme = make_coupling_scheme<2>(coupling(name), *system);
  for (int n = 0; n < steps; ++n) scheme->advance(*system, time / steps);
  return of_all_ranks(PETSC_COMM_WORLD, system->state.positions);
}

double difference(const Points<2>& a, const Points<2>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
  return largest;
}

// Observed order from three steps, and the same limit as the explicit coupling.
TEST_P(EveryCoupling, ConvergesWithTheStepToTheSameMotion) {
  const std::string name = GetParam();
  constexpr double time = 0.016;
  const auto coarse = places_after(name, time, 40), medium = places_after(name, time, 80),
             fine = places_after(name, time, 160), other = places_after("midpoint", time, 160);
  const double order = std::log2(difference(coarse, medium) / difference(medium, fine));
  RecordProperty("order", std::to_string(order));
  const bool second = name == "midpoint" || name == "semi_implicit_second_order";
  EXPECT_GT(order, second ? 1.8 : 0.8);
  EXPECT_LT(difference(fine, other), second ? 1e-6 : 1e-4);
}

double error_after(const std::string& name, double time, int steps) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  disturb(*system, 1e-3);
  const auto scheme = make_coupling_scheme<2>(coupling(name), *system);
  EXPECT_EQ(step_error(*system), 0);
  for (int n = 0; n < steps; ++n) scheme->advance(*system, time / steps);
  return step_error(*system);
}

// The embedded error falls with the step as the scheme's own does.
TEST_P(EveryCoupling, ErrsInAStepByItsOrder) {
  const std::string name = GetParam();
  if (name == "implicit") return;  // by the trapezoidal rule, to which it is compared
  const double order = std::log2(error_after(name, 0.016, 80) / error_after(name, 0.016, 160));
  RecordProperty("order", std::to_string(order));
  const bool second = name == "midpoint" || name == "semi_implicit_second_order";
  EXPECT_GT(order, second ? 1.8 : 0.8);
}

TEST(ExplicitCoupling, IsStableAtTheBoundAndNotFarBeyond) {
  const auto growth = [](double part_of_bound) {
    const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
    const double dt = part_of_bound * cloth_step_bound<2>(system->model);
    disturb(*system, 1e-5);
    const double before = total_energy(*system);
    const auto scheme = make_coupling_scheme<2>(coupling("explicit"), *system);
    for (int n = 0; n < 150 && total_energy(*system) < 1e3 * before; ++n) scheme->advance(*system, dt);
    return total_energy(*system) / before;
  };
  EXPECT_LT(growth(1.0), 1.0);
  EXPECT_GT(growth(5.0), 100.0);
}

TEST(ExplicitCoupling, DampingIsWithinItsBoundToo) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 1e-3), {});
  const double dt = cloth_step_bound<2>(system->model);
  const auto undamped = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  EXPECT_LT(dt, cloth_step_bound<2>(undamped->model));
  disturb(*system, 1e-4);
  const double before = total_energy(*system);
  const auto scheme = make_coupling_scheme<2>(coupling("explicit"), *system);
  for (int n = 0; n < 200; ++n) scheme->advance(*system, dt);
  EXPECT_LT(total_energy(*system), before);
}

void expect_stable_far_beyond_the_explicit_bound(const std::string& name) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  const double dt = 30 * cloth_step_bound<2>(system->model);
  disturb(*system, 1e-4);
  const auto scheme = make_coupling_scheme<2>(coupling(name), *system);
  const double before = total_energy(*system);
  for (int n = 0; n < 100; ++n) {
    scheme->advance(*system, dt);
    if (n < 30) continue;  // F^n overshoots at first: it acts over 30 bounds
    EXPECT_LT(total_energy(*system), before) << name << ", step " << n;
  }
  EXPECT_LT(total_energy(*system), 0.3 * before);
}

TEST(SemiImplicitCoupling, IsStableFarBeyondTheExplicitBound) {
  expect_stable_far_beyond_the_explicit_bound("semi_implicit");
  expect_stable_far_beyond_the_explicit_bound("semi_implicit_row_sums");
}

TEST(ImplicitCoupling, NeverGainsEnergy) {
  for (const TimeScheme time_scheme : {TimeScheme::trapezoidal, TimeScheme::backward_euler}) {
    const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0, 0), {});
    const double dt = 3 * cloth_step_bound<2>(system->model);
    disturb(*system, 2e-3);
    const auto scheme = make_coupling_scheme<2>(coupling("implicit", time_scheme), *system);
    double energy = total_energy(*system);
    const double before = energy;
    for (int n = 0; n < 100; ++n) {
      scheme->advance(*system, dt);
      EXPECT_LT(total_energy(*system), energy + 1e-9 * before) << name_of(time_scheme) << ", step " << n;
      energy = total_energy(*system);
    }
    RecordProperty("iterations_" + name_of(time_scheme), std::to_string(system->step.cloth_iterations / 100));
  }
}

TEST_P(EveryCoupling, LetsHeavyClothSink) {
  CaseOptions<2> options = fibre_in_water(2.0, 0);
  options.model.gravity = {0, -9.81};
  options.model.grid.shape.periodic = {false, false};
  for (auto& axis : options.model.grid.sides)
    for (auto& side : axis) side.kind = BoundaryKind::wall;
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  const auto scheme = make_coupling_scheme<2>(coupling(GetParam()), *system);
  for (int n = 0; n < 50; ++n) scheme->advance(*system, 2e-4);
  for (const auto& velocity : system->state.velocities) EXPECT_LT(velocity[1], 0);
}

}  // namespace
}  // namespace washfsi::test

// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include <gtest/gtest.h>

#include "support/manufactured_flow.hpp"

namespace washfsi::test {
namespace {

constexpr double wave_number = 2 * std::numbers::pi;

// Taylor and Green's decaying vortices in the x,y plane of a unit box.
template <int Dim>
ExactFlow<Dim> taylor_green() {
  ExactFlow<Dim> flow;
  flow.viscosity = 0.01;
  const double rate = 2 * flow.viscosity * wave_number * wave_number;
  flow.velocity = [rate](const Point<Dim>& x, double t) {
    Point<Dim> u = Point<Dim>::Zero();
    u[0] = -std::cos(wave_number * x[0]) * std::sin(wave_number * x[1]) * std::exp(-rate * t);
    u[1] = std::sin(wave_number * x[0]) * std::cos(wave_number * x[1]) * std::exp(-rate * t);
    return u;
  };
  flow.pressure = [rate](const Point<Dim>& x, double t) {
    return -0.25 * (std::cos(2 * wave_number * x[0]) + std::cos(2 * wave_number * x[1])) * std::exp(-2 * rate * t);
  };
  return flow;
}

// Arnold, Beltrami and Childress: u parallel to its own curl, so it decays by viscosity alone and p = -|u|^2/2.
ExactFlow<3> beltrami() {
  ExactFlow<3> flow;
  flow.viscosity = 0.01;
  const double rate = flow.viscosity * wave_number * wave_number;
  flow.velocity = [rate](const Point<3>& x, double t) {
    return Point<3>((std::sin(wave_number * x[2]) + 0.5 * std::cos(wave_number * x[1])) * std::exp(-rate * t),
                    (0.7 * std::sin(wave_number * x[0]) + std::cos(wave_number * x[2])) * std::exp(-rate * t),
                    (0.5 * std::sin(wave_number * x[1]) + 0.7 * std::cos(wave_number * x[0])) * std::exp(-rate * t));
  };
  flow.pressure = [u = flow.velocity](const Point<3>& x, double t) { return -0.5 * u(x, t).squaredNorm(); };
  return flow;
}

template <int Dim>
FlowError run_periodic(const ExactFlow<Dim>& flow, PetscInt n, double dt, int steps) {
  GridShape<Dim> shape;
  shape.cells.fill(n);
  shape.periodic.fill(true);
  return ManufacturedRun<Dim>(flow, shape, {}, false).advance(dt, steps);
}

template <int Dim>
void expect_second_order(const char* name, const ExactFlow<Dim>& flow, PetscInt n, double dt, int steps) {
  const FlowError coarse = run_periodic<Dim>(flow, n, dt, steps),
                  fine = run_periodic<Dim>(flow, 2 * n, dt / 2, 2 * steps);
  report(name, coarse, fine);
  EXPECT_GE(order(coarse.velocity_max, fine.velocity_max), 1.9) << coarse.velocity_max << " " << fine.velocity_max;
  EXPECT_GE(order(coarse.pressure_max, fine.pressure_max), 1.9) << coarse.pressure_max << " " << fine.pressure_max;
}

TEST(TaylorGreen, SecondOrderInSpaceAndTimeInThePlane) {
  expect_second_order<2>("Taylor-Green 2D", taylor_green<2>(), 32, 0.01, 20);
}

TEST(TaylorGreen, SecondOrderInSpaceAndTimeInSpace) {
  expect_second_order<3>("Taylor-Green 3D", taylor_green<3>(), 16, 0.02, 6);
}

TEST(TaylorGreen, BeltramiFlowSecondOrderInSpace) {
  expect_second_order<3>("Beltrami 3D", beltrami(), 16, 0.01, 10);
}

// The spatial error is the same for all steps, so it leaves the differences between steps.
TEST(TaylorGreen, SecondOrderInTimeAlone) {
  GridShape<2> shape;
  shape.cells = {16, 16};
  shape.periodic = {true, true};
  std::array<petsc::Vector, 3> velocity;
  for (int level = 0; level < 3; ++level) {
    ManufacturedRun<2> run(taylor_green<2>(), shape, {}, false);
    (void)run.advance(0.04 / (1 << level), 10 << level);
    auto& copy = velocity[static_cast<std::size_t>(level)];
    copy = petsc::zeros_like(run.fluid().velocity());
    WASH_PETSC(VecCopy(run.fluid().velocity(), copy));
  }
  double first = 0, second = 0;
  WASH_PETSC(VecAXPY(velocity[0], -1, velocity[1]));
  WASH_PETSC(VecAXPY(velocity[1], -1, velocity[2]));
  WASH_PETSC(VecNorm(velocity[0], NORM_INFINITY, &first));
  WASH_PETSC(VecNorm(velocity[1], NORM_INFINITY, &second));
  EXPECT_GE(order(first, second), 1.9) << first << " " << second;
}

// Steps that alternate between 2/3 and 4/3 of their mean keep the order (variable-step Adams-Bashforth).
TEST(TaylorGreen, SecondOrderWithUnequalSteps) {
  GridShape<2> shape;
  shape.periodic = {true, true};
  std::array<FlowError, 2> errors;
  for (std::size_t level = 0; level < 2; ++level) {
    shape.cells = {32 << level, 32 << level};
    ManufacturedRun<2> run(taylor_green<2>(), shape, {}, false);
    errors[level] = run.advance_unequally(0.01 / (1 << level), 10 << level);
  }
  report("unequal steps", errors[0], errors[1]);
  EXPECT_GE(order(errors[0].velocity_max, errors[1].velocity_max), 1.9);
  EXPECT_GE(order(errors[0].pressure_max, errors[1].pressure_max), 1.9);
}

// Upwind advection is of second order where the flow is smooth (in the mean: the limiter acts at extrema), and it only
// takes energy out.
TEST(TaylorGreen, UpwindAdvectionConverges) {
  std::array<FlowError, 2> errors;
  for (std::size_t level = 0; level < 2; ++level) {
    GridShape<2> shape;
    shape.cells = {32 << level, 32 << level};
    shape.periodic = {true, true};
    ManufacturedRun<2> run(taylor_green<2>(), shape, {}, false, "upwind");
    errors[level] = run.advance(0.01 / (1 << level), 20 << level);
    EXPECT_GT(run.fluid().advection().numerical_dissipation(), 0);
  }
  report("upwind", errors[0], errors[1]);
  EXPECT_GE(order(errors[0].velocity_rms, errors[1].velocity_rms), 1.5);
}

// The pressure of this flow balances its advection, whose error it shows: fluxes of fourth order leave a tenth of it.
TEST(TaylorGreen, WideCentralAdvectionIsMoreAccurate) {
  std::array<std::array<FlowError, 2>, 2> errors;
  for (std::size_t scheme = 0; scheme < 2; ++scheme)
    for (std::size_t level = 0; level < 2; ++level) {
      GridShape<2> shape;
      shape.cells = {32 << level, 32 << level};
      shape.periodic = {true, true};
      ManufacturedRun<2> run(taylor_green<2>(), shape, {}, false, scheme == 0 ? "central" : "wide_central");
      errors[scheme][level] = run.advance(0.01 / (1 << level), 20 << level);
    }
  report("wide central", errors[1][0], errors[1][1]);
  EXPECT_GE(order(errors[1][0].velocity_max, errors[1][1].velocity_max), 1.9);
  for (std::size_t level = 0; level < 2; ++level)
    EXPECT_LT(errors[1][level].pressure_max, 0.15 * errors[0][level].pressure_max);
}

}  // namespace
}  // namespace washfsi::test

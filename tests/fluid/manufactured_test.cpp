// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include <gtest/gtest.h>

#include "support/manufactured_flow.hpp"

namespace washfsi::test {
namespace {

constexpr double pi = std::numbers::pi;

double beat(double t) {
  return std::cos(2 * t) + 0.5;
}

// No slip on y = 0, 1 and periodic in x; the pressure has a normal gradient at the walls.
ExactFlow<2> channel_flow() {
  ExactFlow<2> flow;
  flow.velocity = [](const Point<2>& x, double t) -> Point<2> {
    return Point<2>(std::sin(2 * pi * x[0]) * std::sin(2 * pi * x[1]),
                    -2 * std::cos(2 * pi * x[0]) * std::pow(std::sin(pi * x[1]), 2)) *
           beat(t);
  };
  flow.pressure = [](const Point<2>& x, double t) {
    return std::cos(2 * pi * x[0]) * std::sin(pi * x[1] + 0.4) * beat(t);
  };
  return flow;
}

// No slip on all four sides.
ExactFlow<2> box_flow() {
  ExactFlow<2> flow;
  flow.velocity = [](const Point<2>& x, double t) -> Point<2> {
    return Point<2>(std::pow(std::sin(pi * x[0]), 2) * std::sin(2 * pi * x[1]),
                    -std::sin(2 * pi * x[0]) * std::pow(std::sin(pi * x[1]), 2)) *
           beat(t);
  };
  flow.pressure = [](const Point<2>& x, double t) {
    return std::cos(pi * x[0] + 0.3) * std::sin(pi * x[1] + 0.4) * beat(t);
  };
  return flow;
}

// The stream function 0.1 sin(2 pi (x - t)) (y + y^2/3): walls that move along and across themselves, differently at
// every place and time.
ExactFlow<2> moving_channel_flow() {
  ExactFlow<2> flow = channel_flow();
  flow.velocity = [](const Point<2>& x, double t) -> Point<2> {
    const double angle = 2 * pi * (x[0] - t);
    return {0.1 * std::sin(angle) * (1 + 2 * x[1] / 3), -0.2 * pi * std::cos(angle) * (x[1] + x[1] * x[1] / 3)};
  };
  return flow;
}

// The stream function sin(pi x) sin(pi y): all four walls slide along themselves.
ExactFlow<2> moving_box_flow() {
  ExactFlow<2> flow = box_flow();
  flow.velocity = [](const Point<2>& x, double t) -> Point<2> {
    return Point<2>(std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1])) * beat(t);
  };
  return flow;
}

// A density between 1 and `contrast`, which the velocity need not carry: the solver takes it as given.
ExactFlow<2> with_contrast(ExactFlow<2> flow, double contrast, double speed) {
  flow.variable_density = [contrast, speed](const Point<2>& x, double t) {
    const double wave = std::sin(2 * pi * (x[0] - speed * t)) * std::cos(pi * x[1]);
    return 1 + 0.5 * (contrast - 1) * (1 + wave);
  };
  return flow;
}

// No slip on y = 0, 1, periodic in x and z; the flow of the channel and one across it.
ExactFlow<3> channel_flow_in_space() {
  ExactFlow<3> flow;
  flow.velocity = [](const Point<3>& x, double t) -> Point<3> {
    const double along = std::sin(2 * pi * x[0]), wall = std::pow(std::sin(pi * x[1]), 2),
                 across = std::cos(2 * pi * x[2]);
    return Point<3>(along * std::sin(2 * pi * x[1]) * across, -2 * std::cos(2 * pi * x[0]) * wall * across,
                    wall * along) *
           beat(t);
  };
  flow.pressure = [](const Point<3>& x, double t) {
    return std::cos(2 * pi * x[0]) * std::sin(pi * x[1] + 0.4) * std::cos(2 * pi * x[2]) * beat(t);
  };
  return flow;
}

// A viscosity between 0.02 and 0.2 that varies in all directions, at the walls too.
template <int Dim>
ExactFlow<Dim> with_uneven_viscosity(ExactFlow<Dim> flow) {
  flow.variable_viscosity = [](const Point<Dim>& x) {
    double wave = std::sin(2 * pi * x[0]) * std::cos(pi * x[1] + 0.5);
    if constexpr (Dim == 3) wave *= std::cos(2 * pi * x[2]);
    return 0.02 * std::pow(10, 0.5 * (1 + wave));
  };
  return flow;
}

template <int Dim>
typename Boundary<Dim>::Sides moving_sides(const ExactFlow<Dim>& flow, const std::array<bool, Dim>& periodic) {
  typename Boundary<Dim>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.motion = flow.velocity;
  for (std::size_t d = 0; d < Dim; ++d)
    if (periodic[d]) sides[d][0].kind = sides[d][1].kind = BoundaryKind::periodic;
  return sides;
}

template <int Dim>
std::array<FlowError, 2> run_pair(const ExactFlow<Dim>& flow, const std::array<bool, Dim>& periodic,
                                  const Index<Dim>& cells, double dt, int steps) {
  std::array<FlowError, 2> errors;
  for (int level = 0; level < 2; ++level) {
    GridShape<Dim> shape;
    for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = cells[d] << level;
    shape.periodic = periodic;
    errors[static_cast<std::size_t>(level)] = ManufacturedRun<Dim>(flow, shape, moving_sides<Dim>(flow, periodic), true)
                                                  .advance(dt / (1 << level), steps << level);
  }
  return errors;
}

std::array<FlowError, 2> run_pair(const ExactFlow<2>& flow, bool periodic_in_x, Index<2> cells = {32, 32}) {
  return run_pair<2>(flow, {periodic_in_x, false}, cells, 0.5 / 32, 16);
}

// Orders in time alone, from differences between steps on one grid, whose spatial error is the same for all.
FlowError orders_in_time(const char* name, const ExactFlow<2>& flow, bool periodic_in_x) {
  GridShape<2> shape;
  shape.cells = {32, 32};
  shape.periodic = {periodic_in_x, false};
  std::array<std::pair<petsc::Vector, petsc::Vector>, 3> states;
  for (int level = 0; level < 3; ++level)
    states[static_cast<std::size_t>(level)] =
        ManufacturedRun<2>(flow, shape, moving_sides<2>(flow, {periodic_in_x, false}), true)
            .final_state(1.0 / (64 << level), 32 << level);
  std::array<FlowError, 2> differences;
  for (std::size_t i = 0; i < 2; ++i) {
    auto& [u, p] = states[i];
    WASH_PETSC(VecAXPY(u, -1, states[i + 1].first));
    WASH_PETSC(VecAXPY(p, -1, states[i + 1].second));
    WASH_PETSC(VecNorm(u, NORM_INFINITY, &differences[i].velocity_max));
    WASH_PETSC(VecNorm(u, NORM_2, &differences[i].velocity_rms));
    WASH_PETSC(VecNorm(p, NORM_INFINITY, &differences[i].pressure_max));
    WASH_PETSC(VecNorm(p, NORM_2, &differences[i].pressure_rms));
  }
  report(name, differences[0], differences[1]);
  return {order(differences[0].velocity_max, differences[1].velocity_max),
          order(differences[0].velocity_rms, differences[1].velocity_rms),
          order(differences[0].pressure_max, differences[1].pressure_max),
          order(differences[0].pressure_rms, differences[1].pressure_rms)};
}

void expect_second_order(const char* name, const std::array<FlowError, 2>& errors, double least_of_pressure_max) {
  const auto& [coarse, fine] = errors;
  report(name, coarse, fine);
  EXPECT_GE(order(coarse.velocity_max, fine.velocity_max), 1.9) << name;
  EXPECT_GE(order(coarse.velocity_rms, fine.velocity_rms), 1.9) << name;
  EXPECT_GE(order(coarse.pressure_max, fine.pressure_max), least_of_pressure_max) << name;
  EXPECT_GE(order(coarse.pressure_rms, fine.pressure_rms), 1.9) << name;
}

TEST(ManufacturedFlow, ChannelIsSecondOrderInAllNorms) {
  expect_second_order("channel", run_pair(channel_flow(), true), 1.9);
}

TEST(ManufacturedFlow, BoxIsSecondOrder) {
  expect_second_order("box", run_pair(box_flow(), false), 1.9);
}

TEST(ManufacturedFlow, MovingWallsKeepTheOrderInTime) {
  const FlowError channel = orders_in_time("moving channel, time", moving_channel_flow(), true);
  for (const double order : {channel.velocity_max, channel.velocity_rms, channel.pressure_max, channel.pressure_rms})
    EXPECT_GE(order, 1.9);
  const FlowError box = orders_in_time("moving box, time", moving_box_flow(), false);
  for (const double order : {box.velocity_max, box.velocity_rms, box.pressure_rms}) EXPECT_GE(order, 1.9);
  EXPECT_GE(box.pressure_max, 1.6);
}

// In the corners the pressure is less regular: its largest error is of order 1.4 to 2, after the ratio of step to
// spacing (docs/validation/order.md).
TEST(ManufacturedFlow, MovingWallsKeepTheOrderInSpaceAndTime) {
  expect_second_order("moving channel", run_pair(moving_channel_flow(), true), 1.85);
  expect_second_order("moving box", run_pair(moving_box_flow(), false), 1.4);
}

TEST(ManufacturedFlow, CellsOfAnySizeAndShapeKeepTheOrder) {
  expect_second_order("channel 33 x 65", run_pair(channel_flow(), true, {33, 65}), 1.9);
  expect_second_order("box 65 x 33", run_pair(box_flow(), false, {65, 33}), 1.9);
}

TEST(ManufacturedFlow, DensityContrastKeepsTheOrder) {
  for (const double contrast : {1.0, 2.0, 10.0}) {
    const std::string name = "density contrast " + to_text(contrast);
    expect_second_order(name.c_str(), run_pair(with_contrast(channel_flow(), contrast, 0), true), 1.9);
  }
  expect_second_order("contrast 10, moving", run_pair(with_contrast(channel_flow(), 10, 0.7), true), 1.9);
}

// mu div u*, which corrects the pressure, does so exactly for a uniform viscosity alone: what is left is largest at
// walls.
TEST(ManufacturedFlow, UnevenViscosityKeepsTheOrderInThePlane) {
  expect_second_order("viscosity 10, channel", run_pair(with_uneven_viscosity(channel_flow()), true), 1.9);
  expect_second_order("viscosity 10, box", run_pair(with_uneven_viscosity(box_flow()), false), 1.9);
  expect_second_order("viscosity 10, moving", run_pair(with_uneven_viscosity(moving_channel_flow()), true), 1.7);
}

TEST(ManufacturedFlow, UnevenViscosityKeepsTheOrderInSpace) {
  const auto errors =
      run_pair<3>(with_uneven_viscosity(channel_flow_in_space()), {true, false, true}, {16, 16, 16}, 0.5 / 16, 8);
  expect_second_order("viscosity 10, 3D", errors, 1.6);
}

}  // namespace
}  // namespace washfsi::test

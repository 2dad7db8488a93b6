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

std::array<FlowError, 2> run_pair(const ExactFlow<2>& flow, bool periodic_in_x) {
  std::array<FlowError, 2> errors;
  for (int level = 0; level < 2; ++level) {
    GridShape<2> shape;
    shape.cells = {32 << level, 32 << level};
    shape.periodic = {periodic_in_x, false};
    Boundary<2>::Sides sides;
    if (periodic_in_x) sides[0][0].kind = sides[0][1].kind = BoundaryKind::periodic;
    errors[static_cast<std::size_t>(level)] =
        ManufacturedRun<2>(flow, shape, sides, true).advance(0.5 / (32 << level), 16 << level);
  }
  return errors;
}

TEST(ManufacturedFlow, ChannelIsSecondOrderInAllNorms) {
  const auto [coarse, fine] = run_pair(channel_flow(), true);
  report("channel", coarse, fine);
  EXPECT_GE(order(coarse.velocity_max, fine.velocity_max), 1.9);
  EXPECT_GE(order(coarse.velocity_rms, fine.velocity_rms), 1.9);
  EXPECT_GE(order(coarse.pressure_max, fine.pressure_max), 1.9) << coarse.pressure_max << " " << fine.pressure_max;
  EXPECT_GE(order(coarse.pressure_rms, fine.pressure_rms), 1.9);
}

TEST(ManufacturedFlow, BoxIsSecondOrderInTheMean) {
  const auto [coarse, fine] = run_pair(box_flow(), false);
  report("box", coarse, fine);
  EXPECT_GE(order(coarse.velocity_rms, fine.velocity_rms), 1.9);
  EXPECT_GE(order(coarse.pressure_rms, fine.pressure_rms), 1.9) << coarse.pressure_rms << " " << fine.pressure_rms;
}

}  // namespace
}  // namespace washfsi::test

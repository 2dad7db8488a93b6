// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/adams_bashforth.hpp"

#include <array>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

namespace washfsi {
namespace {

constexpr double dt = 0.3, before = 0.2, earlier = 0.7;

// The weighted mean of t^n at 0, -before and -before - earlier over that of the step.
double error_of_power(double bend, int n) {
  const AdvectionWeights weights = adams_bashforth(bend, dt, before, earlier);
  const double mean = std::pow(dt, n) / (n + 1), at_zero = n == 0 ? 1 : 0;
  return weights.now * at_zero + weights.before * std::pow(-before, n) +
         weights.earlier * std::pow(-before - earlier, n) - mean;
}

// How much an oscillation of w dt = angle grows in each of many equal steps.
double growth(double bend, double angle) {
  constexpr int steps = 4000;
  std::array<std::complex<double>, 3> u{1.0, std::polar(1.0, -angle), std::polar(1.0, -2 * angle)};
  const AdvectionWeights weights = adams_bashforth(bend, 1, 1, 1);
  for (int n = 0; n < steps; ++n) {
    const std::complex<double> rate(0, angle);
    const auto next = u[0] + rate * (weights.now * u[0] + weights.before * u[1] + weights.earlier * u[2]);
    u = {next, u[0], u[1]};
  }
  return std::pow(std::abs(u[0]), 1.0 / steps) - 1;
}

TEST(AdamsBashforth, IsExactForLinesAndWithTheWholeParabolaForParabolas) {
  for (const double bend : {0.0, 2.0 / 3, 1.0}) {
    EXPECT_NEAR(error_of_power(bend, 0), 0, 1e-14);
    EXPECT_NEAR(error_of_power(bend, 1), 0, 1e-14);
  }
  EXPECT_NEAR(error_of_power(1, 2), 0, 1e-14);
  EXPECT_NEAR(error_of_power(2.0 / 3, 2), error_of_power(0, 2) / 3, 1e-14);
}

TEST(AdamsBashforth, StartsWithEulerAndTwoSteps) {
  const AdvectionWeights first = adams_bashforth(1, dt, 0, 0), second = adams_bashforth(1, dt, dt, 0);
  EXPECT_EQ(first.now, 1);
  EXPECT_EQ(first.before, 0);
  EXPECT_DOUBLE_EQ(second.now, 1.5);
  EXPECT_DOUBLE_EQ(second.before, -0.5);
  EXPECT_EQ(second.earlier, 0);
}

TEST(AdamsBashforth, LetsWavesGrowFromTwoStepsAndDecayFromThree) {
  for (const double angle : {0.1, 0.2}) {
    const double fourth = std::pow(angle, 4);
    EXPECT_NEAR(growth(0, angle), fourth / 4, 0.15 * fourth);
    EXPECT_NEAR(growth(2.0 / 3, angle), -fourth / 6, 0.05 * fourth);
    EXPECT_NEAR(growth(1, angle), -0.375 * fourth, 0.05 * fourth);
  }
  EXPECT_LT(growth(2.0 / 3, 0.78), 0);
  EXPECT_GT(growth(2.0 / 3, 0.80), 0);
  EXPECT_GT(growth(1, 0.73), 0);
}

}  // namespace
}  // namespace washfsi

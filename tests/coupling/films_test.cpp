// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/films.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

constexpr double gap = 1e-3, radius = 0.05, mean_square = radius * radius / 8;

// Stefan's force on a disc,  3 pi mu R^4 v/(2 d^3).
TEST(FilmEase, OfAThickLiquidIsStefans) {
  constexpr double mu = 10, speed = 1e-5;
  const double force = 1.5 * std::numbers::pi * mu * std::pow(radius, 4) * speed / std::pow(gap, 3);
  const double pressure = force / (std::numbers::pi * radius * radius);
  EXPECT_NEAR(film_ease({1000, mu}, gap, mean_square, 1.8, pressure) * pressure, speed, 1e-4 * speed);
}

TEST(FilmEase, OfAThinLiquidIsThatOfItsInertia) {
  constexpr double pressure = 500;
  const double speed = film_ease({1000, 1e-9}, gap, mean_square, 1.8, pressure) * pressure;
  EXPECT_NEAR(1.8 * 1000 * mean_square * speed * speed / (gap * gap), pressure, 1e-4 * pressure);
}

// Both at once, and nothing but friction without any pressure.
TEST(FilmEase, SolvesItsLaw) {
  constexpr double mu = 1e-2, pressure = 500, slope = 12 * mu * mean_square / (gap * gap * gap);
  const double speed = film_ease({1000, mu}, gap, mean_square, 1.8, pressure) * pressure;
  EXPECT_NEAR(slope * speed + 1.8e3 * mean_square * speed * speed / (gap * gap), pressure, 1e-9 * pressure);
  EXPECT_NEAR(film_ease({1000, mu}, gap, mean_square, 1.8, 0), 1 / slope, 1e-12 / slope);
}

}  // namespace
}  // namespace washfsi::test

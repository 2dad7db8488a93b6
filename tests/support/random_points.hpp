// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>

#include "washfsi/support/point.hpp"

namespace washfsi::test {

/// The same points on every rank and machine.
template <int Dim>
Points<Dim> random_points(std::size_t count, unsigned seed, double scale = 1) {
  std::mt19937_64 engine(seed);
  Points<Dim> points(count);
  for (auto& point : points)
    for (int d = 0; d < Dim; ++d) point[d] = scale * (2 * static_cast<double>(engine() >> 11) * 0x1p-53 - 1);
  return points;
}

/// A crumpled fibre: a walk of steps of about one spacing in random directions.
template <int Dim>
Points<Dim> crumpled_fibre(std::size_t count, double spacing, unsigned seed) {
  Points<Dim> points = random_points<Dim>(count, seed);
  for (std::size_t k = 1; k < count; ++k) {
    const Point<Dim> direction = points[k].normalized();
    points[k] = points[k - 1] + spacing * (1 + 0.1 * points[k][0]) * direction;
  }
  return points;
}

}  // namespace washfsi::test

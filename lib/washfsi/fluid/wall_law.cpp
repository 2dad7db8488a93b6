// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/wall_law.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

struct Law {
  double speed, slope;  ///< u+ and its derivative
};

Law law_at(double y) {
  const double sublayer = std::exp(-y / 11), buffer = std::exp(-y / 3);
  return {std::log1p(karman * y) / karman + 7.8 * (1 - sublayer - y / 11 * buffer),
          1 / (1 + karman * y) + 7.8 * (sublayer / 11 - buffer / 11 + y / 33 * buffer)};
}

// First guess: the viscous layer; far from the wall the power law of Werner and Wengle, u+ = 8.3 y^(1/7).
double first_guess(double reynolds) {
  return std::max(std::sqrt(reynolds), std::pow(reynolds / 8.3, 7.0 / 8));
}

}  // namespace

double reichardt(double y) {
  return law_at(y).speed;
}

// Newton's method for y u+(y) = Re.
double wall_distance(double reynolds) {
  if (!(reynolds > 0)) return 0;
  constexpr int most = 50;
  double y = first_guess(reynolds);
  for (int n = 0; n < most; ++n) {
    const auto [u, slope] = law_at(y);
    const double step = (reynolds - y * u) / (u + y * slope);
    y += step;
    if (std::abs(step) <= 1e-12 * y) break;
  }
  return y;
}

}  // namespace washfsi

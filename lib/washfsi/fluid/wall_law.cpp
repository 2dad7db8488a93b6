// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/wall_law.hpp"

#include <cmath>

namespace washfsi {

double reichardt(double y) {
  return std::log1p(karman * y) / karman + 7.8 * (1 - std::exp(-y / 11) - y / 11 * std::exp(-y / 3));
}

// Newton's method for y u+(y) = Re from the viscous layer's sqrt(Re).
double wall_distance(double reynolds) {
  if (!(reynolds > 0)) return 0;
  constexpr int most = 50;
  double y = std::sqrt(reynolds);
  for (int n = 0; n < most; ++n) {
    const double slope =
        1 / (1 + karman * y) + 7.8 * (std::exp(-y / 11) / 11 - std::exp(-y / 3) / 11 + y / 33 * std::exp(-y / 3));
    const double u = reichardt(y), step = (reynolds - y * u) / (u + y * slope);
    y += step;
    if (std::abs(step) <= 1e-13 * y) break;
  }
  return y;
}

}  // namespace washfsi

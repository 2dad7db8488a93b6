// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/tumbling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace washfsi {

TumbleCounter::TumbleCounter(const Point<2>& axis, const Point<2>& orbit_center, std::size_t cloths)
    : axis_(axis),
      orbit_center_(orbit_center),
      angles_(cloths, std::numeric_limits<double>::quiet_NaN()),
      turned_(cloths, 0.0) {}

void TumbleCounter::observe(const std::vector<Point<3>>& centers) {
  for (std::size_t cloth = 0; cloth < centers.size(); ++cloth) {
    const double r = (centers[cloth].head<2>() - axis_).norm();
    const double angle = std::atan2(centers[cloth][2] - orbit_center_[1], r - orbit_center_[0]);
    if (std::isfinite(angles_[cloth])) turned_[cloth] += std::remainder(angle - angles_[cloth], 2 * std::numbers::pi);
    angles_[cloth] = angle;
  }
}

std::vector<double> TumbleCounter::turns() const {
  std::vector<double> turns;
  for (const double angle : turned_) turns.push_back(angle / (2 * std::numbers::pi));
  return turns;
}

}  // namespace washfsi

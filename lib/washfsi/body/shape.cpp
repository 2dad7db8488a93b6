// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace washfsi {

Vaned::Vaned(const Dimensions& dimensions) : dimensions_(dimensions) {
  for (int k = 0; k < dimensions.vanes; ++k) {
    const double angle = 2 * std::numbers::pi * k / dimensions.vanes;
    directions_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

double Vaned::distance(const Point<2>& place) const {
  const double half_thickness = 0.5 * dimensions_.vane_thickness;
  double distance = place.norm() - dimensions_.hub_radius;
  for (const Point<2>& direction : directions_) {
    const double along = std::clamp(place.dot(direction), 0.0, dimensions_.tip_radius - half_thickness);
    distance = std::min(distance, (place - along * direction).norm() - half_thickness);
  }
  return distance;
}

}  // namespace washfsi

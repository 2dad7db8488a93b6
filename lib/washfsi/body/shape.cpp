// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace washfsi {

double Vaned::distance(const Point<2>& place) const {
  const double radius = place.norm();
  // the nearest vane is the one whose sector the point is in: turn it onto x
  const double sector = 2 * std::numbers::pi / dimensions_.vanes;
  const double angle = std::atan2(place[1], place[0]);
  const double from_vane = angle - sector * std::round(angle / sector);
  const double half_thickness = 0.5 * dimensions_.vane_thickness;
  const double along = radius * std::cos(from_vane), across = radius * std::sin(from_vane);
  const double nearest = std::clamp(along, 0.0, dimensions_.tip_radius - half_thickness);
  const double to_vane = std::hypot(along - nearest, across) - half_thickness;
  return std::min(to_vane, radius - dimensions_.hub_radius);
}

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/vaned.hpp"

#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi {

ShapePtr<2> vaned(const VanedDimensions& dimensions) {
  const double half_thickness = 0.5 * dimensions.vane_thickness;
  const Point<2> tip(dimensions.tip_radius - half_thickness, 0);
  auto vane = std::make_unique<Capsule<2>>(Point<2>::Zero(), tip, half_thickness);
  ShapeList<2> parts;
  parts.push_back(std::make_unique<Sphere<2>>(dimensions.hub_radius));
  parts.push_back(std::make_unique<Repeated<2>>(std::move(vane), dimensions.vanes));
  return std::make_unique<Union<2>>(std::move(parts));
}

}  // namespace washfsi

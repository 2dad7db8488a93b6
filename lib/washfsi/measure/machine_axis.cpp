// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/machine_axis.hpp"

#include <algorithm>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// From the vertical axis at x,y to the nearest upright side of the box [m].
double distance_to_sides(const Point<2>& axis, const Point<3>& lower, const Point<3>& upper) {
  return std::min((axis - lower.head<2>()).minCoeff(), (upper.head<2>() - axis).minCoeff());
}

}  // namespace

MachineAxis MachineAxis::from_options(Options& options, const Point<3>& lower, const Point<3>& upper) {
  MachineAxis machine;
  const Point<3> middle = 0.5 * (lower + upper);
  machine.axis = middle.head<2>();
  options.block("machine_", "Machine", [&](OptionBlock& block) {
    block.point<2>("axis", machine.axis, "m", "x,y of the vertical axis; default: the middle of the box");
    machine.orbit_center = {0.5 * distance_to_sides(machine.axis, lower, upper), middle[2]};
    block.point<2>("orbit_center", machine.orbit_center, "m",
                   "distance from the axis and height of what tumbling cloths go round; default: half-way from the axis"
                   " to the nearest side, half the height");
  });
  const auto refuse = [](const char* name, const Point<2>& value, const std::string& allowed) {
    throw InputError(std::string("-machine_") + name + " " + list_text<2>(value) + ": must be " + allowed);
  };
  for (int d = 0; d < 2; ++d)
    if (!(machine.axis[d] >= lower[d] && machine.axis[d] <= upper[d]))
      refuse("axis", machine.axis,
             "in the box, x,y from " + list_text<2>(lower.head<2>()) + " to " + list_text<2>(upper.head<2>()));
  const auto& [distance, height] = std::pair(machine.orbit_center[0], machine.orbit_center[1]);
  if (!(distance >= 0 && height >= lower[2] && height <= upper[2]))
    refuse("orbit_center", machine.orbit_center,
           "a distance >= 0 and a height in the box, from " + to_text(lower[2]) + " to " + to_text(upper[2]));
  return machine;
}

}  // namespace washfsi

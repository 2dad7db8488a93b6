// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/machine_axis.hpp"

namespace washfsi {

MachineAxis MachineAxis::from_options(Options& options, const Point<3>& lower, const Point<3>& upper) {
  MachineAxis machine;
  const Point<3> middle = 0.5 * (lower + upper);
  machine.axis = middle.head<2>();
  machine.orbit_center = {0.25 * (upper - lower).head<2>().minCoeff(), middle[2]};
  options.block("machine_", "Machine", [&](OptionBlock& block) {
    block.point<2>("axis", machine.axis, "m", "x,y of the vertical axis; default: the middle of the box");
    block.point<2>("orbit_center", machine.orbit_center, "m",
                   "distance from the axis and height of what tumbling cloths go round; default: half-way between axis"
                   " and sides, half the height");
  });
  return machine;
}

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/options.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// The machine's axis, a vertical, and the place of its (r, z) plane round which cloths tumble.
struct MachineAxis {
  Point<2> axis = Point<2>::Zero();          ///< x and y [m]
  Point<2> orbit_center = Point<2>::Zero();  ///< r and z [m]

  /// Reads it for a box with these corners [m].
  static MachineAxis from_options(Options& options, const Point<3>& lower, const Point<3>& upper);
};

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/sheet_states.hpp"

namespace washfsi {

/// The washing action of the water at a marker, on the mean of both sides: its relative speed along the cloth one and a
/// half cells away, near the edge of the delta, and viscosity times that over the distance.
struct WashingAction {
  double relative_speed = 0, shear = 0;  ///< speed [m/s], shear stress [Pa]
};

/// The measured state of a marker after a step.
struct MarkerSample {
  MarkerState state;
  WashingAction action;
};

/// One number of each marker: its mean over the markers of a group is a column, the mean and standard deviation of its
/// time averages at the markers are in the summary, and cloth.h5 contains it.
struct MarkerQuantity {
  const char *name, *unit, *meaning;
  double (*value)(const MarkerSample& sample);
  bool of_cycle = false;  ///< whether its mean is a figure of a cycle
};

/// All marker quantities, in the plane or in space.
template <int Dim>
const std::vector<MarkerQuantity>& marker_quantities();

}  // namespace washfsi

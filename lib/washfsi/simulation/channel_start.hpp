// SPDX-License-Identifier: BSD-3-Clause
//
// A flow along two walls, disturbed so strongly that it becomes turbulent where it can. With e the distance from the
// middle over the half height, on the walls' axis, and V the mean velocity:
//   u = V f(e) + eps |V| delta curl( (1 - e^2)^2 sum_m  c_m sin(m_y pi (e + 1) / 2 + b_m) cos(k_m . x + a_m) )
//   f = 3/2 (1 - e^2)  laminar,   8/7 (1 - |e|)^(1/7)  turbulent
// The sum is over random waves of the box along its periodic axes, the same on any number of ranks. The disturbance
// has no divergence, and vanishes at the walls with all of its components.
#pragma once

#include "washfsi/fluid/fractional_step.hpp"

namespace washfsi {

/// The mean velocity from wall to wall.
enum class ChannelProfile { turbulent, laminar };
const ChoiceNames<ChannelProfile>& names_of(ChannelProfile);

struct ChannelStartOptions {
  ChannelProfile profile = ChannelProfile::turbulent;
  double disturbance = 0.1;  ///< approximate rms over the mean velocity
  PetscInt seed = 1;

  static ChannelStartOptions from_options(Options& options);
};

/// Errors: InputError unless all axes but one are periodic and `mean` lies along them.
template <int Dim>
VelocityAt<Dim> channel_start(const Grid<Dim>& grid, const Point<Dim>& mean, const ChannelStartOptions& options);

extern template VelocityAt<2> channel_start<2>(const Grid<2>&, const Point<2>&, const ChannelStartOptions&);
extern template VelocityAt<3> channel_start<3>(const Grid<3>&, const Point<3>&, const ChannelStartOptions&);

}  // namespace washfsi

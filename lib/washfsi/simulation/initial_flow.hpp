// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/model.hpp"
#include "washfsi/simulation/channel_start.hpp"

namespace washfsi {

/// The motion of the water at the start.
template <int Dim>
struct InitialFlowOptions {
  std::string kind = "rest";                 ///< one of those in `initial_flow.cpp`
  Point<Dim> velocity = Point<Dim>::Zero();  ///< velocity of the uniform flow, or scale of others [m/s]
  std::string body;                          ///< body with which the water turns; empty: the drum
  ChannelStartOptions channel;

  static InitialFlowOptions from_options(Options& options);
};

/// Starts the water:
///   rest
///   uniform       a uniform velocity
///   taylor_green  one wave of vortices in the x,y plane: u = (-cos kx sin ly, (k/l) sin kx cos ly)
///   taylor_green_3d  vortices that break up: u = V sin kx cos ly cos mz, v = -V (k/l) cos kx sin ly cos mz, w = 0
///   channel       along two walls, disturbed: see `channel_start.hpp`
///   rotation      turning with a body as if it were solid: u = omega e_z x (x - x_body)
///   couette       steady circular flow between a turning drum and a turning cylinder in it: u = (A r + B/r) e_theta
///   (4.3-1)
/// Collective. Errors: InputError if the bodies do not fit the flow.
template <int Dim>
void start_flow(const InitialFlowOptions<Dim>& options, Model<Dim>& model);

}  // namespace washfsi

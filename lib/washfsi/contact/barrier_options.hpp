// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_force.hpp"

namespace washfsi {

/// The barrier between cloths.
struct BarrierOptions {
  double distance = 0;         ///< d^, at which it begins [m]; 0: 0.16 of the least spacing of markers
  double body_distance = 0;    ///< that of bodies and walls [m]; 0: 0.4 of the least spacing of markers, and in water
                               ///< at least the least width of a cell
  double stiffness = 1e4;      ///< kappa [Pa]
  double friction = 0.4;       ///< coefficient between cloths, in steps that are solved for
  double body_friction = 0.2;  ///< the same on bodies and walls
  double damping = 0.3;        ///< of the motion along the normal, over the critical one
};

/// d^ for these cloths [m]. Errors: InputError if it is too large for their lattices.
template <int Dim>
double barrier_distance(const BarrierOptions& options, const Cloths<Dim>& cloths);

/// The barrier of bodies and walls: a cushion with the same law. In water it begins a cell off: the water beside a wall
/// holds what is nearer, and from half of that distance on, which is about what water and bodies move in a step, it
/// sees bodies between markers.
template <int Dim>
MakeForce<Dim> barrier_of_bodies(const BarrierOptions& options, bool in_water);

}  // namespace washfsi

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/contact_force.hpp"

namespace washfsi {

/// The barrier between cloths.
struct BarrierOptions {
  double distance = 0;         ///< d^, contact distance of cloths [m]; 0: 0.16 of the least spacing of markers
  double body_distance = 0;    ///< contact distance of bodies and sides of the box [m]; 0: 0.4 of the least spacing of
                               ///< markers, and in water at least the least width of a cell
  double stiffness = 1e4;      ///< kappa [Pa]
  double friction = 0.4;       ///< coefficient between cloths
  double body_friction = 0.2;  ///< coefficient on bodies and sides of the box
  double damping = 0.3;        ///< damping of the normal motion, over the critical one
};

/// d^ for these cloths [m]. Errors: InputError if it is too large for their lattices.
template <int Dim>
double barrier_distance(const BarrierOptions& options, const Cloths<Dim>& cloths);

/// The barrier of bodies and sides of the box: `BodyContact` with the same law. In water it begins a cell off: nearer
/// cloth moves with the water beside the wall. From half of that distance on, about the motion of water and bodies in a
/// step, it also sees bodies between markers.
template <int Dim>
MakeForce<Dim> barrier_of_bodies(const BarrierOptions& options, bool in_water);

}  // namespace washfsi
